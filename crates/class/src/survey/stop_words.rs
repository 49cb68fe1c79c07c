//! Words that say nothing about the subject. Negations are not among them.

use frostem::Algorithm;
use std::collections::HashSet;
use units::Language;

const ENGLISH: &str = "a about above after again against all also although am an and any are as at be because been before being \
    below between both but by can cannot could did do does doing down during each either else even ever every few for from \
    further get gets getting go goes going got had has have having he her here hers herself him himself his how however i if \
    in into is it its itself i'm i've i'd i'll it's just let like made make makes many may me might more most much must my \
    myself of off on once one only onto or other others ought our ours ourselves out over own per perhaps quite rather really \
    s same see seem seems she should since so some something sometimes still such t than that that's the their theirs them \
    themselves then there there's therefore these they they're thing things this those though through thus to too under until \
    up upon us use very was way we we're we've well were what when where whether which while who whom whose why will with \
    within would yes yet you you're you've your yours yourself";

const SPANISH: &str = "a acá ahí al algo algún alguna algunas alguno algunos allá allí ambos ante antes aquel aquella aquellas aquello \
    aquellos aquí así aun aún aunque bajo bastante bien cada casi como cómo con conmigo contra cosa cosas cual cuál cuales \
    cuáles cualquier cuando cuándo cuanto cuánto de del demás demasiado dentro desde después donde dónde durante e el él ella \
    ellas ellos en entonces entre era eran es esa esas ese eso esos esta está estaba estaban estado estamos están estar estas \
    este esto estos estoy estuvo fue fueron ha había habían haber hace hacen hacer hacia han hasta hay he hemos incluso la las \
    le les lo los luego más me mediante menos mi mí mis mientras mismo misma mismos mismas mucha muchas mucho muchos muy nada ni \
    nos nosotros nuestra nuestras nuestro nuestros o os otra otras otro otros para parece pero poca pocas poco pocos podría \
    por porque pude puede pueden puedo pues que qué quien quién quienes quizá quizás se sea sean según ser si sí sido siempre \
    siendo sin sino sobre sois solo sólo somos son soy su sus suya suyo también tan tanta tanto te tendría tenemos tener tengo \
    ti tiene tienen toda todas todavía todo todos tras tu tú tus tuve tuvo u un una unas uno unos usted ustedes va van vez \
    veces voy y ya yo";

const PORTUGUESE: &str = "a à ao aos aquela aquelas aquele aqueles aquilo as às até bastante bem cada coisa coisas com como contra da \
    das de dela delas dele deles demais depois desde dessa dessas desse desses desta destas deste destes disso disto do dos durante e \
    é ela elas ele eles em enquanto então entre era eram essa essas esse esses esta está estão estar estas estava estavam este estes \
    estou eu faz fazem fazer foi foram há havia isso isto já la lá lhe lhes logo mais mas me mediante menos mesma mesmas mesmo mesmos \
    meu meus minha minhas muita muitas muito muitos na nada nas nem nessa nesse nesta neste no nos nós nossa nossas nosso nossos num \
    numa o onde os ou outra outras outro outros para pela pelas pelo pelos perante pode podem pois por porque posso pouca poucas pouco \
    poucos pra qual quais qualquer quando quanto que quê quem quase são se seja sem sempre sendo ser seu seus sido sim sob sobre sua \
    suas só talvez também tanta tanto te tem têm tenho ter teria teve tinha tive toda todas todo todos tu tudo um uma umas uns vai vão \
    vez vezes você vocês";

/// Stemmer and stop words of a language.
pub struct Known {
    /// The language.
    pub language: Language,
    /// Joins forms of a word.
    pub stemmer: Algorithm,
    /// Words that say nothing about the subject.
    pub stop_words: HashSet<&'static str>,
}

/// The known languages. Of two that fit a comment equally, the first one counts.
pub fn known() -> [Known; 3] {
    [
        (Language::English, Algorithm::English, ENGLISH),
        (Language::Spanish, Algorithm::Spanish, SPANISH),
        (Language::Portuguese, Algorithm::Portuguese, PORTUGUESE),
    ]
    .map(|(language, stemmer, words)| Known { language, stemmer, stop_words: words.split_whitespace().collect() })
}

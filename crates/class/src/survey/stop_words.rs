//! Words that say nothing about the subject. Negations are not among them.

use std::collections::HashSet;

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

/// The stop words of both languages.
pub struct StopWords {
    /// English stop words.
    pub english: HashSet<&'static str>,
    /// Spanish stop words.
    pub spanish: HashSet<&'static str>,
}

impl StopWords {
    /// All stop words.
    pub fn new() -> Self {
        let [english, spanish] = [ENGLISH, SPANISH].map(|words| words.split_whitespace().collect());
        Self { english, spanish }
    }

    /// True if the word is a stop word of one of the languages.
    pub fn contains(&self, word: &str) -> bool {
        self.english.contains(word) || self.spanish.contains(word)
    }
}

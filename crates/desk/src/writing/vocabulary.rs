//! What an author can write, with a few words about each: the names of the model that runs, functions, words that begin a
//! statement, units.

use crate::Desk;
use std::collections::BTreeSet;
use units::Language;
use units::number::unit_text;

/// What kind of word it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordKind {
    /// A name of the model that runs.
    Name,
    /// A function.
    Function,
    /// A word of the language.
    Keyword,
    /// A unit.
    Unit,
}

/// Something that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// As it is written.
    pub text: String,
    /// What kind of word it is.
    pub kind: WordKind,
    /// What it is, in the chosen language; empty where its author does not say.
    pub about: String,
}

/// Functions.
const FUNCTIONS: [(&str, &str, &str); 39] = [
    ("sqrt", "square root", "raíz cuadrada"),
    ("cbrt", "cube root", "raíz cúbica"),
    ("abs", "absolute value", "valor absoluto"),
    ("sign", "−1, 0 or 1", "−1, 0 o 1"),
    ("exp", "exponential function", "función exponencial"),
    ("ln", "natural logarithm", "logaritmo natural"),
    ("log10", "decimal logarithm", "logaritmo decimal"),
    ("sin", "sine", "seno"),
    ("cos", "cosine", "coseno"),
    ("tan", "tangent", "tangente"),
    ("asin", "inverse sine", "arcoseno"),
    ("acos", "inverse cosine", "arcocoseno"),
    ("atan", "inverse tangent", "arcotangente"),
    ("atan2", "atan2(y, x): angle of the point (x, y)", "atan2(y, x): ángulo del punto (x, y)"),
    ("sinh", "hyperbolic sine", "seno hiperbólico"),
    ("cosh", "hyperbolic cosine", "coseno hiperbólico"),
    ("tanh", "hyperbolic tangent", "tangente hiperbólica"),
    ("asinh", "inverse hyperbolic sine", "arcoseno hiperbólico"),
    ("acosh", "inverse hyperbolic cosine", "arcocoseno hiperbólico"),
    ("atanh", "inverse hyperbolic tangent", "arcotangente hiperbólica"),
    ("floor", "next lower whole number", "entero inferior"),
    ("ceil", "next higher whole number", "entero superior"),
    ("round", "nearest whole number", "entero más próximo"),
    ("sum", "sum of all arguments", "suma de los argumentos"),
    ("min", "least argument", "argumento menor"),
    ("max", "greatest argument", "argumento mayor"),
    ("mod", "mod(a, b): remainder of a/b", "mod(a, b): resto de a/b"),
    ("hypot", "hypot(a, b): root of a^2 + b^2", "hypot(a, b): raíz de a^2 + b^2"),
    ("coulomb", "coulomb(v, F): dry friction", "coulomb(v, F): rozamiento seco"),
    ("uniform", "uniform(a, b): random, even", "uniform(a, b): al azar, uniforme"),
    ("normal", "normal(mean, deviation): random", "normal(media, desviación): al azar"),
    ("exponential", "exponential(mean): random", "exponential(media): al azar"),
    ("poisson", "poisson(mean): random number of events", "poisson(media): número de sucesos al azar"),
    ("binomial", "binomial(n, p): random number of successes", "binomial(n, p): número de éxitos al azar"),
    ("maximum", "greatest value so far", "mayor valor hasta ahora"),
    ("minimum", "least value so far", "menor valor hasta ahora"),
    ("integral", "integral over the time so far", "integral sobre el tiempo transcurrido"),
    ("mean", "mean over the time so far", "media sobre el tiempo transcurrido"),
    ("pi", "3.14159...", "3,14159..."),
];

/// Words of the language.
const KEYWORDS: [(&str, &str, &str); 17] = [
    ("parameter", "a constant to be changed: m = 1 [kg] in 0..5", "una constante que se cambia: m = 1 [kg] in 0..5"),
    ("independent", "the independent variable: x in [m]", "la variable independiente: x in [m]"),
    ("discrete", "a quantity that only events change", "una magnitud que solo cambian los sucesos"),
    ("hidden", "a quantity that is not shown", "una magnitud que no se muestra"),
    ("switch", "a parameter that is on or off", "un parámetro encendido o apagado"),
    ("choice", "alternatives to choose from", "alternativas que se eligen"),
    ("when", "an event: when y < 0 [m] { ... }", "un suceso: when y < 0 [m] { ... }"),
    ("every", "an event at equal intervals", "un suceso a intervalos iguales"),
    ("button", "an event that the reader triggers", "un suceso que provoca el lector"),
    ("next", "a map: the value after the present one", "una aplicación: el valor que sigue"),
    ("size", "the number of members of a family", "el número de miembros de una familia"),
    ("for", "for i in 1..N: each member of a family", "for i in 1..N: cada miembro de una familia"),
    ("if", "if c then a else b", "if c then a else b"),
    ("then", "the value where the condition holds", "el valor si se cumple la condición"),
    ("else", "the value where it does not hold", "el valor si no se cumple"),
    ("stop", "ends the run", "termina la simulación"),
    ("step", "the step of a slider", "el paso de un deslizador"),
];

/// Units that are often needed; prefixes go before most of them.
const UNITS: [(&str, &str, &str); 36] = [
    ("m", "metre", "metro"),
    ("cm", "centimetre", "centímetro"),
    ("mm", "millimetre", "milímetro"),
    ("km", "kilometre", "kilómetro"),
    ("kg", "kilogram", "kilogramo"),
    ("g", "gram", "gramo"),
    ("s", "second", "segundo"),
    ("ms", "millisecond", "milisegundo"),
    ("min", "minute", "minuto"),
    ("h", "hour", "hora"),
    ("d", "day", "día"),
    ("A", "ampere", "amperio"),
    ("K", "kelvin", "kelvin"),
    ("mol", "mole", "mol"),
    ("rad", "radian", "radián"),
    ("deg", "degree", "grado"),
    ("%", "per cent", "por ciento"),
    ("Hz", "hertz", "hercio"),
    ("N", "newton", "newton"),
    ("Pa", "pascal", "pascal"),
    ("J", "joule", "julio"),
    ("W", "watt", "vatio"),
    ("C", "coulomb", "culombio"),
    ("V", "volt", "voltio"),
    ("Ω", "ohm", "ohmio"),
    ("F", "farad", "faradio"),
    ("H", "henry", "henrio"),
    ("T", "tesla", "tesla"),
    ("L", "litre", "litro"),
    ("eV", "electronvolt", "electronvoltio"),
    ("m/s", "velocity", "velocidad"),
    ("m/s^2", "acceleration", "aceleración"),
    ("rad/s", "angular frequency", "frecuencia angular"),
    ("N/m", "stiffness", "constante de un resorte"),
    ("kg/s", "linear damping", "amortiguamiento lineal"),
    ("kg/m^3", "density", "densidad"),
];

impl Desk {
    /// What can be written. The names are those of the model that runs.
    pub fn vocabulary(&self) -> Vec<Word> {
        let language = self.play.language();
        let fixed = |kind: WordKind, list: &'static [(&str, &str, &str)]| {
            list.iter().map(move |(text, english, spanish)| {
                let about = language.pick(*english, *spanish).to_owned();
                Word { text: (*text).to_owned(), kind, about }
            })
        };
        let mut words = self.names(language);
        words.extend(fixed(WordKind::Function, &FUNCTIONS));
        words.extend(fixed(WordKind::Keyword, &KEYWORDS));
        words.extend(fixed(WordKind::Unit, &UNITS));
        words
    }

    /// The names of the model, each once: those of a family without an index, those of states without primes.
    fn names(&self, language: Language) -> Vec<Word> {
        let model = self.play.model();
        let parameters = model.parameters.iter().map(|one| (&one.name, &one.label, &one.unit));
        let states = model.states.iter().map(|one| (&one.variable, &one.label, &one.unit));
        let own = model.quantities.iter().filter(|one| !one.remembered);
        let quantities = own.map(|one| (&one.name, &one.label, &one.value.unit));
        let mut seen = BTreeSet::new();
        let mut words = Vec::new();
        for (name, label, unit) in parameters.chain(states).chain(quantities) {
            let name = name.split(['[', '.']).next().unwrap_or_default();
            // What the program adds itself has a blank in its name.
            if name.is_empty() || name.contains(' ') || !seen.insert(name.to_owned()) {
                continue;
            }
            let label = label.as_deref().map(|label| self.document.program.text(language.tag(), label));
            let unit = unit_text(&unit.text);
            let unit = if unit.is_empty() { unit } else { format!("[{unit}]") };
            let about = [label.unwrap_or_default(), unit.as_str()].join(" ").trim().to_owned();
            words.push(Word { text: name.to_owned(), kind: WordKind::Name, about });
        }
        words
    }
}

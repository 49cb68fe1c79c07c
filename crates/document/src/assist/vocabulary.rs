//! Keywords and functions of the language, with descriptions.

use program::functions::{FUNCTIONS, Function};
use units::{Words, words};

/// A word and its description.
pub type Entry = (&'static str, Words);

/// Keys of the front matter.
pub const KEYS: &[Entry] = &[
    ("title", words("title of the simulation")),
    ("language", words("language of the text, such as en")),
    ("summary", words("one sentence for lists of simulations")),
    ("topics", words("topics for lists, separated by commas")),
    ("keywords", words("further words that a search finds")),
    ("translates", words("the document that this one translates")),
    ("method", words("numerical method, such as rk4")),
    ("step", words("time step, such as 0.01 [s]")),
    ("until", words("where a run ends, such as 20 [s]")),
    ("speed", words("model time for a second of watching")),
    ("tolerance", words("relative error allowed in a step")),
    ("vary", words("parameters that a fit varies first")),
    ("main", words("up to five parameters that the page shows first")),
    ("assignment", words("name on which the values of the seats depend: tube-2026")),
];

/// Kinds of blocks.
pub const BLOCKS: &[Entry] = &[
    ("model", words("parameters, equations and initial values")),
    ("scene", words("a drawing in SVG")),
    ("plots", words("what is drawn against what")),
    ("presets", words("named sets of parameter values")),
    ("question", words("a question with an answer that the model computes")),
    ("survey", words("opinions that are collected without names")),
    ("check", words("claims that are verified by runs")),
    ("table", words("a function given by points")),
    ("translations", words("texts and their translations")),
];

/// Keywords at the beginning of statements.
pub const STATEMENTS: &[Entry] = &[
    ("parameter", words("a number with a slider: parameter b = 0.2 [kg/s] in 0..2")),
    ("discrete", words("changes at events only: discrete n = 0")),
    ("when", words("an event: when y < 0 [m] { y' = -e*y' }")),
    ("every", words("at equal intervals: every 0.1 [s] { ... }")),
    ("button", words("a button for the reader: button \"Kick\" { ... }")),
    ("group", words("a heading for the controls after it: group \"Circuit\"")),
    ("choice", words("a drop-down list that defines quantities")),
    ("switch", words("a tick box: switch drag = on")),
    ("function", words("a function: function f(x) = x^2")),
    ("table", words("a function given by points")),
    ("size", words("how many members families have: size N = 20 in 2..200")),
    ("next", words("a map: next x = r*x*(1 - x)")),
    ("random", words("the seed of random draws: random seed = 1")),
    ("independent", words("another independent variable: independent x in [m]")),
    ("hidden", words("keeps a value or a parameter from the reader")),
];

/// Keywords inside expressions and statements.
pub const OPERATORS: &[Entry] = &[
    ("if", words("if CONDITION then A else B")),
    ("then", words("the value if the condition holds")),
    ("else", words("the value otherwise")),
    ("and", words("both conditions hold")),
    ("or", words("at least one condition holds")),
    ("not", words("the condition does not hold")),
    ("in", words("states a unit or a range")),
    ("assigned", words("values for the seats of a class: assigned 0.1..0.5 step 0.02")),
    ("for", words("for each value of an index: for i in 1..N")),
    ("against", words("of a plot: the horizontal axis")),
];

/// Frequently used units.
pub const UNITS: &[&str] = &[
    "m", "cm", "mm", "km", "s", "ms", "min", "h", "d", "kg", "g", "m/s", "m/s^2", "km/h", "N", "N/m", "kg/s", "J", "W",
    "Pa", "kPa", "bar", "Hz", "1/s", "rad", "deg", "rad/s", "K", "V", "A", "ohm", "F", "H", "C", "T", "mol", "L", "mL",
    "kg/m^3", "Pa s", "m^2", "m^3", "%", "eV",
];

/// Parts of drawings.
pub const PARTS: &[Entry] = &[
    ("frame", words("axes of lengths for what it holds: x=\"-2..2 [m]\"")),
    ("spring", words("a spring between two points")),
    ("damper", words("a damper between two points")),
    ("rod", words("a rod between two points")),
    ("ground", words("hatched ground")),
    ("arrow", words("an arrow of a vector")),
    ("block", words("a block")),
    ("bob", words("a bob")),
    ("wheel", words("a wheel that turns")),
    ("pulley", words("a pulley that turns")),
    ("ramp", words("an inclined plane")),
    ("label", words("a text at a point")),
    ("ruler", words("a ruler with numbers")),
    ("axes", words("axes with numbers")),
    ("angle", words("an arc of an angle")),
    ("protractor", words("a protractor")),
    ("image", words("a picture inside the document")),
    ("tube", words("a tube with liquid")),
    ("utube", words("a U-tube with liquid")),
    ("trail", words("the path of a point")),
    ("resistor", words("a resistor")),
    ("coil", words("a coil")),
    ("capacitor", words("a capacitor")),
    ("switch", words("a switch of a circuit")),
    ("source", words("a voltage source")),
];

/// Attributes of drawing elements: those that the language adds, and the most common others.
pub const ATTRIBUTES: &[Entry] = &[
    ("at", words("a point: (x, 0 [m])")),
    ("from", words("where it begins: (0, 0)")),
    ("to", words("where it ends: (x, y)")),
    ("visible", words("a condition under which it is shown")),
    ("repeat", words("a copy for each value: i in 1..N")),
    ("drag", words("the state or parameter that follows the pointer")),
    ("points", words("points of a line: (i*a, x[i]) for i in 0..N")),
    ("r", words("radius")),
    ("fill", words("colour of the area")),
    ("stroke", words("colour of the line")),
    ("stroke-width", words("width of the line")),
    ("opacity", words("from 0, invisible, to 1")),
    ("transform", words("translate({x}) rotate({phi in [deg]})")),
    ("class", words("a rule of the style block")),
];

/// Descriptions of built-in functions.
const MEANINGS: &[Entry] = &[
    ("sqrt", words("square root")),
    ("cbrt", words("cube root")),
    ("abs", words("absolute value")),
    ("sign", words("-1, 0 or 1")),
    ("exp", words("exponential function")),
    ("ln", words("natural logarithm")),
    ("log10", words("decimal logarithm")),
    ("sin", words("sine")),
    ("cos", words("cosine")),
    ("tan", words("tangent")),
    ("asin", words("arc sine")),
    ("acos", words("arc cosine")),
    ("atan", words("arc tangent")),
    ("atan2", words("angle of the point (x, y): atan2(y, x)")),
    ("sinh", words("hyperbolic sine")),
    ("cosh", words("hyperbolic cosine")),
    ("tanh", words("hyperbolic tangent")),
    ("asinh", words("inverse hyperbolic sine")),
    ("acosh", words("inverse hyperbolic cosine")),
    ("atanh", words("inverse hyperbolic tangent")),
    ("floor", words("greatest whole number not above")),
    ("ceil", words("least whole number not below")),
    ("round", words("nearest whole number")),
    ("sum", words("sum: sum(x[i] for i in 1..N)")),
    ("min", words("least of several")),
    ("max", words("greatest of several")),
    ("mod", words("remainder of a division: mod(a, b)")),
    ("hypot", words("sqrt(a^2 + b^2)")),
    ("coulomb", words("dry friction: coulomb(v, F)")),
    ("uniform", words("a random number between two values")),
    ("normal", words("a random number with mean and standard deviation")),
    ("exponential", words("a random number with this mean")),
    ("poisson", words("a random whole number with this mean")),
    ("binomial", words("successes in n trials of probability p: binomial(n, p)")),
];

/// Functions of models only, because they depend on the run or are about vectors.
const OF_MODELS: &[Entry] = &[
    ("maximum", words("greatest value of the run so far")),
    ("minimum", words("least value of the run so far")),
    ("mean", words("mean over time of the run so far")),
    ("integral", words("integral over time of the run so far")),
    ("norm", words("length of a vector")),
    ("dot", words("scalar product")),
    ("cross", words("vector product")),
    ("pick", words("one of several at random")),
];

/// All functions that an author can call.
pub fn functions() -> impl Iterator<Item = (&'static str, Words)> {
    let language = FUNCTIONS.iter().filter(|function| function.name != Function::STREAM).map(|function| function.name);
    let all = language.chain(OF_MODELS.iter().map(|(name, _)| *name));
    all.map(|name| (name, function(name).unwrap_or_default()))
}

/// Description of a function.
pub fn function(name: &str) -> Option<Words> {
    let (_, meaning) = MEANINGS.iter().chain(OF_MODELS).find(|(known, _)| *known == name)?;
    Some(meaning.clone())
}

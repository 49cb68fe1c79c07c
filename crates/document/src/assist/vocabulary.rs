//! Keywords and functions of the language, with descriptions.

use program::functions::{FUNCTIONS, Function};
use units::{Words, words};

/// A word and its description in English and Spanish.
pub type Entry = (&'static str, (&'static str, &'static str));

/// Keys of the front matter.
pub const KEYS: &[Entry] = &[
    ("title", ("title of the simulation", "título de la simulación")),
    ("language", ("language of the text, such as en", "idioma del texto, por ejemplo es")),
    ("summary", ("one sentence for lists of simulations", "una frase para listas de simulaciones")),
    ("topics", ("topics for lists, separated by commas", "temas para listas, separados por comas")),
    ("keywords", ("further words that a search finds", "más palabras que encuentra una búsqueda")),
    ("translates", ("the document that this one translates", "el documento que este traduce")),
    ("method", ("numerical method, such as rk4", "método numérico, por ejemplo rk4")),
    ("step", ("time step, such as 0.01 [s]", "paso de tiempo, por ejemplo 0.01 [s]")),
    ("until", ("where a run ends, such as 20 [s]", "dónde termina una simulación, por ejemplo 20 [s]")),
    ("speed", ("model time for a second of watching", "tiempo del modelo por segundo de observación")),
    ("tolerance", ("relative error allowed in a step", "error relativo admitido en un paso")),
    ("vary", ("parameters that a fit varies first", "parámetros que un ajuste varía primero")),
    (
        "main",
        ("up to five parameters that the page shows first", "hasta cinco parámetros que la página muestra primero"),
    ),
    (
        "assignment",
        (
            "name on which the values of the seats depend: tube-2026",
            "nombre del que dependen los valores de los puestos: tubo-2026",
        ),
    ),
];

/// Kinds of blocks.
pub const BLOCKS: &[Entry] = &[
    ("model", ("parameters, equations and initial values", "parámetros, ecuaciones y valores iniciales")),
    ("scene", ("a drawing in SVG", "un dibujo en SVG")),
    ("plots", ("what is drawn against what", "qué se dibuja frente a qué")),
    ("presets", ("named sets of parameter values", "conjuntos de valores con nombre")),
    (
        "question",
        ("a question with an answer that the model computes", "una pregunta cuya respuesta calcula el modelo"),
    ),
    ("survey", ("opinions that are collected without names", "opiniones que se recogen sin nombres")),
    ("check", ("claims that are verified by runs", "afirmaciones que se comprueban con simulaciones")),
    ("table", ("a function given by points", "una función dada por puntos")),
    ("translations", ("texts and their translations", "textos y sus traducciones")),
];

/// Keywords at the beginning of statements.
pub const STATEMENTS: &[Entry] = &[
    (
        "parameter",
        (
            "a number with a slider: parameter b = 0.2 [kg/s] in 0..2",
            "un número con control: parameter b = 0.2 [kg/s] in 0..2",
        ),
    ),
    ("discrete", ("changes at events only: discrete n = 0", "cambia solo en eventos: discrete n = 0")),
    ("when", ("an event: when y < 0 [m] { y' = -e*y' }", "un evento: when y < 0 [m] { y' = -e*y' }")),
    ("every", ("at equal intervals: every 0.1 [s] { ... }", "a intervalos iguales: every 0.1 [s] { ... }")),
    (
        "button",
        ("a button for the reader: button \"Kick\" { ... }", "un botón para el lector: button \"Golpe\" { ... }"),
    ),
    (
        "group",
        (
            "a heading for the controls after it: group \"Circuit\"",
            "un título para los controles que siguen: group \"Circuito\"",
        ),
    ),
    ("choice", ("a drop-down list that defines quantities", "una lista desplegable que define magnitudes")),
    ("switch", ("a tick box: switch drag = on", "una casilla: switch drag = on")),
    ("function", ("a function: function f(x) = x^2", "una función: function f(x) = x^2")),
    ("table", ("a function given by points", "una función dada por puntos")),
    (
        "size",
        (
            "how many members families have: size N = 20 in 2..200",
            "cuántos miembros tienen las familias: size N = 20 in 2..200",
        ),
    ),
    ("next", ("a map: next x = r*x*(1 - x)", "una aplicación iterada: next x = r*x*(1 - x)")),
    ("random", ("the seed of random draws: random seed = 1", "la semilla de los sorteos: random seed = 1")),
    (
        "independent",
        ("another independent variable: independent x in [m]", "otra variable independiente: independent x in [m]"),
    ),
    ("hidden", ("keeps a value or a parameter from the reader", "no muestra al lector una magnitud o un parámetro")),
];

/// Keywords inside expressions and statements.
pub const OPERATORS: &[Entry] = &[
    ("if", ("if CONDITION then A else B", "if CONDICIÓN then A else B")),
    ("then", ("the value if the condition holds", "el valor si se cumple la condición")),
    ("else", ("the value otherwise", "el valor en otro caso")),
    ("and", ("both conditions hold", "se cumplen ambas condiciones")),
    ("or", ("at least one condition holds", "se cumple al menos una condición")),
    ("not", ("the condition does not hold", "no se cumple la condición")),
    ("in", ("states a unit or a range", "declara una unidad o un intervalo")),
    (
        "assigned",
        (
            "values for the seats of a class: assigned 0.1..0.5 step 0.02",
            "valores para los puestos de una clase: assigned 0.1..0.5 step 0.02",
        ),
    ),
    ("for", ("for each value of an index: for i in 1..N", "para cada valor de un índice: for i in 1..N")),
    ("against", ("of a plot: the horizontal axis", "de una gráfica: el eje horizontal")),
];

/// Frequently used units.
pub const UNITS: &[&str] = &[
    "m", "cm", "mm", "km", "s", "ms", "min", "h", "d", "kg", "g", "m/s", "m/s^2", "km/h", "N", "N/m", "kg/s", "J", "W",
    "Pa", "kPa", "bar", "Hz", "1/s", "rad", "deg", "rad/s", "K", "V", "A", "ohm", "F", "H", "C", "T", "mol", "L", "mL",
    "kg/m^3", "Pa s", "m^2", "m^3", "%", "eV",
];

/// Parts of drawings.
pub const PARTS: &[Entry] = &[
    (
        "frame",
        ("axes of lengths for what it holds: x=\"-2..2 [m]\"", "ejes de longitudes para su contenido: x=\"-2..2 [m]\""),
    ),
    ("spring", ("a spring between two points", "un muelle entre dos puntos")),
    ("damper", ("a damper between two points", "un amortiguador entre dos puntos")),
    ("rod", ("a rod between two points", "una varilla entre dos puntos")),
    ("ground", ("hatched ground", "suelo rayado")),
    ("arrow", ("an arrow of a vector", "la flecha de un vector")),
    ("block", ("a block", "un bloque")),
    ("bob", ("a bob", "una lenteja")),
    ("wheel", ("a wheel that turns", "una rueda que gira")),
    ("pulley", ("a pulley that turns", "una polea que gira")),
    ("ramp", ("an inclined plane", "un plano inclinado")),
    ("label", ("a text at a point", "un texto en un punto")),
    ("ruler", ("a ruler with numbers", "una regla con números")),
    ("axes", ("axes with numbers", "ejes con números")),
    ("angle", ("an arc of an angle", "el arco de un ángulo")),
    ("protractor", ("a protractor", "un transportador")),
    ("image", ("a picture inside the document", "una imagen dentro del documento")),
    ("tube", ("a tube with liquid", "un tubo con líquido")),
    ("utube", ("a U-tube with liquid", "un tubo en U con líquido")),
    ("trail", ("the path of a point", "la trayectoria de un punto")),
    ("resistor", ("a resistor", "una resistencia")),
    ("coil", ("a coil", "una bobina")),
    ("capacitor", ("a capacitor", "un condensador")),
    ("switch", ("a switch of a circuit", "un interruptor de un circuito")),
    ("source", ("a voltage source", "una fuente de tensión")),
];

/// Attributes of drawing elements: those that the language adds, and the most common others.
pub const ATTRIBUTES: &[Entry] = &[
    ("at", ("a point: (x, 0 [m])", "un punto: (x, 0 [m])")),
    ("from", ("where it begins: (0, 0)", "dónde empieza: (0, 0)")),
    ("to", ("where it ends: (x, y)", "dónde termina: (x, y)")),
    ("visible", ("a condition under which it is shown", "condición con la que se muestra")),
    ("repeat", ("a copy for each value: i in 1..N", "una copia por valor: i in 1..N")),
    ("drag", ("the state or parameter that follows the pointer", "el estado o parámetro que sigue al puntero")),
    ("points", ("points of a line: (i*a, x[i]) for i in 0..N", "puntos de una línea: (i*a, x[i]) for i in 0..N")),
    ("r", ("radius", "radio")),
    ("fill", ("colour of the area", "color del área")),
    ("stroke", ("colour of the line", "color de la línea")),
    ("stroke-width", ("width of the line", "grosor de la línea")),
    ("opacity", ("from 0, invisible, to 1", "de 0, invisible, a 1")),
    ("transform", ("translate({x}) rotate({phi in [deg]})", "translate({x}) rotate({phi in [deg]})")),
    ("class", ("a rule of the style block", "una regla del bloque de estilo")),
];

/// Descriptions of built-in functions.
const MEANINGS: &[Entry] = &[
    ("sqrt", ("square root", "raíz cuadrada")),
    ("cbrt", ("cube root", "raíz cúbica")),
    ("abs", ("absolute value", "valor absoluto")),
    ("sign", ("-1, 0 or 1", "-1, 0 o 1")),
    ("exp", ("exponential function", "función exponencial")),
    ("ln", ("natural logarithm", "logaritmo natural")),
    ("log10", ("decimal logarithm", "logaritmo decimal")),
    ("sin", ("sine", "seno")),
    ("cos", ("cosine", "coseno")),
    ("tan", ("tangent", "tangente")),
    ("asin", ("arc sine", "arcoseno")),
    ("acos", ("arc cosine", "arcocoseno")),
    ("atan", ("arc tangent", "arcotangente")),
    ("atan2", ("angle of the point (x, y): atan2(y, x)", "ángulo del punto (x, y): atan2(y, x)")),
    ("sinh", ("hyperbolic sine", "seno hiperbólico")),
    ("cosh", ("hyperbolic cosine", "coseno hiperbólico")),
    ("tanh", ("hyperbolic tangent", "tangente hiperbólica")),
    ("asinh", ("inverse hyperbolic sine", "seno hiperbólico inverso")),
    ("acosh", ("inverse hyperbolic cosine", "coseno hiperbólico inverso")),
    ("atanh", ("inverse hyperbolic tangent", "tangente hiperbólica inversa")),
    ("floor", ("greatest whole number not above", "mayor entero no superior")),
    ("ceil", ("least whole number not below", "menor entero no inferior")),
    ("round", ("nearest whole number", "entero más próximo")),
    ("sum", ("sum: sum(x[i] for i in 1..N)", "suma: sum(x[i] for i in 1..N)")),
    ("min", ("least of several", "el menor de varios")),
    ("max", ("greatest of several", "el mayor de varios")),
    ("mod", ("remainder of a division: mod(a, b)", "resto de una división: mod(a, b)")),
    ("hypot", ("sqrt(a^2 + b^2)", "sqrt(a^2 + b^2)")),
    ("coulomb", ("dry friction: coulomb(v, F)", "rozamiento seco: coulomb(v, F)")),
    ("uniform", ("a random number between two values", "un número al azar entre dos valores")),
    (
        "normal",
        ("a random number with mean and standard deviation", "un número al azar con media y desviación estándar"),
    ),
    ("exponential", ("a random number with this mean", "un número al azar con esta media")),
    ("poisson", ("a random whole number with this mean", "un entero al azar con esta media")),
    (
        "binomial",
        (
            "successes in n trials of probability p: binomial(n, p)",
            "éxitos en n intentos de probabilidad p: binomial(n, p)",
        ),
    ),
];

/// Functions of models only, because they depend on the run or are about vectors.
const OF_MODELS: &[Entry] = &[
    ("maximum", ("greatest value of the run so far", "mayor valor hasta ahora")),
    ("minimum", ("least value of the run so far", "menor valor hasta ahora")),
    ("mean", ("mean over time of the run so far", "media temporal hasta ahora")),
    ("integral", ("integral over time of the run so far", "integral temporal hasta ahora")),
    ("norm", ("length of a vector", "módulo de un vector")),
    ("dot", ("scalar product", "producto escalar")),
    ("cross", ("vector product", "producto vectorial")),
    ("pick", ("one of several at random", "uno de varios al azar")),
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
    Some(words(meaning.0, meaning.1))
}

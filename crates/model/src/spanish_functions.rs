//! Functions named in Spanish.

/// Function names in Spanish, without accents.
const SPANISH: [(&str, &str); 22] = [
    ("sen", "sin"),
    ("seno", "sin"),
    ("coseno", "cos"),
    ("tg", "tan"),
    ("tangente", "tan"),
    ("arcsen", "asin"),
    ("arcseno", "asin"),
    ("arcos", "acos"),
    ("arctg", "atan"),
    ("senh", "sinh"),
    ("raiz", "sqrt"),
    ("absoluto", "abs"),
    ("signo", "sign"),
    ("suma", "sum"),
    ("redondear", "round"),
    ("piso", "floor"),
    ("techo", "ceil"),
    ("maximo", "maximum"),
    ("minimo", "minimum"),
    ("media", "mean"),
    ("promedio", "mean"),
    ("norma", "norm"),
];

/// The function that a Spanish word means.
pub(crate) fn in_english(function: &str) -> Option<&'static str> {
    let plain: String = function.chars().map(units::alphabet::without_accent).collect();
    SPANISH.iter().find(|(word, _)| *word == plain.to_lowercase()).map(|(_, ours)| *ours)
}

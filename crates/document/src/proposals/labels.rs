//! Words of labels that say what a value is, in the languages of documents.

/// Meaning of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    Period,
    AngularFrequency,
    Frequency,
    DampingRate,
    HalfLife,
    TimeConstant,
}

/// Words of each meaning. The first that is found counts.
const MEANINGS: [(Meaning, &[&str]); 6] = [
    (Meaning::HalfLife, &["half-life", "half life", "semivida", "período de semidesintegración", "meia-vida"]),
    (
        Meaning::TimeConstant,
        &["time constant", "mean lifetime", "constante de tiempo", "vida media", "constante de tempo"],
    ),
    (
        Meaning::DampingRate,
        &["damping rate", "tasa de amortiguamiento", "tasa de amortiguación", "taxa de amortecimento"],
    ),
    (Meaning::Period, &["period", "período"]),
    (
        Meaning::AngularFrequency,
        &["angular frequency", "frecuencia angular", "pulsación", "frequência angular", "pulsação"],
    ),
    (Meaning::Frequency, &["frequency", "frecuencia", "frequência"]),
];

/// Words that a period or frequency is that of small or free oscillations.
const FREE: [&str; 14] = [
    "natural",
    "small",
    "without damping",
    "undamped",
    "free",
    "pequeñ",
    "sin amortig",
    "propia",
    "libre",
    "pequen",
    "sem amortec",
    "própri",
    "livre",
    "of the formula",
];

/// Words for the position of an equilibrium.
const REST: [&str; 8] = [
    "rest position",
    "position at rest",
    "equilibrium position",
    "position of equilibrium",
    "posición de equilibrio",
    "posición de reposo",
    "posição de equilíbrio",
    "posição de repouso",
];

/// Ends of a label for a value in equilibrium.
const AT_EQUILIBRIUM: [&str; 4] = [" at equilibrium", " en equilibrio", " en el equilibrio", " em equilíbrio"];

/// Ends of a label for a value at the start.
const AT_START: [&str; 7] =
    [" at the start", " at start", " al inicio", " al principio", " al comienzo", " no início", " no começo"];

/// Beginnings of a label for a value at the start, and ends that say the same.
const INITIAL: [&str; 1] = ["initial "];
const INITIAL_ENDS: [&str; 1] = [" inicial"];

const GRAVITY: [&str; 3] = ["gravit", "of gravity", "gravedad"];
const HEIGHT: [&str; 5] = ["height", "upwards", "altura", "hacia arriba", "para cima"];

fn has(label: &str, words: &[&str]) -> bool {
    let label = label.to_lowercase();
    words.iter().any(|word| label.contains(word))
}

/// Meaning of a label of a period, a frequency or a time of decay.
pub fn meaning(label: &str) -> Option<Meaning> {
    MEANINGS.iter().find(|(_, words)| has(label, words)).map(|(meaning, _)| *meaning)
}

/// True if a label is about small, free or undamped oscillations.
pub fn is_free(label: &str) -> bool {
    has(label, &FREE)
}

/// True for a label of an energy.
pub fn is_energy(label: &str) -> bool {
    has(label, &["energ"])
}

/// True for a label of the acceleration of gravity.
pub fn is_gravity(label: &str) -> bool {
    has(label, &GRAVITY)
}

/// True for a label of a quantity that grows upwards.
pub fn is_height(label: &str) -> bool {
    has(label, &HEIGHT)
}

/// True for a label of a position of equilibrium.
pub fn is_rest(label: &str) -> bool {
    has(label, &REST)
}

/// The label without its words for equilibrium.
pub fn without_equilibrium(label: &str) -> Option<String> {
    let label = label.to_lowercase();
    AT_EQUILIBRIUM.iter().find_map(|end| label.strip_suffix(end)).map(str::to_owned)
}

/// The label of a value at the start without the words that say so.
pub fn without_start(label: &str) -> Option<String> {
    let label = label.to_lowercase();
    let ends = AT_START.iter().chain(&INITIAL_ENDS).find_map(|end| label.strip_suffix(end));
    ends.or_else(|| INITIAL.iter().find_map(|start| label.strip_prefix(start))).map(str::to_owned)
}

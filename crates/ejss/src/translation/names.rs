//! Names of the document for the names of a simulation.

use super::run::LOCAL;
use std::collections::{BTreeMap, BTreeSet};
use units::alphabet::{greek_name, without_accent};

/// Separates the name of a function from that of its argument in a key.
pub(super) const ARGUMENT: char = '\u{3}';

/// Words of the language at the beginning of a statement or inside one.
const WORDS: [&str; 43] = [
    "parameter",
    "independent",
    "when",
    "in",
    "step",
    "if",
    "then",
    "else",
    "and",
    "or",
    "not",
    "pi",
    "switch",
    "choice",
    "group",
    "function",
    "table",
    "smooth",
    "steps",
    "drawn",
    "random",
    "next",
    "size",
    "hidden",
    "button",
    "every",
    "let",
    "stop",
    "as",
    "from",
    "until",
    "assigned",
    "for",
    "true",
    "false",
    "on",
    "off",
    "by",
    "discrete",
    "at",
    "end",
    "against",
    "within",
];

/// Functions of the language.
const FUNCTIONS: [&str; 43] = [
    "sqrt",
    "cbrt",
    "abs",
    "sign",
    "exp",
    "ln",
    "log",
    "log10",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "floor",
    "ceil",
    "round",
    "min",
    "max",
    "sum",
    "mod",
    "hypot",
    "norm",
    "dot",
    "cross",
    "coulomb",
    "uniform",
    "normal",
    "maximum",
    "minimum",
    "mean",
    "integral",
    "count",
    "histogram",
    "points",
    "frequency",
];

/// Spelling of every key.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    spellings: BTreeMap<String, String>,
    taken: BTreeSet<String>,
}

impl Names {
    /// Gives a key its name. Returns the new name if it differs from the one in the simulation.
    pub fn declare(&mut self, key: &str) -> Option<String> {
        if self.spellings.contains_key(key) {
            return None;
        }
        let original = original(key);
        let name = self.free(original);
        self.spellings.insert(key.to_owned(), name.clone());
        (name != original).then_some(name)
    }

    /// Gives an argument of a function its name, which none of `used` has.
    pub fn declare_argument(&mut self, key: &str, used: &BTreeSet<String>) {
        let mut name = usable(key.rsplit(ARGUMENT).next().unwrap_or_default());
        while used.contains(&name) {
            name.insert(0, 'v');
        }
        self.spellings.insert(key.to_owned(), name);
    }

    /// A name for something that the simulation does not name.
    pub fn invent(&mut self, wanted: &str) -> String {
        let name = self.free(wanted);
        self.spellings.insert(format!("{name}{LOCAL}"), name.clone());
        name
    }

    /// A name for an event: no name of a quantity, but functions may have it.
    pub fn invent_event(&mut self, wanted: &str) -> String {
        if FUNCTIONS.contains(&wanted) && self.taken.insert(wanted.to_owned()) {
            wanted.to_owned()
        } else {
            self.invent(wanted)
        }
    }

    pub fn spelling(&self, key: &str) -> String {
        self.spellings.get(key).cloned().unwrap_or_else(|| usable(original(key)))
    }

    fn free(&mut self, wanted: &str) -> String {
        let base = usable(wanted);
        let further = (2..).map(|number| format!("{base}_{number}"));
        let mut candidates = [base.clone(), format!("v{base}")].into_iter().chain(further);
        let name = candidates.find(|name| !self.taken.contains(&folded(name))).unwrap_or(base);
        self.taken.insert(folded(&name));
        name
    }
}

/// Name in the simulation of a key.
pub(super) fn original(key: &str) -> &str {
    key.split([LOCAL, ARGUMENT]).next().unwrap_or_default()
}

/// A name that the language reads as one: letters, digits and single `_`, no word of its own.
fn usable(name: &str) -> String {
    let mut usable = String::new();
    for letter in name.chars() {
        let letter = without_accent(letter);
        match letter {
            '_' if usable.is_empty() || usable.ends_with('_') => {}
            _ if letter.is_ascii_alphanumeric() || letter == '_' => usable.push(letter),
            _ => usable.push_str(greek_name(letter).unwrap_or_default()),
        }
    }
    let usable = usable.trim_end_matches('_');
    let is_word = WORDS.contains(&usable) || FUNCTIONS.contains(&usable);
    if usable.is_empty() || is_word || usable.starts_with(|first: char| first.is_ascii_digit()) {
        return format!("v{usable}");
    }
    usable.to_owned()
}

/// Names that the language takes for one have one folded form.
fn folded(name: &str) -> String {
    name.replace('_', "")
}

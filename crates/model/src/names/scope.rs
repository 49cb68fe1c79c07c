//! Meanings of the names of a model.

use crate::tables::TableFunction;
use program::functions::FUNCTIONS;
use rustc_hash::FxHashMap;
use std::collections::HashMap;
use units::nearest;

/// Meaning of a name. The numbers are indices in the order of declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Meaning {
    /// A number the user can change.
    Parameter(usize),
    /// A quantity that an expression defines.
    Definition(usize),
    /// An unknown function of the independent variable, which the equations determine.
    Variable(usize),
    /// The independent variable.
    Independent,
    /// 3.14159...
    Pi,
}

/// The names of a model.
#[derive(Clone, Debug)]
pub(crate) struct Scope {
    /// The name of the independent variable.
    pub independent: String,
    meanings: FxHashMap<String, Meaning>,
    /// In the order of declaration, so that suggestions do not depend on the hash.
    names: Vec<String>,
    /// User-defined functions, including tables.
    functions: Vec<String>,
    /// Functions defined by tables.
    tables: HashMap<String, TableFunction>,
    /// Texts that each choice can have.
    choices: HashMap<String, Vec<String>>,
    /// Labels in lower case, each with its name.
    labels: Vec<(String, String)>,
}

/// Names of functions in other languages that are too different to be found as misspellings.
const FOREIGN_FUNCTIONS: [(&str, &[&str]); 11] = [
    ("sqrt", &["raiz", "raíz", "root", "wurzel", "racine"]),
    ("sin", &["sen", "seno"]),
    ("cos", &["coseno"]),
    ("tan", &["tg", "tang", "tangente"]),
    ("asin", &["arcsen", "arcsin", "asen"]),
    ("acos", &["arccos"]),
    ("atan", &["arctan", "arctg", "atg"]),
    ("abs", &["fabs", "valabs", "betrag"]),
    ("floor", &["int", "trunc", "entero"]),
    ("max", &["maximo", "máximo"]),
    ("min", &["minimo", "mínimo"]),
];

/// Name of the constant.
pub(crate) const PI: &str = "pi";

impl Scope {
    /// Scope with only `pi` and the independent variable.
    pub fn new(independent: &str) -> Self {
        let mut scope = Self {
            independent: independent.to_owned(),
            meanings: FxHashMap::default(),
            names: Vec::new(),
            functions: Vec::new(),
            tables: HashMap::new(),
            choices: HashMap::new(),
            labels: Vec::new(),
        };
        scope.declare(PI, Meaning::Pi);
        scope.declare(independent, Meaning::Independent);
        scope
    }

    /// Declares a name, unless it is already declared.
    pub fn declare(&mut self, name: &str, meaning: Meaning) {
        if !self.meanings.contains_key(name) {
            self.meanings.insert(name.to_owned(), meaning);
            self.names.push(name.to_owned());
        }
    }

    /// Replaces the meaning of a name, or removes it with `None`. Returns the former meaning; the same call with it
    /// restores the scope.
    pub fn exchange(&mut self, name: &str, meaning: Option<Meaning>) -> Option<Meaning> {
        match meaning {
            Some(meaning) => self.meanings.insert(name.to_owned(), meaning),
            None => self.meanings.remove(name),
        }
    }

    /// Declares user-defined functions.
    pub fn declare_functions<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        self.functions.extend(names.into_iter().map(str::to_owned));
    }

    /// Declares a function defined by a table.
    pub fn declare_table(&mut self, name: &str, table: TableFunction) {
        self.declare_functions([name]);
        self.tables.insert(name.to_owned(), table);
    }

    /// The table with that name.
    pub fn table(&self, name: &str) -> Option<&TableFunction> {
        self.tables.get(name)
    }

    /// Declares the texts that the value of a name can have.
    pub fn declare_choice(&mut self, name: &str, texts: Vec<String>) {
        self.choices.insert(name.to_owned(), texts);
    }

    /// Adds the author's label of a name.
    pub fn declare_label(&mut self, name: &str, label: Option<&str>) {
        self.labels.extend(label.map(|label| (label.to_lowercase(), name.to_owned())));
    }

    /// The only name whose label is `words` or begins with these words, underscores read as blanks: `m` for `mass`. `None`
    /// if there are several.
    pub fn called(&self, words: &str) -> Option<&str> {
        let words = words.to_lowercase().replace('_', " ");
        let begins =
            |label: &str| label.strip_prefix(&words).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '));
        let mut found = self.labels.iter().filter(|(label, _)| begins(label)).map(|(_, name)| name.as_str());
        found.next().filter(|_| found.next().is_none())
    }

    /// Texts that the value of a name can have; `None` if it is not a choice.
    pub fn choice(&self, name: &str) -> Option<&[String]> {
        self.choices.get(name).map(Vec::as_slice)
    }

    /// True if there is a user-defined function of that name.
    pub fn is_function(&self, name: &str) -> bool {
        self.functions.iter().any(|function| function == name)
    }

    /// Meaning of a name.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        self.meanings.get(name).copied()
    }

    /// All names, in the order of declaration.
    pub fn names(&self) -> impl Iterator<Item = &str> + Clone {
        self.names.iter().map(String::as_str)
    }

    /// The declared name most similar to `name`.
    pub fn near(&self, name: &str) -> Option<&str> {
        nearest(name, self.names.iter().map(String::as_str))
    }

    /// The function that `name` probably means.
    pub fn near_function(&self, name: &str) -> Option<&str> {
        let foreign = FOREIGN_FUNCTIONS.iter().find(|(_, others)| others.contains(&name.to_lowercase().as_str()));
        if let Some((ours, _)) = foreign {
            return Some(ours);
        }
        let own = self.functions.iter().map(String::as_str);
        nearest(name, own.chain(FUNCTIONS.iter().map(|function| function.name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offers_the_name_that_was_meant() {
        let mut scope = Scope::new("t");
        for (index, name) in ["omega_0", "omega_d", "h_l", "L", "rho", "gamma"].into_iter().enumerate() {
            scope.declare(name, Meaning::Parameter(index));
        }
        for (written, meant) in [
            ("omega0", Some("omega_0")),
            ("omgea_d", Some("omega_d")),
            ("hl", Some("h_l")),
            ("l", Some("L")),
            ("Rho", Some("rho")),
            ("gama", Some("gamma")),
            ("q", None),
            ("temperature", None),
        ] {
            assert_eq!(scope.near(written), meant, "{written}");
        }
        scope.declare_functions(["drag"]);
        assert_eq!(scope.near_function("sine"), Some("sin"));
        assert_eq!(scope.near_function("squrt"), Some("sqrt"));
        assert_eq!(scope.near_function("darg"), Some("drag"));
    }
}

//! What each name of a model means.

use crate::tables::TableFunction;
use program::functions::FUNCTIONS;
use rustc_hash::FxHashMap;
use std::collections::HashMap;
use units::nearest;

/// What a name stands for. The numbers are indices in the order of declaration.
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
    /// In the order of declaration, so that offers do not depend on the hash.
    names: Vec<String>,
    /// The functions of the author's own.
    functions: Vec<String>,
    /// The functions that are given by tables.
    tables: HashMap<String, TableFunction>,
    /// The names of choices with their texts.
    choices: HashMap<String, Vec<String>>,
    /// The labels of names, in small letters.
    labels: Vec<(String, String)>,
}

/// Functions as other languages and programs call them, which are too far from ours to be taken for a slip.
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

/// The name of the constant.
pub(crate) const PI: &str = "pi";

impl Scope {
    /// Only `pi` and the independent variable.
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

    /// Gives a name a meaning, unless it has one already.
    pub fn declare(&mut self, name: &str, meaning: Meaning) {
        if !self.meanings.contains_key(name) {
            self.meanings.insert(name.to_owned(), meaning);
            self.names.push(name.to_owned());
        }
    }

    /// Gives a name another meaning, or none. Returns the former one, with which the same call takes this back.
    pub fn exchange(&mut self, name: &str, meaning: Option<Meaning>) -> Option<Meaning> {
        match meaning {
            Some(meaning) => self.meanings.insert(name.to_owned(), meaning),
            None => self.meanings.remove(name),
        }
    }

    /// Declares functions of the author's own.
    pub fn declare_functions<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        self.functions.extend(names.into_iter().map(str::to_owned));
    }

    /// Declares a function that is given by a table.
    pub fn declare_table(&mut self, name: &str, table: TableFunction) {
        self.declare_functions([name]);
        self.tables.insert(name.to_owned(), table);
    }

    /// The function of that name, if it is given by a table.
    pub fn table(&self, name: &str) -> Option<&TableFunction> {
        self.tables.get(name)
    }

    /// Notes what texts the value of a name can be.
    pub fn declare_choice(&mut self, name: &str, texts: Vec<String>) {
        self.choices.insert(name.to_owned(), texts);
    }

    /// Notes how the author calls a name in words.
    pub fn declare_label(&mut self, name: &str, label: Option<&str>) {
        self.labels.extend(label.map(|label| (label.to_lowercase(), name.to_owned())));
    }

    /// The one name whose label is `words`, with blanks for underscores, or begins with them: `m` for `mass`.
    pub fn called(&self, words: &str) -> Option<&str> {
        let words = words.to_lowercase().replace('_', " ");
        let begins =
            |label: &str| label.strip_prefix(&words).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '));
        let mut found = self.labels.iter().filter(|(label, _)| begins(label)).map(|(_, name)| name.as_str());
        found.next().filter(|_| found.next().is_none())
    }

    /// The texts that the value of a name can be; `None` if it is no choice.
    pub fn choice(&self, name: &str) -> Option<&[String]> {
        self.choices.get(name).map(Vec::as_slice)
    }

    /// Whether the author has a function of that name.
    pub fn is_function(&self, name: &str) -> bool {
        self.functions.iter().any(|function| function == name)
    }

    /// What a name means.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        self.meanings.get(name).copied()
    }

    /// All names, in the order of declaration.
    pub fn names(&self) -> impl Iterator<Item = &str> + Clone {
        self.names.iter().map(String::as_str)
    }

    /// The declared name that `name` was probably meant to be.
    pub fn near(&self, name: &str) -> Option<&str> {
        nearest(name, self.names.iter().map(String::as_str))
    }

    /// The function that `name` was probably meant to be.
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

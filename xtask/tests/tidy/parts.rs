//! Check of objects that are made of owned parts: who can change a type, and how much of it others see.

use crate::texts::{product, root, texts};
use std::collections::{BTreeMap, BTreeSet};

/// Crates made of such parts, and the object whose methods are their wiring.
const OWNERS: [(&str, &str); 2] = [("desk", "Desk"), ("play", "Play")];

/// Maximum number of public methods of a type.
const MOST_METHODS: usize = 40;

/// A type of a crate, from its definition and all blocks of methods.
#[derive(Default)]
struct Found {
    /// Fields that other modules than the folder of the type can change.
    open_fields: Vec<String>,
    /// True if a method changes it.
    changes: bool,
    public_methods: usize,
    /// Files with methods of its own.
    files: BTreeSet<String>,
}

/// Name of the type of an `impl` block, and true if the block is of no trait. Other lines have none.
fn implemented(line: &str) -> Option<(&str, bool)> {
    let rest = line.strip_prefix("impl")?;
    let rest = match rest.strip_prefix('<') {
        Some(generics) => &generics[generics.find("> ")? + 1..],
        None => rest,
    };
    let (of_trait, own) = match rest.split_once(" for ") {
        Some((_, own)) => (true, own),
        None => (false, rest),
    };
    Some((name_in(own)?, !of_trait))
}

/// Identifier at the start of a text.
fn name_in(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    (end > 0).then(|| &text[..end])
}

/// Name of the field of a line that is visible in the whole crate or beyond it.
fn open_field(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("    pub ").or_else(|| line.strip_prefix("    pub(crate) "))?;
    rest.split_once(':').map(|(name, _)| name)
}

/// The types of a crate, by name. Texts are formatted: items and the ends of their blocks stand at the start of a line.
fn types<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> BTreeMap<String, Found> {
    let mut found: BTreeMap<String, Found> = BTreeMap::new();
    for (file, text) in files {
        // Type of the present block, and true in its methods.
        let mut block: Option<(&str, bool)> = None;
        for line in product(text).lines() {
            let of_struct =
                line.split_once("struct ").filter(|(before, _)| before.is_empty() || before.starts_with("pub"));
            if let Some(name) = of_struct.and_then(|(_, rest)| name_in(rest)) {
                if line.contains("(pub ") || line.contains("(pub(crate) ") {
                    found.entry(name.to_owned()).or_default().open_fields.push("0".to_owned());
                }
                block = line.ends_with('{').then_some((name, false));
            } else if let Some((name, is_own)) = implemented(line) {
                if is_own {
                    found.entry(name.to_owned()).or_default().files.insert(file.to_owned());
                }
                block = Some((name, true));
            } else if line == "}" {
                block = None;
            } else if let Some((name, is_method)) = block {
                let of_type = found.entry(name.to_owned()).or_default();
                if is_method {
                    of_type.changes |= line.contains("&mut self");
                    of_type.public_methods += usize::from(line.starts_with("    pub fn "));
                } else {
                    of_type.open_fields.extend(open_field(line).map(str::to_owned));
                }
            }
        }
    }
    found
}

/// What breaks the rules in the types of a crate.
fn faults(types: &BTreeMap<String, Found>, owner: &str) -> Vec<String> {
    let mut faults = Vec::new();
    for (name, found) in types {
        if found.changes && !found.open_fields.is_empty() {
            faults.push(format!("{name} has methods that change it and open fields: {}", found.open_fields.join(", ")));
        }
        if found.public_methods > MOST_METHODS {
            faults.push(format!("{name} has {} public methods", found.public_methods));
        }
        if owner == name && found.files.len() != 1 {
            faults.push(format!("methods of {name} stand in {} files", found.files.len()));
        }
    }
    faults
}

#[test]
fn parts_own_their_state() {
    for (name, owner) in OWNERS {
        let mut sources = Vec::new();
        texts(&root().join("crates").join(name).join("src"), &mut sources);
        let files: Vec<(String, String)> =
            sources.into_iter().map(|(path, text)| (path.display().to_string(), text)).collect();
        let types = types(files.iter().map(|(path, text)| (path.as_str(), text.as_str())));
        assert!(types.get(owner).is_some_and(|found| found.changes), "crates/{name} has no {owner}");
        let faults = faults(&types, owner);
        assert!(faults.is_empty(), "crates/{name}: {faults:#?}");
    }
}

#[test]
fn broken_rules_are_found() {
    let part = "pub struct Part {\n    pub(crate) open: u32,\n    pub(super) own: u32,\n    closed: u32,\n}\n";
    let reads = "impl Part {\n    pub fn open(&self) -> u32 {\n        self.open\n    }\n}\n";
    let changes = "impl<'a, T: Fn()> Part<'a> {\n    pub fn change(\n        &mut self,\n    ) {\n    }\n}\n";
    let of_trait = "impl Workers for Part {\n    fn begin(&mut self) {}\n}\n";
    let found = |texts: &[&str]| {
        let texts: Vec<(String, &str)> = texts.iter().enumerate().map(|(at, text)| (at.to_string(), *text)).collect();
        faults(&types(texts.iter().map(|(name, text)| (name.as_str(), *text))), "Part")
    };
    assert_eq!(found(&[part, reads]), Vec::<String>::new(), "plain data may be open");
    assert_eq!(
        found(&[part, reads, changes]),
        ["Part has methods that change it and open fields: open", "methods of Part stand in 2 files"]
    );
    assert_eq!(found(&[part, reads, of_trait]), ["Part has methods that change it and open fields: open"]);
    assert_eq!(
        found(&["pub(crate) struct Part(pub u32);\n", of_trait, "impl Part {}\n"]),
        ["Part has methods that change it and open fields: 0"]
    );
    let many = format!("impl Part {{\n{}}}\n", "    pub fn a(&self) {}\n".repeat(41));
    assert_eq!(found(&[&many]), ["Part has 41 public methods"]);
    assert_eq!(found(&[&many.replace("pub fn", "pub(crate) fn")]), Vec::<String>::new());
}

//! Code size of a module by crate. Each function is counted for the crate in its name from the name section.

use crate::steps;
use anyhow::{Context, Result};
use rustc_demangle::demangle;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use wasmparser::{KnownCustom, Name, Parser, Payload, TypeRef};

/// Crates below this size in bytes are summed.
const LEAST: usize = 2_000;

/// Prints the size of the code of each crate in kB, the largest first, and the size of the data.
pub fn print(module: &Path) -> Result<()> {
    let bytes = std::fs::read(module).with_context(|| format!("cannot read {}", module.display()))?;
    let (mut imported, mut data, mut sizes, mut names) = (0, 0, Vec::new(), HashMap::new());
    for payload in Parser::new(0).parse_all(&bytes) {
        match payload? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import?.ty, TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => sizes.push(body.range().len()),
            Payload::DataSection(section) => data = section.range().len(),
            Payload::CustomSection(section) => {
                let KnownCustom::Name(section) = section.as_known() else { continue };
                for part in section {
                    let Name::Function(functions) = part? else { continue };
                    for function in functions {
                        let function = function?;
                        names.insert(function.index, format!("{:#}", demangle(function.name)));
                    }
                }
            }
            _ => {}
        }
    }
    let own = own_crates()?;
    let mut by_crate: BTreeMap<String, usize> = BTreeMap::new();
    for (number, size) in (imported..).zip(&sizes) {
        let name = names.get(&number).map_or("", String::as_str);
        *by_crate.entry(crate_of(name, &own)).or_default() += size;
    }
    let mut heaviest: Vec<(String, usize)> = by_crate.into_iter().collect();
    heaviest.sort_by_key(|(_, size)| std::cmp::Reverse(*size));
    let (heavy, light): (Vec<_>, Vec<_>) = heaviest.into_iter().partition(|(_, size)| *size >= LEAST);
    let rest: usize = light.iter().map(|(_, size)| size).sum();
    let line = |name: &str, size: usize| println!("  {name:24}{:8.1} kB", size as f64 / 1000.0);
    heavy.iter().for_each(|(name, size)| line(name, *size));
    line("other crates", rest);
    line("data", data);
    Ok(())
}

/// Names of the crates of the workspace.
fn own_crates() -> Result<Vec<String>> {
    let directory = steps::root().join("crates");
    let entries = std::fs::read_dir(&directory).with_context(|| format!("cannot read {}", directory.display()))?;
    entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect()
}

/// Crate of a function: the first crate of the workspace in its name, otherwise the first crate in it.
fn crate_of(name: &str, own: &[String]) -> String {
    let words: Vec<&str> = name.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).collect();
    let paths =
        name.split("::").filter_map(|part| part.rsplit(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).next());
    let of_workspace = paths.clone().find(|word| own.iter().any(|own| own == word));
    let first = || words.iter().copied().find(|word| !word.is_empty() && *word != "impl");
    let found = of_workspace.or_else(|| if name.contains("::") { first() } else { None });
    found.unwrap_or("no path in Rust").to_owned()
}

#[cfg(test)]
mod tests {
    use super::crate_of;

    #[test]
    fn a_function_counts_for_the_crate_of_the_workspace_in_its_name() {
        let own = ["play", "view", "engine"].map(str::to_owned);
        for (name, expected) in [
            ("play::plots::plot::<impl play::play::Play>::figure_of", "play"),
            ("core::ptr::drop_in_place<core::option::Option<play::play::Play>>", "play"),
            ("core::fmt::write", "core"),
            ("<alloc::string::String as core::fmt::Write>::write_str", "alloc"),
            ("view::views::changing::{{closure}}", "view"),
            ("memcpy", "no path in Rust"),
        ] {
            assert_eq!(crate_of(name, &own), expected, "{name}");
        }
    }
}

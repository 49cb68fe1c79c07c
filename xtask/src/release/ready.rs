//! Conditions of a release.

use super::version::VERSION;
use crate::steps::{self, output};
use anyhow::{Context, Result, bail, ensure};
use std::path::Path;

/// Files that could state a version of their own.
const STATE_VERSIONS: [&str; 4] =
    ["CITATION.cff", "crates/python/pyproject.toml", "crates/lab/editor/package.json", "tests/page/package.json"];

/// Notes of this version, from `CHANGELOG.md`. Refuses a state of the repository that is no release.
pub fn notes(root: &Path) -> Result<String> {
    let changed = output(&mut steps::program("git", &["status", "--porcelain"]))?;
    ensure!(changed.is_empty(), "commit these changes first:\n{changed}");
    let tag = format!("v{VERSION}");
    let mut tags = steps::program("git", &["tag", "--list", &tag, "--no-contains", "HEAD"]);
    ensure!(output(&mut tags)?.is_empty(), "{tag} is released already: raise `version` in Cargo.toml");
    for file in STATE_VERSIONS {
        same_version(&read(root, file)?, VERSION).with_context(|| file.to_owned())?;
    }
    of_version(&read(root, "CHANGELOG.md")?, VERSION)
}

fn read(root: &Path, file: &str) -> Result<String> {
    std::fs::read_to_string(root.join(file)).with_context(|| format!("cannot read {file}"))
}

/// Refuses a text with a line that states another version.
fn same_version(text: &str, version: &str) -> Result<()> {
    const STATED: [&str; 3] = ["version: ", "version = ", "\"version\": "];
    for line in text.lines().map(str::trim) {
        let stated = STATED.iter().find_map(|beginning| line.strip_prefix(beginning));
        if let Some(stated) = stated.map(|stated| stated.trim_matches(['"', ','])) {
            ensure!(stated == version, "it states version {stated}, Cargo.toml {version}");
        }
    }
    Ok(())
}

/// Text below the first heading, which must be that of the version.
fn of_version(changes: &str, version: &str) -> Result<String> {
    let Some((_, first)) = changes.split_once("\n## ") else { bail!("CHANGELOG.md has no heading of a version") };
    let (heading, rest) = first.split_once('\n').unwrap_or((first, ""));
    let named = heading.split_whitespace().next().unwrap_or_default();
    ensure!(named == version, "CHANGELOG.md begins with «{heading}»: its first heading must name version {version}");
    let notes = rest.split("\n## ").next().unwrap_or_default().trim();
    ensure!(!notes.is_empty(), "CHANGELOG.md says nothing about version {version}");
    Ok(format!("{notes}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_are_those_of_the_first_heading() {
        let changes = "# Changes\n\nText.\n\n## 0.2.0 (2026-12-01)\n\n### Page\n\n- New.\n\n## 0.1.0\n\n- Old.\n";
        assert_eq!(of_version(changes, "0.2.0").unwrap(), "### Page\n\n- New.\n");
        let refused =
            [changes.replace("0.2.0 (2026-12-01)", "Unreleased"), changes.replace("### Page\n\n- New.\n\n", "")];
        for text in refused.iter().map(String::as_str).chain(["# Changes\n"]) {
            assert!(of_version(text, "0.2.0").is_err(), "{text}");
        }
        assert!(of_version(changes, "0.3.0").is_err());
    }

    #[test]
    fn documents_have_the_addresses_of_the_workspace() {
        let docs = std::fs::read_dir(steps::root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
        let documents = docs.filter(|path| path.extension().is_some_and(|ending| ending == "md"));
        for path in documents.chain(["README.md", "SECURITY.md"].map(|name| steps::root().join(name))) {
            let text = std::fs::read_to_string(&path).unwrap();
            let is_end = |letter: char| !letter.is_alphanumeric() && !"-./".contains(letter);
            let addresses = text.split("https://").skip(1).map(|rest| rest.split(is_end).next().unwrap_or_default());
            for address in addresses.filter(|address| address.split('/').next().unwrap().contains("meniscus")) {
                let own = [env!("CARGO_PKG_HOMEPAGE"), env!("CARGO_PKG_REPOSITORY")]
                    .map(|own| own.trim_start_matches("https://"));
                assert!(own.iter().any(|own| address.starts_with(own)), "{}: https://{address}", path.display());
            }
        }
    }

    #[test]
    fn every_stated_version_is_that_of_the_workspace() {
        for text in ["version: 0.2.0\n", "dynamic = [\"version\"]\n", "  \"version\": \"0.2.0\",\n"] {
            assert!(same_version(text, "0.2.0").is_ok(), "{text}");
        }
        for text in ["version: 0.1.0\n", "version = \"0.2\"\n", "  \"version\": \"1.0.0\",\n"] {
            assert!(same_version(text, "0.2.0").is_err(), "{text}");
        }
        for file in STATE_VERSIONS {
            same_version(&read(&steps::root(), file).unwrap(), VERSION).expect(file);
        }
    }
}

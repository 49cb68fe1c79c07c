//! Packages of others that are in what is published: their licences, and a bill of materials (CycloneDX 1.5). Both follow from the lock files.

use super::version::VERSION;
use crate::steps::{self, output};
use crate::tools;
use anyhow::{Context, Result};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Packages of the workspace that are published, with all that they are made of.
const PUBLISHED: [&str; 5] = ["meniscus", "player", "lab", "python", "pyodide"];

/// A package of somebody else.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Component {
    name: String,
    version: String,
    /// SPDX expression.
    licence: String,
    /// `cargo` or `npm`.
    registry: &'static str,
    /// Folder with its sources.
    folder: PathBuf,
}

/// Writes the licences as one text, and the bill of materials.
pub fn write(licences: &Path, bill: &Path) -> Result<()> {
    let mut metadata = steps::cargo(&["metadata", "--format-version", "1", "--locked"]);
    let metadata: Value = serde_json::from_str(&output(&mut metadata)?)?;
    let editor = steps::root().join("crates").join("lab").join("editor");
    tools::packages(&editor)?;
    let lock: Value = serde_json::from_str(&fs::read_to_string(editor.join("package-lock.json"))?)?;
    let mut components = crates(&metadata).context("cargo metadata has another form")?;
    components.extend(scripts(&lock, &editor).context("package-lock.json has another form")?);
    components.sort();
    fs::write(licences, texts(&components)?)?;
    fs::write(bill, serde_json::to_string_pretty(&bill_of(&components))? + "\n")?;
    println!("{} packages", components.len());
    Ok(())
}

/// Crates from registries that published packages are compiled of, on any system. Tools of builds and tests are not in them.
fn crates(metadata: &Value) -> Option<Vec<Component>> {
    let nodes = metadata["resolve"]["nodes"].as_array()?;
    let uses: BTreeMap<&str, &Value> =
        nodes.iter().filter_map(|node| Some((node["id"].as_str()?, &node["deps"]))).collect();
    let packages = metadata["packages"].as_array()?;
    let is_published =
        |package: &&Value| package["source"].is_null() && PUBLISHED.iter().any(|name| package["name"] == *name);
    let mut open: Vec<&str> =
        packages.iter().filter(is_published).filter_map(|package| package["id"].as_str()).collect();
    let mut reached = BTreeSet::new();
    while let Some(id) = open.pop() {
        if reached.insert(id) {
            let is_compiled = |used: &&Value| {
                used["dep_kinds"].as_array().is_some_and(|kinds| kinds.iter().any(|kind| kind["kind"].is_null()))
            };
            open.extend(uses.get(id)?.as_array()?.iter().filter(is_compiled).filter_map(|used| used["pkg"].as_str()));
        }
    }
    let foreign = packages.iter().filter(|package| !package["source"].is_null());
    foreign
        .filter(|package| package["id"].as_str().is_some_and(|id| reached.contains(id)))
        .map(|package| {
            let text = |field: &str| package[field].as_str().map(str::to_owned);
            Some(Component {
                name: text("name")?,
                version: text("version")?,
                // Old packages write alternatives with a slash.
                licence: text("license").unwrap_or_default().replace('/', " OR "),
                registry: "cargo",
                folder: Path::new(package["manifest_path"].as_str()?).parent()?.to_owned(),
            })
        })
        .collect()
}

/// Packages of npm that are bundled into the editor.
fn scripts(lock: &Value, folder: &Path) -> Option<Vec<Component>> {
    let packages = lock["packages"].as_object()?;
    let bundled = packages.iter().filter(|(path, package)| !path.is_empty() && package["dev"] != true);
    bundled
        .map(|(path, package)| {
            Some(Component {
                name: path.rsplit_once("node_modules/")?.1.to_owned(),
                version: package["version"].as_str()?.to_owned(),
                licence: package["license"].as_str().unwrap_or_default().to_owned(),
                registry: "npm",
                folder: folder.join(path),
            })
        })
        .collect()
}

/// A list of all components, then each text of a licence once, with the components that have it.
fn texts(components: &[Component]) -> Result<String> {
    let mut texts = BTreeMap::<String, Vec<String>>::new();
    let mut all = format!("Meniscus {VERSION} contains these packages of others, under their licences.\n\n");
    for component in components {
        let Component { name, version, licence, folder, .. } = component;
        all += &format!("{name} {version}: {licence}\n");
        for text in licence_files(folder)? {
            texts.entry(text).or_default().push(format!("{name} {version}"));
        }
    }
    let font = steps::root().join("crates").join("view").join("page").join("math-font.txt");
    texts.entry(fs::read_to_string(font)?).or_default().push("New Computer Modern Math".to_owned());
    for (text, names) in texts {
        all += &format!("\n{}\n{}\n\n{}\n", "=".repeat(80), names.join(", "), text.trim());
    }
    Ok(all)
}

/// Texts of the licences in a folder.
fn licence_files(folder: &Path) -> Result<Vec<String>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        if path.is_file() && ["LICEN", "COPYING", "NOTICE", "UNLICENSE"].iter().any(|start| name.starts_with(start)) {
            paths.push(path);
        }
    }
    paths.sort();
    paths.iter().map(|path| Ok(fs::read_to_string(path)?.replace("\r\n", "\n"))).collect()
}

/// Bill of materials.
fn bill_of(components: &[Component]) -> Value {
    let listed = components.iter().map(|Component { name, version, licence, registry, .. }| {
        json!({
            "type": "library",
            "name": name,
            "version": version,
            "licenses": [{ "expression": licence }],
            "purl": format!("pkg:{registry}/{}@{version}", name.replace('@', "%40")),
        })
    });
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "meniscus", "version": VERSION } },
        "components": listed.collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_those_that_are_compiled_in() {
        let package = |name: &str, source: Value| json!({ "id": name, "name": name, "version": "1.0.0", "source": source, "license": "MIT/Apache-2.0", "manifest_path": format!("/x/{name}/Cargo.toml") });
        let used = |name: &str, kind: Value| json!({ "pkg": name, "dep_kinds": [{ "kind": kind }] });
        let registry = json!("registry");
        let metadata = json!({
            "packages": [package("meniscus", Value::Null), package("a", registry.clone()), package("b", registry.clone()), package("c", registry)],
            "resolve": { "nodes": [
                { "id": "meniscus", "deps": [used("a", Value::Null), used("c", json!("dev"))] },
                { "id": "a", "deps": [used("b", json!("build"))] },
                { "id": "b", "deps": [] },
                { "id": "c", "deps": [] },
            ] },
        });
        let found = crates(&metadata).unwrap();
        assert_eq!(
            found.iter().map(|one| (one.name.as_str(), one.licence.as_str())).collect::<Vec<_>>(),
            [("a", "MIT OR Apache-2.0")]
        );
        let lock = json!({ "packages": { "": {}, "node_modules/@x/y": { "version": "2.0.0", "license": "MIT" }, "node_modules/z": { "version": "1.0.0", "dev": true } } });
        let scripts = scripts(&lock, Path::new("/e")).unwrap();
        let bill = bill_of(&scripts);
        assert_eq!(bill["components"].as_array().map(Vec::len), Some(1));
        assert_eq!(bill["components"][0]["purl"], "pkg:npm/%40x/y@2.0.0");
    }
}

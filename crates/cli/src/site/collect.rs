//! Collection of the documents of a folder, in the order of the site.

use super::names::{INDEX, LABORATORY};
use crate::failure::Failure;
use crate::load;
use crate::terminal::Terminal;
use document::page::Source;
use document::{BlockKind, Document};
use runner::Loaded;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use units::{percent_encoded, say};

/// Maximum length of the path of a document in bytes; it is also that of a link to it.
const LONGEST_NAME: usize = 200;

/// A document that becomes a page.
#[derive(Debug)]
pub struct Simulation {
    /// Path below the folder, with slashes and without `.md`: `theories/linear`.
    pub name: String,
    /// Files of the document, the base first.
    files: Vec<Source>,
    /// The document.
    pub document: Document,
}

impl Simulation {
    /// Path of its page in the site.
    pub fn page(&self) -> String {
        format!("{}.html", self.name)
    }

    /// Path of its folder; empty at the top level.
    pub fn folder(&self) -> &str {
        self.name.rsplit_once('/').map_or("", |(folder, _)| folder)
    }

    /// Depth of its folder below the top level.
    pub fn depth(&self) -> usize {
        self.name.matches('/').count()
    }

    /// Address of the laboratory with this document, relative to the top of the site.
    pub fn in_laboratory(&self) -> String {
        format!("{LABORATORY}#1&d={}.md", percent_encoded(&self.name))
    }

    /// Text of the document in a language; the base text if there is no such translation.
    pub fn text(&self, language: &str) -> &str {
        let document = &self.document;
        let mut translations = document.program.languages().skip(1).zip(&document.translations);
        let own = translations.find(|(tag, _)| *tag == language);
        own.map_or(&document.source, |(_, text)| text)
    }

    /// Files with their paths below the folder, as named in the library of the laboratory.
    pub fn library(&self) -> impl Iterator<Item = Source> {
        let folder = self.folder();
        let slash = if folder.is_empty() { "" } else { "/" };
        self.files
            .iter()
            .map(move |file| Source { name: [folder, slash, &file.name].concat(), text: file.text.clone() })
    }
}

/// Collects the documents below `directory`; those of a folder come before its subfolders. Reports findings in them and
/// names the files that are left out.
pub fn collect(directory: &Path, site: &Path, terminal: Terminal) -> Result<Vec<Simulation>, Failure> {
    let mut walk = Walk { site: site.canonicalize().ok(), ..Walk::default() };
    walk.folder(directory)?;
    let (mut simulations, mut translations, mut has_errors) = (Vec::new(), BTreeSet::new(), false);
    let (mut left_out, mut other_names) = (walk.others, Vec::new());
    for path in walk.texts {
        let sources = load::sources(&path)?;
        if sources.path() != path {
            // A translation is read with its document if its name matches that of the document.
            other_names.push((path, sources.path().to_owned()));
            continue;
        }
        let (_, text) = sources.texts().next().unwrap_or((&path, ""));
        if document::read(text).blocks_of(BlockKind::Model).next().is_none() {
            left_out.push(path);
            continue;
        }
        translations.extend(sources.texts().skip(1).map(|(path, _)| path.to_owned()));
        let loaded = Loaded::open(sources);
        terminal.report(&loaded);
        has_errors |= loaded.opened.has_errors();
        let files = loaded.sources.embedded();
        if let Some(document) = loaded.opened.document {
            let name = name_of(directory, &path)?;
            simulations.push((path, Simulation { name, files, document }));
        }
    }
    left_out.retain(|path| !translations.contains(path));
    simulations.retain(|(path, _)| !translations.contains(path));
    left_out.sort();
    name_left_out(&left_out, directory, terminal);
    for (path, base) in other_names.iter().filter(|(path, _)| !translations.contains(path)) {
        let (path, base) = (path.display(), base.with_extension(""));
        let base = base.display();
        terminal.print(&say!(
            terminal.language,
            "left out: {path} (to belong to {base}.md, it must be called {base}.LANGUAGE.md)\n"
        ));
    }
    if has_errors {
        return Err(Failure::Document);
    }
    let simulations: Vec<Simulation> = simulations.into_iter().map(|(_, simulation)| simulation).collect();
    if simulations.is_empty() {
        return Err(Failure::with_hint(
            format!("{} holds no simulation", directory.display()),
            "a simulation is a file NAME.md with its equations in a block that begins with a line \"```model\"",
        ));
    }
    check_names(&simulations)?;
    Ok(simulations)
}

#[derive(Default)]
struct Walk {
    /// Folder of the site, which may be inside the folder of the documents.
    site: Option<PathBuf>,
    texts: Vec<PathBuf>,
    others: Vec<PathBuf>,
}

impl Walk {
    /// Collects the files of a folder, then those of its subfolders, by name. Hidden files (leading dot) and links to
    /// folders, which may be circular, are left out.
    fn folder(&mut self, directory: &Path) -> Result<(), Failure> {
        let failure = |error| Failure::file("read", directory, &error);
        let entries = fs::read_dir(directory).map_err(failure)?;
        let mut paths =
            entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>().map_err(failure)?;
        paths.retain(|path| !path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.')));
        paths.sort();
        let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) = paths.into_iter().partition(|path| path.is_dir());
        let (texts, others): (Vec<PathBuf>, Vec<PathBuf>) =
            files.into_iter().partition(|path| path.extension().is_some_and(|ending| ending == "md"));
        self.texts.extend(texts);
        self.others.extend(others);
        for folder in folders.iter().filter(|folder| !folder.is_symlink()) {
            if self.site.is_none() || folder.canonicalize().ok() != self.site {
                self.folder(folder)?;
            }
        }
        Ok(())
    }
}

/// Name of a document in the site: its path below the folder without `.md`.
fn name_of(directory: &Path, path: &Path) -> Result<String, Failure> {
    let refused =
        |why: &str| Failure::with_hint(format!("{} cannot be an address: {why}", path.display()), "rename it");
    let below = path.strip_prefix(directory).unwrap_or(path).with_extension("");
    let names: Option<Vec<&str>> = below.iter().map(|name| name.to_str()).collect();
    let name = names.ok_or_else(|| refused("its name is not UTF-8"))?.join("/");
    if name.chars().any(char::is_control) {
        return Err(refused("there is a control character in its name"));
    }
    if name.len() > LONGEST_NAME {
        return Err(refused("its name is too long"));
    }
    Ok(name)
}

/// Refuses page names that collide with each other or with files of the site, regardless of case.
fn check_names(simulations: &[Simulation]) -> Result<(), Failure> {
    let mut names: BTreeMap<String, &str> = BTreeMap::new();
    for simulation in simulations {
        let (page, name) = (simulation.page().to_lowercase(), simulation.name.as_str());
        if page == INDEX || page == LABORATORY || page.starts_with("assets/") {
            return Err(Failure::with_hint(
                format!("{name}.md would take a place that the site needs: {page}"),
                "rename it or its folder",
            ));
        }
        if let Some(other) = names.insert(page, name) {
            return Err(Failure::with_hint(
                format!("{other}.md and {name}.md would be one page on some hosts"),
                "rename one of them",
            ));
        }
    }
    Ok(())
}

/// Prints the files that did not become a page; of many, only the first ones.
fn name_left_out(paths: &[PathBuf], directory: &Path, terminal: Terminal) {
    const NAMED: usize = 8;
    if paths.is_empty() {
        return;
    }
    let language = terminal.language;
    let names = paths.iter().map(|path| path.strip_prefix(directory).unwrap_or(path).display().to_string());
    let mut names: Vec<String> = names.collect();
    if names.len() > NAMED {
        let more = names.len() - NAMED;
        names.truncate(NAMED);
        names.push(say!(language, "{more} more"));
    }
    terminal.print(&say!(language, "left out, since there is no simulation in it: {}\n", language.join(&names)));
}

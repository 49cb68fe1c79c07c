//! `cargo xtask docs`: the documentation as one site with search, `target/page/docs`. Every example of the language plays where it
//! stands, by the element of `crates/player/element`.
//!
//! | module | content |
//! |---|---|
//! | `markdown.rs` | a page: headings with ids, links between pages, examples |
//! | `examples.rs` | an example: its document, compiled simulation and picture |
//! | `links.rs` | links that lead nowhere, which fail the build |
//!
//! It is not made with mdBook: that would be the largest program in CI, shows examples as text, and has no place for a compiled
//! simulation beside them. Markdown, pages and the element are in this workspace.

mod examples;
mod links;
mod markdown;

use crate::{editor, element, steps};
use anyhow::{Context, Result, bail};
use markdown::Page;
use std::fs;
use std::path::{Path, PathBuf};
use units::markup::escaped;

/// Pages in the order of their list, by groups. `index.md` is the first page.
const GROUPS: [(&str, &[&str]); 5] = [
    ("Begin", &["index", "questions", "first-simulation", "installing", "coming-from", "ejs"]),
    ("Write", &["language"]),
    ("Measure", &["data", "films"]),
    ("Publish and teach", &["publishing", "element", "courses", "class", "administration"]),
    ("Compute and develop", &["python", "assistants", "extending", "debugging"]),
];

/// Pages that are translations: name and language.
const TRANSLATIONS: [(&str, &str); 2] = [("ejs", "es"), ("courses", "es")];

/// Place of the site.
pub fn folder() -> PathBuf {
    steps::page().with_file_name("docs")
}

/// Builds the site. The page must have been built.
///
/// # Errors
/// A page is not listed or missing, a link leads nowhere, or an example cannot be opened or run.
pub fn build() -> Result<PathBuf> {
    let (source, folder) = (steps::root().join("docs"), folder());
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(folder.join("examples"))?;
    let mut pages = Vec::new();
    for name in names() {
        let path = source.join(format!("{name}.md"));
        let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        pages.push(Page::of(&name, &text)?);
    }
    all_are_listed(&source)?;
    for path in other_files(&source)? {
        let to = folder.join(path.strip_prefix(&source)?);
        fs::create_dir_all(to.parent().unwrap_or(&folder))?;
        fs::copy(&path, to)?;
    }
    let assets = steps::root().join("xtask/src/docs");
    let template = fs::read_to_string(assets.join("page.html"))?;
    for page in &pages {
        let html = filled(&template, page, &pages);
        fs::write(folder.join(format!("{}.html", page.name)), html)?;
        for example in &page.examples {
            example.write(&folder.join("examples"))?;
        }
    }
    for name in ["docs.css", "docs.js"] {
        fs::write(folder.join(name), editor::minified(&assets.join(name))?)?;
    }
    fs::write(folder.join("search.json"), search(&pages)?)?;
    copy(&element::folder(), &folder.join("meniscus"))?;
    let broken = links::broken(&pages, &folder);
    if !broken.is_empty() {
        bail!("links that lead nowhere:\n{}", broken.join("\n"));
    }
    let examples: usize = pages.iter().map(|page| page.examples.len()).sum();
    println!("{} pages, {examples} examples", pages.len());
    Ok(folder)
}

/// Names of all pages.
fn names() -> Vec<String> {
    let base = GROUPS.iter().flat_map(|(_, names)| names.iter().map(|name| (*name).to_owned()));
    base.chain(TRANSLATIONS.iter().map(|(name, language)| format!("{name}.{language}"))).collect()
}

fn all_are_listed(source: &Path) -> Result<()> {
    let names = names();
    for entry in fs::read_dir(source)? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_some_and(|ending| ending == "md") && !names.contains(&name) {
            bail!("docs/{name}.md is in no group of xtask/src/docs/mod.rs");
        }
    }
    Ok(())
}

/// Files of the documentation that are not pages: pictures, notebooks.
fn other_files(source: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![source.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_none_or(|ending| ending != "md") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    let entries =
        fs::read_dir(from).with_context(|| format!("{} is missing: run `cargo xtask page`", from.display()))?;
    for entry in entries {
        let entry = entry?;
        fs::copy(entry.path(), to.join(entry.file_name()))?;
    }
    Ok(())
}

/// A page of the site.
fn filled(template: &str, page: &Page, pages: &[Page]) -> String {
    let language = page.name.split_once('.').map_or("en", |(_, language)| language);
    let others: Vec<String> = TRANSLATIONS
        .iter()
        .filter(|(name, language)| page.name == *name || page.name == format!("{name}.{language}"))
        .map(|(name, language)| {
            let [address, tag, words] = if page.name == *name {
                [format!("{name}.{language}"), (*language).to_owned(), "Español".to_owned()]
            } else {
                [(*name).to_owned(), "en".to_owned(), "English".to_owned()]
            };
            format!(
                "<p class=\"languages\"><a href=\"{address}.html\" lang=\"{tag}\" hreflang=\"{tag}\">{words}</a></p>"
            )
        })
        .collect();
    [
        ("<!--language-->", language),
        ("<!--title-->", &escaped(&page.title)),
        ("<!--list-->", &list(page, pages)),
        ("<!--content-->", &(others.concat() + &page.html)),
    ]
    .into_iter()
    .fold(template.to_owned(), |html, (place, text)| html.replace(place, text))
}

/// List of all pages, with the sections of this one.
fn list(page: &Page, pages: &[Page]) -> String {
    let mut list = String::new();
    for (group, names) in GROUPS {
        list += &format!("<h2>{group}</h2><ul>");
        for other in names.iter().filter_map(|name| pages.iter().find(|page| page.name == **name)) {
            let is_own = other.name == page.name;
            let current = if is_own { " aria-current=\"page\"" } else { "" };
            list += &format!("<li><a href=\"{}.html\"{current}>{}</a>", other.name, escaped(&other.title));
            if is_own {
                let main = page.sections.iter().filter(|section| section.level == 2);
                let entries = main
                    .map(|section| format!("<li><a href=\"#{}\">{}</a></li>", section.id, escaped(&section.heading)));
                list += &format!("<ul>{}</ul>", entries.collect::<String>());
            }
            list += "</li>";
        }
        list += "</ul>";
    }
    list
}

/// Index of the search: a list of address, page, heading and words of each section.
fn search(pages: &[Page]) -> Result<String> {
    let sections = pages.iter().filter(|page| !page.name.contains('.')).flat_map(|page| {
        page.sections.iter().map(|section| {
            let address = format!("{}.html#{}", page.name, section.id);
            [address, page.title.clone(), section.heading.clone(), section.words.clone()]
        })
    });
    Ok(serde_json::to_string(&sections.collect::<Vec<_>>())?)
}

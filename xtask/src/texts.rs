//! The catalogues of texts: which English texts the code has, and what each catalogue says to them.

use anyhow::{Context, Result, bail};
use polib::catalog::Catalog;
use polib::message::Message;
use polib::metadata::CatalogMetadata;
use polib::po_file::{POParseOptions, parse_with_option, write_to_file};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use units::Language;

/// Languages whose catalogues must be complete.
#[cfg(test)]
const COMPLETE: [Language; 1] = [Language::Spanish];

/// A text of the code, in English.
#[derive(Debug)]
pub struct Text {
    /// The key of the catalogues.
    pub english: String,
    /// File in which it stands first, from the root of the project.
    pub file: String,
}

/// Brings all catalogues up to date: new texts without a translation, in the order of the code; texts that the code no
/// longer has are dropped. Prints how much of each language is translated.
pub fn update(root: &Path) -> Result<()> {
    let texts = of_code(root)?;
    for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
        let file = file(root, language);
        let known = read(&file)?;
        let mut catalogue = Catalog::new(metadata(language));
        let mut missing = 0;
        for text in &texts {
            let translation = known.find_message(None, &text.english, None).and_then(|message| message.msgstr().ok());
            let translation = translation.unwrap_or_default().to_owned();
            missing += usize::from(translation.is_empty());
            let mut message = Message::build_singular();
            message.with_msgid(text.english.clone()).with_msgstr(translation).with_source(text.file.clone());
            catalogue.append_or_update(message.done());
        }
        write_to_file(&catalogue, &file)?;
        let (name, count) = (language.name(), texts.len());
        println!("{name}: {} of {count} texts, {}", count - missing, file.display());
    }
    Ok(())
}

/// The catalogue of a language.
fn file(root: &Path, language: Language) -> PathBuf {
    root.join("crates/catalogues/languages").join(language.tag()).with_extension("po")
}

fn read(file: &Path) -> Result<Catalog> {
    if !file.exists() {
        return Ok(Catalog::new(CatalogMetadata::new()));
    }
    let options = POParseOptions { translated_only: false, ..POParseOptions::default() };
    parse_with_option(file, &options).with_context(|| format!("cannot read {}", file.display()))
}

fn metadata(language: Language) -> CatalogMetadata {
    let mut metadata = CatalogMetadata::new();
    metadata.project_id_version = "Meniscus".into();
    metadata.mime_version = "1.0".into();
    metadata.content_type = "text/plain; charset=UTF-8".into();
    metadata.content_transfer_encoding = "8bit".into();
    metadata.language = language.tag().into();
    metadata
}

/// All texts of the product's code, each once, in the order of the files.
pub fn of_code(root: &Path) -> Result<Vec<Text>> {
    let mut files = Vec::new();
    rust_files(&root.join("crates"), &mut files)?;
    files.sort();
    let mut found = Found::default();
    for path in files {
        let source = fs::read_to_string(&path)?;
        let tokens: TokenStream = source.parse().map_err(|error| anyhow::anyhow!("{}: {error}", path.display()))?;
        found.file = path.strip_prefix(root).unwrap_or(&path).display().to_string();
        found.search(tokens)?;
    }
    Ok(found.texts)
}

/// Source files of the product; tests and the crates that define the macros are left out.
fn rust_files(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            let skipped = ["tests", "benches", "examples", "fuzz", "wording"].contains(&name.as_str());
            if !skipped {
                rust_files(&path, files)?;
            }
        } else if name.ends_with(".rs") {
            files.push(path);
        }
    }
    Ok(())
}

#[derive(Default)]
struct Found {
    texts: Vec<Text>,
    known: HashSet<String>,
    file: String,
}

impl Found {
    fn search(&mut self, tokens: TokenStream) -> Result<()> {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        for (at, token) in tokens.iter().enumerate() {
            let before = at.checked_sub(1).and_then(|before| tokens.get(before));
            if let TokenTree::Ident(name) = token
                && !is_ident(before, "fn")
            {
                let is_macro = is_mark(tokens.get(at + 1), '!');
                let group = tokens.get(if is_macro { at + 2 } else { at + 1 });
                if let Some(TokenTree::Group(group)) = group {
                    let receiver = tokens.get(..at.saturating_sub(1)).filter(|_| is_mark(before, '.'));
                    self.call(&name.to_string(), is_macro, receiver, group)?;
                }
            }
            if let TokenTree::Group(group) = token
                && !is_ident(before, "tests")
            {
                self.search(group.stream())?;
            }
        }
        Ok(())
    }

    /// The texts in the arguments of a call that makes a message.
    fn call(&mut self, name: &str, is_macro: bool, receiver: Option<&[TokenTree]>, group: &Group) -> Result<()> {
        let arguments = arguments(group);
        let argument = |index: usize| arguments.get(index).map_or(&[][..], Vec::as_slice);
        // Other types have methods of the same name.
        let of_language = receiver.is_some_and(|tokens| match tokens {
            [.., name, TokenTree::Group(arguments)] if arguments.stream().is_empty() => {
                is_ident(Some(name), "language")
            }
            [.., name] => is_ident(Some(name), "language"),
            [] => false,
        });
        match (name, is_macro, receiver.is_some()) {
            ("table_of_words", true, _) => {
                for line in group.stream().into_iter().collect::<Vec<_>>().split(|token| is_mark(Some(token), ';')) {
                    line.last().and_then(text).into_iter().for_each(|text| self.add(text));
                }
            }
            ("words", true, _) => self.must(argument(0))?,
            ("say", true, _) => self.must(argument(1))?,
            // Other functions of this name have other arguments.
            ("words", false, false) if arguments.len() == 1 => {
                argument(0).first().and_then(text).into_iter().for_each(|text| self.add(text))
            }
            ("say", false, true) if of_language => self.must(argument(0))?,
            ("say", false, true) => argument(0).first().and_then(text).into_iter().for_each(|text| self.add(text)),
            ("say_all", false, true) => {
                let [TokenTree::Group(list)] = argument(0) else { bail!("{}: `say_all` takes literals", self.file) };
                self::arguments(list).iter().try_for_each(|one| self.must(one))?;
            }
            _ => {}
        }
        Ok(())
    }

    fn must(&mut self, argument: &[TokenTree]) -> Result<()> {
        match argument {
            [token] if let Some(text) = text(token) => self.add(text),
            // A macro hands its text through.
            [TokenTree::Punct(mark), ..] if matches!(mark.as_char(), '$' | '*') => {}
            _ => bail!(
                "{}: a text must be a literal, not `{}`",
                self.file,
                argument.iter().cloned().collect::<TokenStream>()
            ),
        }
        Ok(())
    }

    fn add(&mut self, english: String) {
        if !english.is_empty() && self.known.insert(english.clone()) {
            self.texts.push(Text { english, file: self.file.clone() });
        }
    }
}

fn arguments(group: &Group) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    tokens.split(|token| is_mark(Some(token), ',')).map(<[TokenTree]>::to_vec).filter(|one| !one.is_empty()).collect()
}

fn text(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Literal(literal) => {
            syn::parse_str::<syn::LitStr>(&literal.to_string()).ok().map(|text| text.value())
        }
        TokenTree::Group(group) if group.delimiter() == Delimiter::None => text(&group.stream().into_iter().next()?),
        _ => None,
    }
}

fn is_mark(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

fn is_ident(token: Option<&TokenTree>, name: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::steps;
    use std::collections::BTreeSet;
    use units::Catalogue;

    /// Places of a template: `{name}`, and `{}` by their numbers.
    fn places(template: &str) -> BTreeSet<String> {
        let (mut places, mut unnamed) = (BTreeSet::new(), 0);
        let mut rest = template;
        while let Some(at) = rest.find('{') {
            rest = &rest[at + 1..];
            if let Some(after) = rest.strip_prefix('{') {
                rest = after;
            } else if let Some((name, after)) = rest.split_once('}') {
                rest = after;
                let is_name = name.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
                if name.is_empty() {
                    places.insert(unnamed.to_string());
                    unnamed += 1;
                } else if is_name {
                    places.insert(name.to_owned());
                }
            }
        }
        places
    }

    #[test]
    fn catalogues_have_the_texts_of_the_code() {
        let texts = of_code(&steps::root()).unwrap();
        assert!(texts.len() > 3000, "{} texts", texts.len());
        let english: BTreeSet<&str> = texts.iter().map(|text| text.english.as_str()).collect();
        for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
            let catalogue = catalogues::texts(language);
            let known: BTreeSet<&str> = catalogue.keys().map(String::as_str).collect();
            let differing: Vec<_> = english.symmetric_difference(&known).take(5).collect();
            assert!(differing.is_empty(), "{language:?}: run `cargo xtask texts`: {differing:#?}");
            let missing: Vec<_> = catalogue.iter().filter(|(_, text)| text.is_empty()).map(|(key, _)| key).collect();
            assert!(missing.is_empty() || !COMPLETE.contains(&language), "{language:?} lacks {missing:#?}");
            for (key, text) in catalogue.iter().filter(|(_, text)| !text.is_empty()) {
                assert_eq!(places(key), places(text), "{language:?}: {key:?} and {text:?} have other places");
                assert!(!text.contains('\0'), "{key:?}");
            }
            let pairs = catalogue.iter().map(|(key, text)| (key.as_str(), text.as_str()));
            assert!(Catalogue::pack(pairs).is_ok(), "two texts have the same hash: reword one");
        }
    }

    #[test]
    fn texts_are_found_in_calls_and_macros() {
        let source = r#"
            fn words(name: &str) {}
            table_of_words! { @beside around; one: "One"; two: "Two"; }
            let a = (words("a"), words!("b {x}", x = words("c")), say!(self.language(), "d"), find("no", words));
            let b = [language.say("e"), app.say(text), play.language().say("f"), language.say_all(["g", "h"]).len()];
        "#;
        let mut found = Found::default();
        found.search(source.parse().unwrap()).unwrap();
        let texts: Vec<&str> = found.texts.iter().map(|text| text.english.as_str()).collect();
        assert_eq!(texts, ["One", "Two", "a", "b {x}", "c", "d", "e", "f", "g", "h"]);
        let unclear = "language.say(text)".parse().unwrap();
        assert!(Found::default().search(unclear).is_err());
    }
}

//! `meniscus new`: creates a folder with a document from a template.

use super::arguments::New;
use crate::failure::Failure;
use crate::terminal::Terminal;
use document::TEMPLATES;
use runner::quoted;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;
use units::{say, words};

/// Writes `DIR/DIR.md` from a template, in the language of messages.
///
/// # Errors
/// The folder has no name or cannot be created, or the document exists.
pub fn new(arguments: &New, terminal: Terminal) -> Result<(), Failure> {
    let directory = arguments.directory.as_path();
    let language = terminal.language;
    fs::create_dir_all(directory).map_err(|error| Failure::file("make", directory, &error))?;
    let path = directory.join(format!("{}.md", name(directory)?));
    let template = TEMPLATES.iter().find(|template| template.name == arguments.template);
    let text = template.map_or("", |template| template.text(language));
    let mut file = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Ok(file) => file,
        Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {
            let path = path.display();
            return Err(Failure::in_words(
                words!("{path} exists already"),
                words("choose another folder, or move the file away"),
            ));
        }
        Err(error) => return Err(Failure::file("write", &path, &error)),
    };
    file.write_all(text.as_bytes()).map_err(|error| Failure::file("write", &path, &error))?;
    let (written, path, folder) = (path.display(), quoted(&path), quoted(directory));
    terminal.print(&say!(language, "Wrote {written}\n\n  meniscus serve {path}   shows it while you write it\n  meniscus check {path}   says what is wrong with it\n  \
             meniscus export {path} --output page.html   makes one offline page of it\n  \
             meniscus build {folder} --output site   makes a web site of the folder\n"));
    Ok(())
}

/// Name of the folder; `.` is resolved.
fn name(directory: &Path) -> Result<String, Failure> {
    let whole = directory.canonicalize().map_err(|error| Failure::file("read", directory, &error))?;
    let name = whole.file_name().and_then(|name| name.to_str());
    name.map(str::to_owned).ok_or_else(|| Failure::request(format!("{} has no name for a document", whole.display())))
}

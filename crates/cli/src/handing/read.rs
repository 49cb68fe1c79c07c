//! Reading of hand-ins and projects.

use super::VERSION;
use crate::failure::Failure;
use class::collection::Collection;
use saved::hand_in::{HAND_IN_ENDING, HandIn, HandInError, LONGEST_HAND_IN};
use std::io::Read;
use std::path::{Path, PathBuf};
use units::Language;

/// Content of a file of at most `most` bytes. One byte more is read, so that its reader refuses a longer file.
pub fn bytes(path: &Path, most: usize) -> Result<Vec<u8>, Failure> {
    let fails = |error| Failure::file("read", path, &error);
    let file = std::fs::File::open(path).map_err(fails)?;
    let mut bytes = Vec::new();
    file.take(most as u64 + 1).read_to_end(&mut bytes).map_err(fails)?;
    Ok(bytes)
}

/// True if a file of a folder is a hand-in or a page, by its name.
fn is_candidate(path: &Path) -> bool {
    let name = path.to_string_lossy().to_lowercase();
    [HAND_IN_ENDING, ".html", ".htm"].iter().any(|ending| name.ends_with(ending))
}

/// The hand-ins of files and folders, in the order of their names, computed again. Of the pages in a folder only those that
/// carry the data of a hand-in are taken. Also returns the paths of the files.
///
/// # Errors
/// A file or folder cannot be read, or a folder has no hand-ins.
pub fn computed(paths: &[PathBuf], language: Language) -> Result<(Collection, Vec<PathBuf>), Failure> {
    let (mut class, mut taken) = (Collection::new(VERSION, language), Vec::new());
    let mut add = |path: &Path, content| {
        class.add(&path.to_string_lossy(), content);
        taken.push(path.to_owned());
    };
    for path in paths {
        if !path.is_dir() {
            add(path, read(path)?);
            continue;
        }
        let entries = std::fs::read_dir(path).map_err(|error| Failure::file("read", path, &error))?;
        let names = entries.filter_map(|entry| Some(entry.ok()?.path()));
        let mut inside: Vec<PathBuf> = names.filter(|path| is_candidate(path)).collect();
        inside.sort();
        let mut is_empty = true;
        for path in inside {
            let content = read(&path)?;
            if content != Err(HandInError::NoData) {
                add(&path, content);
                is_empty = false;
            }
        }
        if is_empty {
            return Err(Failure::with_hint(
                format!("{} has no hand-ins", path.display()),
                format!("their names end in {HAND_IN_ENDING}"),
            ));
        }
    }
    while class.advance() {}
    Ok((class, taken))
}

fn read(path: &Path) -> Result<Result<HandIn, HandInError>, Failure> {
    Ok(HandIn::open(&bytes(path, LONGEST_HAND_IN)?))
}

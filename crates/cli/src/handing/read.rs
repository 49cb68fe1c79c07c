//! Reading of hand-ins and projects.

use crate::failure::Failure;
use crate::load;
use class::collection::{Collection, References};
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

/// Files of a folder whose names are wanted, in the order of their names.
///
/// # Errors
/// The folder cannot be read.
pub fn files_in(folder: &Path, is_wanted: impl Fn(&str) -> bool) -> Result<Vec<PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(|error| Failure::file("read", folder, &error))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut files: Vec<PathBuf> = paths.filter(|path| is_wanted(&path.to_string_lossy())).collect();
    files.sort();
    Ok(files)
}

/// The hand-ins of files and folders, in the order of their names, computed again. Of the pages in a folder only those that
/// carry the data of a hand-in are taken. `documents`: the teacher's, if there are any. Also returns the paths of the files.
///
/// # Errors
/// A file or folder cannot be read, or a folder has no hand-ins.
pub fn computed(
    paths: &[PathBuf],
    documents: &[PathBuf],
    language: Language,
) -> Result<(Collection, Vec<PathBuf>), Failure> {
    let (mut class, mut taken) = (Collection::new(language), Vec::new());
    let references =
        documents.iter().map(|path| Ok(load::sources(path)?.embedded())).collect::<Result<_, Failure>>()?;
    class.set_references(References::given(references));
    for path in paths {
        if !path.is_dir() {
            class.add(&path.to_string_lossy(), read(path)?);
            taken.push(path.clone());
            continue;
        }
        let before = taken.len();
        for path in files_in(path, Collection::is_candidate)? {
            if class.add_of_folder(&path.to_string_lossy(), read(&path)?) {
                taken.push(path);
            }
        }
        if taken.len() == before {
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

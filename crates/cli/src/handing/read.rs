//! Reading of hand-ins and projects.

use crate::failure::Failure;
use saved::hand_in::{HAND_IN_ENDING, HandIn, HandInError, LONGEST_HAND_IN};
use std::collections::HashMap;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A file, and the hand-in in it or the reason why there is none.
pub struct Handed {
    /// The file.
    pub path: PathBuf,
    /// The hand-in.
    pub content: Result<HandIn, HandInError>,
}

impl Handed {
    /// Name of the sender; empty if the file cannot be read.
    pub fn sender_name(&self) -> &str {
        self.content.as_ref().map_or("", |hand_in| hand_in.sender.name.as_str())
    }
}

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

/// The hand-ins of files and folders, in the order of their names. Of the pages in a folder only those that carry the data of
/// a hand-in are taken.
///
/// # Errors
/// A file or folder cannot be read, or a folder has no hand-ins.
pub fn all(paths: &[PathBuf]) -> Result<Vec<Handed>, Failure> {
    let read = |path: PathBuf| -> Result<Handed, Failure> {
        let content = HandIn::open(&bytes(&path, LONGEST_HAND_IN)?);
        Ok(Handed { path, content })
    };
    let mut handed = Vec::new();
    for path in paths {
        if !path.is_dir() {
            handed.push(read(path.clone())?);
            continue;
        }
        let entries = std::fs::read_dir(path).map_err(|error| Failure::file("read", path, &error))?;
        let names = entries.filter_map(|entry| Some(entry.ok()?.path()));
        let mut inside: Vec<PathBuf> = names.filter(|path| is_candidate(path)).collect();
        inside.sort();
        let inside: Vec<Handed> = inside.into_iter().map(read).collect::<Result<_, _>>()?;
        let before = handed.len();
        handed.extend(inside.into_iter().filter(|one| one.content != Err(HandInError::NoData)));
        if handed.len() == before {
            return Err(Failure::with_hint(
                format!("{} has no hand-ins", path.display()),
                format!("their names end in {HAND_IN_ENDING}"),
            ));
        }
    }
    Ok(handed)
}

/// Name, seat and assignment of a sender.
type Sender<'a> = (&'a str, Option<u32>, &'a str);

/// The sender of a hand-in.
pub fn sender(hand_in: &HandIn) -> Sender<'_> {
    (&hand_in.sender.name, hand_in.sender.seat, &hand_in.sender.assignment)
}

/// Index of the last hand-in of each sender with a name.
pub fn last_of_each(handed: &[Handed]) -> HashMap<Sender<'_>, usize> {
    let mut last: HashMap<Sender<'_>, (u64, usize)> = HashMap::new();
    for (index, one) in handed.iter().enumerate() {
        // Reports have no sender.
        let Some(hand_in) = one.content.as_ref().ok().filter(|hand_in| !hand_in.sender.name.is_empty()) else {
            continue;
        };
        let place = last.entry(sender(hand_in)).or_insert((hand_in.made, index));
        if hand_in.made >= place.0 {
            *place = (hand_in.made, index);
        }
    }
    last.into_iter().map(|(sender, (_, index))| (sender, index)).collect()
}

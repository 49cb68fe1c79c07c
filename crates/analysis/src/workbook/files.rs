//! Text files of an archive, read like the sheets of a workbook.

use super::refusal::WorkbookError;
use super::source::{Progress, SheetSource, SheetText};
use crate::data_sets::{DEVICE, EVENTS};
use crate::import::{self, Program};
use packed::{Archive, Part};

/// Upper bound of the files that are read.
const MOST_FILES: usize = 60;
/// Upper bound of the expanded size of all files together: a fixed number of bytes, plus a multiple of the archive.
/// Measurements expand by 2 to 20.
const ALWAYS_ALLOWED: u64 = 8 << 20;
const MOST_EXPANSION: u64 = 60;

/// Text files of an archive.
#[derive(Debug)]
pub(super) struct Files {
    archive: Archive,
    /// Paths of the files, the next one last.
    paths: Vec<String>,
    /// Present file, with its bytes expanded so far.
    part: Option<(Part, Vec<u8>)>,
}

impl Files {
    /// Text files of an archive, which expand to at most `most` bytes. An error if there are none.
    pub fn open(archive: Archive, most: usize) -> Result<Self, WorkbookError> {
        let mut paths: Vec<String> =
            archive.names().filter(|path| is_table(path)).take(MOST_FILES).map(str::to_owned).collect();
        if archive.has("main.xml") && paths.is_empty() {
            return Err(WorkbookError::Program(Program::Capstone));
        }
        if paths.is_empty() {
            return Err(WorkbookError::NoSheets { found: archive.first_names() });
        }
        paths.reverse();
        let sizes = paths.iter().filter_map(|path| archive.stored(path)).map(|stored| stored.expanded);
        let (packed, expanded) = (archive.size(), sizes.fold(0, u64::saturating_add));
        if expanded > (ALWAYS_ALLOWED + MOST_EXPANSION.saturating_mul(packed)).min(most as u64) {
            return Err(WorkbookError::Expands { packed, expanded });
        }
        Ok(Self { archive, paths, part: None })
    }

    /// Name of the data set in a file: without folders and ending, unless another file has the same name.
    fn name(&self, path: &str) -> String {
        let lower = path.to_ascii_lowercase();
        if lower.ends_with("meta/device.csv") {
            return DEVICE.to_owned();
        }
        if lower.ends_with("meta/time.csv") {
            return EVENTS.to_owned();
        }
        let alone = self.archive.names().filter(|other| last(other) == last(path)).count() < 2;
        let name = if alone { last(path) } else { path };
        name.rsplit_once('.').map_or(name, |(name, _)| name).to_owned()
    }
}

/// True for the path of a text file that may hold a table. macOS adds files with the attributes of others.
fn is_table(path: &str) -> bool {
    let lower = path.to_ascii_lowercase();
    let ends = [".csv", ".txt", ".tsv", ".dat"].iter().any(|ending| lower.ends_with(ending));
    ends && !path.starts_with("__MACOSX/") && !last(path).starts_with('.')
}

/// Path without its folders.
fn last(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

impl SheetSource for Files {
    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        let Some(path) = self.paths.last() else { return Ok(Progress::End) };
        let (part, bytes) = match &mut self.part {
            Some(part) => part,
            None => self.part.insert((self.archive.part(path, None)?, Vec::new())),
        };
        if !part.expand(usize::try_from(budget).unwrap_or(usize::MAX), bytes)? {
            return Ok(Progress::More);
        }
        let text = import::characters(bytes).into_owned();
        let name = self.name(path);
        (self.part, _) = (None, self.paths.pop());
        Ok(Progress::Sheet(SheetText { name, text }))
    }

    fn has_more(&mut self) -> bool {
        !self.paths.is_empty()
    }

    fn progress(&self) -> f64 {
        self.part.as_ref().map_or(0.0, |(part, _)| part.progress())
    }

    fn holds_texts(&self) -> bool {
        true
    }
}

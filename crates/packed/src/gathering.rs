//! Partial reading of an archive: the ranges of bytes needed to read its projects and to locate its films.

use crate::archive::{self, Archive, End, File, HEADER, LONGEST_COMMENT};
use std::cmp::Reverse;
use std::ops::Range;
use units::order::sort_by_key;

/// Upper bound of the length of the directory, in bytes.
const LONGEST_DIRECTORY: u64 = 4 << 20;
/// Upper bound of the compressed size of all files that are read, in bytes.
const MOST_BYTES: u64 = 64 << 20;
/// Upper bound of the number of needed files, and of the largest other files that are located.
const MOST_FOUND: usize = 20;
/// Allowance for the name and the extra field in the header of a file, in bytes. Each may have 65535 bytes, but is rarely
/// longer.
const BEFORE: u64 = 4096;

/// Ranges of bytes needed from an archive, requested one after the other.
#[derive(Debug)]
pub struct Gathering {
    size: u64,
    /// Ending, in lower case, of the names of the files that are read.
    ending: &'static str,
    stage: Stage,
    pieces: Vec<(u64, Vec<u8>)>,
}

#[derive(Debug)]
enum Stage {
    Tail,
    Directory(End),
    /// Ranges still to be read, the next one last, and all files.
    Pieces(Vec<Range<u64>>, Vec<File>),
    /// Not an archive, or no needed file in it.
    Nothing,
}

impl Gathering {
    /// For an archive of this length in bytes, with the content of the files whose names have this ending.
    pub fn new(size: u64, ending: &'static str) -> Self {
        Self { size, ending, stage: Stage::Tail, pieces: Vec::new() }
    }

    /// Next range of bytes needed; `None` if all are there.
    pub fn wanted(&self) -> Option<Range<u64>> {
        match &self.stage {
            Stage::Tail => Some(self.size.saturating_sub(LONGEST_COMMENT as u64 + 22)..self.size),
            Stage::Directory(end) => Some(end.directory.clone()),
            Stage::Pieces(ranges, _) => ranges.last().cloned(),
            Stage::Nothing => None,
        }
    }

    /// Takes the bytes of the range that [`Self::wanted`] requested.
    pub fn supply(&mut self, bytes: Vec<u8>) {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Nothing) {
            Stage::Tail => {
                let inside = |end: &End| {
                    let Range { start, end } = end.directory;
                    start <= end && end <= self.size && end - start <= LONGEST_DIRECTORY
                };
                archive::end(&bytes).filter(inside).map_or(Stage::Nothing, Stage::Directory)
            }
            Stage::Directory(end) => match archive::files(&bytes, &end).map(|files| (self.ranges(&files, &end), files))
            {
                Some((Some(ranges), files)) => Stage::Pieces(ranges, files),
                _ => Stage::Nothing,
            },
            Stage::Pieces(mut ranges, files) => {
                if let Some(range) = ranges.pop() {
                    self.pieces.push((range.start, bytes));
                }
                Stage::Pieces(ranges, files)
            }
            Stage::Nothing => Stage::Nothing,
        };
    }

    /// Ranges of the needed files, and of the headers of the largest others; `None` if no file is needed, or too much.
    fn ranges(&self, files: &[File], end: &End) -> Option<Vec<Range<u64>>> {
        let is_needed = |file: &&File| file.name.to_ascii_lowercase().ends_with(self.ending);
        let needed: Vec<&File> = files.iter().filter(is_needed).collect();
        let sum = needed.iter().fold(0_u64, |sum, file| sum.saturating_add(file.packed));
        if needed.is_empty() || sum > MOST_BYTES || needed.len() > MOST_FOUND {
            return None;
        }
        let mut others: Vec<&File> = files.iter().filter(|file| !is_needed(file)).collect();
        sort_by_key(&mut others, |file| Reverse(file.packed));
        let range = |file: &File, length: u64| file.header..file.header.saturating_add(length).min(end.directory.start);
        let needed = needed.into_iter().map(|file| range(file, file.packed.saturating_add(HEADER + BEFORE)));
        let found = others.into_iter().take(MOST_FOUND).map(|file| range(file, HEADER));
        let ranges: Vec<Range<u64>> = needed.chain(found).filter(|range| range.start < range.end).collect();
        Some(ranges)
    }

    /// Archive with the gathered pieces; `None` if it contains no needed file.
    pub fn finish(self) -> Option<Archive> {
        let Stage::Pieces(_, files) = self.stage else { return None };
        Some(Archive::of_pieces(self.size, self.pieces, files))
    }
}

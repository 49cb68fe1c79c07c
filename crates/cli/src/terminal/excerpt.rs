//! Source lines shown under a finding. Of a long line only the part around the position is shown.

use codespan_reporting::diagnostic::{Diagnostic, LabelStyle};
use codespan_reporting::files::{Error, Files, SimpleFiles};
use std::collections::BTreeMap;
use std::ops::Range;
use units::{Language, say};

/// Maximum length in bytes of a line that is shown in full. A document may be a single line of a million bytes.
const LONGEST: usize = 400;
/// Number of bytes shown before the position.
const BEFORE: usize = 100;

/// Files of a finding, with long lines cut to the shown part.
#[derive(Debug)]
pub struct Excerpt<'f, 'a> {
    files: &'f SimpleFiles<String, &'a str>,
    /// Shown part of long lines, by file and line.
    parts: BTreeMap<(usize, usize), Range<usize>>,
}

impl<'f, 'a> Excerpt<'f, 'a> {
    /// Chooses the shown parts of long lines around the labels of `finding`. Removes labels that are not shown, and
    /// adds a note if a line is cut.
    pub fn of(files: &'f SimpleFiles<String, &'a str>, finding: &mut Diagnostic<usize>, language: Language) -> Self {
        let mut excerpt = Self { files, parts: BTreeMap::new() };
        finding.labels.sort_by_key(|label| label.style != LabelStyle::Primary);
        for label in &finding.labels {
            for place in [label.range.start, label.range.end] {
                excerpt.choose(label.file_id, place);
            }
        }
        finding.labels.retain_mut(|label| excerpt.fit(label.file_id, &mut label.range));
        if !excerpt.parts.is_empty() {
            finding.notes.push(say!(language, "lines of more than {LONGEST} bytes are shown in part"));
        }
        excerpt
    }

    /// Chooses the shown part of the line around `place` if the line is long.
    fn choose(&mut self, file: usize, place: usize) {
        let Ok(source) = self.files.source(file) else { return };
        let Ok(line) = self.files.line_index(file, place) else { return };
        let Ok(range) = self.files.line_range(file, line) else { return };
        if range.len() > LONGEST {
            self.parts.entry((file, line)).or_insert_with(|| {
                let start = source.floor_char_boundary(place.saturating_sub(BEFORE).max(range.start));
                start..source.floor_char_boundary((start + LONGEST).min(range.end))
            });
        }
    }

    /// Clips a label to the shown part of its lines. Returns false if it starts outside of it.
    fn fit(&self, file: usize, range: &mut Range<usize>) -> bool {
        let shown = |place: usize| {
            let line = self.files.line_index(file, place).ok()?;
            self.parts.get(&(file, line))
        };
        if shown(range.start).is_some_and(|part| !part.contains(&range.start)) {
            return false;
        }
        if let Some(part) = shown(range.end) {
            range.end = range.end.clamp(part.start, part.end);
        }
        true
    }
}

impl<'a> Files<'a> for Excerpt<'_, 'a> {
    type FileId = usize;
    type Name = String;
    type Source = &'a str;

    fn name(&'a self, file: usize) -> Result<String, Error> {
        self.files.name(file)
    }

    fn source(&'a self, file: usize) -> Result<&'a str, Error> {
        self.files.source(file)
    }

    fn line_index(&'a self, file: usize, place: usize) -> Result<usize, Error> {
        self.files.line_index(file, place)
    }

    /// Columns count from the beginning of the line, also if its beginning is not shown.
    fn column_number(&'a self, file: usize, line: usize, place: usize) -> Result<usize, Error> {
        self.files.column_number(file, line, place)
    }

    fn line_range(&'a self, file: usize, line: usize) -> Result<Range<usize>, Error> {
        match self.parts.get(&(file, line)) {
            Some(part) => Ok(part.clone()),
            None => self.files.line_range(file, line),
        }
    }
}

//! Positions of a project as text: a line for each frame with a marked mass, and tabs between the cells.

use super::project::{Mark, Mass, Project};
use super::refusal::TrackerError;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Header of the first column of a project without times. Its unit is not one of time, so that frame numbers are not read
/// as seconds.
const FRAMES: &str = "frame [frames]";

impl Project {
    /// Times in s, or frame numbers if the project has no times, and the positions of all masses in units of length, or in
    /// pixels if the project has no scale. The text is a table for the import; positions in unmarked frames are empty.
    ///
    /// # Errors
    /// The project has fewer than two marked frames, or the table more than `most` bytes.
    pub fn table(&self, most: usize) -> Result<String, TrackerError> {
        let rows = self.rows();
        if rows.len() < 2 {
            let film = self.trackable().is_some();
            return Err(if rows.is_empty() { TrackerError::NoMass { film } } else { TrackerError::OneFrame { film } });
        }
        // Each body has its own name, which its columns share.
        let names = self.body_names();
        let unit = self.column_unit();
        let has_times = self.has_times();
        let mut text = if has_times { "t [s]" } else { FRAMES }.to_owned();
        for name in &names {
            // Writing to a string cannot fail.
            let _ = write!(text, "\t{name}: x [{unit}]\t{name}: y [{unit}]");
        }
        text.push('\n');
        for (frame, marks) in rows {
            let _ = if has_times { write!(text, "{:?}", self.clip.time(frame)) } else { write!(text, "{frame}") };
            let axes = self.coordinates.at(frame);
            let mut written = 0;
            for (body, mark) in marks {
                text.extend(std::iter::repeat_n("\t\t", body - written));
                let [x, y] = axes.world(mark.pixel);
                let _ = write!(text, "\t{x:?}\t{y:?}");
                written = body + 1;
            }
            text.extend(std::iter::repeat_n("\t\t", names.len() - written));
            text.push('\n');
            if text.len() > most {
                return Err(TrackerError::TooLarge);
            }
        }
        Ok(text)
    }

    /// True if frames have times: listed ones, or those of a constant step.
    pub fn has_times(&self) -> bool {
        self.clip.is_timed() || self.clip.stretch().is_some()
    }

    /// Masses that are marked in frames of the clip.
    pub(super) fn shown(&self) -> impl Iterator<Item = &Mass> {
        self.masses.iter().filter(|mass| mass.marks.iter().any(|mark| self.clip.includes(mark.frame)))
    }

    /// Marks of each frame of the clip, with the indices of their masses.
    fn rows(&self) -> BTreeMap<u32, Vec<(usize, Mark)>> {
        let mut rows: BTreeMap<u32, Vec<(usize, Mark)>> = BTreeMap::new();
        for (body, mass) in self.shown().enumerate() {
            for mark in mass.marks.iter().filter(|mark| self.clip.includes(mark.frame)) {
                rows.entry(mark.frame).or_default().push((body, *mark));
            }
        }
        rows
    }

    /// Distinct names of the masses, without signs that have a meaning in a header.
    fn body_names(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for (number, mass) in (1..).zip(self.shown()) {
            let plain = |sign: char| if sign.is_control() || ":\"#%/[](){}<>|;,".contains(sign) { ' ' } else { sign };
            let name: String = mass.name.chars().map(plain).collect();
            let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
            let name = if name.is_empty() { format!("mass {number}") } else { name };
            let taken = names.contains(&name);
            names.push(if taken { format!("{name} no {number}") } else { name });
        }
        names
    }

    /// Unit of the positions: that of the project's lengths, or pixels.
    pub(super) fn column_unit(&self) -> String {
        if !self.coordinates.is_scaled() {
            return "px".to_owned();
        }
        let stated = self.length_unit.as_deref().unwrap_or_default();
        let plain = |sign: &char| !sign.is_control() && !"[]\"".contains(*sign);
        let unit: String = stated.chars().filter(plain).collect();
        if unit.trim().is_empty() { "m".to_owned() } else { unit.trim().to_owned() }
    }
}

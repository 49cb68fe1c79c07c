//! Builds a project from the objects and properties of the XML. Other properties, such as colours and views, are ignored.

use super::coordinates::Placement;
use super::project::{Film, Mark, Mass, Missing, Project};
use super::refusal::TrackerError;
use std::collections::{BTreeMap, BTreeSet};
use units::order::sort_by_key;

/// Upper bound of the bodies.
const MOST_MASSES: usize = 200;
/// Upper bound of the listed other tracks, and of the listed filters.
const MOST_OTHERS: usize = 200;
/// Upper bound of the listed files of a set of tabs.
const MOST_TABS: usize = 200;
/// Greatest length of a path, in characters.
const LONGEST_PATH: usize = 1000;
/// Classes of videos that are pictures: a sequence, or an animated picture.
const PICTURES: [&str; 2] = ["ImageVideo", "GifVideo"];
/// Greatest length of a name, in characters; longer names are truncated.
const LONGEST_NAME: usize = 40;

/// Project that has been read in part.
#[derive(Debug, Default)]
pub(super) struct Builder {
    project: Project,
    /// True after the root element.
    begun: bool,
    track: Track,
    mark: [Option<f64>; 2],
    placement: Placement,
    has_clip: bool,
    /// Duration of a frame stated by a sequence of pictures, s.
    of_pictures: Option<f64>,
    /// Files named by a set of tabs; `None` if the root is a project.
    tabs: Option<Vec<String>>,
}

/// Track being read.
#[derive(Debug, Default)]
struct Track {
    name: String,
    marks: BTreeMap<u32, [f64; 2]>,
    keys: Option<BTreeSet<u32>>,
}

impl Builder {
    /// Processes the begin of an element; `path` holds the names of the enclosing elements and its own.
    pub fn open(&mut self, path: &[&str]) -> Result<(), TrackerError> {
        match path {
            ["TrackerPanel"] if !self.begun => self.begun = true,
            ["TFrame"] if !self.begun => (self.begun, self.tabs) = (true, Some(Vec::new())),
            [class] => return Err(TrackerError::NotAProject { class: (*class).to_owned() }),
            [_, "tracks", "item", _] => self.track = Track::default(),
            [_, "tracks", "item", "PointMass", "framedata", _] => self.mark = [None; 2],
            [_, "tabs", _] => self.name_tab(""),
            [_, "videoclip", _] => self.has_clip = true,
            [_, "videoclip", _, "video", class] => {
                self.project.film = Some(Film { pictures: PICTURES.contains(class), ..Film::default() });
            }
            [_, "videoclip", _, "video", _, "filters", _, class] if self.project.filters.len() < MOST_OTHERS => {
                self.project.filters.push((*class).to_owned());
            }
            [_, "coords", _, "framedata", index] => {
                self.placement = Placement { frame: frame(index)?, ..Placement::default() };
            }
            _ => {}
        }
        Ok(())
    }

    /// Processes the end of an element with its own text.
    pub fn close(&mut self, path: &[&str], text: &str) -> Result<(), TrackerError> {
        match path {
            [_, name] => self.take_property(name, text),
            // First the absolute path, then the shorter one relative to the folder of the file.
            [_, "tabs", _, _] if !text.is_empty() => self.name_tab(text),
            [_, "videoclip", _, name] => self.take_clip(name, text)?,
            [_, "clipcontrol", _, "delta_t"] => self.project.clip.interval = number(text)?.abs() / 1000.0,
            [_, "videoclip", _, "video", _, "path"] => {
                if let Some(film) = &mut self.project.film {
                    text.clone_into(&mut film.path);
                }
            }
            [_, "videoclip", _, "video", _, "delta_t"] => {
                self.of_pictures = text.parse().ok().map(|milliseconds: f64| milliseconds.abs() / 1000.0);
            }
            [_, "videoclip", _, "video", _, "start_times", "array"] => {
                let times = array::<f64>(text).unwrap_or_default();
                self.project.clip.times = times.into_iter().map(|milliseconds| milliseconds / 1000.0).collect();
            }
            [_, "coords", _, name] => self.take_fixed(name, text),
            [_, "coords", _, "framedata", _, _, name] => self.take_placement(name, text)?,
            [_, "coords", _, "framedata", _] if self.placement.is_usable() => {
                self.project.coordinates.placements.push(self.placement);
            }
            [_, "tracks", "item", _, "name"] => self.track.name = text.chars().take(LONGEST_NAME).collect(),
            [_, "tracks", "item", "PointMass", "keyFrames", "array"] => {
                self.track.keys = array(text).map(|keys| keys.into_iter().collect());
            }
            [_, "tracks", "item", "PointMass", "framedata", _, _, "x"] => self.mark[0] = Some(number(text)?),
            [_, "tracks", "item", "PointMass", "framedata", _, _, "y"] => self.mark[1] = Some(number(text)?),
            [_, "tracks", "item", "PointMass", "framedata", index] => self.take_mark(index)?,
            [_, "tracks", "item", class] => self.take_track(class)?,
            _ => {}
        }
        Ok(())
    }

    pub fn finish(mut self) -> Result<Project, TrackerError> {
        if !self.begun {
            return Err(TrackerError::Damaged);
        }
        if let Some(files) = self.tabs {
            let files: Vec<String> = files.into_iter().filter(|file| !file.is_empty()).collect();
            return Err(if files.is_empty() {
                TrackerError::NotAProject { class: "TFrame".to_owned() }
            } else {
                TrackerError::Tabs { files }
            });
        }
        self.project.missing = Missing { clip: !self.has_clip, duration: !self.project.clip.is_timed() };
        if let Some(interval) = self.of_pictures.filter(|_| self.project.missing.duration) {
            self.project.clip.interval = interval;
        }
        sort_by_key(&mut self.project.coordinates.placements, |placement| placement.frame);
        Ok(self.project)
    }

    /// Adds a file of a set of tabs for an empty path; otherwise replaces the path of the last one.
    fn name_tab(&mut self, path: &str) {
        let Some(tabs) = &mut self.tabs else { return };
        if path.is_empty() {
            tabs.extend((tabs.len() < MOST_TABS).then(String::new));
        } else if let Some(last) = tabs.last_mut() {
            *last = path.chars().take(LONGEST_PATH).collect();
        }
    }

    fn take_property(&mut self, name: &str, text: &str) {
        let text: String = text.chars().take(LONGEST_NAME).collect();
        match name {
            "length_unit" if !text.is_empty() => self.project.length_unit = Some(text),
            "referenceframe" if !text.is_empty() => self.project.reference = Some(text),
            _ => {}
        }
    }

    fn take_clip(&mut self, name: &str, text: &str) -> Result<(), TrackerError> {
        let clip = &mut self.project.clip;
        // Java's `int`; Tracker itself uses the absolute value of steps and counts.
        let whole = || text.parse::<i32>().map_err(|_| TrackerError::Damaged);
        match name {
            "startframe" => clip.first = u32::try_from(whole()?).unwrap_or(0),
            "stepsize" => clip.step = whole()?.unsigned_abs().max(1),
            "stepcount" => clip.count = whole()?.unsigned_abs().max(1),
            "frameshift" => clip.shift = whole()?.into(),
            "starttime" => clip.start = Some(number(text)? / 1000.0).filter(|start| start.is_finite()).unwrap_or(0.0),
            _ => {}
        }
        Ok(())
    }

    fn take_fixed(&mut self, name: &str, text: &str) {
        let coordinates = &mut self.project.coordinates;
        match name {
            "fixedorigin" => coordinates.fixed_origin = text == "true",
            "fixedangle" => coordinates.fixed_angle = text == "true",
            "fixedscale" => coordinates.fixed_scale = text == "true",
            _ => {}
        }
    }

    fn take_placement(&mut self, name: &str, text: &str) -> Result<(), TrackerError> {
        let placement = &mut self.placement;
        match name {
            "xorigin" => placement.origin[0] = number(text)?,
            "yorigin" => placement.origin[1] = number(text)?,
            "angle" => placement.angle = number(text)?,
            "xscale" => placement.scale[0] = number(text)?,
            "yscale" => placement.scale[1] = number(text)?,
            _ => {}
        }
        Ok(())
    }

    fn take_mark(&mut self, index: &str) -> Result<(), TrackerError> {
        let frame = frame(index)?;
        // A frame without a mark is missing or `null`.
        let [Some(x), Some(y)] = self.mark else { return Ok(()) };
        if x.is_finite() && y.is_finite() {
            self.track.marks.insert(frame, [x, y]);
        }
        Ok(())
    }

    fn take_track(&mut self, class: &str) -> Result<(), TrackerError> {
        let Track { name, marks, keys } = std::mem::take(&mut self.track);
        match class {
            "PointMass" if marks.is_empty() => {}
            "PointMass" if self.project.masses.len() >= MOST_MASSES => return Err(TrackerError::TooLarge),
            "PointMass" => {
                let is_key = |frame| keys.as_ref().is_some_and(|keys| keys.contains(&frame));
                let mark = |(frame, pixel)| Mark { frame, pixel, key: is_key(frame) };
                let marks = marks.into_iter().map(mark).collect();
                self.project.masses.push(Mass { name, marks, has_keys: keys.is_some() });
            }
            _ if self.project.others.len() < MOST_OTHERS => self.project.others.push((class.to_owned(), name)),
            _ => {}
        }
        Ok(())
    }
}

/// Parses a number written by Java.
fn number(text: &str) -> Result<f64, TrackerError> {
    text.parse().map_err(|_| TrackerError::Damaged)
}

/// Index of the frame in an element of an array: `[12]`.
fn frame(index: &str) -> Result<u32, TrackerError> {
    let digits = index.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    digits.and_then(|digits| digits.parse().ok()).ok_or(TrackerError::Damaged)
}

/// Numbers of an array in one text: `{0,5,9}`.
fn array<T: std::str::FromStr>(text: &str) -> Option<Vec<T>> {
    let inside = text.strip_prefix('{')?.strip_suffix('}')?.trim();
    if inside.is_empty() {
        return Some(Vec::new());
    }
    inside.split(',').map(|number| number.trim().parse().ok()).collect()
}

//! Film of a Tracker project, with its clicks, axes, scale, factor and used part in our form.

use crate::films::clip::Clip;
use crate::films::lengths::{CalibrationForm, LengthsForm};
use crate::number;
use analysis::tracker::{Mass, PackedFilm, Placement, Project};
use film::tracking::column::Click;
use std::ops::Range;
use units::{Words, words};

/// Filters that move points of the picture.
const MOVING_FILTERS: [&str; 4] = ["PerspectiveFilter", "RadialDistortionFilter", "ResizeFilter", "RotateFilter"];
/// Relative difference of the mean frame interval of project and film below which there is no slow motion.
const SAME_RATE: f64 = 0.05;
/// Maximum length of the ruler that represents the scale, relative to the width of the picture.
const RULER: f64 = 0.8;

/// Film in the archive of a Tracker project that has become a record.
#[derive(Clone, Debug, PartialEq)]
pub struct ProjectFilm {
    record: u32,
    packed: PackedFilm,
    pub(super) project: Box<Project>,
}

impl ProjectFilm {
    pub(crate) fn new(record: u32, project: Box<Project>) -> Option<Self> {
        let packed = project.film.as_ref().filter(|film| !film.pictures)?.packed.clone()?;
        Some(Self { record, packed, project })
    }

    /// Id of the record of the project.
    pub(crate) fn record(&self) -> u32 {
        self.record
    }

    /// File name of the film, without folders.
    pub fn name(&self) -> &str {
        self.packed.name.rsplit('/').next().unwrap_or_default()
    }

    /// Byte range of the film in the archive.
    pub fn range(&self) -> Range<u64> {
        self.packed.range.clone()
    }

    /// True if these bytes are compressed by Deflate, false if they are the film.
    pub fn is_deflated(&self) -> bool {
        self.packed.deflated
    }

    /// Size of the film in bytes, as stated by the archive.
    pub fn size(&self) -> u64 {
        self.packed.size
    }

    /// Positions of each mass in the frames of the film, px.
    pub(super) fn clicks(&self, clip: &Clip) -> Vec<(&Mass, Vec<Click>)> {
        let frames = clip.times().len();
        let of_mass = |mass: &Mass| -> Vec<Click> {
            let inside = mass.marks.iter().filter(|mark| self.project.clip.includes(mark.frame));
            let click = |mark: &analysis::tracker::Mark| {
                let frame = self.project.clip.film_frame(mark.frame).filter(|frame| *frame < frames)?;
                Some(Click { frame, position: mark.pixel })
            };
            inside.filter_map(click).collect()
        };
        let masses = self.project.masses.iter().map(|mass| (mass, of_mass(mass)));
        masses.filter(|(_, clicks)| !clicks.is_empty()).collect()
    }

    /// Frames in which a mass was marked by hand; the first one if the project does not distinguish them.
    pub(super) fn keys(&self, mass: &Mass, clicks: &[Click]) -> Vec<Click> {
        let is_key = |click: &&Click| {
            let mark = mass.marks.iter().find(|mark| self.project.clip.film_frame(mark.frame) == Some(click.frame));
            mark.is_some_and(|mark| mark.key)
        };
        let keys: Vec<Click> = clicks.iter().filter(is_key).copied().collect();
        if keys.is_empty() { clicks.first().copied().into_iter().collect() } else { keys }
    }

    /// Factor of slow motion by the mean frame interval of the project; `None` if it agrees with the film. `stated`:
    /// factor stated by the file.
    pub(super) fn factor(&self, clip: &Clip, stated: f64) -> Option<f64> {
        let factor = 1.0 / (clip.rate()? * self.project.clip.interval);
        let says_so = factor.is_finite() && factor > 0.0 && (factor / stated - 1.0).abs() > SAME_RATE;
        says_so.then_some(factor)
    }

    /// Used part of the film in s of playback; `None` for an end of the film.
    pub(super) fn part(&self, clip: &Clip) -> [Option<f64>; 2] {
        let own = &self.project.clip;
        let last = own.count.saturating_sub(1).saturating_mul(own.step.max(1)).saturating_add(own.first);
        let first = own.film_frame(own.first).filter(|frame| *frame > 0);
        let last = own.film_frame(last).filter(|frame| frame + 1 < clip.times().len());
        [first, last].map(|frame| clip.times().get(frame?).copied())
    }

    /// Axes and scale of the project as a calibration form. A project stores the scale but not its ruler, so that a
    /// ruler of a round length represents it.
    ///
    /// # Errors
    ///
    /// Reason why the form cannot represent the project.
    pub(super) fn form(&self, clip: &Clip, style: number::Style) -> Result<CalibrationForm, Words> {
        let coordinates = &self.project.coordinates;
        if coordinates.changes() {
            return Err(words("its axes or its scale change from frame to frame, and those of a film here do not"));
        }
        if let Some(filter) = self.project.filters.iter().find(|filter| MOVING_FILTERS.contains(&filter.as_str())) {
            return Err(words!(
                "its positions belong to pictures that a filter has changed ({filter})",
                filter = Words::same(filter.clone())
            ));
        }
        let Placement { origin, angle, scale: [scale, down], .. } = coordinates.at(self.project.clip.first);
        let [width, height] = clip.size();
        let lengths = if !coordinates.is_scaled() {
            LengthsForm::Pixels
        } else if scale > 0.0 && (down / scale - 1.0).abs() < 1e-6 {
            let unit = self.project.length_unit.as_deref().unwrap_or("m");
            let most = RULER * width / scale;
            let power = libm::pow(10.0, libm::log10(most).floor());
            let length = [5.0, 2.0].map(|part| part * power).into_iter().find(|length| *length <= most);
            let length = length.unwrap_or(power);
            let half = 0.5 * length * scale;
            let end = |x: f64| [0.5 * width + x, 0.9 * height];
            let text = format!("{} {unit}", number::plain(length, 3, style));
            LengthsForm::Ruler { marks: [end(-half), end(half)], length: text, intervals: 1 }
        } else {
            return Err(words("its scale along the rows is not that along the columns"));
        };
        let (sine, cosine) = libm::sincos(angle.to_radians());
        let inside = |point: &[f64; 2]| (0.0..=width).contains(&point[0]) && (0.0..=height).contains(&point[1]);
        let axis = (angle != 0.0).then(|| {
            let reach = [0.4, 0.2, 0.1, 0.05, 0.02].map(|part| part * width.min(height));
            let points = reach.map(|reach| [origin[0] + reach * cosine, origin[1] - reach * sine]);
            points.into_iter().find(inside)
        });
        if !inside(&origin) || axis == Some(None) {
            return Err(words("its origin lies outside the picture"));
        }
        Ok(CalibrationForm { lengths, origin: Some(origin), axis: axis.flatten(), parallax: None })
    }
}

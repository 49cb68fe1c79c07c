//! Remarks on a project for the user.

use super::coordinates::Placement;
use super::project::{Opened, Project};
use units::Language;
use units::order::sort_by_key;

/// Remark on the data of a project for the user.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The archive contains several projects; the one with this name was read.
    OneOfSeveral(String),
    /// Times are the frame number times a constant step.
    ConstantStep {
        /// Step, ms.
        milliseconds: f64,
        /// Path of the film, if it has times of its own.
        film: Option<String>,
        /// True if the film is in the archive of the project.
        packed: bool,
    },
    /// Neither the project nor its pictures state the duration of a frame: the table has frame numbers.
    FrameNumbers {
        /// Path of the film, if it has times of its own.
        film: Option<String>,
    },
    /// The project has no clip control with the duration of a frame: times are the listed ones, or from the step stated by
    /// its pictures.
    NoClipControl {
        /// True if they are the listed ones.
        listed: bool,
    },
    /// The project has no video clip, which states the used frames.
    NoClip,
    /// The project lists the times of all frames, which were multiplied by a factor.
    ListedTimes {
        /// Factor, different from 1 if the project states another mean duration of a frame than its film.
        stretch: f64,
    },
    /// Times are those of the frames of the film, which was opened.
    FilmTimes {
        /// Constant step stated by the project, ms; `None` if it states none.
        milliseconds: Option<f64>,
    },
    /// Conversion of pixels to lengths.
    Calibration {
        /// Axes and scale in the first frame.
        axes: Placement,
        /// True if they change from frame to frame.
        changes: bool,
        /// Unit of lengths; `None` if the project has no scale.
        unit: Option<String>,
    },
    /// The project has a scale, but states no unit of length.
    AssumedMetres,
    /// Tracker shows positions relative to this mass.
    Reference(String),
    /// Some positions of a mass are not key frames.
    Unconfirmed {
        /// Name of the mass.
        mass: String,
        /// Number of positions in key frames.
        keys: usize,
        /// Number of all positions.
        marks: usize,
    },
    /// Number of positions in frames outside the clip.
    OutsideClip(usize),
    /// Tracks of a kind that was left out, with their names.
    LeftOut(LeftOut, Vec<String>),
    /// Filters of the pictures of the film.
    Filters(Vec<String>),
}

/// Kinds of tracks that are not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOut {
    /// Particle models: their positions are computed, not measured.
    Models,
    /// Centres of mass.
    Centres,
    /// Tables that were pasted into the project.
    Data,
    /// Vectors and their sums.
    Vectors,
    /// Line profiles.
    Profiles,
    /// RGB regions.
    Regions,
    /// Protractors, circle fitters and rulers for angles.
    Tools,
    /// Tracks of other classes.
    Others,
}

impl LeftOut {
    /// Kind of a track of this class; `None` for tracks that belong to the calibration.
    fn of_class(class: &str) -> Option<Self> {
        Some(match class {
            "CoordAxes" | "TapeMeasure" | "OffsetOrigin" | "Calibration" | "PerspectiveTrack" => return None,
            "AnalyticParticle" | "DynamicParticle" | "DynamicParticlePolar" | "DynamicSystem" => Self::Models,
            "CenterOfMass" => Self::Centres,
            "ParticleDataTrack" => Self::Data,
            "Vector" | "VectorSum" => Self::Vectors,
            "LineProfile" => Self::Profiles,
            "RGBRegion" => Self::Regions,
            "Protractor" | "CircleFitter" | "AngleRuler" | "Compass" => Self::Tools,
            _ => Self::Others,
        })
    }

    pub(super) fn text(self, language: Language) -> &'static str {
        match self {
            Self::Models => language.say("models"),
            Self::Centres => language.say("centres of mass"),
            Self::Data => language.say("pasted data"),
            Self::Vectors => language.say("vectors"),
            Self::Profiles => language.say("line profiles"),
            Self::Regions => language.say("RGB regions"),
            Self::Tools => language.say("protractors and circle fitters"),
            Self::Others => language.say("other tracks"),
        }
    }
}

impl Opened {
    /// Remarks for the user.
    pub fn remarks(&self) -> Vec<Remark> {
        let Self { project, name } = self;
        let mut remarks: Vec<Remark> = name.iter().cloned().map(Remark::OneOfSeveral).collect();
        remarks.push(project.times());
        if project.missing.duration && project.has_times() {
            remarks.push(Remark::NoClipControl { listed: project.clip.stretch().is_some() });
        }
        remarks.extend(project.missing.clip.then_some(Remark::NoClip));
        remarks.extend(project.calibration());
        remarks.extend(project.reference.clone().map(Remark::Reference));
        for mass in project.shown().filter(|mass| mass.has_keys) {
            let keys = mass.marks.iter().filter(|mark| mark.key).count();
            if keys < mass.marks.len() {
                remarks.push(Remark::Unconfirmed { mass: mass.name.clone(), keys, marks: mass.marks.len() });
            }
        }
        let marks = project.masses.iter().flat_map(|mass| &mass.marks);
        let outside = marks.filter(|mark| !project.clip.includes(mark.frame)).count();
        remarks.extend((outside > 0).then_some(Remark::OutsideClip(outside)));
        let mut others: Vec<(LeftOut, Vec<String>)> = Vec::new();
        for (class, name) in &project.others {
            let Some(kind) = LeftOut::of_class(class) else { continue };
            let name = if name.is_empty() { class.clone() } else { name.clone() };
            match others.iter_mut().find(|(other, _)| *other == kind) {
                Some((_, names)) => names.push(name),
                None => others.push((kind, vec![name])),
            }
        }
        sort_by_key(&mut others, |(kind, _)| *kind);
        remarks.extend(others.into_iter().map(|(kind, names)| Remark::LeftOut(kind, names)));
        remarks.extend((!project.filters.is_empty()).then(|| Remark::Filters(project.filters.clone())));
        remarks
    }
}

impl Project {
    fn times(&self) -> Remark {
        if let Some(stretch) = self.clip.stretch() {
            return Remark::ListedTimes { stretch };
        }
        let film = self.trackable();
        if !self.clip.is_timed() {
            return Remark::FrameNumbers { film: film.map(|film| film.path.clone()) };
        }
        Remark::ConstantStep {
            milliseconds: 1000.0 * self.clip.interval,
            film: film.map(|film| film.path.clone()),
            packed: film.is_some_and(|film| film.packed.is_some()),
        }
    }

    fn calibration(&self) -> Vec<Remark> {
        let scaled = self.coordinates.is_scaled();
        let axes = self.coordinates.at(self.clip.first);
        let unit = scaled.then(|| self.column_unit());
        let mut remarks = vec![Remark::Calibration { axes, changes: self.coordinates.changes(), unit }];
        if scaled && self.length_unit.is_none() {
            remarks.push(Remark::AssumedMetres);
        }
        remarks
    }
}

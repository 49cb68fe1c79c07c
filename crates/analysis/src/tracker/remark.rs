//! What a person should know about a project, in words.

use super::coordinates::Placement;
use super::project::{Opened, Project};
use units::Language;

/// Something a person should know about the data of a project.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The archive holds several projects; this is the one that was read, by its name.
    OneOfSeveral(String),
    /// Times are the number of the frame times a constant step.
    ConstantStep {
        /// The step in milliseconds.
        milliseconds: f64,
        /// The path of the film, if it is one with times of its own.
        film: Option<String>,
        /// Whether the film is in the archive of the project.
        packed: bool,
    },
    /// The project does not state how long a frame lasts, and nothing else does: the table has the numbers of the frames.
    FrameNumbers {
        /// The path of the film, if it is one with times of its own.
        film: Option<String>,
    },
    /// The project has no clip control, which states how long a frame lasts: times are the listed ones, or of the step that its pictures
    /// state.
    NoClipControl {
        /// Whether they are the listed ones.
        listed: bool,
    },
    /// The project has no video clip, which states the frames that it uses.
    NoClip,
    /// The project lists the times of all frames, which are multiplied by a factor.
    ListedTimes {
        /// The factor, as the project states another mean duration of a frame than its film.
        stretch: f64,
    },
    /// Times are those of the frames of the film, which was opened.
    FilmTimes {
        /// The constant step that the project states, in milliseconds, if it does.
        milliseconds: Option<f64>,
    },
    /// How pixels became lengths.
    Calibration {
        /// The axes and the scale, those of the first frame.
        axes: Placement,
        /// Whether they change from frame to frame.
        changes: bool,
        /// The unit of lengths; `None` where the project has no scale.
        unit: Option<String>,
    },
    /// The project has a scale, but states no unit of length.
    AssumedMetres,
    /// Tracker shows positions relative to this mass.
    Reference(String),
    /// Positions of a mass that are no key frames.
    Unconfirmed {
        /// The mass.
        mass: String,
        /// How many positions are key frames.
        keys: usize,
        /// How many there are.
        marks: usize,
    },
    /// Positions in frames that do not belong to the clip.
    OutsideClip(usize),
    /// Tracks of a kind that was left out, by their names.
    LeftOut(LeftOut, Vec<String>),
    /// Filters of the film's pictures.
    Filters(Vec<String>),
}

/// What is not read of a project.
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
    /// What a track of this class is; `None` for what is part of the calibration.
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
        let (english, spanish) = match self {
            Self::Models => ("models", "modelos"),
            Self::Centres => ("centres of mass", "centros de masas"),
            Self::Data => ("pasted data", "datos pegados"),
            Self::Vectors => ("vectors", "vectores"),
            Self::Profiles => ("line profiles", "perfiles de línea"),
            Self::Regions => ("RGB regions", "regiones RGB"),
            Self::Tools => ("protractors and circle fitters", "transportadores y ajustes de círculo"),
            Self::Others => ("other tracks", "otras trayectorias"),
        };
        language.pick(english, spanish)
    }
}

impl Opened {
    /// What a person should know about it.
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
        others.sort_by_key(|(kind, _)| *kind);
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

//! Errors of reading a project.

use super::wording::listed;
use packed::Defect;
use units::{Language, say};

/// Reason why a project was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TrackerError {
    /// The file is XML of Open Source Physics, but not a project of one film.
    NotAProject {
        /// Last part of the class of its object.
        class: String,
    },
    /// The file is a set of tabs of Tracker.
    Tabs {
        /// Projects and films of the tabs, as named in the file.
        files: Vec<String>,
    },
    /// No point mass is marked.
    NoMass {
        /// True if it names a film that can be tracked here.
        film: bool,
    },
    /// Only one frame is marked.
    OneFrame {
        /// True if it names a film that can be tracked here.
        film: bool,
    },
    /// The XML declares entities, or uses undefined ones; no program writes such a project.
    Entities,
    /// The XML or the archive is truncated or changed.
    Damaged,
    /// The archive needs a password.
    Protected,
    /// The project would expand too much.
    Expands {
        /// Size in the archive, in bytes.
        packed: u64,
        /// Expanded size, in bytes.
        expanded: u64,
    },
    /// The project holds more masses or positions than can be read.
    TooLarge,
}

impl TrackerError {
    /// Message for users.
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::NotAProject { class } => {
                say!(language, "this is a file of Open Source Physics, but no project of Tracker: it holds a `{class}`")
            }
            Self::Tabs { files } => {
                let names = listed(files, language);
                say!(language, "this is a set of tabs of Tracker, and not a project; it names {names}")
            }
            Self::NoMass { .. } => language.say("no point mass is marked in this project of Tracker").to_owned(),
            Self::OneFrame { .. } => language.say("only one frame is marked in this project of Tracker").to_owned(),
            Self::Entities => {
                language.say("this project of Tracker uses entities of XML that no program writes").to_owned()
            }
            Self::Damaged => language.say("the project of Tracker is damaged or incomplete").to_owned(),
            Self::Protected => language.say("the archive is protected by a password").to_owned(),
            Self::Expands { packed, expanded } => {
                let (packed, expanded) = (packed.div_ceil(1000), expanded.div_ceil(1000));
                say!(language, "{packed} kB of the archive would expand to {expanded} kB, more than a project needs")
            }
            Self::TooLarge => language.say("the project holds more masses or positions than can be read").to_owned(),
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match self {
            Self::NotAProject { .. } => language.say("open it in Tracker and save the tab with the film"),
            Self::Tabs { .. } => language.say("open them one by one"),
            Self::NoMass { film: false } | Self::OneFrame { film: false } => language.say("mark a point mass in several frames in Tracker and save the project; it names no film that can be tracked here"),
            Self::NoMass { film: true } | Self::OneFrame { film: true } => language.say("mark a point mass in Tracker and save the project, or track its film: in the tab Measure of the page, or with `meniscus track`"),
            Self::Entities | Self::Damaged => language.say("open it in Tracker and save it again, or export the table there: File > Export > Data File"),
            Self::Protected => language.say("save it without a password"),
            Self::Expands { .. } | Self::TooLarge => language.say("export the table of one mass in Tracker: File > Export > Data File"),
        }
    }
}

impl From<Defect> for TrackerError {
    fn from(defect: Defect) -> Self {
        match defect {
            Defect::Damaged => Self::Damaged,
            Defect::Protected => Self::Protected,
            Defect::Expands { packed, expanded } => Self::Expands { packed, expanded },
        }
    }
}

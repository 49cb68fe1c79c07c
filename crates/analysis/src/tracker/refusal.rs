//! Errors of reading a project.

use super::wording::listed;
use crate::packed::Defect;
use units::Language::{self, Spanish};

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
        let say = |english: &str, other: &str| (if language == Spanish { other } else { english }).to_owned();
        match self {
            Self::NotAProject { class } => say(
                &format!("this is a file of Open Source Physics, but no project of Tracker: it holds a `{class}`"),
                &format!("es un archivo de Open Source Physics, pero no un proyecto de Tracker: contiene un «{class}»"),
            ),
            Self::Tabs { files } => {
                let names = listed(files, language);
                say(
                    &format!("this is a set of tabs of Tracker, and not a project; it names {names}"),
                    &format!("es un conjunto de pestañas de Tracker, y no un proyecto; nombra {names}"),
                )
            }
            Self::NoMass { .. } => say(
                "no point mass is marked in this project of Tracker",
                "en este proyecto de Tracker no hay ninguna masa puntual marcada",
            ),
            Self::OneFrame { .. } => say(
                "only one frame is marked in this project of Tracker",
                "en este proyecto de Tracker solo hay un fotograma marcado",
            ),
            Self::Entities => say(
                "this project of Tracker uses entities of XML that no program writes",
                "este proyecto de Tracker usa entidades de XML que ningún programa escribe",
            ),
            Self::Damaged => say(
                "the project of Tracker is damaged or incomplete",
                "el proyecto de Tracker está dañado o incompleto",
            ),
            Self::Protected => {
                say("the archive is protected by a password", "el archivo comprimido está protegido por contraseña")
            }
            Self::Expands { packed, expanded } => {
                let (packed, expanded) = (packed.div_ceil(1000), expanded.div_ceil(1000));
                say(
                    &format!("{packed} kB of the archive would expand to {expanded} kB, more than a project needs"),
                    &format!(
                        "{packed} kB del archivo se convertirían en {expanded} kB, más de lo que necesita un proyecto"
                    ),
                )
            }
            Self::TooLarge => say(
                "the project holds more masses or positions than can be read",
                "el proyecto contiene más masas o posiciones de las que se pueden leer",
            ),
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        let (english, spanish) = match self {
            Self::NotAProject { .. } => (
                "open it in Tracker and save the tab with the film",
                "ábrelo en Tracker y guarda la pestaña con el vídeo",
            ),
            Self::Tabs { .. } => ("open them one by one", "ábrelos uno por uno"),
            Self::NoMass { film: false } | Self::OneFrame { film: false } => (
                "mark a point mass in several frames in Tracker and save the project; it names no film that can be tracked here",
                "marca una masa puntual en varios fotogramas en Tracker y guarda el proyecto; no nombra ningún vídeo que se pueda seguir aquí",
            ),
            Self::NoMass { film: true } | Self::OneFrame { film: true } => (
                "mark a point mass in Tracker and save the project, or track its film: with Open film in the page, or with `meniscus track`",
                "marca una masa puntual en Tracker y guarda el proyecto, o sigue su vídeo: con Abrir un vídeo en la página, o con «meniscus track»",
            ),
            Self::Entities | Self::Damaged => (
                "open it in Tracker and save it again, or export the table there: File > Export > Data File",
                "ábrelo en Tracker y guárdalo de nuevo, o exporta allí la tabla: Archivo > Exportar > Archivo de datos",
            ),
            Self::Protected => ("save it without a password", "guárdalo sin contraseña"),
            Self::Expands { .. } | Self::TooLarge => (
                "export the table of one mass in Tracker: File > Export > Data File",
                "exporta en Tracker la tabla de una masa: Archivo > Exportar > Archivo de datos",
            ),
        };
        language.pick(english, spanish)
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

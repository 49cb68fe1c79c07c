//! What a person should know about a project, in words.

use super::coordinates::Placement;
use super::project::{Opened, Project};
use units::Language::{self, English, Spanish};
use units::number;

/// How many names are listed.
const SHOWN: usize = 6;

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
    /// The project lists the times of all frames, which are multiplied by a factor.
    ListedTimes {
        /// The factor, as the project states another mean duration of a frame than its film.
        stretch: f64,
    },
    /// Times are those of the frames of the film, which was opened.
    FilmTimes {
        /// The constant step that the project states, in milliseconds.
        milliseconds: f64,
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

    fn text(self, language: Language) -> &'static str {
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
        let film = self.film.as_ref().filter(|film| !film.pictures && !film.path.is_empty());
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

impl Remark {
    /// It in a sentence or two, in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let say = |english: String, other: String| if language == Spanish { other } else { english };
        let round = |value: f64, digits: usize| number::plain(value, digits, language.style());
        match self {
            Self::OneOfSeveral(name) => say(
                format!(
                    "the archive holds several projects of Tracker; the first with a marked mass was read: `{name}`"
                ),
                format!(
                    "el archivo contiene varios proyectos de Tracker; se leyó el primero con una masa marcada: «{name}»"
                ),
            ),
            Self::ConstantStep { milliseconds, film, packed } => {
                let step = round(*milliseconds, 8);
                let times = say(
                    format!("times are the frame number times a constant step of {step} ms, as the project states"),
                    format!(
                        "los tiempos son el número del fotograma por un paso constante de {step} ms, como indica el proyecto"
                    ),
                );
                let Some(film) = film else { return times };
                let place = match (packed, language) {
                    (true, English) => " in the archive",
                    (true, Spanish) => " del archivo",
                    (false, _) => "",
                };
                times
                    + &say(
                        format!(
                            "; the film{place}, `{film}`, has a time for each frame, which is better: `meniscus track` reads it"
                        ),
                        format!(
                            "; el vídeo{place}, «{film}», tiene un tiempo para cada fotograma, que es mejor: «meniscus track» lo lee"
                        ),
                    )
            }
            Self::ListedTimes { stretch } if *stretch == 1.0 => say(
                "times are those that the project lists for the frames of its film".to_owned(),
                "los tiempos son los que el proyecto enumera para los fotogramas de su vídeo".to_owned(),
            ),
            Self::ListedTimes { stretch } => {
                let factor = round(*stretch, 6);
                say(
                    format!(
                        "times are those that the project lists for the frames of its film, multiplied by {factor}, since it states \
                         another frame rate than the film has"
                    ),
                    format!(
                        "los tiempos son los que el proyecto enumera para los fotogramas de su vídeo, multiplicados por {factor}, pues \
                         indica otra frecuencia de fotogramas que la del vídeo"
                    ),
                )
            }
            Self::FilmTimes { milliseconds } => {
                let step = round(*milliseconds, 8);
                say(
                    format!(
                        "times are those of the frames of its film, and not the constant step of {step} ms of the project"
                    ),
                    format!(
                        "los tiempos son los de los fotogramas de su vídeo, y no el paso constante de {step} ms del proyecto"
                    ),
                )
            }
            Self::Calibration { axes, changes, unit } => calibration(axes, *changes, unit.as_deref(), language),
            Self::AssumedMetres => say(
                "the project states no unit of length: metres are assumed, as Tracker does".to_owned(),
                "el proyecto no indica la unidad de longitud: se suponen metros, como hace Tracker".to_owned(),
            ),
            Self::Reference(mass) => say(
                format!("Tracker shows positions relative to {mass}; those here are relative to the axes"),
                format!("Tracker muestra las posiciones respecto a {mass}; aquí son respecto a los ejes"),
            ),
            Self::Unconfirmed { mass, keys, marks } => say(
                format!(
                    "{mass}: {keys} of {marks} positions are key frames, marked by hand or confirmed; the autotracker found the \
                     others, or they were interpolated (autofill)"
                ),
                format!(
                    "{mass}: {keys} de {marks} posiciones son fotogramas clave, marcados a mano o confirmados; las demás las \
                     encontró el autotracker o se interpolaron (autofill)"
                ),
            ),
            Self::OutsideClip(count) => say(
                format!("positions outside the clip that the project selects were left out: {count}"),
                format!("se dejaron fuera las posiciones ajenas al corte que elige el proyecto: {count}"),
            ),
            Self::LeftOut(kind, names) => {
                let (kind, names) = (kind.text(language), listed(names, language));
                say(format!("{kind} were not read: {names}"), format!("no se leyeron {kind}: {names}"))
            }
            Self::Filters(names) => {
                let names = listed(names, language);
                say(
                    format!("the project filters its film ({names}); positions belong to the filtered pictures"),
                    format!(
                        "el proyecto filtra su vídeo ({names}); las posiciones pertenecen a las imágenes filtradas"
                    ),
                )
            }
        }
    }
}

fn calibration(axes: &Placement, changes: bool, unit: Option<&str>, language: Language) -> String {
    let round = |value: f64| number::plain(value, 5, language.style());
    let [along, down] = axes.scale.map(round);
    let origin = axes.origin.map(|value| number::fixed(value, 1, language.style())).join("; ");
    let angle = number::fixed(axes.angle, 2, language.style());
    let mut text = match (unit, language, along == down) {
        (None, English, _) => "the project has no scale: positions are in pixels, y upwards".to_owned(),
        (None, Spanish, _) => "el proyecto no tiene escala: las posiciones están en píxeles, y hacia arriba".to_owned(),
        (Some(unit), English, true) => format!("the scale of the project is {along} px/{unit}"),
        (Some(unit), Spanish, true) => format!("la escala del proyecto es {along} px/{unit}"),
        (Some(unit), English, false) => {
            format!(
                "the scale of the project is {along} px/{unit} along the rows and {down} px/{unit} along the columns"
            )
        }
        (Some(unit), Spanish, false) => {
            format!("la escala del proyecto es {along} px/{unit} en las filas y {down} px/{unit} en las columnas")
        }
    };
    text.push_str(&match language {
        English => format!("; the origin is at the pixel ({origin}), the x axis at {angle}°"),
        Spanish => format!("; el origen está en el píxel ({origin}) y el eje x a {angle}°"),
    });
    if changes {
        text.push_str(language.pick(
            " in the first frame; they change from frame to frame, which is taken into account",
            " en el primer fotograma; cambian de un fotograma a otro, lo que se tiene en cuenta",
        ));
    }
    if unit.is_some() {
        text.push_str(language.pick(
            "; the project states no error of the scale, and errors of lengths in fits do not include it",
            "; el proyecto no indica el error de la escala, y los errores de las longitudes en los ajustes no lo incluyen",
        ));
    }
    text
}

/// The first names of a list.
fn listed(names: &[String], language: Language) -> String {
    let shown = names.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(SHOWN) {
        0 => shown,
        more => language.pick(format!("{shown} and {more} more"), format!("{shown} y {more} más")),
    }
}

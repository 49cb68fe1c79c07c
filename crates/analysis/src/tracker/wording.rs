//! Texts of the remarks.

use super::coordinates::Placement;
use super::remark::Remark;
use units::Language::{self, English, Spanish};
use units::number;

/// Upper bound of the listed names.
const SHOWN: usize = 6;

impl Remark {
    /// Remark as one or two sentences in English or Spanish.
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
                            "; the film{place}, `{film}`, has a time for each frame, which is better: track it, with Open film in the page or with `meniscus track`"
                        ),
                        format!(
                            "; el vídeo{place}, «{film}», tiene un tiempo para cada fotograma, que es mejor: síguelo, con Abrir un vídeo en la página o con «meniscus track»"
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
            Self::FrameNumbers { film } => {
                let numbers = say(
                    "the project does not state how long a frame lasts, and no duration is assumed: the first column is the number of \
                     the frame, and not a time"
                        .to_owned(),
                    "el proyecto no indica cuánto dura un fotograma, y no se supone ninguna duración: la primera columna es el número \
                     del fotograma, y no un tiempo"
                        .to_owned(),
                );
                let remedy = match film {
                    Some(film) => say(
                        format!("; the film, `{film}`, has a time for each frame: track it, with Open film in the page or with `meniscus track`"),
                        format!("; el vídeo, «{film}», tiene un tiempo para cada fotograma: síguelo, con Abrir un vídeo en la página o con «meniscus track»"),
                    ),
                    None => say(
                        "; set the frame rate in Tracker and save the project".to_owned(),
                        "; indica en Tracker los fotogramas por segundo y guarda el proyecto".to_owned(),
                    ),
                };
                numbers + &remedy
            }
            Self::NoClipControl { listed: true } => say(
                "the project has no clip control, which states the mean duration of a frame: the listed times were taken as they are"
                    .to_owned(),
                "el proyecto no tiene control del vídeo, que indica la duración media de un fotograma: los tiempos enumerados se tomaron \
                 tal cual"
                    .to_owned(),
            ),
            Self::NoClipControl { listed: false } => say(
                "the project has no clip control, which states the duration of a frame: the one of its pictures was taken".to_owned(),
                "el proyecto no tiene control del vídeo, que indica la duración de un fotograma: se tomó la de sus imágenes".to_owned(),
            ),
            Self::NoClip => say(
                "the project has no video clip, which states the frames that it uses: all marked frames were read, and time zero is \
                 frame 0"
                    .to_owned(),
                "el proyecto no tiene corte del vídeo, que indica los fotogramas que usa: se leyeron todos los marcados, y el tiempo cero \
                 es el fotograma 0"
                    .to_owned(),
            ),
            Self::FilmTimes { milliseconds: None } => say(
                "times are those of the frames of its film".to_owned(),
                "los tiempos son los de los fotogramas de su vídeo".to_owned(),
            ),
            Self::FilmTimes { milliseconds: Some(milliseconds) } => {
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

/// First names of a list, and the number of the others.
pub(super) fn listed(names: &[String], language: Language) -> String {
    let shown = names.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(SHOWN) {
        0 => shown,
        more => language.pick(format!("{shown} and {more} more"), format!("{shown} y {more} más")),
    }
}

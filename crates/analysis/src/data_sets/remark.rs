//! Remarks on data sets, as text.

use units::Language::{self, Spanish};
use units::number;

/// Remark on data sets that were exported together.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// There are several sets, with these names.
    Several(Vec<String>),
    /// A file or sheet is no table and was left out.
    NoTable(String),
    /// A set was left out, because all together are too large.
    TooMany(String),
    /// App and phone of the measurement; empty where the file does not state them.
    Device {
        /// Version of phyphox.
        version: String,
        /// Manufacturer and model.
        phone: String,
    },
    /// Sensor of a set; texts that the file does not state are empty.
    Sensor {
        /// Name of the set.
        set: String,
        /// Name of the sensor.
        name: String,
        /// Range, in the unit.
        range: String,
        /// Resolution, in the unit.
        resolution: String,
        /// Unit of the set.
        unit: String,
    },
    /// The measurement was paused.
    Pauses {
        /// Number of pauses.
        count: usize,
        /// Experiment time of the first pause, s.
        from: f64,
        /// Length of the first pause, s; `None` if unknown.
        length: Option<f64>,
        /// True if the times after a pause were shifted by it.
        moved: bool,
    },
}

impl Remark {
    /// True if the remark concerns the record of this set.
    pub fn is_about(&self, name: &str) -> bool {
        match self {
            Self::Several(_) | Self::NoTable(_) | Self::TooMany(_) => false,
            Self::Device { .. } | Self::Pauses { .. } => true,
            Self::Sensor { set, .. } => set == name,
        }
    }

    /// Remark as a sentence in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let say = |english: String, other: String| if language == Spanish { other } else { english };
        let decimal = |value: f64| number::plain(value, 6, language.style());
        match self {
            Self::Several(names) => {
                let (list, last) = (names.join(", "), names.last().map_or("", String::as_str));
                let count = names.len();
                say(
                    format!(
                        "there are {count} data sets, each with its own times on a common clock: {list}; a column is named with its \
                         set, `{last}.X`"
                    ),
                    format!(
                        "hay {count} conjuntos de datos, cada uno con sus tiempos en un reloj común: {list}; una columna se nombra \
                         con su conjunto, «{last}.X»"
                    ),
                )
            }
            Self::NoTable(name) => say(
                format!("`{name}` holds no table and was left out"),
                format!("«{name}» no contiene una tabla y se dejó fuera"),
            ),
            Self::TooMany(name) => say(
                format!("`{name}` was left out: all data sets together are too large"),
                format!("«{name}» se dejó fuera: todos los conjuntos de datos juntos son demasiado grandes"),
            ),
            Self::Device { version, phone } => {
                let version = if version.is_empty() { String::new() } else { format!(" {version}") };
                let on = |word: &str| if phone.is_empty() { String::new() } else { format!("{word}{phone}") };
                say(
                    format!("recorded with phyphox{version}{}", on(" on ")),
                    format!("registrado con phyphox{version}{}", on(" en ")),
                )
            }
            Self::Sensor { set, name, range, resolution, unit } => {
                let part = |word: &str, value: &str, unit: &str| {
                    (!value.is_empty()).then(|| format!("{word} {value} {unit}").trim().to_owned())
                };
                let list = |words: [&str; 3]| {
                    let [sensor, span, step] = words;
                    [part(sensor, name, ""), part(span, range, unit), part(step, resolution, unit)]
                        .into_iter()
                        .flatten()
                        .collect::<Vec<_>>()
                        .join(", ")
                };
                say(
                    format!("{set}: {}", list(["sensor", "range", "resolution"])),
                    format!("{set}: {}", list(["sensor", "rango", "resolución"])),
                )
            }
            Self::Pauses { count, from, length, moved } => {
                let from = decimal(*from);
                let long = |word: &str| length.map_or(String::new(), |length| format!("{word}{} s", decimal(length)));
                let paused = match count {
                    1 => say(
                        format!("measuring was paused at {from} s of the experiment time{}", long(", for ")),
                        format!("la medición se pausó a los {from} s del tiempo del experimento{}", long(", durante ")),
                    ),
                    _ => say(
                        format!(
                            "measuring was paused {count}×, first at {from} s of the experiment time{}",
                            long(", for ")
                        ),
                        format!(
                            "la medición se pausó {count}×, la primera vez a los {from} s del tiempo del experimento{}",
                            long(", durante ")
                        ),
                    ),
                };
                let then = match (moved, length) {
                    (true, _) => say(
                        "; its clock stands still meanwhile, so the times after a pause were moved on by its length: a gap".to_owned(),
                        "; su reloj se detiene entretanto, así que los tiempos tras una pausa se desplazaron lo que duró: un hueco".to_owned(),
                    ),
                    (false, Some(_)) => say("; the times have a gap there".to_owned(), "; los tiempos tienen ahí un hueco".to_owned()),
                    (false, None) => say(
                        "; how long is not stated, so the times go on without a gap".to_owned(),
                        "; no consta cuánto, así que los tiempos siguen sin hueco".to_owned(),
                    ),
                };
                paused + &then
            }
        }
    }
}

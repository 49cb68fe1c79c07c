//! Remarks on data sets, as text.

use units::number;
use units::{Language, say};

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
        let decimal = |value: f64| number::plain(value, 6, language.style());
        match self {
            Self::Several(names) => {
                let (list, last) = (names.join(", "), names.last().map_or("", String::as_str));
                let count = names.len();
                say!(
                    language,
                    "there are {count} data sets, each with its own times on a common clock: {list}; a column is named with its \
                         set, `{last}.X`"
                )
            }
            Self::NoTable(name) => say!(language, "`{name}` holds no table and was left out"),
            Self::TooMany(name) => say!(language, "`{name}` was left out: all data sets together are too large"),
            Self::Device { version, phone } => {
                let version = if version.is_empty() { String::new() } else { format!(" {version}") };
                match phone.as_str() {
                    "" => say!(language, "recorded with phyphox{version}"),
                    phone => say!(language, "recorded with phyphox{version} on {phone}"),
                }
            }
            Self::Sensor { set, name, range, resolution, unit } => {
                let part = |word: &str, value: &str, unit: &str| {
                    (!value.is_empty()).then(|| format!("{word} {value} {unit}").trim().to_owned())
                };
                let [sensor, span, step] = language.say_all(["sensor", "range", "resolution"]);
                let parts = [part(sensor, name, ""), part(span, range, unit), part(step, resolution, unit)];
                format!("{set}: {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
            }
            Self::Pauses { count, from, length, moved } => {
                let from = decimal(*from);
                let long = length.map_or(String::new(), |length| say!(language, ", for {} s", decimal(length)));
                let paused = match count {
                    1 => say!(language, "measuring was paused at {from} s of the experiment time{long}"),
                    _ => {
                        say!(language, "measuring was paused {count}×, first at {from} s of the experiment time{long}")
                    }
                };
                let then = match (moved, length) {
                    (true, _) => language.say("; its clock stands still meanwhile, so the times after a pause were moved on by its length: a gap"),
                    (false, Some(_)) => language.say("; the times have a gap there"),
                    (false, None) => language.say("; how long is not stated, so the times go on without a gap"),
                };
                paused + then
            }
        }
    }
}

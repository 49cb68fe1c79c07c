//! What was noticed about a file, and what its measurement hides, in words.

mod heading;
mod words;

use crate::sampling::Gap;
use crate::stencil::Stencil;
use crate::tracker::Remark;
use crate::{data_sets, roles};
pub use heading::{Certainty, Heading};
use units::Language::{self, Spanish};
pub(crate) use words::readings;
use words::{backwards, called, clock, decimal, missing, reading, rounded_step, runs, separator, word};

/// Something a person should know about their data. Lines and rows count from 1; times are in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The workbook has several sheets; this is the one that was read, by its name.
    Sheet(String),
    /// What the positions of a project of Tracker are.
    Project(Remark),
    /// What was noticed about data sets that were exported together.
    DataSets(data_sets::Remark),
    /// A word, or a number too large for a double, stands where a number should; the cell became a gap.
    Word {
        /// The line of the file.
        line: usize,
        /// The column, by its label.
        column: String,
        /// What stands there.
        text: String,
    },
    /// So many more words, which are not listed.
    MoreWords(usize),
    /// Lines of words between the rows; they were passed over.
    WordLines {
        /// The first of them.
        line: usize,
        /// How many.
        count: usize,
    },
    /// A column of words was left out.
    WordColumn(String),
    /// A column has a name but no number.
    EmptyColumn(String),
    /// Rows with more cells than a table of this size can have columns; what was beyond was left out.
    ExtraCells {
        /// The first of them.
        line: usize,
        /// How many rows.
        count: usize,
    },
    /// What was decided about names, units and errors in the header.
    Heading(Heading),
    /// What stands in the brackets of a header is no unit.
    UnknownUnit {
        /// The column.
        column: String,
        /// What stands there.
        unit: String,
    },
    /// A comma or a point could be read in two ways, and a column contradicts one of them.
    Separator {
        /// The line of the first number with it.
        line: usize,
        /// That number: `1,295`.
        text: String,
        /// A number without it in the same column: `926`.
        beside: String,
        /// Whether it was taken to group digits, and not for a decimal sign.
        thousands: bool,
    },
    /// All commas have three digits behind them; they were taken for decimal signs.
    DecimalSign {
        /// The line of the first.
        line: usize,
        /// The number: `1,295`.
        text: String,
    },
    /// All points or commas between the digits of a column's numbers have three digits behind them, and the file's decimal sign is
    /// the other one; they were taken to group digits.
    GroupSign {
        /// The line of the first.
        line: usize,
        /// The number: `1.295`.
        text: String,
    },
    /// A column has the other decimal sign than the rest of the file, and was read with its own.
    OtherSign {
        /// The column.
        column: String,
        /// Whether its numbers have a point, and the others a comma.
        point: bool,
    },
    /// Clock times or dates were read as seconds from the first row.
    Clock {
        /// The column.
        column: String,
        /// Whether it holds dates alone.
        days: bool,
        /// How often the clock began again at zero.
        wrapped: usize,
        /// Whether `12:30` was taken for minutes and seconds without anything that says so.
        minutes: bool,
    },
    /// The time stamps of a serial monitor were left out for the times of the device itself.
    Stamps {
        /// The unit in which those are.
        unit: String,
    },
    /// The runs of a logger, each with its own clock.
    Runs(Vec<String>),
    /// The role of columns, where it is not plain.
    Role(roles::Remark),
    /// No unit is stated for a time; it is taken for seconds, or in a fit for the unit of the model's time.
    AssumedSeconds(String),
    /// The times of these columns are all the same, or there are none.
    NoTimes(String),
    /// All lengths share a relative standard error, that of the scale of their film.
    Scale(f64),
    /// Frames are missing.
    Missing {
        /// Where.
        gaps: Vec<Gap>,
        /// The unit of the times, `s`.
        unit: &'static str,
    },
    /// Rows with the time of the row before.
    Doubled {
        /// The first such time.
        time: f64,
        /// Its unit.
        unit: &'static str,
        /// How many.
        count: usize,
    },
    /// Rows that are earlier than the row before.
    Backwards {
        /// The first such time.
        time: f64,
        /// Its unit.
        unit: &'static str,
        /// How many.
        count: usize,
    },
    /// The distances of the rows vary by this part of their mean (standard deviation).
    Uneven(f64),
    /// Every time is rounded.
    RoundedTimes {
        /// To this.
        to: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// The time step itself was rounded, and the error adds up.
    RoundedStep {
        /// The step of the file.
        interval: f64,
        /// Frames a second.
        rate: f64,
    },
    /// A column was computed from another one by finite differences.
    Derived {
        /// The column.
        column: String,
        /// What it was computed from.
        of: String,
        /// How.
        stencil: Stencil,
        /// The factor by which it is too small at the frequency of this record, if that is known.
        attenuation: Option<f64>,
    },
}

impl Finding {
    /// It in a sentence or two, in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let say = |english: String, other: String| if language == Spanish { other } else { english };
        match self {
            Self::Sheet(name) => say(
                format!("the workbook has several sheets; the first with a table was read: `{name}`"),
                format!("el libro tiene varias hojas; se leyó la primera con una tabla: «{name}»"),
            ),
            Self::Project(remark) => remark.text(language),
            Self::DataSets(remark) => remark.text(language),
            Self::Word { line, column, text } => word(*line, column, text, language),
            Self::MoreWords(count) => say(
                format!("{count} more cells are not numbers and became gaps"),
                format!("otras {count} celdas no son números y quedaron como huecos"),
            ),
            Self::WordLines { line, count: 1 } => say(
                format!("line {line} has no number and was passed over"),
                format!("la línea {line} no tiene números y se pasó por alto"),
            ),
            Self::WordLines { line, count } => say(
                format!("{count} lines have no number and were passed over; the first is line {line}"),
                format!("{count} líneas no tienen números y se pasaron por alto; la primera es la {line}"),
            ),
            Self::WordColumn(column) => say(
                format!("column {column} holds words and was left out"),
                format!("la columna {column} contiene palabras y se dejó fuera"),
            ),
            Self::EmptyColumn(column) => {
                say(format!("column {column} is empty"), format!("la columna {column} está vacía"))
            }
            Self::ExtraCells { line, count } => say(
                format!(
                    "{count} rows are longer than the others, the first in line {line}; the cells beyond were left out"
                ),
                format!(
                    "{count} filas son más largas que las otras, la primera en la línea {line}; lo que sobra se dejó fuera"
                ),
            ),
            Self::Heading(heading) => heading.text(language),
            Self::UnknownUnit { column, unit } => say(
                format!("`{unit}`, the unit of {column}, is not known; until one is stated, its numbers have none"),
                format!(
                    "«{unit}», la unidad de {column}, no se conoce; mientras no se indique, sus números no tienen unidad"
                ),
            ),
            Self::Separator { line, text, beside, thousands } => separator(*line, text, beside, *thousands, language),
            Self::DecimalSign { line, text } => {
                let [decimal, thousands] = readings(text, language);
                say(
                    format!(
                        "line {line}: the comma of `{text}` is taken for a decimal sign: {decimal}, not {thousands}"
                    ),
                    format!("línea {line}: la coma de «{text}» se toma como signo decimal: {decimal}, no {thousands}"),
                )
            }
            Self::GroupSign { line, text } => {
                let [decimal, thousands] = readings(text, language);
                say(
                    format!(
                        "line {line}: `{text}` is read as {thousands} and not as {decimal}, as other numbers of the file have the other sign for their decimals"
                    ),
                    format!(
                        "línea {line}: «{text}» se lee como {thousands} y no como {decimal}, pues otros números del archivo tienen el otro signo decimal"
                    ),
                )
            }
            Self::OtherSign { column, point } => {
                let column = called(column, language);
                let (english, spanish) = if *point {
                    (["point", "comma"], ["punto decimal", "coma decimal"])
                } else {
                    (["comma", "point"], ["coma decimal", "punto decimal"])
                };
                say(
                    format!(
                        "{column} has a decimal {}, other columns have a decimal {}; each is read with its own sign",
                        english[0], english[1]
                    ),
                    format!(
                        "{column} tiene {}, otras columnas tienen {}; cada una se lee con su propio signo",
                        spanish[0], spanish[1]
                    ),
                )
            }
            Self::Clock { column, days, wrapped, minutes } => clock(column, *days, *wrapped, *minutes, language),
            Self::Stamps { unit } => say(
                format!(
                    "each line has a time stamp; the column behind it shows the same times in {unit} and is used instead, as \
                     it was not delayed on the way"
                ),
                format!(
                    "cada línea tiene una marca de tiempo; la columna siguiente da los mismos tiempos en {unit} y se usa en su \
                     lugar, pues no sufrió el retardo de la transmisión"
                ),
            ),
            Self::Runs(names) => runs(names, language),
            Self::Role(remark) => remark.text(language),
            Self::AssumedSeconds(column) => {
                let column = called(column, language);
                say(
                    format!(
                        "no unit is stated for the times of {column}: they are taken for seconds, or in a fit for the unit of \
                         the model's time; the header `t [ms]` states one"
                    ),
                    format!(
                        "no se indica la unidad de los tiempos de {column}: se toman como segundos o, en un ajuste, en la \
                         unidad del tiempo del modelo; el encabezado «t [ms]» la indica"
                    ),
                )
            }
            Self::NoTimes(column) => {
                let column = called(column, language);
                say(
                    format!("the times in {column} are missing or all the same: nothing can be measured against them"),
                    format!(
                        "los tiempos de {column} faltan o son todos iguales: no se puede medir nada frente a ellos"
                    ),
                )
            }
            Self::Scale(error) => {
                let percent = decimal(100.0 * error, 2, language);
                say(
                    format!(
                        "all lengths share the standard error of the film's scale, {percent} %, which fits take into account"
                    ),
                    format!(
                        "todas las longitudes comparten el error estándar de la escala del vídeo, {percent} %, que los ajustes tienen \
                         en cuenta"
                    ),
                )
            }
            Self::Missing { gaps, unit } => missing(gaps, unit, language),
            Self::Doubled { time, unit, count: 1 } => say(
                format!("the time {} stands twice", reading(*time, unit, language)),
                format!("el tiempo {} está repetido", reading(*time, unit, language)),
            ),
            Self::Doubled { time, unit, count } => say(
                format!(
                    "{count} rows repeat the time of the row before, the first at {}",
                    reading(*time, unit, language)
                ),
                format!(
                    "{count} filas repiten el tiempo de la anterior, la primera en {}",
                    reading(*time, unit, language)
                ),
            ),
            Self::Backwards { time, unit, count } => backwards(*time, unit, *count, language),
            Self::Uneven(jitter) => say(
                format!(
                    "the rows are unevenly spaced: their distances vary by {} %",
                    decimal(100.0 * jitter, 2, language)
                ),
                format!(
                    "las filas no están equiespaciadas: sus distancias varían un {} %",
                    decimal(100.0 * jitter, 2, language)
                ),
            ),
            Self::RoundedTimes { to, unit } => say(
                format!("the times are rounded to {}", reading(*to, unit, language)),
                format!("los tiempos están redondeados a {}", reading(*to, unit, language)),
            ),
            Self::RoundedStep { interval, rate } => rounded_step(*interval, *rate, language),
            Self::Derived { column, of, stencil, attenuation } => {
                let numbered = of.bytes().all(|byte| byte.is_ascii_digit());
                let formula = stencil.formula(if numbered { "x" } else { of });
                let (column, of) = (called(column, language), called(of, language));
                let made = say(
                    format!("{column} was computed from {of}, {formula}: it adds no independent information"),
                    format!("{column} se calculó a partir de {of}, {formula}: no aporta información independiente"),
                );
                let Some(factor) = attenuation else { return made };
                let percent = decimal(100.0 * (1.0 - factor), 2, language);
                made + &say(
                    format!("; at the frequency of this record that makes it too small by {percent} %"),
                    format!("; a la frecuencia de este registro resulta un {percent} % demasiado pequeña"),
                )
            }
        }
    }
}

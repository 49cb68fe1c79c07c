//! Decisions about the header of a file, with their reasons.

use super::words::{called, decimal};
use crate::conversion::UnitReading;
use units::Language::{self, Spanish};

/// Decision about names, units or errors in the header.
#[derive(Clone, Debug, PartialEq)]
pub enum Heading {
    /// Lines of names and units, if other lines could have them too.
    Lines {
        /// Line of names, from 1.
        names: usize,
        /// Line of units, from 1, if there is one.
        units: Option<usize>,
        /// Lines taken as comments, from 1.
        comments: Vec<usize>,
    },
    /// The header has one name less than the table has columns.
    FewNames {
        /// Number of names.
        names: usize,
        /// True if the first column has no name, because it counts or names the rows; false if it is the last one.
        first: bool,
    },
    /// The line of units has no unit for these columns.
    NoUnit(Vec<String>),
    /// The reading of a unit depends on the name of the column.
    Unit {
        /// The column.
        column: String,
        /// Text of the unit.
        written: String,
        /// Reading of the unit.
        reading: UnitReading,
    },
    /// The heading has a power of ten.
    Power {
        /// The column.
        column: String,
        /// Text of the heading.
        heading: String,
        /// Exponent of ten by which the numbers are multiplied.
        tens: i32,
        /// Certainty of this reading.
        certainty: Certainty,
    },
    /// The cells have another unit than the header.
    CellUnit {
        /// The column.
        column: String,
        /// Unit of the header.
        header: String,
        /// Unit of the cells, which is used.
        cells: String,
    },
    /// Some cells of a column have a unit, others have none; all were read in this unit.
    BareNumbers {
        /// The column.
        column: String,
        /// The unit.
        unit: String,
        /// Number of cells without a unit.
        count: usize,
    },
    /// A column holds the standard errors of another one.
    Errors {
        /// The column.
        column: String,
        /// Column to which they belong.
        of: String,
        /// True if that is an independent variable, whose errors are not used.
        unused: bool,
    },
    /// A column is named as standard errors and is not used as such.
    NotErrors {
        /// The column.
        column: String,
        /// Column to which the errors would belong, if there is one.
        of: Option<String>,
    },
}

/// Certainty of the meaning of a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// There is only one meaning.
    Clear,
    /// The usual one of several meanings.
    Usual,
    /// Both meanings are usual; none was applied.
    Open,
}

impl Heading {
    /// Decision as one or two sentences in English or Spanish.
    pub(super) fn text(&self, language: Language) -> String {
        let say = |english: String, other: String| if language == Spanish { other } else { english };
        let list = |lines: &[usize]| lines.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        match self {
            Self::Lines { names, units, comments } => {
                let mut english = format!("line {names} of the file has the names");
                let mut spanish = format!("la línea {names} del archivo tiene los nombres");
                if let Some(units) = units {
                    english.push_str(&format!(", line {units} the units"));
                    spanish.push_str(&format!(", la línea {units} las unidades"));
                }
                say(
                    format!("{english}; taken for a comment: line {}", list(comments)),
                    format!("{spanish}; se toma por comentario: línea {}", list(comments)),
                )
            }
            Self::FewNames { names, first: true } => say(
                format!(
                    "{names} names stand over {} columns: the first column counts or names the rows and has no name",
                    names + 1
                ),
                format!(
                    "hay {names} nombres para {} columnas: la primera numera o nombra las filas y no tiene nombre",
                    names + 1
                ),
            ),
            Self::FewNames { names, first: false } => say(
                format!(
                    "{names} names stand over {} columns: the last column has no name, as the first does not count the rows",
                    names + 1
                ),
                format!(
                    "hay {names} nombres para {} columnas: la última no tiene nombre, pues la primera no numera las filas",
                    names + 1
                ),
            ),
            Self::NoUnit(columns) => {
                let columns = columns.join(", ");
                say(
                    format!("the line of units has none for {columns}: its numbers are taken without one"),
                    format!("la línea de unidades no tiene ninguna para {columns}: sus números se toman sin unidad"),
                )
            }
            Self::Unit { column, written, reading } => {
                let (column, reading) = (called(column, language), unit_text(*reading, language));
                say(format!("{column}: `{written}` is {reading}"), format!("{column}: «{written}» es {reading}"))
            }
            Self::Power { column, heading, tens, certainty } => power(column, heading, *tens, *certainty, language),
            Self::CellUnit { column, header, cells } => say(
                format!("{column}: the header says {header}, the cells say {cells}, which counts"),
                format!("{column}: el encabezado dice {header} y las celdas dicen {cells}, que es lo que vale"),
            ),
            Self::BareNumbers { column, unit, count } => say(
                format!("{column}: {count} cells have no unit and were read in {unit}, as the others"),
                format!("{column}: {count} celdas no tienen unidad y se leyeron en {unit}, como las otras"),
            ),
            Self::Errors { column, of, unused: false } => say(
                format!(
                    "{column} is taken for the standard errors of {of}, by its name and numbers; fits use them, cycles do not"
                ),
                format!(
                    "{column} se toma como los errores estándar de {of}, por su nombre y sus números; los ajustes los usan, los ciclos no"
                ),
            ),
            Self::Errors { column, of, unused: true } => say(
                format!(
                    "{column} is called like the standard errors of {of}; errors of an independent variable are not used"
                ),
                format!(
                    "{column} se llama como los errores estándar de {of}; los errores de una variable independiente no se usan"
                ),
            ),
            Self::NotErrors { column, of: Some(of) } => say(
                format!(
                    "{column} is not taken for standard errors of {of}: not all its numbers are positive and small, or its unit is another"
                ),
                format!(
                    "{column} no se toma como errores estándar de {of}: no todos sus números son positivos y pequeños, o su unidad es otra"
                ),
            ),
            Self::NotErrors { column, of: None } => say(
                format!(
                    "{column} is called like standard errors, but no column has the name that it would belong to; it is not used as such"
                ),
                format!(
                    "{column} se llama como unos errores estándar, pero ninguna columna tiene el nombre al que pertenecería; no se usa así"
                ),
            ),
        }
    }
}

fn power(column: &str, heading: &str, tens: i32, certainty: Certainty, language: Language) -> String {
    let (column, factor) = (
        called(column, language),
        if tens.abs() <= 4 { decimal(libm::exp10(f64::from(tens)), 4, language) } else { format!("10^{tens}") },
    );
    match (certainty, language == Spanish) {
        (Certainty::Clear, false) => {
            format!("{column}: the numbers were multiplied by {factor}, as the heading `{heading}` says")
        }
        (Certainty::Clear, true) => {
            format!("{column}: los números se multiplicaron por {factor}, como dice el encabezado «{heading}»")
        }
        (Certainty::Usual, false) => format!(
            "{column}: the numbers were multiplied by {factor}, the usual sense of `{heading}`; if they hold the product already, write the power before the name"
        ),
        (Certainty::Usual, true) => format!(
            "{column}: los números se multiplicaron por {factor}, el sentido usual de «{heading}»; si ya contienen el producto, escribe la potencia delante del nombre"
        ),
        (Certainty::Open, false) => format!(
            "{column}: the power of ten in `{heading}` can mean that the numbers hold the product, or that they are to be multiplied by it; none was applied, and the unit must be stated"
        ),
        (Certainty::Open, true) => format!(
            "{column}: la potencia de diez en «{heading}» puede decir que los números contienen el producto o que hay que multiplicarlos por ella; no se aplicó, y hay que indicar la unidad"
        ),
    }
}

fn unit_text(reading: UnitReading, language: Language) -> &'static str {
    let (english, spanish) = match reading {
        UnitReading::Celsius => (
            "a temperature in °C: 273.15 was added, the column is in K",
            "una temperatura en °C: se sumó 273,15, la columna está en K",
        ),
        UnitReading::Fahrenheit => {
            ("a temperature in °F: the column was converted to K", "una temperatura en °F: la columna se convirtió a K")
        }
        UnitReading::CelsiusDifference => (
            "a difference of temperatures, which is the same in K, as the name says",
            "una diferencia de temperaturas, que en K es la misma, como dice el nombre",
        ),
        UnitReading::FahrenheitDifference => (
            "a difference of temperatures in °F, as the name says: the column was converted to K",
            "una diferencia de temperaturas en °F, como dice el nombre: la columna se convirtió a K",
        ),
        UnitReading::Gravity { thousandth: false } => (
            "multiples of 9.80665 m/s^2 and not gram, as the name is that of an acceleration: the column was converted to m/s^2",
            "múltiplos de 9,80665 m/s^2 y no gramos, pues el nombre es el de una aceleración: la columna se convirtió a m/s^2",
        ),
        UnitReading::Gravity { thousandth: true } => (
            "thousandths of 9.80665 m/s^2 and not milligram, as the name is that of an acceleration: the column was converted to m/s^2",
            "milésimas de 9,80665 m/s^2 y no miligramos, pues el nombre es el de una aceleración: la columna se convirtió a m/s^2",
        ),
        UnitReading::Seconds => (
            "seconds and not siemens, as the name is that of a time",
            "segundos y no siemens, pues el nombre es el de un tiempo",
        ),
    };
    if language == Spanish { spanish } else { english }
}

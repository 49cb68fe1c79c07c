//! Dimensions in words and in columns.

use super::form::Form;
use units::{Dimension, Exponent};

/// `a length`, `an energy`, `a pure number`, or `the dimension kg m^3`.
pub(crate) fn with_article(dimension: Dimension) -> String {
    match noun(dimension) {
        Some(noun) => article(noun),
        None => format!("the dimension {dimension}"),
    }
}

/// `a length`, `something with the dimension kg m^3`: what could be multiplied.
pub(crate) fn as_factor(dimension: Dimension) -> String {
    match noun(dimension) {
        Some(noun) => article(noun),
        None => format!("something with the dimension {dimension}"),
    }
}

/// The usual name of what has this dimension.
pub(crate) fn noun(dimension: Dimension) -> Option<&'static str> {
    if dimension.is_none() { Some("pure number") } else { dimension.quantity_names().first().copied() }
}

fn article(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{} {noun}", if vowel { "an" } else { "a" })
}

/// What stands in a comparison of dimensions.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub title: String,
    pub form: Form,
}

/// The rows under each other, with a column for each base unit, and at the end the usual name of such a quantity.
pub(crate) fn table(rows: &[Row], name_of: impl Fn(usize) -> String) -> String {
    let cells: Vec<Vec<(String, Exponent)>> = rows.iter().map(|row| cells(&row.form, &name_of)).collect();
    let mut columns: Vec<String> = Vec::new();
    // Base units come in one order for every dimension, so the columns of all rows can be merged in that order.
    for symbol in
        BASE.iter().map(|&symbol| symbol.to_owned()).chain(cells.iter().flatten().map(|(symbol, _)| symbol.clone()))
    {
        if !columns.contains(&symbol) && cells.iter().flatten().any(|(other, _)| *other == symbol) {
            columns.push(symbol);
        }
    }
    let mut lines: Vec<String> = rows.iter().map(|row| row.title.clone()).collect();
    align(&mut lines);
    for column in &columns {
        for (line, cells) in lines.iter_mut().zip(&cells) {
            line.push_str("  ");
            if let Some((symbol, exponent)) = cells.iter().find(|(symbol, _)| symbol == column) {
                line.push_str(&power(symbol, *exponent));
            }
        }
        align(&mut lines);
    }
    for (line, row) in lines.iter_mut().zip(rows) {
        if let Some(noun) = row.form.dimension().and_then(noun) {
            line.push_str("  ");
            line.push_str(noun);
        }
        line.truncate(line.trim_end().len());
    }
    lines.join("\n")
}

/// The base units in the order of the columns.
const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

fn cells(form: &Form, name_of: &impl Fn(usize) -> String) -> Vec<(String, Exponent)> {
    let known = form.known.base().map(|(symbol, exponent)| (symbol.to_owned(), exponent));
    let unknown = form.unknown.iter().map(|(variable, exponent)| (name_of(variable.0), *exponent));
    known.chain(unknown).collect()
}

fn power(symbol: &str, exponent: Exponent) -> String {
    if exponent == Exponent::ONE {
        symbol.to_owned()
    } else if exponent.is_whole() {
        format!("{symbol}^{exponent}")
    } else {
        format!("{symbol}^({exponent})")
    }
}

fn align(lines: &mut [String]) {
    let width = lines.iter().map(|line| line.chars().count()).max().unwrap_or_default();
    for line in lines {
        let missing = width - line.chars().count();
        line.extend(std::iter::repeat_n(' ', missing));
    }
}

/// By which factor one of two sides differs from the other, said in the simplest way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Factor {
    /// The first side would have to be multiplied by something of this dimension.
    Lacking(Dimension),
    /// The first side would have to be divided by something of this dimension.
    Excess(Dimension),
}

impl Factor {
    /// From the dimension of `found` divided by that of `expected`.
    pub fn of(ratio: Dimension) -> Self {
        let inverse = ratio.inverse();
        // "a length too many" says more than "a wave number is lacking".
        let oddness = |dimension: Dimension| {
            let negative = dimension.base().filter(|(_, exponent)| exponent.numerator() < 0).count();
            let nameless = usize::from(noun(dimension).is_none());
            (negative, nameless)
        };
        if oddness(inverse) < oddness(ratio) { Self::Lacking(inverse) } else { Self::Excess(ratio) }
    }

    /// `lacks a factor with the dimension of mass`, `has one length too many`
    pub fn verdict(self) -> String {
        match self {
            Self::Lacking(dimension) => match (single(dimension), noun(dimension)) {
                (Some((base, count)), _) if count > 1 => {
                    format!("lacks {} factors with the dimension of {base}", number(count))
                }
                (_, Some(noun)) => format!("lacks a factor with the dimension of {noun}"),
                _ => format!("lacks a factor with the dimension {dimension}"),
            },
            Self::Excess(dimension) => match (single(dimension), noun(dimension)) {
                (Some((base, count)), _) => format!("has {} too many", counted(base, count)),
                (_, Some(noun)) => format!("has a factor with the dimension of {noun} too many"),
                _ => format!("has a factor with the dimension {dimension} too many"),
            },
        }
    }

    /// What the first side would have to be multiplied by.
    pub fn lacking(self) -> Dimension {
        match self {
            Self::Lacking(dimension) => dimension,
            Self::Excess(dimension) => dimension.inverse(),
        }
    }

    /// The dimension of what is lacking or too many.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Lacking(dimension) | Self::Excess(dimension) => dimension,
        }
    }
}

/// The base quantity of which the dimension is a small positive whole power.
fn single(dimension: Dimension) -> Option<(&'static str, i32)> {
    let mut base = dimension.base();
    let (Some((symbol, exponent)), None) = (base.next(), base.next()) else {
        return None;
    };
    let is_small = exponent.is_whole() && (1..=9).contains(&exponent.numerator());
    let quantity = match symbol {
        "kg" => "mass",
        "m" => "length",
        "s" => "time",
        "K" => "temperature",
        "A" => "current",
        _ => return None,
    };
    is_small.then_some((quantity, exponent.numerator()))
}

/// `one length`, `two masses`, `two factors of time` (two times would be something else)
fn counted(base: &str, count: i32) -> String {
    let things = match (base, count) {
        ("time", 1) => "factor of time".to_owned(),
        ("time", _) => "factors of time".to_owned(),
        ("mass", 2..) => "masses".to_owned(),
        (_, 1) => base.to_owned(),
        _ => format!("{base}s"),
    };
    format!("{} {things}", number(count))
}

fn number(count: i32) -> String {
    match count {
        1 => "one".to_owned(),
        2 => "two".to_owned(),
        3 => "three".to_owned(),
        4 => "four".to_owned(),
        count => count.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dimension(unit: &str) -> Dimension {
        units::Unit::parse(unit).unwrap().dimension
    }

    #[test]
    fn says_what_is_too_many_or_lacking() {
        for (ratio, verdict) in [
            ("m", "has one length too many"),
            ("1/m", "lacks a factor with the dimension of length"),
            ("m^2", "has two lengths too many"),
            ("kg^-2", "lacks two factors with the dimension of mass"),
            ("s", "has one factor of time too many"),
            ("1/s", "lacks a factor with the dimension of time"),
            ("N", "has a factor with the dimension of force too many"),
            ("m/kg", "lacks a factor with the dimension of mass per length"),
            ("m^7/A", "has a factor with the dimension m^7 A^-1 too many"),
        ] {
            assert_eq!(Factor::of(dimension(ratio)).verdict(), verdict, "{ratio}");
        }
    }

    #[test]
    fn aligns_the_exponents() {
        let row = |title: &str, unit| Row { title: title.to_owned(), form: Form::from(dimension(unit)) };
        let rows = [row("left side", "N"), row("right", "m/s^2"), row("x", "A^2"), row("y", "")];
        let expected = "left side  kg  m  s^-2       force\n\
                        right          m  s^-2       acceleration\n\
                        x                       A^2\n\
                        y                            pure number";
        assert_eq!(table(&rows, |_| String::new()), expected);
    }
}

//! Dimensions in words and in columns.

use super::form::Form;
use units::{Dimension, Exponent, Language, QuantityName, Words, words};

/// `a length`, `an energy`, `a pure number`, or `the dimension kg m^3`.
pub(crate) fn with_article(dimension: Dimension) -> Words {
    named(dimension).map_or_else(|| words!("the dimension {dimension}"), |name| name.with_article())
}

/// `a length`, `something with the dimension kg m^3`: the object of "multiply by".
pub(crate) fn as_factor(dimension: Dimension) -> Words {
    named(dimension).map_or_else(|| words!("something with the dimension {dimension}"), |name| name.with_article())
}

/// Usual name of a quantity of this dimension.
fn named(dimension: Dimension) -> Option<&'static QuantityName> {
    if dimension.is_none() { Some(QuantityName::PURE_NUMBER) } else { dimension.quantity_names().first() }
}

/// One row in a comparison of dimensions.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub title: Words,
    pub form: Form,
}

/// Comparison table: the rows below one another, one column per base unit, and last the usual name of the quantity.
pub(crate) fn table(rows: &[Row], language: Language, name_of: impl Fn(usize) -> String) -> String {
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
    let mut lines: Vec<String> = rows.iter().map(|row| row.title.text(language).into_owned()).collect();
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
        if let Some(name) = row.form.dimension().and_then(named) {
            line.push_str("  ");
            line.push_str(&name.noun().text(language));
        }
        line.truncate(line.trim_end().len());
    }
    lines.join("\n")
}

/// Base units in the order of the columns.
const BASE: [&str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "px"];

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

/// Factor between the dimensions of two sides, in the simpler of two forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Factor {
    /// The first side would have to be multiplied by something of this dimension.
    Lacking(Dimension),
    /// The first side would have to be divided by something of this dimension.
    Excess(Dimension),
}

impl Factor {
    /// From the quotient of the dimensions of `found` and `expected`.
    pub fn of(ratio: Dimension) -> Self {
        let inverse = ratio.inverse();
        // "A length too many" is clearer than "a wave number is lacking".
        let oddness = |dimension: Dimension| {
            let negative = dimension.base().filter(|(_, exponent)| exponent.numerator() < 0).count();
            let nameless = usize::from(named(dimension).is_none());
            (negative, nameless)
        };
        if oddness(inverse) < oddness(ratio) { Self::Lacking(inverse) } else { Self::Excess(ratio) }
    }

    /// `lacks a factor with the dimension of mass`, `has one length too many`; the Spanish sentence begins with the factor:
    /// `falta un factor con dimensión de masa`.
    pub fn verdict(self) -> Words {
        let dimension = self.dimension();
        let name = named(dimension).map(|name| name.noun());
        match (self, single(dimension), name) {
            (Self::Lacking(_), Some((base, count)), _) if count > 1 => {
                words!("lacks {count} factors with the dimension of {base}", base = base.noun(), count = number(count))
            }
            (Self::Lacking(_), _, Some(name)) => words!("lacks a factor with the dimension of {name}"),
            (Self::Lacking(_), ..) => {
                words!("lacks a factor with the dimension {dimension}")
            }
            (Self::Excess(_), Some((base, count)), _) => too_many(base, count),
            (Self::Excess(_), _, Some(name)) => {
                words!("has a factor with the dimension of {name} too many")
            }
            (Self::Excess(_), ..) => words!("has a factor with the dimension {dimension} too many"),
        }
    }

    /// Dimension by which the first side must be multiplied.
    pub fn lacking(self) -> Dimension {
        match self {
            Self::Lacking(dimension) => dimension,
            Self::Excess(dimension) => dimension.inverse(),
        }
    }

    /// Dimension of the lacking or surplus factor.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Lacking(dimension) | Self::Excess(dimension) => dimension,
        }
    }
}

/// A base quantity that messages name.
#[derive(Clone, Copy)]
enum Base {
    Mass,
    Length,
    Time,
    Temperature,
    Current,
}

impl Base {
    fn noun(self) -> Words {
        match self {
            Self::Mass => words("mass"),
            Self::Length => words("length"),
            Self::Time => words("time"),
            Self::Temperature => words("temperature"),
            Self::Current => words("current"),
        }
    }
}

/// Base quantity and exponent, if the dimension is an integer power from 1 to 9 of one base unit.
fn single(dimension: Dimension) -> Option<(Base, i32)> {
    let mut base = dimension.base();
    let (Some((symbol, exponent)), None) = (base.next(), base.next()) else {
        return None;
    };
    let is_small = exponent.is_whole() && (1..=9).contains(&exponent.numerator());
    let quantity = match symbol {
        "kg" => Base::Mass,
        "m" => Base::Length,
        "s" => Base::Time,
        "K" => Base::Temperature,
        "A" => Base::Current,
        _ => return None,
    };
    is_small.then_some((quantity, exponent.numerator()))
}

/// `has one length too many`, `has two masses too many`, `has two factors of time too many` ("two times" would mean
/// twice).
fn too_many(base: Base, count: i32) -> Words {
    let many = number(count);
    match (base, count) {
        (Base::Mass, 1) => words("has one mass too many"),
        (Base::Length, 1) => words("has one length too many"),
        (Base::Time, 1) => words("has one factor of time too many"),
        (Base::Temperature, 1) => words("has one temperature too many"),
        (Base::Current, 1) => words("has one current too many"),
        (Base::Mass, _) => words!("has {many} masses too many"),
        (Base::Length, _) => words!("has {many} lengths too many"),
        (Base::Time, _) => words!("has {many} factors of time too many"),
        (Base::Temperature, _) => words!("has {many} temperatures too many"),
        (Base::Current, _) => words!("has {many} currents too many"),
    }
}

/// Number word; the Spanish one is the form before a masculine noun.
fn number(count: i32) -> Words {
    match count {
        1 => words("one"),
        2 => words("two"),
        3 => words("three"),
        4 => words("four"),
        count => Words::same(count.to_string()),
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
            assert_eq!(Factor::of(dimension(ratio)).verdict().english(), verdict, "{ratio}");
        }
    }

    #[test]
    fn aligns_the_exponents() {
        let row = |title: &str, unit| Row { title: Words::same(title.to_owned()), form: Form::from(dimension(unit)) };
        let rows = [row("left side", "N"), row("right", "m/s^2"), row("x", "A^2"), row("y", "")];
        let expected = "left side  kg  m  s^-2       force\n\
                        right          m  s^-2       acceleration\n\
                        x                       A^2\n\
                        y                            pure number";
        assert_eq!(table(&rows, Language::English, |_| String::new()), expected);
    }
}

//! Tables: arguments and values in two rows.

use super::expression::Typesetter;
use crate::{DrawnRange, Name, StatedUnit, TableStatement};
use units::mathml::{name, number, unit_after_number};

/// Maximum number of points shown; of a longer table only the first points and the last one are shown.
const MOST_SHOWN: usize = 8;

impl Typesetter<'_> {
    /// Two rows, each with a heading: the argument, and the value of the function.
    pub(super) fn table(&self, table: &TableStatement) -> String {
        if let (Some(range), true) = (&table.drawn, table.points.is_empty()) {
            return self.drawn(table, range);
        }
        let argument = (name(&table.argument.text, 0, None), &table.argument_unit);
        let value = (self.declared(&table.name, std::slice::from_ref::<Name>(&table.argument)), &table.unit);
        let rows = [argument, value].into_iter().zip([0, 1]).map(|((heading, unit), which)| {
            let unit = unit.as_ref().map(|unit: &StatedUnit| bracketed(&unit.unit)).unwrap_or_default();
            let numbers: Vec<f64> =
                table.points.iter().map(|point| if which == 0 { point.x } else { point.y }).collect();
            let cells: String = shown(&numbers).into_iter().map(|cell| format!("<mtd>{cell}</mtd>")).collect();
            format!("<mtr><mtd><mrow>{heading}{unit}</mrow></mtd>{cells}</mtr>")
        });
        format!("<mtable>{}</mtable>", rows.collect::<String>())
    }
}

impl Typesetter<'_> {
    /// Range of the values and of the arguments of a drawn curve.
    fn drawn(&self, table: &TableStatement, range: &DrawnRange) -> String {
        let between = |low: f64, what: String, high: f64, unit: &Option<StatedUnit>| {
            let unit = unit.as_ref().map(|unit| unit_after_number(&unit.unit)).unwrap_or_default();
            format!("<mrow>{}<mo>≤</mo>{what}<mo>≤</mo>{}{unit}</mrow>", number(low), number(high))
        };
        let value = self.declared(&table.name, std::slice::from_ref::<Name>(&table.argument));
        let argument = name(&table.argument.text, 0, None);
        let values = between(range.bounds.low, value, range.bounds.high, &table.unit);
        let arguments = between(range.from, argument, range.until, &table.argument_unit);
        format!("{values}<mo separator=\"true\">,</mo>{arguments}")
    }
}

/// The numbers as MathML; of a long list the middle ones are left out.
fn shown(numbers: &[f64]) -> Vec<String> {
    if numbers.len() <= MOST_SHOWN {
        return numbers.iter().map(|&value| number(value)).collect();
    }
    let (first, last) = (&numbers[..MOST_SHOWN - 2], &numbers[numbers.len() - 1..]);
    let mut cells: Vec<String> = first.iter().map(|&value| number(value)).collect();
    cells.push("<mo>…</mo>".to_owned());
    cells.extend(last.iter().map(|&value| number(value)));
    cells
}

/// Unit in brackets after a blank: ` [K]`.
fn bracketed(unit: &units::Unit) -> String {
    if unit.text.is_empty() {
        return String::new();
    }
    format!(
        "<mspace width=\"0.3em\"/><mo stretchy=\"false\">[</mo>{}<mo stretchy=\"false\">]</mo>",
        unit_after_number(unit)
    )
}

//! Results of groups against a parameter that each group held fixed at a value of its own.

mod line;
mod power;

pub use line::{Line, Point, line};
pub use power::Power;

use crate::results::Quantity;
use units::number::{Layout, error_with_unit, plain, unit_text, with_error};
use units::{Dimension, Language, Unit, Words, say};

/// Significant digits of a parameter.
const DIGITS: usize = 6;

/// A power of the results of a quantity against a power of a parameter, in SI units.
#[derive(Clone, Debug)]
pub struct Against {
    /// The power of the quantity.
    pub y: Power,
    /// The power of the parameter.
    pub x: Power,
    /// Index of the hand-in of each result, and its point. Results of groups that did not hold the parameter fixed are
    /// left out.
    pub points: Vec<(usize, Point)>,
    /// The straight line, or the reason why there is none.
    pub line: Result<Line, Words>,
    /// SI units of y, of x and of the slope.
    units: [Unit; 3],
}

impl Against {
    /// Results of a quantity against a parameter. `y`: power of the quantity; `None`: the quantity itself. Results that
    /// are marked as outliers are not left out: groups with different values of the parameter may differ.
    ///
    /// Returns `None` if `y` is about another quantity, or if no group held the parameter fixed.
    pub fn new(quantity: &Quantity, y: Option<&Power>, x: &Power) -> Option<Self> {
        if y.is_some_and(|y| y.name() != quantity.name) {
            return None;
        }
        let y = y.cloned().unwrap_or_else(|| Power::first(&quantity.name));
        let mut unit = None;
        let mut points = Vec::new();
        for ((index, measured), fixed) in quantity.results.iter().zip(&quantity.fixed) {
            if let Some(fixed) = fixed.iter().find(|fixed| fixed.name == x.name()) {
                unit.get_or_insert(&fixed.unit);
                points.push((*index, Point { x: x.raise(fixed.value), measured: y.raise_measured(*measured) }));
            }
        }
        let (x_dimension, y_dimension) = (dimension(unit?, x)?, dimension(&quantity.unit, &y)?);
        let units = [y_dimension, x_dimension, y_dimension.per(x_dimension)?].map(Unit::si);
        let line = line(&points.iter().map(|(_, point)| *point).collect::<Vec<_>>());
        Some(Self { y, x: x.clone(), points, line, units })
    }

    /// Heading: both powers with their units.
    pub fn title(&self, language: Language) -> String {
        let bracketed = |text: String| if text.is_empty() { text } else { format!(" [{text}]") };
        let [y, x] = self.unit_texts().map(bracketed);
        let (of, parameter) = (&self.y, &self.x);
        say!(language, "{of}{y} against {parameter}{x}")
    }

    /// SI units of the power of the quantity and of that of the parameter; empty for pure numbers.
    pub fn unit_texts(&self) -> [String; 2] {
        let [y, x, _] = &self.units;
        [unit_text(&y.text), unit_text(&x.text)]
    }

    /// Value of the parameter of a point, and its result with the standard error.
    pub fn texts(&self, point: Point, language: Language) -> [String; 2] {
        let style = language.style();
        [plain(point.x, DIGITS, style), with_error(point.measured.value, Some(point.measured.error), style)]
    }

    /// A sentence about the line: its slope and its value at 0, with intervals; or why there is none.
    pub fn sentence(&self, language: Language) -> String {
        let found = match &self.line {
            Ok(line) => line,
            Err(why) => {
                return say!(language, "No line: {why}.");
            }
        };
        let style = language.style();
        let with_interval = |value: f64, error: f64, (low, high): (f64, f64), unit: &Unit| {
            let unit = unit_text(&unit.text);
            // The ends have the digits that the error allows.
            let layout = Layout::of_errors([(value, error)]);
            let end = |end: f64| layout.map_or_else(|| plain(end, DIGITS, style), |layout| layout.number(end, style));
            let [low, high] = [low, high].map(end);
            let value = error_with_unit(&with_error(value, Some(error), style), &unit);
            say!(language, "{value} (95 %: {low} to {high})")
        };
        let slope = with_interval(found.slope, found.slope_error, found.slope_interval, &self.units[2]);
        let start = with_interval(found.intercept, found.intercept_error, found.intercept_interval, &self.units[0]);
        let count = found.count;
        say!(language, "Straight line, n = {count}: slope {slope}, value at 0: {start}")
    }
}

/// Dimension of a power of a quantity with this unit.
fn dimension(unit: &str, power: &Power) -> Option<Dimension> {
    power.dimension(Unit::parse(unit).map_or(Dimension::NONE, |unit| unit.dimension))
}

//! Curves drawn by the reader: tables of the model whose points are set in the page. Changing a curve restarts the run.

use crate::basis::input::DIGITS;
use crate::values::symbol::symbol;
use crate::{Basis, Course, Refusal, number};
use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use engine::Setup;
use program::{Drawn, Model, Table};
use units::Unit;

/// Number of levels between the least and the greatest value of a curve. One level fits into two characters of a link.
const LEVELS: u16 = 4000;

/// Number of line segments between adjacent points of a smooth curve.
const SMOOTH: usize = 8;

/// A curve drawn by the reader, for its field. Heights and places are fractions of the range, from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawingView {
    /// Index among the drawn curves of the model.
    pub index: usize,
    /// Label in the chosen language; `a(t)` if there is none.
    pub label: String,
    /// Symbol with argument: `a(t)`.
    pub symbol: String,
    /// Heights of the points, which are equally spaced.
    pub heights: Vec<f64>,
    /// Points of the interpolated line: (place, height).
    pub line: Vec<(f64, f64)>,
    /// Height of the value 0, if it lies in the range.
    pub zero: Option<f64>,
    /// Least and greatest value, with unit.
    pub values: [String; 2],
    /// Least and greatest argument, with unit.
    pub arguments: [String; 2],
    /// True if the curve is the document's own.
    pub is_default: bool,
}

impl Basis {
    /// All curves drawn by the reader, in the order of the text.
    pub fn drawn_curves(&self, at: &Course) -> Vec<DrawingView> {
        (0..at.begun().drawings.len()).filter_map(|index| self.drawn_curve(at, index)).collect()
    }

    /// One drawn curve; `None` for an unknown index.
    pub fn drawn_curve(&self, at: &Course, index: usize) -> Option<DrawingView> {
        let (table, drawn) = table(self.model(), index)?;
        let values = at.begun().drawings.get(index)?;
        let curve = drawn.curve(values)?;
        let lines = (Drawn::POINTS - 1) * SMOOTH;
        let line = (0..=lines).map(|part| {
            let place = part as f64 / lines as f64;
            let argument = drawn.from + place * (drawn.until - drawn.from);
            (place, height(drawn, curve.value(argument, curve.piece(argument))))
        });
        let text = |value: f64, unit: &Unit| {
            number::with_unit(&number::plain(unit.from_si(value), DIGITS, self.style()), unit)
        };
        Some(DrawingView {
            index,
            label: self.label_of(table),
            symbol: symbol_of(table),
            heights: values.iter().map(|&value| height(drawn, value)).collect(),
            line: line.collect(),
            zero: Some(height(drawn, 0.0)).filter(|zero| (0.0..=1.0).contains(zero)),
            values: [drawn.low, drawn.high].map(|value| text(value, &table.unit)),
            arguments: [drawn.from, drawn.until].map(|value| text(value, &table.argument_unit)),
            is_default: self.defaults().drawings.get(index) == Some(values),
        })
    }

    /// Text for a point of a curve at a height: `t = 2 s: 1.5 m/s²`.
    pub fn drawn_text(&self, index: usize, point: usize, height: f64) -> String {
        let Some((table, drawn)) = table(self.model(), index) else { return String::new() };
        let shown =
            |value: f64, unit: &Unit| number::with_unit(&number::plain(unit.from_si(value), 4, self.style()), unit);
        let argument = shown(drawn.argument(point), &table.argument_unit);
        format!("{} = {argument}: {}", symbol(&table.argument), shown(value(drawn, level(height)), &table.unit))
    }

    /// Maps the drawn curves of a run of the former program to this one. Adds the names of lost curves to `lost`.
    pub(crate) fn drawings_from(&self, former: &Setup, before: &Basis, lost: &mut Vec<String>) -> Vec<Vec<f64>> {
        let mut drawings = self.defaults().drawings.clone();
        for (index, values) in former.drawings.iter().enumerate() {
            if before.defaults().drawings.get(index) == Some(values) {
                continue;
            }
            let Some((old, old_drawn)) = table(before.model(), index) else { continue };
            let same = |place: &usize| {
                table(self.model(), *place).is_some_and(|(new, drawn)| {
                    new.name == old.name
                        && [&new.unit, &new.argument_unit].map(|unit| unit.dimension)
                            == [&old.unit, &old.argument_unit].map(|unit| unit.dimension)
                        && (drawn.from, drawn.until) == (old_drawn.from, old_drawn.until)
                        && drawn.takes(values)
                })
            };
            match (0..drawings.len()).find(same).and_then(|place| drawings.get_mut(place)) {
                Some(own) => own.clone_from(values),
                None => lost.push(before.drawing_label(index)),
            }
        }
        drawings
    }
}

impl Basis {
    /// Values (SI) of a curve through points at these heights (0 to 1).
    pub(crate) fn drawn_values(&self, index: usize, heights: &[f64]) -> Result<Vec<f64>, Refusal> {
        let drawn = table(self.model(), index).map(|(_, drawn)| drawn);
        let fits = heights.len() == Drawn::POINTS && heights.iter().all(|height| height.is_finite());
        let drawn = drawn.filter(|_| fits).ok_or_else(|| Refusal::Unknown { name: index.to_string() })?;
        Ok(heights.iter().map(|&height| value(drawn, level(height))).collect())
    }

    /// Label of a drawn curve in the chosen language.
    pub(crate) fn drawing_label(&self, index: usize) -> String {
        table(self.model(), index).map_or_else(String::new, |(table, _)| self.label_of(table))
    }

    fn label_of(&self, table: &Table) -> String {
        table.label.as_deref().map_or_else(|| symbol_of(table), |label| self.text(label).to_owned())
    }
}

/// Symbol of a table with its argument: `a(t)`.
fn symbol_of(table: &Table) -> String {
    format!("{}({})", symbol(&table.name), symbol(&table.argument))
}

/// Drawn curve with this index, and its table.
fn table(model: &Model, index: usize) -> Option<(&Table, &Drawn)> {
    model.tables.iter().filter_map(|table| Some((table, table.drawn.as_ref()?))).nth(index)
}

/// Height (0 to 1) of a value.
fn height(drawn: &Drawn, value: f64) -> f64 {
    (value - drawn.low) / (drawn.high - drawn.low)
}

/// Level nearest to a height.
fn level(height: f64) -> u16 {
    (height.clamp(0.0, 1.0) * f64::from(LEVELS)).round() as u16
}

/// Value of a level.
fn value(drawn: &Drawn, level: u16) -> f64 {
    let part = f64::from(level.min(LEVELS)) / f64::from(LEVELS);
    (drawn.low + part * (drawn.high - drawn.low)).clamp(drawn.low, drawn.high)
}

/// Text form, for a link, of the curves that differ from the document's: `a:` and two characters per point.
pub(crate) fn written(model: &Model, drawings: &[Vec<f64>], defaults: &[Vec<f64>]) -> Vec<String> {
    let one = |(index, (values, own)): (usize, (&Vec<f64>, &Vec<f64>))| {
        let (table, drawn) = table(model, index).filter(|_| values != own)?;
        // Two points of 12 bits each take three bytes.
        let levels: Vec<u16> = values.iter().map(|&value| level(height(drawn, value))).collect();
        let bytes: Vec<u8> = levels
            .chunks(2)
            .flat_map(|pair| {
                let (first, second) = (pair.first().copied().unwrap_or(0), pair.get(1).copied().unwrap_or(0));
                [(first >> 4) as u8, ((first << 4) as u8) | (second >> 8) as u8, second as u8]
            })
            .collect();
        Some(format!("{}:{}", table.name, URL_SAFE_NO_PAD.encode(bytes)))
    };
    drawings.iter().zip(defaults).enumerate().filter_map(one).collect()
}

/// Parses the output of [`written`] into index and values; `None` if it does not match.
pub(crate) fn read(model: &Model, text: &str) -> Option<(usize, Vec<f64>)> {
    let (name, points) = text.split_once(':')?;
    let count = model.tables.iter().filter(|table| table.drawn.is_some()).count();
    let index = (0..count).find(|index| table(model, *index).is_some_and(|(table, _)| table.name == name))?;
    let (_, drawn) = table(model, index)?;
    // Limits decoding to the length of a valid curve.
    let bytes = URL_SAFE_NO_PAD.decode(points.get(..4 * Drawn::POINTS.div_ceil(2)).unwrap_or(points)).ok()?;
    let levels = bytes.chunks_exact(3).flat_map(|three| {
        let [a, b, c] = [three[0], three[1], three[2]].map(u16::from);
        [a << 4 | b >> 4, (b & 15) << 8 | c]
    });
    let levels: Vec<u16> = levels.take(Drawn::POINTS).collect();
    let fits = bytes.len() == 3 * Drawn::POINTS.div_ceil(2)
        && points.len() == 4 * Drawn::POINTS.div_ceil(2)
        && levels.iter().all(|level| *level <= LEVELS);
    fits.then(|| (index, levels.into_iter().map(|level| value(drawn, level)).collect()))
}

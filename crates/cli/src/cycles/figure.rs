//! The cycles drawn: the record, and each quantity against time and against amplitude.

use super::Record;
use analysis::cycles::{Cycle, Measured};
use figure::{Axis, Interval, Palette, Plot, Series, Settings, Style, View, layout};
use std::fmt::Write;

/// The size of a panel in pixels.
const WIDTH: f64 = 460.0;
const HEIGHT: f64 = 250.0;

/// A quantity of the cycles, as a column.
struct Quantity {
    label: &'static str,
    unit: String,
    values: Vec<f64>,
    errors: Vec<f64>,
}

impl Quantity {
    fn of(record: &Record, label: &'static str, unit: &str, of: fn(&Cycle) -> Measured) -> Self {
        let cycles = record.found.cycles.iter().map(of);
        let (values, errors) = cycles.map(|measured| (measured.value, measured.error)).unzip();
        Self { label, unit: unit.to_owned(), values, errors }
    }

    fn axis(&self) -> Axis<'_> {
        Axis { label: self.label, unit: &self.unit, include: None }
    }

    /// What is drawn of it: all that is known to within four times the usual error. The last cycles, of which little is
    /// known, must not make the others a line.
    fn limits(&self) -> Vec<Interval> {
        let mut errors = self.errors.clone();
        errors.sort_by(f64::total_cmp);
        let usual = errors.get(errors.len() / 2).copied().unwrap_or(0.0);
        let known = self.values.iter().zip(&self.errors).filter(|(_, error)| **error <= 4.0 * usual);
        let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (value, error)| {
            (low.min(value - error), high.max(value + error))
        });
        let margin = 0.05 * (high - low);
        if margin > 0.0 { vec![Interval { low: low - margin, high: high + margin }] } else { Vec::new() }
    }
}

/// All panels in one picture.
pub fn svg(record: &Record) -> String {
    let time = Quantity::of(record, "t", "s", |cycle| cycle.time);
    let amplitude = Quantity::of(record, "A", &record.unit, |cycle| cycle.amplitude);
    let rest = [
        Quantity::of(record, "T", "s", |cycle| cycle.period),
        Quantity::of(record, "decrement", "", |cycle| cycle.decrement),
        Quantity::of(record, "ω", "rad/s", |cycle| cycle.angular_frequency),
        Quantity::of(record, "γ", "1/s", |cycle| cycle.damping),
    ];
    let mut panels =
        vec![measured(record, &time, &amplitude), panel(&time, &amplitude, "Amplitude against time", Vec::new())];
    for (quantity, name) in rest.iter().zip(["Period", "Logarithmic decrement", "Angular frequency", "Damping"]) {
        panels.push(panel(&time, quantity, &format!("{name} against time"), quantity.limits()));
        panels.push(panel(&amplitude, quantity, &format!("{name} against amplitude"), quantity.limits()));
    }
    let rows = panels.len().div_ceil(2);
    let (width, height) = (2.0 * WIDTH, rows as f64 * HEIGHT);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n"
    );
    for (index, panel) in panels.iter().enumerate() {
        let (x, y) = ((index % 2) as f64 * WIDTH, (index / 2) as f64 * HEIGHT);
        // Writing to a string cannot fail.
        let _ = write!(out, "<g transform=\"translate({x} {y})\">\n{panel}</g>\n");
    }
    out + "</svg>\n"
}

/// The record with the amplitudes above and below its middle.
fn measured(record: &Record, time: &Quantity, amplitude: &Quantity) -> String {
    let offsets = record.found.cycles.iter().map(|cycle| cycle.offset.value);
    let (above, below): (Vec<f64>, Vec<f64>) =
        offsets.zip(&amplitude.values).map(|(offset, size)| (offset + size, offset - size)).unzip();
    let axis = Axis { label: &record.name, unit: &record.unit, include: None };
    let envelope = |y| Series { label: "", colour: 1, x: &time.values, y, ..Series::default() };
    let points = Series { label: "", style: Style::Points, x: &record.times, y: &record.values, ..Series::default() };
    drawn(&Plot {
        title: "The record and its envelope",
        description: "The measured values against time, between the amplitudes of the cycles",
        x: time.axis(),
        y: vec![axis],
        series: vec![envelope(&above), envelope(&below), points],
        ordered: true,
        ..Plot::default()
    })
}

/// One quantity against another, with error bars.
fn panel(x: &Quantity, y: &Quantity, title: &str, limits: Vec<Interval>) -> String {
    let series = Series { style: Style::Points, x: &x.values, y: &y.values, spread: &y.errors, ..Series::default() };
    drawn(&Plot {
        title,
        description: "Each point is a turning point with the half-cycles around it; bars are one standard error",
        x: x.axis(),
        y: vec![y.axis()],
        series: vec![series],
        view: View { x: None, y: limits },
        ..Plot::default()
    })
}

fn drawn(plot: &Plot) -> String {
    let settings = Settings { width: WIDTH, height: HEIGHT, ..Settings::default() };
    layout(plot, &settings).svg(&Palette::LIGHT)
}

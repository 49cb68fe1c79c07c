//! Figure of the cycles: the record, and each quantity against time and against amplitude.

use super::record::Record;
use analysis::cycles::{Cycle, Measured, Quantity, well_known};
use figure::{Axis, Interval, Palette, Plot, Series, Settings, Style, View, layout};
use std::fmt::Write;
use units::Language;
use units::alphabet::capitalised;

/// Size of a panel in pixels.
const WIDTH: f64 = 460.0;
const HEIGHT: f64 = 250.0;

/// Values of one quantity, one per cycle.
struct CycleValues {
    label: &'static str,
    unit: String,
    values: Vec<f64>,
    errors: Vec<f64>,
    limits: Vec<Interval>,
}

impl CycleValues {
    fn of(record: &Record, label: &'static str, unit: String, of: impl Fn(&Cycle) -> Measured) -> Self {
        let measured: Vec<Measured> = record.found.cycles.iter().map(of).collect();
        // Margin for the error bars at the ends.
        let limits = well_known(&measured).map(|(low, high)| (low, high, 0.05 * (high - low)));
        Self {
            label,
            unit,
            values: measured.iter().map(|one| one.value).collect(),
            errors: measured.iter().map(|one| one.error).collect(),
            limits: limits
                .map(|(low, high, room)| Interval { low: low - room, high: high + room })
                .into_iter()
                .collect(),
        }
    }

    fn axis(&self) -> Axis<'_> {
        Axis { label: self.label, unit: &self.unit, ..Axis::default() }
    }
}

/// SVG of all panels.
pub fn svg(record: &Record) -> String {
    let time = CycleValues::of(record, "t", "s".to_owned(), |cycle| cycle.time);
    let of = |quantity: Quantity| {
        let unit = quantity.unit(&record.unit, "s");
        CycleValues::of(record, quantity.symbol(Language::English), unit, |cycle| quantity.of(cycle))
    };
    let amplitude = of(Quantity::Amplitude);
    let mut panels =
        vec![measured(record, &time, &amplitude), panel(&time, &amplitude, "Amplitude against time", false)];
    for quantity in Quantity::ALL.into_iter().filter(|quantity| *quantity != Quantity::Amplitude) {
        let (column, name) = (of(quantity), capitalised(quantity.name(Language::English)));
        panels.push(panel(&time, &column, &format!("{name} against time"), true));
        panels.push(panel(&amplitude, &column, &format!("{name} against amplitude"), true));
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

/// Panel of the record with its envelope: offset plus and minus amplitude.
fn measured(record: &Record, time: &CycleValues, amplitude: &CycleValues) -> String {
    let offsets = record.found.cycles.iter().map(|cycle| cycle.offset.value);
    let (above, below): (Vec<f64>, Vec<f64>) =
        offsets.zip(&amplitude.values).map(|(offset, size)| (offset + size, offset - size)).unzip();
    let axis = Axis { label: &record.name, unit: &record.unit, ..Axis::default() };
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

/// Panel of one quantity against another, with error bars. `bounded`: limits the ordinate to the well-known values.
fn panel(x: &CycleValues, y: &CycleValues, title: &str, bounded: bool) -> String {
    let limits = if bounded { y.limits.clone() } else { Vec::new() };
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

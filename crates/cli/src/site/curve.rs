//! Curve on the card of a simulation: the beginning of a run with the values of the document.

use engine::{Advance, Readings, Run, Setup};
use program::Program;
use std::fmt::Write as _;

/// Width and height of the drawing, in units of its view box.
pub const SIZE: (f64, f64) = (640.0, 144.0);
/// Distance of the curve from the edges, so that its stroke is not clipped.
const MARGIN: f64 = 6.0;
/// Maximum number of rows that are drawn.
const ROWS: usize = 300;
/// Maximum work of the run in floating-point operations; a longer run gets no curve. The shipped simulations need less
/// than a tenth.
const WORK: u64 = 200_000_000;

/// SVG path of the first curve of the first plot against the independent variable. `None` if there is no such plot or
/// the run fails.
pub fn path(program: &Program) -> Option<String> {
    let plot = program.plots.iter().find(|plot| program.model.is_independent(plot.x.value.node))?;
    let roots = [plot.x.value.node, plot.curves.first()?.value.node];
    let run = run(program)?;
    let mut readings = Readings::new(&program.model, &roots);
    let mut rows: Vec<(f64, f64)> = Vec::new();
    for row in 0..run.history().len() {
        let [x, y] = readings.at_row(run.history(), row) else { return None };
        rows.push((*x, *y));
    }
    let scale = |pick: fn(&(f64, f64)) -> f64, length: f64| {
        let (least, most) = rows
            .iter()
            .map(pick)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
        let range = most - least;
        // A constant is drawn in the middle.
        let factor = if range > 0.0 { (length - 2.0 * MARGIN) / range } else { 0.0 };
        let start = if range > 0.0 { MARGIN } else { length / 2.0 };
        (range.is_finite() && factor.is_finite()).then_some(move |value: f64| start + (value - least) * factor)
    };
    let (x, y) = (scale(|row| row.0, SIZE.0)?, scale(|row| row.1, SIZE.1)?);
    // Relative coordinates from rounded absolute ones: short text without accumulated rounding errors.
    let mut points = rows.iter().map(|row| (x(row.0).round() as i32, (SIZE.1 - y(row.1)).round() as i32));
    let mut last = points.next()?;
    let mut path = format!("M{} {}l", last.0, last.1);
    for point in points {
        // Writing to a string cannot fail.
        let _ = write!(path, "{} {} ", point.0 - last.0, point.1 - last.1);
        last = point;
    }
    Some(path)
}

/// The beginning of a run with the settings of the document.
fn run(program: &Program) -> Option<Run> {
    let mut run = Run::start(&program.model, Setup::of(program)).ok()?;
    let end = program.until.unwrap_or(f64::INFINITY);
    while run.history().len() < ROWS && run.time() < end {
        match run.advance_within(WORK.checked_sub(run.work())?).ok()? {
            Advance::Step | Advance::Event => {}
            Advance::Full | Advance::Partial => return None,
        }
    }
    Some(run)
}

//! Deviation of the present run from a claim about the whole run: a conserved quantity or a closed form.

use crate::{Basis, Course, words};
use engine::Readings;
use figure::{Axis, Palette, Plot, Series, Settings};
use program::{Claim, Compiled, Moment, Test, Tolerance};

/// Approximate number of rows in the plot; more cannot be distinguished.
const ROWS: usize = 1500;

/// Deviation of a run from a claim about the whole run.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// Values of the independent variable, in its unit.
    pub times: Vec<f64>,
    /// Value minus expected value: in the value's unit, or as a fraction of the greatest magnitude of the expected
    /// value in the run.
    pub off: Vec<f64>,
    /// True if `off` is that fraction.
    pub is_relative: bool,
}

/// Deviation of the present run from claim number `claim` of entry `check` of [`Claims::list`]. `None` for a claim that is
/// not about the whole run, and before the first step.
///
/// [`Claims::list`]: super::Claims::list
pub fn deviation(basis: &Basis, at: &Course, place: (usize, usize)) -> Option<Deviation> {
    let (value, expected, tolerance) = compared(claim(basis, place)?)?;
    let history = at.history().filter(|history| history.len() > 1)?;
    let mut readings = Readings::new(basis.model(), &[value.node, expected.node]);
    let unit = &basis.model().independent.unit;
    let (mut times, mut off) = (Vec::new(), Vec::new());
    let mut greatest = 0.0f64;
    for row in (0..history.len()).step_by(history.len().div_ceil(ROWS)) {
        let &[is, should] = readings.at_row(history, row) else { return None };
        times.push(unit.from_si(history.time(row)));
        off.push(is - should);
        greatest = greatest.max(should.abs());
    }
    let is_relative = matches!(tolerance, Tolerance::Relative(_)) && greatest > 0.0;
    let scale = |off: &f64| if is_relative { off / greatest } else { value.unit.from_si(*off) };
    Some(Deviation { times, off: off.iter().map(scale).collect(), is_relative })
}

/// The deviation plot as an SVG file.
pub fn deviation_svg(
    basis: &Basis,
    at: &Course,
    place: (usize, usize),
    settings: &Settings,
    palette: &Palette,
) -> Option<String> {
    let claim = claim(basis, place)?;
    let Deviation { times, off, is_relative } = deviation(basis, at, place)?;
    let unit = compared(claim).filter(|_| !is_relative).map_or("", |(value, ..)| &value.unit.text);
    let independent = &basis.model().independent;
    let settings = Settings { decimal_comma: basis.style().decimal_comma, ..*settings };
    let plot = Plot {
        title: basis.text(&claim.name),
        x: Axis { label: &independent.name, unit: &independent.unit.text, ..Axis::default() },
        y: vec![Axis { label: words::deviation(basis.language(), is_relative), unit, ..Axis::default() }],
        series: vec![Series { x: &times, y: &off, ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    Some(figure::layout(&plot, &settings).svg(palette))
}

fn claim(basis: &Basis, (check, claim): (usize, usize)) -> Option<&Claim> {
    basis.program().checks.get(check)?.claims.get(claim)
}

/// Value, expected value and tolerance of a claim about the whole run; `None` for other claims.
pub(super) fn compared(claim: &Claim) -> Option<(&Compiled, &Compiled, Tolerance)> {
    match (&claim.test, &claim.moment) {
        (Test::Near { value, expected, tolerance }, Moment::Always) => Some((value, expected, *tolerance)),
        _ => None,
    }
}

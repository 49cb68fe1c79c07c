//! The figures: measured values over the fitted curve, and below, on the same axis, what is left over.

use crate::Report;
use crate::markup::plain_symbol;
use crate::results::size;
use analysis::fit::ObservationFit;
use figure::{Axis, Figure, Interval, Palette, Plot, Series, Settings, Style, View, layout};
use units::number::unit_text;

/// The width of a figure, and of one of two side by side.
pub const WIDTH: f64 = 700.0;
pub const HALF: f64 = 345.0;
const UPPER: f64 = 300.0;
const LOWER: f64 = 190.0;
const SLIM: f64 = 190.0;
/// More points than this are not drawn one by one.
const MOST_POINTS: usize = 4000;
/// The colours of the data, of the curve, of outliers, and of what was not fitted.
const DATA: u8 = 0;
const CURVE: u8 = 1;
const OUTLIER: u8 = 3;
const UNUSED: u8 = 4;

/// The columns of one observation in the units of its axes.
struct Columns {
    /// Of the values that were fitted, of those that were not, and of outliers: time, value, its error (if known), and residual and error
    /// in the unit of residuals.
    points: [[Vec<f64>; 5]; 3],
    /// The unit of residuals.
    unit: String,
    /// How much of the unit of the observation it is.
    part: f64,
    /// The curve: times, and twice the standard error in the unit of values and in that of residuals.
    times: Vec<f64>,
    spread: [Vec<f64>; 2],
    /// The curve in the fitted part and outside, NaN elsewhere.
    fitted: Vec<f64>,
    predicted: Vec<f64>,
}

/// The figures of all observations as one standalone SVG, one below the other: the measured values over the fitted curve, and
/// what is left over below.
pub fn figure(report: &Report<'_>) -> String {
    let language = report.language;
    let title = report.document.program.edition(language.tag()).title.as_str();
    let (mut parts, mut height) = (String::new(), 0.0);
    for fit in &report.outcome.observations {
        let record = report.task.records.get(fit.record).map_or("", |record| record.name.as_str());
        let title = if record.is_empty() { title.to_owned() } else { [title, " · ", record].concat() };
        height = add_panels(&mut parts, report, fit, &title, height);
    }
    svg(&parts, height)
}

/// How many values stand for one that is drawn.
pub fn thinned(fit: &ObservationFit) -> usize {
    fit.times.len().div_ceil(MOST_POINTS).max(1)
}

/// Both panels of one observation as one SVG, without a title.
pub fn panels(report: &Report<'_>, fit: &ObservationFit) -> String {
    let mut parts = String::new();
    let height = add_panels(&mut parts, report, fit, "", 0.0);
    svg(&parts, height)
}

/// Adds both panels of one observation from `top` on; the result is where they end. `title` may be empty.
fn add_panels(parts: &mut String, report: &Report<'_>, fit: &ObservationFit, title: &str, mut top: f64) -> f64 {
    let columns = columns(report, fit, greatest(fit));
    let drawn = [(UPPER, title), (LOWER, "")]
        .map(|(height, title)| (draw(report, fit, &columns, title, height, 0.0, None), height, title));
    // One axis of time for both: the panel with the narrower numbers begins further right and is as much narrower.
    let left = drawn.iter().map(|(figure, ..)| figure.panel.x).fold(0.0, f32::max);
    for (figure, height, title) in drawn {
        let shift = f64::from(left - figure.panel.x);
        let figure = if shift > 0.0 { draw(report, fit, &columns, title, height, shift, None) } else { figure };
        place(parts, &figure, shift, top);
        top += height;
    }
    top
}

/// An SVG of this height around its parts.
fn svg(parts: &str, height: f64) -> String {
    let (width, height) = (WIDTH.to_string(), height.to_string());
    let ground = Palette::LIGHT.ground.to_string();
    let pieces = [
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"",
        &width,
        "\" height=\"",
        &height,
        "\" viewBox=\"0 0 ",
        &width,
        " ",
        &height,
        "\"><rect width=\"",
        &width,
        "\" height=\"",
        &height,
        "\" fill=\"",
        &ground,
        "\"/>\n",
        parts,
        "</svg>\n",
    ];
    pieces.concat()
}

/// The residuals of one observation as an SVG of such a width, on an axis that shows as much as `reach` (SI) to either
/// side.
pub fn residuals(report: &Report<'_>, fit: &ObservationFit, title: &str, reach: f64, width: f64) -> String {
    draw(report, fit, &columns(report, fit, reach), title, SLIM, WIDTH - width, Some(reach)).svg(&Palette::LIGHT)
}

/// One of the panels, identified by its height, so much narrower than the page.
fn draw(
    report: &Report<'_>,
    fit: &ObservationFit,
    columns: &Columns,
    title: &str,
    height: f64,
    narrower: f64,
    reach: Option<f64>,
) -> Figure {
    let language = report.language;
    let upper = height == UPPER;
    let independent = &report.document.program.model.independent;
    let (name, observed) = (plain_symbol(&independent.name), plain_symbol(&fit.name));
    let time_unit = unit_text(&independent.unit.text);
    let value_unit = if upper { unit_text(&fit.unit.text) } else { columns.unit.clone() };
    let shown = if upper { observed } else { ["Δ", &observed].concat() };
    let what = if upper {
        language.pick(": measured values and fitted curve against ", ": valores medidos y curva ajustada frente a ")
    } else {
        language.pick(": measured minus fitted, against ", ": medido menos ajustado, frente a ")
    };
    let description = [&shown, what, &name].concat();
    let zero = vec![0.0; columns.times.len()];
    let [used, unused, outlying] = &columns.points;
    let outside = !unused[0].is_empty();
    let named = |english, spanish| if upper { language.pick(english, spanish) } else { "" };
    let of_points = |points, label, colour| {
        let [x, values, errors, residuals, residual_errors]: &[Vec<f64>; 5] = points;
        let (y, spread) = if upper { (values, errors) } else { (residuals, residual_errors) };
        Series { label, style: Style::Points, colour, x, y, spread, ..Series::default() }
    };
    let of_curve = |label, style, y| {
        let (x, spread) = (&columns.times, &columns.spread[usize::from(!upper)]);
        Series { label, colour: CURVE, style, x, y, spread, ..Series::default() }
    };
    let mut series = vec![of_points(used, named("measured", "medido"), DATA)];
    if outside {
        series.push(of_points(unused, named("not fitted", "sin ajustar"), UNUSED));
    }
    if !outlying[0].is_empty() {
        series.push(of_points(outlying, named("outlier", "atípico"), OUTLIER));
    }
    if upper {
        series.push(of_curve(named("fitted", "ajustado"), Style::Line, &columns.fitted));
        if outside {
            series.push(of_curve(named("predicted", "predicho"), Style::Kept(0), &columns.predicted));
        }
    } else {
        series.insert(0, of_curve("", Style::Line, &zero));
    }
    // Residuals of several theories on one scale: what lies beyond it is not drawn.
    let limits = reach.map(|reach| size(&fit.unit, reach) / columns.part);
    let view = View { x: None, y: limits.map(|limit| Interval::new(-limit, limit)).into_iter().collect() };
    let plot = Plot {
        title,
        description: &description,
        x: Axis { label: &name, unit: &time_unit, include: None },
        y: vec![Axis { label: &shown, unit: &value_unit, include: None }],
        series,
        ordered: true,
        view,
        ..Plot::default()
    };
    layout(
        &plot,
        &Settings { width: WIDTH - narrower, height, font_size: 13.0, decimal_comma: language.style().decimal_comma },
    )
}

/// A figure inside another SVG.
fn place(out: &mut String, figure: &Figure, x: f64, y: f64) {
    let svg = figure.svg(&Palette::LIGHT);
    let rest = svg.strip_prefix("<svg").unwrap_or(&svg);
    out.extend(["<svg x=\"", &x.to_string(), "\" y=\"", &y.to_string(), "\"", rest]);
}

/// The greatest residual, SI.
pub fn greatest(fit: &ObservationFit) -> f64 {
    greatest_where(fit, |_| true)
}

/// The greatest residual that tells one theory from another, SI: of those outside the fitted part, what is more than three
/// times as large as the greatest inside would only flatten the rest.
pub fn telling(fit: &ObservationFit) -> f64 {
    let fitted = greatest_where(fit, |inside| inside);
    fitted.max(greatest(fit).min(3.0 * fitted))
}

fn greatest_where(fit: &ObservationFit, wanted: impl Fn(bool) -> bool) -> f64 {
    let rows = fit.measured.iter().zip(&fit.fitted).zip(&fit.inside).filter(|(_, inside)| wanted(**inside));
    let residuals = rows.map(|((measured, fitted), _)| (measured - fitted).abs());
    residuals.filter(|size| size.is_finite()).fold(0.0, f64::max)
}

/// `reach` is the SI size of residuals that their unit is to suit.
fn columns(report: &Report<'_>, fit: &ObservationFit, reach: f64) -> Columns {
    let residual_unit = fit.unit.for_residuals(size(&fit.unit, reach).abs());
    let (part, unit) = (residual_unit.factor / fit.unit.factor, unit_text(&residual_unit.text));
    let clock = &report.document.program.model.independent.unit;
    let value = |si: f64| fit.unit.from_si(si);
    // A difference on a scale has its factor, not its zero.
    let difference = |si: f64| size(&fit.unit, si);
    let errors = errors(report, fit);
    let mut points: [[Vec<f64>; 5]; 3] = Default::default();
    let own =
        report.outcome.outliers.iter().filter(|one| (one.record, one.observation) == (fit.record, fit.observation));
    let outlying: Vec<usize> = own.map(|one| one.row).collect();
    let every = thinned(fit);
    for row in 0..fit.times.len() {
        let kind = if outlying.contains(&row) { 2 } else { usize::from(!fit.inside[row]) };
        // An outlier is drawn in any case.
        if row % every != 0 && kind != 2 {
            continue;
        }
        let [times, values, spreads, residuals, residual_spreads] = &mut points[kind];
        times.push(clock.from_si(fit.times[row]));
        values.push(value(fit.measured[row]));
        residuals.push(difference(fit.measured[row] - fit.fitted[row]) / part);
        if let Some(error) = errors.get(row) {
            spreads.push(difference(*error));
            residual_spreads.push(difference(*error) / part);
        }
    }
    let trace = report.traces.iter().find(|trace| trace.record == fit.record && trace.observation == fit.observation);
    let (times, values, stderr) = match trace {
        Some(trace) => (&trace.times[..], &trace.values[..], &trace.stderr[..]),
        None => (&fit.times[..], &fit.fitted[..], &[][..]),
    };
    // The two parts of the curve share the points where they meet.
    let piece = |wanted: bool| -> Vec<f64> {
        let near = |row: usize| times.get(row).is_some_and(|time| report.task.covers(*time) == wanted);
        let belongs = |row: usize| near(row) || (!wanted && (near(row + 1) || (row > 0 && near(row - 1))));
        let shown = values.iter().enumerate().map(|(row, si)| if belongs(row) { value(*si) } else { f64::NAN });
        shown.collect()
    };
    Columns {
        points,
        times: times.iter().map(|time| clock.from_si(*time)).collect(),
        spread: [1.0, part].map(|part| stderr.iter().map(|error| 2.0 * difference(*error) / part).collect()),
        fitted: piece(true),
        predicted: piece(false),
        unit,
        part,
    }
}

/// The errors that were given for the values of an observation, if any: rows are found by time and value.
fn errors(report: &Report<'_>, fit: &ObservationFit) -> Vec<f64> {
    let observation = report.task.records.get(fit.record).and_then(|record| record.observations.get(fit.observation));
    let Some((given, observation)) = observation.and_then(|one| Some((one.errors.as_ref()?, one))) else {
        return Vec::new();
    };
    let mut rows: Vec<(f64, f64, f64)> = (observation.times.iter().zip(&observation.values).zip(given))
        .map(|((time, value), error)| (*time, *value, *error))
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut rows = rows.into_iter();
    let find =
        |(time, value): (&f64, &f64)| rows.find(|row| row.0 == *time && row.1 == *value).map_or(f64::NAN, |row| row.2);
    fit.times.iter().zip(&fit.measured).map(find).collect()
}

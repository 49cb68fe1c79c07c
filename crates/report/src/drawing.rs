//! Figures: measured values over the fitted curve, and below, on the same time axis, the residuals.

use crate::Report;
use crate::markup::plain_symbol;
use crate::written::size;
use analysis::fit::ObservationFit;
use figure::{Axis, Figure, Interval, Palette, Plot, Series, Settings, Style, View, layout};
use units::number::unit_text;

/// Width of a figure in pixels. `HALF` is the width of one of two side by side.
pub const WIDTH: f64 = 700.0;
pub const HALF: f64 = 345.0;
const UPPER: f64 = 300.0;
const LOWER: f64 = 190.0;
const SLIM: f64 = 190.0;
/// Maximum number of drawn points; longer observations are thinned.
const MOST_POINTS: usize = 4000;
/// Indices of colours: data, curve, outliers, and values that were not fitted.
const DATA: u8 = 0;
const CURVE: u8 = 1;
const OUTLIER: u8 = 3;
const UNUSED: u8 = 4;

/// Data of one observation in the units of its axes.
struct Columns {
    /// Points of fitted values, of values that were not fitted, and of outliers. Each has time, value, standard error
    /// of the value (empty if unknown), residual, and standard error in `unit`.
    points: [[Vec<f64>; 5]; 3],
    /// Unit of the residuals.
    unit: String,
    /// Size of `unit` in units of the observation.
    part: f64,
    /// Times of the points of the curve. `spread`: twice its standard error, in the unit of the values and in that of
    /// the residuals.
    times: Vec<f64>,
    spread: [Vec<f64>; 2],
    /// Fitted curve inside the fitted part, NaN elsewhere. `predicted`: the curve outside.
    fitted: Vec<f64>,
    predicted: Vec<f64>,
}

/// Figures of all observations as one standalone SVG, one below the other: the measured values over the fitted curve,
/// with the residuals below.
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

/// Number of values per drawn point.
pub fn thinned(fit: &ObservationFit) -> usize {
    fit.times.len().div_ceil(MOST_POINTS).max(1)
}

/// SVG of both panels of one observation, without a title.
pub fn panels(report: &Report<'_>, fit: &ObservationFit) -> String {
    let mut parts = String::new();
    let height = add_panels(&mut parts, report, fit, "", 0.0);
    svg(&parts, height)
}

/// Adds both panels of one observation at the height `top`. Returns the height of their lower end. `title` may be
/// empty.
fn add_panels(parts: &mut String, report: &Report<'_>, fit: &ObservationFit, title: &str, mut top: f64) -> f64 {
    let columns = columns(report, fit, greatest(fit));
    let drawn = [(UPPER, title), (LOWER, "")]
        .map(|(height, title)| (draw(report, fit, &columns, title, height, 0.0, None), height, title));
    // Both panels share one time axis: the one with the narrower labels is shifted to the right and made narrower.
    let left = drawn.iter().map(|(figure, ..)| figure.panel.x).fold(0.0, f32::max);
    for (figure, height, title) in drawn {
        let shift = f64::from(left - figure.panel.x);
        let figure = if shift > 0.0 { draw(report, fit, &columns, title, height, shift, None) } else { figure };
        place(parts, &figure, shift, top);
        top += height;
    }
    top
}

/// SVG element of this height around `parts`.
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

/// SVG of the residuals of one observation, `width` pixels wide. The axis extends to `reach`, SI, on either side.
pub fn residuals(report: &Report<'_>, fit: &ObservationFit, title: &str, reach: f64, width: f64) -> String {
    draw(report, fit, &columns(report, fit, reach), title, SLIM, WIDTH - width, Some(reach)).svg(&Palette::LIGHT)
}

/// Draws a panel, identified by its height and `narrower` pixels narrower than the page.
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
        language.say(": measured values and fitted curve against ")
    } else {
        language.say(": measured minus fitted, against ")
    };
    let description = [&shown, what, &name].concat();
    let zero = vec![0.0; columns.times.len()];
    let [used, unused, outlying] = &columns.points;
    let outside = !unused[0].is_empty();
    let named = |words: &'static str| if upper { words } else { "" };
    let of_points = |points, label, colour| {
        let [x, values, errors, residuals, residual_errors]: &[Vec<f64>; 5] = points;
        let (y, spread) = if upper { (values, errors) } else { (residuals, residual_errors) };
        Series { label, style: Style::Points, colour, x, y, spread, ..Series::default() }
    };
    let of_curve = |label, style, y| {
        let (x, spread) = (&columns.times, &columns.spread[usize::from(!upper)]);
        Series { label, colour: CURVE, style, x, y, spread, ..Series::default() }
    };
    let mut series = vec![of_points(used, named(language.say("measured")), DATA)];
    if outside {
        series.push(of_points(unused, named(language.say("not fitted")), UNUSED));
    }
    if !outlying[0].is_empty() {
        series.push(of_points(outlying, named(language.say("outlier")), OUTLIER));
    }
    if upper {
        series.push(of_curve(named(language.say("fitted")), Style::Line, &columns.fitted));
        if outside {
            series.push(of_curve(named(language.say("predicted")), Style::Kept(0), &columns.predicted));
        }
    } else {
        series.insert(0, of_curve("", Style::Line, &zero));
    }
    // Residuals of several theories share one scale. Larger residuals are not drawn.
    let limits = reach.map(|reach| size(&fit.unit, reach) / columns.part);
    let view = View { x: None, y: limits.map(|limit| Interval::new(-limit, limit)).into_iter().collect() };
    let plot = Plot {
        title,
        description: &description,
        x: Axis { label: &name, unit: &time_unit, ..Axis::default() },
        y: vec![Axis { label: &shown, unit: &value_unit, ..Axis::default() }],
        series,
        ordered: true,
        view,
        ..Plot::default()
    };
    layout(
        &plot,
        &Settings {
            width: WIDTH - narrower,
            height,
            font_size: 13.0,
            decimal_comma: language.style().decimal_comma,
            level: None,
        },
    )
}

/// Embeds a figure in another SVG.
fn place(out: &mut String, figure: &Figure, x: f64, y: f64) {
    let svg = figure.svg(&Palette::LIGHT);
    let rest = svg.strip_prefix("<svg").unwrap_or(&svg);
    out.extend(["<svg x=\"", &x.to_string(), "\" y=\"", &y.to_string(), "\"", rest]);
}

/// Largest absolute residual, SI.
pub fn greatest(fit: &ObservationFit) -> f64 {
    greatest_where(fit, |_| true)
}

/// Largest absolute residual that is relevant to compare theories, SI. Residuals outside the fitted part count up to
/// three times the largest one inside, because larger ones would only flatten the figure.
pub fn telling(fit: &ObservationFit) -> f64 {
    let fitted = greatest_where(fit, |inside| inside);
    fitted.max(greatest(fit).min(3.0 * fitted))
}

fn greatest_where(fit: &ObservationFit, wanted: impl Fn(bool) -> bool) -> f64 {
    let rows = fit.measured.iter().zip(&fit.fitted).zip(&fit.inside).filter(|(_, inside)| wanted(**inside));
    let residuals = rows.map(|((measured, fitted), _)| (measured - fitted).abs());
    residuals.filter(|size| size.is_finite()).fold(0.0, f64::max)
}

/// Data of one observation. `reach`: size of a residual, SI, from which the unit of residuals is chosen.
fn columns(report: &Report<'_>, fit: &ObservationFit, reach: f64) -> Columns {
    let residual_unit = fit.unit.for_residuals(size(&fit.unit, reach).abs());
    let (part, unit) = (residual_unit.factor / fit.unit.factor, unit_text(&residual_unit.text));
    let clock = &report.document.program.model.independent.unit;
    let value = |si: f64| fit.unit.from_si(si);
    // A difference is scaled by the factor of the unit, without its zero.
    let difference = |si: f64| size(&fit.unit, si);
    let errors = errors(report, fit);
    let mut points: [[Vec<f64>; 5]; 3] = Default::default();
    let own =
        report.outcome.outliers.iter().filter(|one| (one.record, one.observation) == (fit.record, fit.observation));
    let outlying: Vec<usize> = own.map(|one| one.row).collect();
    let every = thinned(fit);
    for row in 0..fit.times.len() {
        let kind = if outlying.contains(&row) { 2 } else { usize::from(!fit.inside[row]) };
        // Outliers are never thinned.
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
    // The two parts of the curve share their end points.
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

/// Standard errors given for the values of an observation, SI, NaN if a row is not found; empty if none were given.
/// Rows are matched by time and value.
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

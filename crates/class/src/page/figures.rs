//! Figures of a class, as SVG.

use crate::collection::{Collection, CurveGroup, Member};
use crate::pooling::Measured;
use crate::results::Quantity;
use desk::{FittedCurve, MeasuredCurve};
use figure::{Axis, Interval, Palette, Plot, Series, Settings, Style, View, layout};
use report::plain_symbol;
use units::number::unit_text;
use units::{Language, Unit};

/// Maximum number of drawn points of a curve, and of all curves of a figure together; longer curves are thinned.
const MOST_POINTS: usize = 500;
const MOST_IN_FIGURE: usize = 20_000;
/// Maximum number of drawn curves.
pub const MOST_CURVES: usize = 200;

/// Colours of the series: curve of the theory, results, results far from the others, and the pooled value.
const THEORY: u8 = 1;
const RESULTS: u8 = 0;
const FAR: u8 = 3;
const POOLED: u8 = 1;

/// Size, colours and language of the figures.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Width in pixels.
    pub width: f64,
    /// Height of the figure of measured curves in pixels.
    pub height: f64,
    /// Colours.
    pub palette: &'static Palette,
    /// Language of the texts.
    pub language: Language,
}

impl Look {
    /// A plot of this height in pixels.
    pub(super) fn svg(self, plot: &Plot<'_>, height: f64) -> String {
        let decimal_comma = self.language.style().decimal_comma;
        let settings = Settings { width: self.width, height, font_size: 13.0, decimal_comma, level: None };
        layout(plot, &settings).svg(self.palette)
    }
}

/// Maximum number of drawn points of one of these curves.
fn most_points(curves: usize) -> usize {
    MOST_POINTS.min(MOST_IN_FIGURE / curves.clamp(1, MOST_CURVES))
}

/// Evenly chosen values, at most `most`.
fn thinned(values: &[f64], most: usize) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(most).max(1)).copied().collect()
}

/// A drawn curve: horizontal and vertical values.
type Points = (Vec<f64>, Vec<f64>);

/// The measured curves of these groups over the fitted curve of one of them. At most 200 curves are drawn. `labels`: a name
/// for each curve, or empty for faint curves without a legend.
pub fn curves(
    collection: &Collection,
    group: &CurveGroup,
    members: &[Member],
    labels: &[String],
    look: Look,
) -> String {
    let language = look.language;
    let own = |member: &Member| collection.curve(*member);
    let most = most_points(members.len());
    let points = |curve: &MeasuredCurve| (thinned(&curve.times, most), thinned(&curve.values, most));
    let drawn: Vec<Points> = members.iter().take(MOST_CURVES).filter_map(own).map(points).collect();
    let typical = collection.typical_fit(&CurveGroup { members: members.to_vec(), ..group.clone() });
    let mut series = ghosts(&drawn);
    for ((number, series), label) in series.iter_mut().enumerate().zip(labels) {
        (series.style, series.label, series.colour) = (Style::Run(number as u8), label, 0);
    }
    if let Some((_, FittedCurve { curve_times, curve_values, .. })) = typical {
        let label = language.say("theory");
        series.push(Series { label, colour: THEORY, x: curve_times, y: curve_values, ..Series::default() });
    }
    let description = language.say("measured curves of all groups");
    draw(group, ("", description), series, look, look.height)
}

/// Residuals of the fits of these groups: measured minus fitted. `None` without a fit.
pub fn residuals(collection: &Collection, group: &CurveGroup, members: &[Member], look: Look) -> Option<String> {
    let fits = members.iter().take(MOST_CURVES).filter_map(|member| collection.fit_of(*member));
    let most = most_points(members.len());
    let drawn: Vec<Points> = fits.map(|fit| (thinned(&fit.times, most), thinned(&fit.residuals, most))).collect();
    let description = look.language.say("residuals of the fits of all groups");
    (!drawn.is_empty()).then(|| draw(group, ("Δ", description), ghosts(&drawn), look, 190.0))
}

fn ghosts(drawn: &[Points]) -> Vec<Series<'_>> {
    let mut series: Vec<Series<'_>> = Vec::with_capacity(drawn.len() + 1);
    for (number, (x, y)) in drawn.iter().enumerate() {
        series.push(Series { style: Style::Ghost, colour: (number % 6) as u8, x, y, ..Series::default() });
    }
    series
}

fn draw(
    group: &CurveGroup,
    (prefix, description): (&str, &str),
    series: Vec<Series<'_>>,
    look: Look,
    height: f64,
) -> String {
    let (across, name) = (plain_symbol(&group.across.name), plain_symbol(&group.quantity.name));
    let (across_unit, unit) = (unit_text(&group.across.unit), unit_text(&group.quantity.unit));
    let shown = [prefix, &name].concat();
    let plot = Plot {
        description: &[&shown, ": ", description].concat(),
        x: Axis { label: &across, unit: &across_unit, ..Axis::default() },
        y: vec![Axis { label: &shown, unit: &unit, ..Axis::default() }],
        series,
        ordered: true,
        ..Plot::default()
    };
    look.svg(&plot, height)
}

/// SI units per unit of a quantity.
pub fn scale(quantity: &Quantity) -> f64 {
    Unit::parse(&quantity.unit).map_or(1.0, |unit| unit.to_si(1.0) - unit.to_si(0.0))
}

/// Results of the groups with their standard errors, by the number of the group in the list, over the interval of the pooled
/// value without results far from the others.
pub fn results(quantity: &Quantity, look: Look) -> String {
    let language = look.language;
    let scale = scale(quantity);
    let (mut near, mut outside): ([Vec<f64>; 3], [Vec<f64>; 3]) = Default::default();
    for (place, (_, Measured { value, error })) in quantity.results.iter().enumerate() {
        let [x, y, spread] = if quantity.outlier(place).is_some() { &mut outside } else { &mut near };
        x.push(place as f64 + 1.0);
        y.push(value / scale);
        spread.push(error / scale);
    }
    let ends = [0.5, quantity.results.len() as f64 + 0.5];
    let pooled = quantity.pool.as_ref().ok().map(|pool| {
        let pooled = pool.without.as_ref().unwrap_or(&pool.all);
        ([pooled.value / scale; 2], [(pooled.interval.1 - pooled.value) / scale; 2])
    });
    let mut series = Vec::new();
    if let Some((y, spread)) = &pooled {
        let label = language.say("pooled, 95 %");
        series.push(Series { label, colour: POOLED, x: &ends, y, spread, ..Series::default() });
    }
    let named = [(language.say("groups"), &near, RESULTS), (language.say("far"), &outside, FAR)];
    for (label, [x, y, spread], colour) in named {
        if !x.is_empty() {
            series.push(Series { label, style: Style::Points, colour, x, y, spread, ..Series::default() });
        }
    }
    let (name, unit) = (plain_symbol(&quantity.name), unit_text(&quantity.unit));
    let description = [name.as_str(), language.say(": results of the groups")].concat();
    let plot = Plot {
        description: &description,
        x: Axis { label: language.say("group"), ..Axis::default() },
        y: vec![Axis { label: &name, unit: &unit, ..Axis::default() }],
        series,
        view: View { x: Some(Interval::new(ends[0], ends[1])), y: Vec::new() },
        ordered: true,
        ..Plot::default()
    };
    look.svg(&plot, 260.0)
}

/// Histogram of the results. The number of bins is the square root of the number of results, between 3 and 30.
pub fn histogram(quantity: &Quantity, look: Look) -> String {
    let language = look.language;
    let scale = scale(quantity);
    let values: Vec<f64> = quantity.results.iter().map(|(_, one)| one.value / scale).collect();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let bins = ((values.len() as f64).sqrt().ceil() as usize).clamp(3, 30);
    let width = if high > low { (high - low) / bins as f64 } else { 1.0 };
    let mut counts = vec![0.0; bins];
    for value in &values {
        let bin = (((value - low) / width) as usize).min(bins - 1);
        counts[bin] += 1.0;
    }
    let middles: Vec<f64> = (0..bins).map(|bin| low + (bin as f64 + 0.5) * width).collect();
    let (name, unit) = (plain_symbol(&quantity.name), unit_text(&quantity.unit));
    let description = [name.as_str(), language.say(": number of groups by result")].concat();
    let bars = Series { style: Style::Bars, colour: RESULTS, x: &middles, y: &counts, width, ..Series::default() };
    let plot = Plot {
        description: &description,
        x: Axis { label: &name, unit: &unit, ..Axis::default() },
        y: vec![Axis { label: language.say("groups"), include: Some(Interval::new(0.0, 2.0)), ..Axis::default() }],
        series: vec![bars],
        steady: true,
        ..Plot::default()
    };
    look.svg(&plot, 200.0)
}

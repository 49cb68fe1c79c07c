//! Results of the groups against a parameter that each group held fixed at a value of its own.

use super::figures::{Look, scale};
use crate::against::{Against, Point, Power};
use crate::collection::Collection;
use crate::results::{Fixed, Quantity, turning};
use figure::{Axis, Plot, Series, Style};
use report::{Page, escaped, plain_symbol};
use units::Unit;
use units::number::unit_text;

/// Maximum number of parameters.
const MOST: usize = 3;
/// Factor by which the curve of the theory reaches beyond the values of the groups.
const BEYOND: f64 = 1.2;

/// Section of a quantity against a parameter: the results with their errors and the straight line as a figure, the sentence about
/// the line, and a table of the first `most` results.
pub fn against(asked: &Against, collection: &Collection, most: usize, look: Look) -> String {
    let language = look.language;
    let mut page = Page::default();
    page.element("h3", &asked.title(language));
    page.raw("<figure>\n");
    page.raw(&straight_line(asked, look));
    page.raw("</figure>\n");
    page.element("p", &asked.sentence(language));
    let headings = [language.say("Name"), &format!("#{}", asked.x), &format!("#{}", asked.y)];
    page.table("", &headings);
    for (index, point) in asked.points.iter().take(most) {
        let [x, y] = asked.texts(*point, language);
        page.row(&[&escaped(collection.sender(*index)), &format!("#{x}"), &format!("#{y}")]);
    }
    page.end_table();
    page.out
}

/// Results with their errors, and the straight line from the vertical axis to beyond the greatest value.
fn straight_line(asked: &Against, look: Look) -> String {
    let language = look.language;
    let column = |value: fn(&Point) -> f64| asked.points.iter().map(|(_, point)| value(point)).collect::<Vec<f64>>();
    let (x, y) = (column(|point| point.x), column(|point| point.measured.value));
    let errors = column(|point| point.measured.error);
    let [low, high] =
        [x.iter().fold(0.0_f64, |least, x| least.min(*x)), x.iter().fold(0.0_f64, |most, x| most.max(*x))];
    let ends = [low, high].map(|end| end * BEYOND);
    let drawn = asked.line.as_ref().ok().map(|line| ends.map(|x| line.intercept + line.slope * x));
    let mut series = Vec::new();
    if let Some(drawn) = &drawn {
        let label = language.say("straight line");
        series.push(Series { label, colour: 1, x: &ends, y: drawn, ..Series::default() });
    }
    let label = language.say("groups");
    series.push(Series { label, style: Style::Points, x: &x, y: &y, spread: &errors, ..Series::default() });
    let ([unit, x_unit], [name, x_name]) = (asked.unit_texts(), [&asked.y, &asked.x].map(ToString::to_string));
    let plot = Plot {
        description: &asked.title(language),
        x: Axis { label: &x_name, unit: &x_unit, ..Axis::default() },
        y: vec![Axis { label: &name, unit: &unit, ..Axis::default() }],
        series,
        steady: true,
        ..Plot::default()
    };
    look.svg(&plot, 300.0)
}

/// A figure for each parameter that the groups held fixed at different values: the results, the curve of the theory if the
/// quantity follows from it, and a sentence about the straight line. At most three parameters; empty without any.
pub(super) fn section(quantity: &Quantity, collection: &Collection, look: Look) -> String {
    let mut page = Page::default();
    for parameter in parameters(quantity).into_iter().take(MOST) {
        page.raw("<figure>\n");
        page.raw(&figure(quantity, collection, parameter, look));
        page.raw("</figure>\n");
        if let Some(against) = Against::new(quantity, None, &Power::first(&parameter.name)) {
            let sentence = format!("{}. {}", against.title(look.language), against.sentence(look.language));
            page.element("p", &sentence);
        }
    }
    page.out
}

/// The parameters with at least two values, as in the first fit that has them.
fn parameters(quantity: &Quantity) -> Vec<&Fixed> {
    let mut found: Vec<&Fixed> = Vec::new();
    let all = || quantity.fixed.iter().flatten();
    for one in all() {
        let differs = all().any(|other| other.name == one.name && other.value.to_bits() != one.value.to_bits());
        if differs && found.iter().all(|known| known.name != one.name) {
            found.push(one);
        }
    }
    found
}

fn figure(quantity: &Quantity, collection: &Collection, parameter: &Fixed, look: Look) -> String {
    let language = look.language;
    let (scale, unit) = (scale(quantity), Unit::parse(&parameter.unit).unwrap_or_else(|_| Unit::dimensionless()));
    let (mut x, mut y, mut errors) = (Vec::new(), Vec::new(), Vec::new());
    for ((_, measured), fixed) in quantity.results.iter().zip(&quantity.fixed) {
        if let Some(own) = fixed.iter().find(|own| own.name == parameter.name) {
            x.push(unit.from_si(own.value * turning(&own.unit, &parameter.unit)));
            y.push(measured.value / scale);
            errors.push(measured.error / scale);
        }
    }
    let reached = x.iter().fold(0.0_f64, |most, x| most.max(x.abs())) * BEYOND;
    let curve =
        collection.theory_curve(&quantity.theory, &quantity.name, &parameter.name).filter(|_| quantity.is_derived);
    let points = curve.iter().flat_map(|curve| curve.x.iter().zip(&curve.y));
    let points = points.map(|(x, y)| (unit.from_si(*x), y / scale)).filter(|(x, _)| x.abs() <= reached);
    let (curve_x, curve_y): (Vec<f64>, Vec<f64>) = points.unzip();
    let mut series = Vec::new();
    if !curve_x.is_empty() {
        let label = language.say("theory");
        series.push(Series { label, colour: 1, x: &curve_x, y: &curve_y, ..Series::default() });
    }
    let label = language.say("groups");
    series.push(Series { label, style: Style::Points, x: &x, y: &y, spread: &errors, ..Series::default() });
    let (name, against) = (plain_symbol(&quantity.name), plain_symbol(&parameter.name));
    let (unit, against_unit) = (unit_text(&quantity.unit), unit_text(&parameter.unit));
    let description = format!("{name}{}{against}", language.say(" against "));
    let plot = Plot {
        description: &description,
        x: Axis { label: &against, unit: &against_unit, ..Axis::default() },
        y: vec![Axis { label: &name, unit: &unit, ..Axis::default() }],
        series,
        steady: true,
        ..Plot::default()
    };
    look.svg(&plot, 240.0)
}

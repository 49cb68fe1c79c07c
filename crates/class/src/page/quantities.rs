//! A fitted quantity: results of the groups and the pooled value.

use super::against;
use super::figures::{Look, histogram, results, scale};
use crate::collection::Collection;
use crate::pooling::{Measured, Pool, Pooled};
use crate::results::Quantity;
use report::{Page, escaped, symbol};
use units::alphabet::capitalised;
use units::number::{Layout, plain, unit_text, with_error, with_unit};
use units::{Language, Unit, say};

/// Number of results from which on a histogram is drawn.
const FOR_HISTOGRAM: usize = 8;
/// Significant digits of a number without an error.
const DIGITS: usize = 3;

/// Section of a quantity: figure, pooled value, table of the first `most` results, histogram.
pub fn quantity(quantity: &Quantity, collection: &Collection, most: usize, look: Look) -> String {
    let language = look.language;
    let mut page = Page::default();
    let unit = unit_text(&quantity.unit);
    let unit = if unit.is_empty() { unit } else { format!(" [{}]", escaped(&unit)) };
    page.wrapped("h3", &format!("{}: {}{unit}", escaped(&quantity.theory), symbol(&quantity.name)));
    page.raw("<figure>\n");
    page.raw(&results(quantity, look));
    page.raw("</figure>\n");
    for sentence in pooled(quantity, language) {
        page.element("p", &sentence);
    }
    let headings = language.say_all(["#Group", "Name", "#Result", "Remark"]);
    page.table("", &headings);
    for (place, (index, measured)) in quantity.results.iter().enumerate().take(most) {
        let sender = collection.sender(*index);
        let (number, value) = (format!("#{}", place + 1), format!("#{}", result_text(quantity, *measured, language)));
        page.row(&[&number, &escaped(sender), &value, &escaped(&far_text(quantity, place, language))]);
    }
    page.end_table();
    let rest = quantity.results.len().saturating_sub(most);
    if rest > 0 {
        let text = language.say("Further groups, listed in the report");
        page.element("p class=\"note\"", &format!("{text}: {rest}."));
    }
    page.raw(&against::section(quantity, collection, look));
    if quantity.results.len() >= FOR_HISTOGRAM {
        page.raw("<figure>\n");
        page.raw(&histogram(quantity, look));
        page.raw("</figure>\n");
    }
    page.out
}

/// Value and standard error of a result in the unit of the quantity, with the digits that the error allows.
pub fn result_text(quantity: &Quantity, Measured { value, error }: Measured, language: Language) -> String {
    let scale = scale(quantity);
    with_error(value / scale, Some(error / scale), language.style())
}

/// Text for a result far from the others, with the likely reason; empty for others.
pub fn far_text(quantity: &Quantity, place: usize, language: Language) -> String {
    let Some(outlier) = quantity.outlier(place) else { return String::new() };
    let reason = outlier.reason.map(|reason| format!(": {}", reason.words().text(language)));
    format!("{}{}", language.say("far from the others"), reason.unwrap_or_default())
}

/// Sentences about the pooled value: with all results, and without those far from the others; or why there is none.
pub fn pooled(quantity: &Quantity, language: Language) -> Vec<String> {
    let Pool { all, without, .. } = match &quantity.pool {
        Ok(pool) => pool,
        Err(why) => return vec![format!("{}.", capitalised(&why.text(language)))],
    };
    let (scale, style) = (scale(quantity), language.style());
    let unit = unit_text(&quantity.unit);
    let gap = if unit.is_empty() { "" } else { " " };
    // In a unit with a prefix, so that a small scatter needs no power of ten.
    let number = |si: f64| {
        let Ok(own) = Unit::parse(&quantity.unit) else { return plain(si, DIGITS, style) };
        let shown = own.for_residuals(si / scale);
        with_unit(&plain(si / scale * (own.factor / shown.factor), DIGITS, style), &shown)
    };
    let line = |title: &str, pooled: &Pooled| {
        // The ends of the interval have the digits that the error allows.
        let layout = Layout::of_errors([(pooled.value / scale, pooled.error / scale)]);
        let end = |value: f64| layout.map_or_else(|| plain(value, 6, style), |layout| layout.number(value, style));
        let (low, high) = (end(pooled.interval.0 / scale), end(pooled.interval.1 / scale));
        let between = say!(language, "95 %: {low} to {high}{gap}{unit}");
        let value = with_error(pooled.value / scale, Some(pooled.error / scale), style);
        let scatter = pooled.scatter_text(language, number);
        format!("{title}, n = {}: {value}{gap}{unit} ({between}). {scatter}", pooled.count)
    };
    let mut sentences = vec![line(language.say("Pooled"), all)];
    let title = language.say("Without those far from the others");
    sentences.extend(without.as_ref().map(|without| line(title, without)));
    sentences
}

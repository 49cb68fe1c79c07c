//! Tables of the results of a fit.

use crate::Report;
use crate::markup::{Page, cell, escaped, symbol};
use analysis::fit::{Estimate, Interval};
use program::Program;
use units::number::{DASH, Style, concise, fixed, plain, steady, unit_text};
use units::{Language, Unit};

/// Maximum number of parameters for which the full correlation matrix is shown.
const MATRIX: usize = 10;

/// Value of an estimate in its unit, rounded by its standard error for correlated residuals, otherwise by the ordinary
/// one. A dash if undetermined.
pub fn quoted(estimate: &Estimate, style: Style) -> String {
    let value = estimate.unit.from_si(estimate.value);
    if !estimate.determined {
        return DASH.to_owned();
    }
    concise(value, estimate.stderr_hac.or(estimate.stderr).map(|error| size(&estimate.unit, error)), style)
}

/// Converts a difference from SI to a unit, without the zero of the unit.
pub fn size(unit: &Unit, si: f64) -> f64 {
    unit.from_si(si) - unit.from_si(0.0)
}

/// Estimates with units in which they need no power of ten. All estimates of one quantity get the same unit.
pub fn readable_units(estimates: &[Estimate]) -> Vec<Estimate> {
    let of_size = |one: &Estimate| {
        let alike = estimates.iter().filter(|other| other.name == one.name && other.determined);
        let sizes = alike.flat_map(|other| [other.value, other.stderr_hac.or(other.stderr).unwrap_or(0.0)]);
        let greatest = sizes.filter(|si| si.is_finite()).fold(0.0_f64, |greatest, si| greatest.max(si.abs()));
        one.unit.for_size(size(&one.unit, greatest).abs())
    };
    estimates.iter().map(|one| Estimate { unit: of_size(one), ..one.clone() }).collect()
}

/// Label of an estimate; empty if it has none.
pub fn label(program: &Program, language: Language, estimate: &Estimate) -> String {
    if let Some(label) = &estimate.label {
        return program.text(language.tag(), label).to_owned();
    }
    let own = estimate.parameter().is_some();
    match estimate.name.rsplit_once('_') {
        Some((name, "origin")) if !own && name == program.model.independent.name => {
            language.say("Reading of the clock at the start").to_owned()
        }
        Some((name, "offset")) if !own => [language.say("Zero of the scale of "), &name.replace('\'', "′")].concat(),
        _ => String::new(),
    }
}

/// Derived quantities, with one entry for those that are equal in all records.
pub fn once(derived: &[Estimate]) -> Vec<Estimate> {
    let mut result: Vec<Estimate> = Vec::new();
    for estimate in derived {
        let alike = |other: &&Estimate| other.name == estimate.name;
        let same = derived.iter().filter(alike).all(|other| {
            other.value == estimate.value && other.stderr == estimate.stderr && other.stderr_hac == estimate.stderr_hac
        });
        if !same {
            result.push(estimate.clone());
        } else if !result.iter().any(|other| other.name == estimate.name) {
            result.push(Estimate { record: None, ..estimate.clone() });
        }
    }
    result
}

/// Adds the table of the parameters or, if `derived`, of the derived quantities.
pub fn estimates(page: &mut Page, report: &Report<'_>, estimates: &[Estimate], derived: bool) {
    let language = report.language;
    let profiles = if derived { &[][..] } else { report.intervals };
    let mut headings = vec![
        language.say("Symbol"),
        language.say("Quantity"),
        language.say("#Value"),
        language.say("Unit"),
        language.say("#Standard error"),
        language.say("#if residuals were independent"),
    ];
    if !profiles.is_empty() {
        headings.push(language.say("#68 % by profile, if residuals were independent"));
    }
    page.table("wide", &headings);
    let estimates = &readable_units(estimates);
    // Estimates that hold for all records come first, then those of each record.
    let mut order: Vec<usize> = (0..estimates.len()).collect();
    order.sort_by_key(|&index| estimates[index].record.map_or(0, |record| record + 1));
    let mut group = None;
    for index in order {
        let estimate = &estimates[index];
        if estimate.record != group {
            group = estimate.record;
            let name = group.and_then(|record| report.task.records.get(record)).map_or("", |record| &record.name);
            let columns = headings.len().to_string();
            page.raw(
                &[
                    "<tr class=\"group\"><th scope=\"colgroup\" colspan=\"",
                    &columns,
                    "\">",
                    &escaped(name),
                    "</th></tr>\n",
                ]
                .concat(),
            );
        }
        let interval = profiles.get(index).copied().flatten();
        row(page, report, estimate, (!profiles.is_empty()).then_some(interval));
    }
    page.end_table();
}

fn row(page: &mut Page, report: &Report<'_>, estimate: &Estimate, interval: Option<Option<[Interval; 2]>>) {
    let language = report.language;
    let style = language.style();
    let own = |si: Option<f64>| match si {
        Some(si) if estimate.determined => cell(&steady(size(&estimate.unit, si), 2, style)),
        _ => cell(DASH),
    };
    let value = if !estimate.determined {
        ["#<small>", language.say("not determined"), "</small>"].concat()
    } else if let Some(stopped) = estimate.stopped_text(language) {
        let value = plain(estimate.unit.from_si(estimate.value), 6, style);
        ["#", &escaped(&value), " <small>", stopped, "</small>"].concat()
    } else {
        ["#<b>", &escaped(&quoted(estimate, style)), "</b>"].concat()
    };
    let mut cells = vec![
        symbol(&estimate.name),
        escaped(&label(&report.document.program, report.language, estimate)),
        value,
        escaped(&unit_text(&estimate.unit.text)),
        own(estimate.stderr_hac),
        own(estimate.stderr),
    ];
    if let Some(interval) = interval {
        cells.push(cell(&interval.map_or_else(|| DASH.to_owned(), |[one, _]| ends(estimate, one, style))));
    }
    let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
    page.row(&cells);
}

/// Interval `0.383 … 0.391`, with the digits that its width justifies.
fn ends(estimate: &Estimate, interval: Interval, style: Style) -> String {
    let [low, high] = [interval.low, interval.high].map(|end| end.map(|si| estimate.unit.from_si(si)));
    let width = match (low, high) {
        (Some(low), Some(high)) => (high - low) / 2.0,
        _ => estimate.stderr.map_or(f64::NAN, |si| size(&estimate.unit, si)),
    };
    let write = |end: Option<f64>| match end {
        Some(value) => {
            let text = concise(value, Some(width), style);
            // Removes the error in parentheses; a power of ten may follow it.
            match (text.find('('), text.find(')')) {
                (Some(open), Some(close)) => [&text[..open], &text[close + 1..]].concat(),
                _ => text,
            }
        }
        None => "…".to_owned(),
    };
    [&write(low), " … ", &write(high)].concat()
}

/// Adds the correlation matrix, or for many parameters a list of the strongest correlations.
pub fn correlations(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let (parameters, matrix) = (&report.outcome.parameters, &report.outcome.correlation);
    let count = parameters.len();
    if count < 2 || matrix.len() != count * count {
        return;
    }
    page.heading(language.say("Correlations"));
    let mut strongest: Vec<(usize, usize, f64)> = (0..count)
        .flat_map(|row| (0..row).map(move |column| (column, row)))
        .map(|(a, b)| (a, b, matrix[b * count + a]))
        .filter(|(.., value)| value.is_finite())
        .collect();
    strongest.sort_by(|a, b| b.2.abs().total_cmp(&a.2.abs()));
    let named = |index: usize| {
        let estimate = &parameters[index];
        match estimate.record.and_then(|record| report.task.records.get(record)) {
            Some(record) => [&symbol(&estimate.name), " <small>", &escaped(&record.name), "</small>"].concat(),
            None => symbol(&estimate.name),
        }
    };
    if count > MATRIX {
        let heads = [language.say("Parameter"), language.say("Correlated with"), language.say("#Correlation")];
        page.table("", &heads);
        for (a, b, value) in strongest.into_iter().take(12) {
            page.row(&[&named(a), &named(b), &cell(&fixed(value, 3, language.style()))]);
        }
        page.end_table();
        return;
    }
    page.raw("<div class=\"scroll\"><table class=\"matrix\"><thead><tr><td></td>");
    for index in 0..count {
        page.header("scope=\"col\"", &named(index).replace(" <small>", "<br/> <small>"));
    }
    page.raw("</tr></thead><tbody>\n");
    for row in 0..count {
        page.raw("<tr>");
        page.header("scope=\"row\"", &named(row));
        for column in 0..count {
            let value = matrix[row * count + column];
            page.wrapped(&tinted(value), &fixed(value, 2, language.style()));
        }
        page.raw("</tr>\n");
    }
    page.end_table();
    if let Some((a, b, value)) = strongest.first().filter(|(.., value)| value.abs() > 0.9) {
        let start = language.say("The strongest is that of ");
        let end = language.say(": the data determine a combination of the two much better than either by itself.");
        let value = fixed(*value, 3, language.style());
        page.wrapped("p", &[start, &named(*a), language.say(" and "), &named(*b), ", ", &value, end].concat());
    }
}

/// Table cell whose colour shows a correlation: blue for positive, orange for negative, darker for stronger.
fn tinted(value: f64) -> String {
    if !value.is_finite() {
        return "td".to_owned();
    }
    let colour = if value > 0.0 { "11,90,168" } else { "209,70,0" };
    // The square emphasises strong correlations. The depth is limited so that the number stays legible.
    let depth = (value * value).min(1.0) * 0.42;
    ["td style=\"background:rgba(", colour, ",", &fixed(depth, 3, Style::POINT), ")\""].concat()
}

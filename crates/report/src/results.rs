//! Tables of the results of a fit.

use crate::Report;
use crate::fit_report::FitRow;
use crate::markup::{Page, cell, escaped, symbol};
use crate::written::size;
use analysis::fit::{Estimate, Interval};
use units::number::{DASH, Style, concise, fixed, steady, unit_text};

/// Maximum number of parameters for which the full correlation matrix is shown.
const MATRIX: usize = 10;

/// Adds a table of the varied numbers or of the derived quantities. `profiles`: with a column of profile intervals.
pub fn estimates<'a>(page: &mut Page, report: &Report<'_>, rows: impl Iterator<Item = &'a FitRow>, profiles: bool) {
    let language = report.language;
    let mut headings = vec![
        language.say("Symbol"),
        language.say("Quantity"),
        language.say("#Value"),
        language.say("Unit"),
        language.say("#Standard error"),
        language.say("#if residuals were independent"),
    ];
    if profiles {
        headings.push(language.say("#68 % by profile, if residuals were independent"));
    }
    page.table("wide", &headings);
    let mut group = None;
    for one in rows {
        if one.estimate.record != group {
            group = one.estimate.record;
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
        row(page, one, language.style(), profiles);
    }
    page.end_table();
}

fn row(page: &mut Page, row: &FitRow, style: Style, profiles: bool) {
    let estimate = &row.estimate;
    let own = |si: Option<f64>| match si {
        Some(si) if estimate.determined => cell(&steady(size(&estimate.unit, si), 2, style)),
        _ => cell(DASH),
    };
    let note = ["<small>", &escaped(row.note), "</small>"].concat();
    let value = match (estimate.determined, row.note.is_empty()) {
        (false, _) => ["#", &note].concat(),
        (true, false) => ["#", &escaped(&row.rounded), " ", &note].concat(),
        (true, true) => ["#<b>", &escaped(&row.rounded), "</b>"].concat(),
    };
    let mut cells = vec![
        symbol(&estimate.name),
        escaped(&row.label),
        value,
        escaped(&unit_text(&estimate.unit.text)),
        own(estimate.stderr_hac),
        own(estimate.stderr),
    ];
    if profiles {
        cells.push(cell(&row.intervals.map_or_else(|| DASH.to_owned(), |[one, _]| ends(estimate, one, style))));
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

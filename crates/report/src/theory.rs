//! Sections about the theory, the data, and the repetition of the fit.

use crate::Report;
use crate::markup::{Page, cell, escaped, symbol};
use crate::written::size;
use analysis::fit::Target;
use program::Parameter;
use units::number::{fixed, plain, unit_text};

/// Maximum number of rows of data that are written into the page.
const MOST_ROWS: usize = 5000;

/// Adds the equations and the fixed parameters.
pub fn theory(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let model = &report.document.program.model;
    page.heading(language.say("The theory"));
    page.raw("<div class=\"equations\">");
    for equation in &report.document.program.edition(language.tag()).equations {
        page.wrapped("div", equation);
    }
    page.raw("</div>\n");
    let varied = |index: usize| report.outcome.parameters.iter().any(|one| one.parameter() == Some(index));
    let held: Vec<(usize, &Parameter)> = model.shown_parameters().filter(|(index, _)| !varied(*index)).collect();
    if held.is_empty() {
        return;
    }
    page.element("h3", language.say("Held"));
    page.table("", &[language.say("Symbol"), language.say("Quantity"), language.say("#Value"), language.say("Unit")]);
    for (index, parameter) in held {
        let label = parameter.label.as_deref().map_or("", |label| report.document.program.text(language.tag(), label));
        let mut values: Vec<f64> =
            report.outcome.settings.iter().filter_map(|values| values.get(index).copied()).collect();
        values.dedup();
        let shown = |si: &f64| match parameter.word(*si, &model.texts) {
            Some(word) => report.document.program.text(language.tag(), word).to_owned(),
            None => plain(parameter.unit.from_si(*si), 8, language.style()),
        };
        let values: Vec<String> = values.iter().map(shown).collect();
        let cells = [
            symbol(&parameter.name),
            escaped(label),
            cell(&values.join("; ")),
            escaped(&unit_text(&parameter.unit.text)),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
}

/// Adds the section about the data.
pub fn data(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let style = language.style();
    let independent = &report.document.program.model.independent;
    page.heading(language.say("The data"));
    let of = [&symbol(&independent.name), language.say(" from … to")].concat();
    page.raw("<div class=\"scroll\"><table class=\"wide\"><thead><tr>");
    for (heading, number) in [
        (escaped(language.say("Record")), false),
        (escaped(language.say("Observed")), false),
        (escaped(language.say("Values")), true),
        (escaped(language.say("of which fitted")), true),
        (of, true),
    ] {
        page.header(if number { "scope=\"col\" class=\"n\"" } else { "scope=\"col\"" }, &heading);
    }
    page.raw("</tr></thead><tbody>\n");
    for fit in &report.outcome.observations {
        let ends = [fit.times.first(), fit.times.last()]
            .map(|time| plain(independent.unit.from_si(time.copied().unwrap_or(f64::NAN)), 6, style));
        let time_unit = unit_text(&independent.unit.text);
        let observed = [&symbol(&fit.name), " <small>", &escaped(&unit_text(&fit.unit.text)), "</small>"].concat();
        let used = fit.inside.iter().filter(|inside| **inside).count();
        let cells = [
            escaped(crate::findings::record(report, fit)),
            observed,
            cell(&fit.times.len().to_string()),
            cell(&used.to_string()),
            cell([&ends[0], " … ", &ends[1], " ", &time_unit].concat().trim()),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
    for (number, notes) in report.notes.iter().enumerate() {
        let name = report.task.records.get(number).map_or("", |record| &record.name);
        for note in notes {
            page.wrapped("p class=\"note\"", &["<b>", &escaped(name), "</b>: ", &escaped(note)].concat());
        }
    }
}

/// Adds everything needed to repeat the fit.
pub fn repeat(page: &mut Page, report: &Report<'_>, csv: &str) {
    let language = report.language;
    page.heading(language.say("To repeat this"));
    if !report.command.is_empty() {
        page.wrapped("pre tabindex=\"0\"", &escaped(report.command));
    }
    page.raw("<dl class=\"steps\">");
    page.pair(language.say("Theory"), &report.document_name);
    let records: Vec<String> = report.task.records.iter().map(|record| record.name.clone()).collect();
    page.pair(language.say("Data"), &language.join(&records));
    page.pair(language.say("Varied"), &varied(report).join(", "));
    page.pair(language.say("Fitted part"), &part(report));
    page.pair(language.say("Method"), &method(report));
    page.pair(language.say("Program"), &["Meniscus ", report.version].concat());
    page.raw("</dl>\n");
    let mut detail = |summary: &str, text: &str| {
        page.raw("<details>");
        page.element("summary", summary);
        page.wrapped("pre tabindex=\"0\"", &escaped(text));
        page.raw("</details>\n");
    };
    let source = [language.say("The document, "), report.document_name].concat();
    detail(&source, &report.document.source);
    let rows: usize = report.outcome.observations.iter().map(|fit| fit.times.len()).sum();
    if rows <= MOST_ROWS {
        detail(language.say("The measured and fitted values"), csv);
    }
}

/// Varied numbers, each with its start and bounds if stated.
fn varied(report: &Report<'_>) -> Vec<String> {
    let language = report.language;
    let model = &report.document.program.model;
    let describe = |varied: &analysis::fit::Varied| {
        let (mut text, unit) = match varied.target {
            Target::Parameter(index) => {
                let parameter = model.parameters.get(index)?;
                (parameter.name.clone(), parameter.unit.clone())
            }
            Target::Origin => ([&model.independent.name, "_origin"].concat(), model.independent.unit.clone()),
            Target::Offset(number) => {
                let of = report.task.records.iter().find_map(|record| record.observations.get(number))?;
                ([&of.name, "_offset"].concat(), of.observed.unit.clone())
            }
        };
        let number = |si: f64| plain(size(&unit, si), 8, language.style());
        let mut options = Vec::new();
        if varied.shared && report.task.records.len() > 1 {
            options.push(language.say("one value for all").to_owned());
        }
        if let Some(start) = varied.start {
            options.push([language.say("from "), &number(start)].concat());
        }
        if let Some((low, high)) = varied.bounds {
            options.push([language.say("within "), &number(low), " … ", &number(high)].concat());
        }
        if !options.is_empty() {
            text.extend([" (", &options.join(", "), ")"]);
        }
        Some(text)
    };
    report.task.varied.iter().filter_map(describe).collect()
}

/// Text of the fitted part.
fn part(report: &Report<'_>) -> String {
    let language = report.language;
    let independent = &report.document.program.model.independent;
    let time = |si: f64| {
        let number = plain(independent.unit.from_si(si), 8, language.style());
        [&number, " ", &unit_text(&independent.unit.text)].concat().trim_end().to_owned()
    };
    match (report.task.from, report.task.until) {
        (None, None) => language.say("all values").to_owned(),
        (Some(from), None) => [language.say("from "), &time(from)].concat(),
        (None, Some(until)) => [language.say("until "), &time(until)].concat(),
        (Some(from), Some(until)) => [&time(from), " … ", &time(until)].concat(),
    }
}

/// Text of the method of the fit.
fn method(report: &Report<'_>) -> String {
    let language = report.language;
    let mut text = language
        .say("least squares (Levenberg and Marquardt), derivatives by the parameters from the model itself")
        .to_owned();
    if !report.document.program.model.states.is_empty() {
        text += language.say("; equations of motion integrated to 10⁻⁹");
    }
    let records = &report.task.records;
    let given = records.iter().flat_map(|record| &record.observations).all(|one| one.errors.is_some());
    if given {
        text += language.say("; weights from the given errors");
    } else if report.outcome.observations.len() > 1 {
        text += language.say("; each observation weighed by its own scatter");
    }
    if report.outcome.starts > 1 {
        let starts = report.outcome.starts.to_string();
        text.extend([language.say("; from "), &starts, language.say(" starts")]);
    }
    if report.outcome.improved > 0 {
        text += language.say("; made again from a lower chi-square that the profile of a parameter met");
    }
    let mut origins = report.outcome.origins.clone();
    origins.dedup();
    if !origins.is_empty() {
        let independent = &report.document.program.model.independent;
        let reading = |origin: &f64| fixed(independent.unit.from_si(*origin), 4, language.style());
        let values: Vec<String> = origins.iter().map(reading).collect();
        text += match report.document.program.model.states.is_empty() {
            true => language.say("; the 0 of the formula is at "),
            false => language.say("; initial values refer to "),
        };
        text.extend([&independent.name, " = ", &values.join("; "), " ", &unit_text(&independent.unit.text)]);
        text += language.say(" of the record's clock");
        let early: usize = report.outcome.observations.iter().map(|fit| fit.early).sum();
        if early > 0 {
            let rest = language.say(", and nothing is predicted of the # values before");
            text += &rest.replace('#', &early.to_string());
        }
    }
    text
}

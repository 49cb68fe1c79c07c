//! Sections about the theory, the data, and the repetition of the fit.

use crate::Report;
use crate::markup::{Page, cell, escaped, symbol};
use crate::results::size;
use analysis::fit::Target;
use program::Parameter;
use units::number::{fixed, plain, unit_text};

/// Maximum number of rows of data that are written into the page.
const MOST_ROWS: usize = 5000;

/// Adds the equations and the fixed parameters.
pub fn theory(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let model = &report.document.program.model;
    page.heading(language.pick("The theory", "La teoría"));
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
    page.element("h3", language.pick("Held", "Mantenido"));
    page.table(
        "",
        &[
            language.pick("Symbol", "Símbolo"),
            language.pick("Quantity", "Magnitud"),
            language.pick("#Value", "#Valor"),
            language.pick("Unit", "Unidad"),
        ],
    );
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
    page.heading(language.pick("The data", "Los datos"));
    let of = [&symbol(&independent.name), language.pick::<&str>(" from … to", " de … a")].concat();
    page.raw("<div class=\"scroll\"><table class=\"wide\"><thead><tr>");
    for (heading, number) in [
        (escaped(language.pick("Record", "Registro")), false),
        (escaped(language.pick("Observed", "Observado")), false),
        (escaped(language.pick("Values", "Valores")), true),
        (escaped(language.pick("of which fitted", "de ellos ajustados")), true),
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
    page.heading(language.pick("To repeat this", "Para repetirlo"));
    if !report.command.is_empty() {
        page.wrapped("pre tabindex=\"0\"", &escaped(report.command));
    }
    page.raw("<dl class=\"steps\">");
    page.pair(language.pick("Theory", "Teoría"), &report.document_name);
    let records: Vec<String> = report.task.records.iter().map(|record| record.name.clone()).collect();
    page.pair(language.pick("Data", "Datos"), &language.join(&records));
    page.pair(language.pick("Varied", "Variado"), &varied(report).join(", "));
    page.pair(language.pick("Fitted part", "Parte ajustada"), &part(report));
    page.pair(language.pick("Method", "Método"), &method(report));
    page.pair(language.pick("Program", "Programa"), &["Meniscus ", report.version].concat());
    page.raw("</dl>\n");
    let mut detail = |summary: &str, text: &str| {
        page.raw("<details>");
        page.element("summary", summary);
        page.wrapped("pre tabindex=\"0\"", &escaped(text));
        page.raw("</details>\n");
    };
    let source = [language.pick("The document, ", "El documento, "), report.document_name].concat();
    detail(&source, &report.document.source);
    let rows: usize = report.outcome.observations.iter().map(|fit| fit.times.len()).sum();
    if rows <= MOST_ROWS {
        detail(language.pick("The measured and fitted values", "Los valores medidos y ajustados"), csv);
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
            options.push(language.pick("one value for all", "un valor para todos").to_owned());
        }
        if let Some(start) = varied.start {
            options.push([language.pick("from ", "desde "), &number(start)].concat());
        }
        if let Some((low, high)) = varied.bounds {
            options.push([language.pick("within ", "entre "), &number(low), " … ", &number(high)].concat());
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
        (None, None) => language.pick("all values", "todos los valores").to_owned(),
        (Some(from), None) => [language.pick("from ", "desde "), &time(from)].concat(),
        (None, Some(until)) => [language.pick("until ", "hasta "), &time(until)].concat(),
        (Some(from), Some(until)) => [&time(from), " … ", &time(until)].concat(),
    }
}

/// Text of the method of the fit.
fn method(report: &Report<'_>) -> String {
    let language = report.language;
    let mut text = language
        .pick(
            "least squares (Levenberg and Marquardt), derivatives by the parameters from the model itself",
            "mínimos cuadrados (Levenberg y Marquardt), con las derivadas respecto a los parámetros tomadas del propio modelo",
        )
        .to_owned();
    if !report.document.program.model.states.is_empty() {
        text += language
            .pick("; equations of motion integrated to 10⁻⁹", "; ecuaciones del movimiento integradas con 10⁻⁹");
    }
    let records = &report.task.records;
    let given = records.iter().flat_map(|record| &record.observations).all(|one| one.errors.is_some());
    if given {
        text += language.pick("; weights from the given errors", "; pesos según los errores dados");
    } else if report.outcome.observations.len() > 1 {
        text += language.pick(
            "; each observation weighed by its own scatter",
            "; cada observación, ponderada por su propia dispersión",
        );
    }
    if report.outcome.starts > 1 {
        let starts = report.outcome.starts.to_string();
        text.extend([language.pick("; from ", "; desde "), &starts, language.pick(" starts", " comienzos")]);
    }
    if report.outcome.improved > 0 {
        text += language.pick(
            "; made again from a lower chi-square that the profile of a parameter met",
            "; repetido desde un chi cuadrado menor que encontró el perfil de un parámetro",
        );
    }
    let mut origins = report.outcome.origins.clone();
    origins.dedup();
    if !origins.is_empty() {
        let independent = &report.document.program.model.independent;
        let reading = |origin: &f64| fixed(independent.unit.from_si(*origin), 4, language.style());
        let values: Vec<String> = origins.iter().map(reading).collect();
        text += language.pick("; initial values refer to ", "; los valores iniciales corresponden a ");
        text.extend([&independent.name, " = ", &values.join("; "), " ", &unit_text(&independent.unit.text)]);
        text += language.pick(" of the record's clock", " en el reloj del registro");
        let early: usize = report.outcome.observations.iter().map(|fit| fit.early).sum();
        if early > 0 {
            let rest = language.pick(
                ", and nothing is predicted of the # values before",
                ", y de los # valores anteriores no se predice nada",
            );
            text += &rest.replace('#', &early.to_string());
        }
    }
    text
}

//! `meniscus class report`: the results of a class, pooled.

use super::arguments::{Report, ReportFormat};
use super::gradebook::gradebook;
use crate::failure::Failure;
use crate::handing::read::computed;
use crate::terminal::Terminal;
use crate::terminal::output;
use crate::terminal::visible::visible;
use analysis::csv::Dialect;
use class::against::{Against, Power};
use class::collection::{Collection, State};
use class::page;
use class::pooling::{Measured, Pooled};
use class::results::Quantity;
use serde_json::{Value, json};
use units::{Language, words};

/// Writes the report.
///
/// # Errors
/// A file cannot be read, or no hand-in has a fit or an answer.
pub fn report(arguments: &Report, terminal: Terminal) -> Result<(), Failure> {
    // The paths given may be folders; none of the hand-ins in them is to be overwritten.
    let (class, paths) = computed(&arguments.paths, &arguments.document, terminal.language)?;
    for entry in class.entries() {
        if let State::Unreadable(why) = entry.state() {
            terminal.print(&format!("{} {}\n", entry.file(), why.text(terminal.language)));
        }
    }
    let format = ReportFormat::chosen(arguments.format, arguments.output.as_deref());
    let quantities = class.quantities();
    if quantities.is_empty() && !format.has_answers() {
        return Err(Failure::in_words(words("no hand-in has a fit"), words("`meniscus verify` says what is in them")));
    }
    let language = terminal.language;
    let against = against(arguments, format, &quantities)?;
    let bytes = match format {
        ReportFormat::Text => {
            let text = as_text(&quantities, &class, language) + &against_text(&against, &class, language);
            visible(&text).into_owned().into_bytes()
        }
        ReportFormat::Csv => as_csv(&quantities, &class).into_bytes(),
        ReportFormat::Gradebook => gradebook(&class, language).into_bytes(),
        ReportFormat::Json => as_json(&quantities, &class, language).into_bytes(),
        ReportFormat::Html => page::html(&class, &against, language, "").into_bytes(),
        ReportFormat::Xlsx => page::workbook(&class, language),
    };
    output::deliver(arguments.output.as_deref(), &paths, &bytes)
}

/// Quantities against a parameter, as asked for.
///
/// # Errors
/// The argument is no power, or there are no such results, or the form has no place for them.
fn against(arguments: &Report, format: ReportFormat, quantities: &[Quantity]) -> Result<Vec<Against>, Failure> {
    let Some(asked) = &arguments.against else { return Ok(Vec::new()) };
    if !matches!(format, ReportFormat::Text | ReportFormat::Html) {
        return Err(Failure::in_words(
            words("only the report as text or as a page has results against a parameter"),
            words("leave out `--against`, or choose `--format text` or `--format html`"),
        ));
    }
    let power = |text: &String| {
        let hint = words("for example `--against 1/L --power omega^2`");
        Power::parse(text).map_err(|why| Failure::in_words(why, hint))
    };
    let (x, y) = (power(asked)?, arguments.power.as_ref().map(power).transpose()?);
    let found: Vec<Against> = quantities.iter().filter_map(|quantity| Against::new(quantity, y.as_ref(), &x)).collect();
    if found.is_empty() {
        let name = x.name();
        return Err(Failure::in_words(
            words!("no such result has {name} held fixed in its fit"),
            words("the report without `--against` lists the quantities"),
        ));
    }
    Ok(found)
}

fn against_text(all: &[Against], class: &Collection, language: Language) -> String {
    let mut text = String::new();
    for one in all {
        text += &format!("{}\n", one.title(language));
        let names: Vec<&str> = one.points.iter().map(|(index, _)| class.sender(*index)).collect();
        let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        for (name, (_, point)) in names.iter().zip(&one.points) {
            let [x, y] = one.texts(*point, language);
            text += &format!("  {name:<width$}  {x:<9}  {y}\n");
        }
        text += &format!("  {}\n\n", one.sentence(language));
    }
    text
}

fn as_text(quantities: &[Quantity], class: &Collection, language: Language) -> String {
    let mut text = String::new();
    for quantity in quantities {
        let unit = if quantity.unit.is_empty() { String::new() } else { format!(" [{}]", quantity.unit) };
        text += &format!("{}: {}{unit}\n", quantity.theory, quantity.name);
        let names: Vec<&str> = quantity.results.iter().map(|(index, _)| class.sender(*index)).collect();
        let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        for (place, (name, (_, measured))) in names.iter().zip(&quantity.results).enumerate() {
            let far = page::far_text(quantity, place, language);
            let arrow = if far.is_empty() { "" } else { "  ← " };
            text += &format!("  {name:<width$}  {}{arrow}{far}\n", page::result_text(quantity, *measured, language));
        }
        for sentence in page::pooled(quantity, language) {
            text += &format!("  {sentence}\n");
        }
        text.push('\n');
    }
    text
}

fn as_csv(quantities: &[Quantity], class: &Collection) -> String {
    let mut text = String::from(
        "theory,quantity,unit,group,value,standard error,far from the others,n,interval from,interval to,tau,tau from,tau to\n",
    );
    for quantity in quantities {
        let scale = page::scale(quantity);
        for (place, (index, measured)) in quantity.results.iter().enumerate() {
            let marked = quantity.outlier(place).is_some();
            // Writing to a string cannot fail.
            for word in [&quantity.theory, &quantity.name, &quantity.unit, class.sender(*index)] {
                let _ = Dialect::Commas.text(&mut text, word);
                text.push(',');
            }
            for number in [measured.value / scale, measured.error / scale] {
                let _ = Dialect::Commas.number(&mut text, number);
                text.push(',');
            }
            text += if marked { "1,,,,,,\n" } else { "0,,,,,,\n" };
        }
        let Ok(pool) = &quantity.pool else { continue };
        let without = pool.without.as_ref().map(|without| ("pooled without those far", without));
        for (name, pooled) in std::iter::once(("pooled", &pool.all)).chain(without) {
            for word in [&quantity.theory, &quantity.name, &quantity.unit, name] {
                let _ = Dialect::Commas.text(&mut text, word);
                text.push(',');
            }
            let Pooled { value, error, interval, tau, tau_interval, .. } = pooled;
            let numbers = [*value, *error].map(|number| number / scale);
            let further = [interval.0, interval.1, *tau, tau_interval.0, tau_interval.1].map(|number| number / scale);
            let cells = numbers.iter().copied().map(Some).chain([None, Some(pooled.count as f64)]);
            for cell in cells.chain(further.into_iter().map(Some)) {
                if let Some(number) = cell {
                    let _ = Dialect::Commas.number(&mut text, number);
                }
                text.push(',');
            }
            text.pop();
            text.push('\n');
        }
    }
    text
}

fn as_json(quantities: &[Quantity], class: &Collection, language: Language) -> String {
    let pooled = |pooled: &Pooled, scale: f64| {
        json!({
            "n": pooled.count,
            "value": pooled.value / scale,
            "standard_error": pooled.error / scale,
            "interval": [pooled.interval.0 / scale, pooled.interval.1 / scale],
            "tau": pooled.tau / scale,
            "tau_interval": [pooled.tau_interval.0 / scale, pooled.tau_interval.1 / scale],
        })
    };
    let quantity = |quantity: &Quantity| {
        let scale = page::scale(quantity);
        let result = |(place, (index, measured)): (usize, &(usize, Measured))| {
            let outlier = quantity.outlier(place);
            json!({
                "group": class.sender(*index),
                "value": measured.value / scale,
                "standard_error": measured.error / scale,
                "outlier": outlier.is_some(),
                "reason": outlier.and_then(|one| one.reason).map(|reason| reason.words().text(language).into_owned()),
            })
        };
        let pool = quantity.pool.as_ref().ok();
        json!({
            "theory": quantity.theory,
            "quantity": quantity.name,
            "unit": quantity.unit,
            "results": quantity.results.iter().enumerate().map(result).collect::<Vec<_>>(),
            "pooled": pool.map(|pool| pooled(&pool.all, scale)),
            "without_outliers": pool.and_then(|pool| pool.without.as_ref()).map(|one| pooled(one, scale)),
        })
    };
    let whole: Vec<Value> = quantities.iter().map(quantity).collect();
    format!("{:#}\n", Value::Array(whole))
}

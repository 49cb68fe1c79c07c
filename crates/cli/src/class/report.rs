//! `meniscus class report`: the results of a class, pooled.

use super::arguments::{ListFormat, Report};
use crate::failure::Failure;
use crate::handing::read::{Handed, all, last_of_each, sender};
use crate::terminal::Terminal;
use crate::terminal::output;
use crate::terminal::visible::visible;
use analysis::csv::Dialect;
use class::pooling::{Measured, Pool, Pooled};
use class::results::{Quantity, quantities};
use class::verify::Recomputation;
use saved::hand_in::Fact;
use serde_json::{Value, json};
use std::path::PathBuf;
use units::number::{self, Style, with_error};
use units::{Language, Unit, words};

/// Significant digits of a number without an error.
const DIGITS: usize = 3;

/// Writes the report.
///
/// # Errors
/// A hand-in cannot be read, or none has a fit.
pub fn report(arguments: &Report, terminal: Terminal) -> Result<(), Failure> {
    let handed = all(&arguments.paths)?;
    let quantities = quantities(&facts(&handed, terminal));
    if quantities.is_empty() {
        return Err(Failure::in_words(
            words("no hand-in has a fit", "ninguna entrega tiene un ajuste"),
            words("`meniscus verify` says what is in them", "`meniscus verify` dice qué contienen"),
        ));
    }
    let text = match ListFormat::chosen(arguments.format, arguments.output.as_deref()) {
        ListFormat::Text => visible(&as_text(&quantities, &handed, terminal.language)).into_owned(),
        ListFormat::Csv => as_csv(&quantities, &handed),
        ListFormat::Json => as_json(&quantities, &handed, terminal.language),
    };
    // The paths given may be folders; none of the hand-ins in them is to be overwritten.
    let paths: Vec<PathBuf> = handed.into_iter().map(|one| one.path).collect();
    output::deliver(arguments.output.as_deref(), &paths, text.as_bytes())
}

/// Facts of the hand-ins that count, computed again. What is left out is said.
fn facts(handed: &[Handed], terminal: Terminal) -> Vec<(usize, Vec<Fact>)> {
    let last = last_of_each(handed);
    let mut facts = Vec::new();
    for (index, one) in handed.iter().enumerate() {
        let name = one.path.display();
        let computed = match &one.content {
            Err(error) => Err(error.words()),
            Ok(hand_in) if last.get(&sender(hand_in)) != Some(&index) => continue,
            Ok(hand_in) => Recomputation::complete(&hand_in.work),
        };
        match computed {
            Ok(recomputation) => facts.push((index, recomputation.facts())),
            Err(why) => terminal.print(&format!("{name} {}\n", why.text(terminal.language))),
        }
    }
    facts
}

fn sender_name(handed: &[Handed], index: usize) -> &str {
    handed.get(index).map_or("", Handed::sender_name)
}

/// A quantity with the scale of its unit, SI units per unit.
struct Scaled<'a> {
    quantity: &'a Quantity,
    scale: f64,
}

impl<'a> Scaled<'a> {
    fn new(quantity: &'a Quantity) -> Self {
        let scale = Unit::parse(&quantity.unit).map_or(1.0, |unit| unit.to_si(1.0) - unit.to_si(0.0));
        Self { quantity, scale }
    }

    /// Value and standard error in the unit, with the digits that the error allows.
    fn text(&self, Measured { value, error }: Measured) -> String {
        with_error(value / self.scale, Some(error / self.scale), Style::POINT)
    }

    fn number(&self, value: f64) -> String {
        let unit = number::unit_text(&self.quantity.unit);
        let gap = if unit.is_empty() { "" } else { " " };
        format!("{}{gap}{unit}", number::plain(value / self.scale, DIGITS, Style::POINT))
    }
}

fn as_text(quantities: &[Quantity], handed: &[Handed], language: Language) -> String {
    let mut text = String::new();
    for quantity in quantities {
        let scaled = Scaled::new(quantity);
        let unit = if quantity.unit.is_empty() { String::new() } else { format!(" [{}]", quantity.unit) };
        text += &format!("{}: {}{unit}\n", quantity.theory, quantity.name);
        let names: Vec<&str> = quantity.results.iter().map(|(index, _)| sender_name(handed, *index)).collect();
        let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        let outlier = |place: usize| {
            let pool = quantity.pool.as_ref().ok()?;
            let outlier = pool.outliers.iter().find(|one| one.index == place)?;
            let reason = outlier.reason.map(|reason| format!(": {}", reason.words().text(language)));
            Some(format!(
                "  ← {}{}",
                language.pick("far from the others", "lejos de los demás"),
                reason.unwrap_or_default()
            ))
        };
        for (place, (name, (_, measured))) in names.iter().zip(&quantity.results).enumerate() {
            text += &format!("  {name:<width$}  {}{}\n", scaled.text(*measured), outlier(place).unwrap_or_default());
        }
        match &quantity.pool {
            Err(why) => text += &format!("  {}\n", why.text(language)),
            Ok(pool) => text += &pooled_text(pool, &scaled, language),
        }
        text.push('\n');
    }
    text
}

fn pooled_text(pool: &Pool, scaled: &Scaled<'_>, language: Language) -> String {
    let line = |title: &str, pooled: &Pooled| {
        let [low, high] = [pooled.interval.0, pooled.interval.1].map(|end| scaled.number(end));
        let between = language.pick(format!("95 %: {low} to {high}"), format!("95 %: de {low} a {high}"));
        let value = scaled.text(Measured { value: pooled.value, error: pooled.error });
        format!(
            "  {title}, n = {}: {value} ({between})\n    {}\n",
            pooled.count,
            pooled.scatter_text(language, |value| scaled.number(value))
        )
    };
    let mut text = line(language.pick("pooled", "conjunto"), &pool.all);
    if let Some(without) = &pool.without {
        text +=
            &line(language.pick("without those far from the others", "sin los que están lejos de los demás"), without);
    }
    text
}

fn as_csv(quantities: &[Quantity], handed: &[Handed]) -> String {
    let mut text = String::from("theory,quantity,unit,group,value,standard error,far from the others\n");
    for quantity in quantities {
        let scaled = Scaled::new(quantity);
        for (place, (index, measured)) in quantity.results.iter().enumerate() {
            let marked = quantity.pool.as_ref().is_ok_and(|pool| pool.outliers.iter().any(|one| one.index == place));
            // Writing to a string cannot fail.
            for word in [&quantity.theory, &quantity.name, &quantity.unit, sender_name(handed, *index)] {
                let _ = Dialect::Commas.text(&mut text, word);
                text.push(',');
            }
            for number in [measured.value / scaled.scale, measured.error / scaled.scale] {
                let _ = Dialect::Commas.number(&mut text, number);
                text.push(',');
            }
            text += if marked { "1\n" } else { "0\n" };
        }
    }
    text
}

fn as_json(quantities: &[Quantity], handed: &[Handed], language: Language) -> String {
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
        let scale = Scaled::new(quantity).scale;
        let result = |(place, (index, measured)): (usize, &(usize, Measured))| {
            let pool = quantity.pool.as_ref().ok();
            let outlier = pool.and_then(|pool| pool.outliers.iter().find(|one| one.index == place));
            json!({
                "group": sender_name(handed, *index),
                "value": measured.value / scale,
                "standard_error": measured.error / scale,
                "outlier": outlier.is_some(),
                "reason": outlier.and_then(|one| one.reason).map(|reason| reason.words().text(language).to_owned()),
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

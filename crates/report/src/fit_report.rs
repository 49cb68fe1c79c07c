//! A fit as rows and sentences, from which all its printers are fed: text, HTML, workbook, and the page.

use crate::written::{self, of_record, size};
use crate::{Report, doubt, remarks};
use analysis::fit::{Estimate, Interval, Outcome};
use program::Program;
use units::number::{DASH, Style, concise, fixed, near_one, plain, unit_text};
use units::{Language, Unit, say};

/// Rows and sentences about a fit in the language of its report.
#[derive(Clone, Debug)]
pub struct FitReport {
    /// Varied numbers, then quantities derived from them; each first those that hold for all records, then those of each
    /// record.
    pub rows: Vec<FitRow>,
    /// Statistics of the whole fit.
    pub statistics: Vec<Statistic>,
    /// Judgement of the residuals.
    pub verdict: String,
    /// Reasons to doubt the numbers: a search that did not converge, numbers at an end of their range or not determined,
    /// outliers that decided the fit, and another minimum.
    pub warnings: Vec<String>,
    /// Sentences about residuals, search and data that are no warnings.
    pub findings: Vec<String>,
}

/// A varied number or a derived quantity.
#[derive(Clone, Debug)]
pub struct FitRow {
    /// Value and standard errors, SI, with a unit in which they need no power of ten.
    pub estimate: Estimate,
    /// Label; empty if it has none.
    pub label: String,
    /// True for a quantity that is derived from the varied numbers.
    pub is_derived: bool,
    /// Profile intervals of 68 % and 95 %, SI; `None` if none were computed.
    pub intervals: Option<[Interval; 2]>,
    /// Value with the standard error of its last digits in parentheses: `0.387(4)`; a dash if undetermined.
    pub rounded: String,
    /// Why it has no value or no standard error; empty if it has both.
    pub note: &'static str,
}

impl FitRow {
    /// Unit for readers; empty for a number that is not determined.
    pub fn unit_text(&self) -> String {
        if self.estimate.determined { unit_text(&self.estimate.unit.text) } else { String::new() }
    }
}

/// A statistic of a fit.
#[derive(Clone, Debug)]
pub struct Statistic {
    /// Name: `Reduced χ²`.
    pub name: &'static str,
    /// Value in `unit`.
    pub value: f64,
    /// Unit; dimensionless for pure numbers.
    pub unit: Unit,
    /// Value and unit for readers.
    pub text: String,
    /// What it is to be compared with; empty if nothing.
    pub note: String,
}

impl Statistic {
    /// Value, unit and note.
    pub fn full_text(&self) -> String {
        if self.note.is_empty() { self.text.clone() } else { [&self.text, "; ", &self.note].concat() }
    }
}

impl FitReport {
    /// Rows and sentences of a report.
    pub fn new(report: &Report<'_>) -> Self {
        let (outcome, language) = (report.outcome, report.language);
        let rows = rows(report, &outcome.parameters, report.intervals, false)
            .chain(rows(report, &once(&outcome.derived), &[], true))
            .collect();
        Self {
            rows,
            statistics: statistics(outcome, language),
            verdict: outcome.verdict_text(language),
            warnings: warnings(report),
            findings: findings(report),
        }
    }

    /// Rows of the varied numbers.
    pub fn varied(&self) -> impl Iterator<Item = &FitRow> {
        self.rows.iter().filter(|row| !row.is_derived)
    }

    /// Rows of the derived quantities.
    pub fn derived(&self) -> impl Iterator<Item = &FitRow> {
        self.rows.iter().filter(|row| row.is_derived)
    }

    /// All sentences: verdict, warnings, findings.
    pub fn sentences(&self) -> impl Iterator<Item = &String> {
        std::iter::once(&self.verdict).chain(&self.warnings).chain(&self.findings)
    }
}

/// Rows of estimates, first those that hold for all records, then those of each record. `intervals`: one for each estimate,
/// or none.
fn rows(
    report: &Report<'_>,
    estimates: &[Estimate],
    intervals: &[Option<[Interval; 2]>],
    is_derived: bool,
) -> impl Iterator<Item = FitRow> {
    let language = report.language;
    let row = |(place, estimate): (usize, Estimate)| FitRow {
        label: label(&report.document.program, language, &estimate),
        is_derived,
        intervals: intervals.get(place).copied().flatten(),
        rounded: quoted(&estimate, language.style()),
        note: match estimate.stopped_text(language) {
            _ if !estimate.determined => language.say("not determined"),
            stopped => stopped.unwrap_or_default(),
        },
        estimate,
    };
    let mut rows: Vec<FitRow> = readable_units(estimates).into_iter().enumerate().map(row).collect();
    rows.sort_by_key(|row| row.estimate.record.map_or(0, |record| record + 1));
    rows.into_iter()
}

/// Value of an estimate in its unit, rounded by its standard error for correlated residuals, otherwise by the ordinary
/// one. A dash if undetermined.
fn quoted(estimate: &Estimate, style: Style) -> String {
    let value = estimate.unit.from_si(estimate.value);
    if !estimate.determined {
        return DASH.to_owned();
    }
    concise(value, estimate.stderr_hac.or(estimate.stderr).map(|error| size(&estimate.unit, error)), style)
}

/// Estimates with units in which they need no power of ten. All estimates of one quantity get the same unit.
fn readable_units(estimates: &[Estimate]) -> Vec<Estimate> {
    let of_size = |one: &Estimate| {
        let alike = estimates.iter().filter(|other| other.name == one.name && other.determined);
        let sizes = alike.flat_map(|other| [other.value, other.stderr_hac.or(other.stderr).unwrap_or(0.0)]);
        let greatest = sizes.filter(|si| si.is_finite()).fold(0.0_f64, |greatest, si| greatest.max(si.abs()));
        one.unit.for_size(size(&one.unit, greatest).abs())
    };
    estimates.iter().map(|one| Estimate { unit: of_size(one), ..one.clone() }).collect()
}

/// Label of an estimate; empty if it has none.
fn label(program: &Program, language: Language, estimate: &Estimate) -> String {
    if let Some(label) = &estimate.label {
        return program.text(language.tag(), label).to_owned();
    }
    let own = estimate.parameter().is_some();
    match estimate.name.rsplit_once('_') {
        Some((name, "origin")) if !own && name == program.model.independent.name => {
            language.say("Reading of the clock at the start").to_owned()
        }
        Some((_, "offset")) if !own => language.say("Offset of the readings").to_owned(),
        _ => String::new(),
    }
}

/// Derived quantities, with one entry for those that are equal in all records.
fn once(derived: &[Estimate]) -> Vec<Estimate> {
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

fn statistics(outcome: &Outcome, language: Language) -> Vec<Statistic> {
    let style = language.style();
    let number = |name: &'static str, value: f64, text: String| Statistic {
        name,
        value,
        unit: Unit::dimensionless(),
        text,
        note: String::new(),
    };
    let count = |name: &'static str, count: usize| number(name, count as f64, count.to_string());
    let residual = |name: &'static str, si: f64| Statistic {
        name,
        value: size(&outcome.rmse_unit, si),
        unit: outcome.rmse_unit.clone(),
        text: written::difference(si, &outcome.rmse_unit, style),
        note: String::new(),
    };
    let mut all = vec![
        count(language.say("Values"), outcome.n),
        count(language.say("Degrees of freedom"), outcome.dof),
        residual(language.say("RMS residual"), outcome.rmse),
    ];
    all.extend(
        outcome.chi2_reduced.map(|reduced| number(language.say("Reduced χ²"), reduced, plain(reduced, 5, style))),
    );
    all.push(match &outcome.reweighted {
        None => number("R²", outcome.r2, near_one(outcome.r2, style)),
        Some(robust) => residual(language.say("Median scale of residuals"), robust.scale),
    });
    all.extend(outcome.aicc.map(|aicc| number("AICc", aicc, fixed(aicc, 1, style))));
    all.push(number("BIC", outcome.bic, fixed(outcome.bic, 1, style)));
    if let Some(runs) = outcome.runs {
        let expected = fixed(runs.expected, 0, style);
        let z = fixed(runs.z, 1, style);
        all.push(Statistic {
            note: say!(language, "independent residuals would make {expected} ({z} standard deviations)"),
            ..count(language.say("Runs of equal sign"), runs.runs)
        });
    }
    all.push(Statistic {
        note: language.say("2 for independent residuals").to_owned(),
        ..number("Durbin-Watson", outcome.durbin_watson, fixed(outcome.durbin_watson, 2, style))
    });
    let correlation = language.say("Correlation of neighbouring residuals");
    all.push(number(correlation, outcome.autocorrelation, fixed(outcome.autocorrelation, 2, style)));
    all
}

fn warnings(report: &Report<'_>) -> Vec<String> {
    let (outcome, language) = (report.outcome, report.language);
    let mut sentences = Vec::new();
    if !outcome.converged {
        let text = language.say("The fit did not converge: these numbers are the best found so far, not a result.");
        sentences.push(text.to_owned());
    }
    sentences.extend(doubt::doubts(outcome, report.task, report.independent(), language));
    sentences.extend(outcome.undetermined.iter().map(|one| one.text(language)));
    let quantity = |one: &Estimate, si: f64| written::quantity(si, &one.unit, language.style());
    sentences.extend(outcome.rival_text(language, quantity));
    let (_, unit) = report.independent();
    let period = |si: f64| written::quantity(si, unit, language.style());
    sentences.extend(outcome.unexplained_text(language, period));
    sentences
}

fn findings(report: &Report<'_>) -> Vec<String> {
    let (outcome, language, task) = (report.outcome, report.language, report.task);
    let mut sentences = remarks::remarks(outcome, task, report.independent(), language);
    sentences.extend(outcome.search_texts(language));
    for (record, one) in task.records.iter().enumerate() {
        let names = |chosen: &dyn Fn(usize) -> bool| {
            let names = one.observations.iter().enumerate().filter(|(place, _)| chosen(*place));
            let names: Vec<String> = names.map(|(_, one)| one.name.clone()).collect();
            (!names.is_empty()).then(|| language.join(&names))
        };
        let prefix = of_record(Some(record), task);
        for (observation, unit) in &one.assumed {
            let Some(observation) = one.observations.get(*observation) else { continue };
            let (name, declared) = (&observation.name, &observation.observed.unit);
            let mut text = {
                let unit = unit_text(&unit.text);
                say!(language, "The record states no unit of {name}: its numbers are read in {unit}.")
            };
            if unit.to_si(1.0) != declared.to_si(1.0) {
                let declared = unit_text(&declared.text);
                text += &say!(
                    language,
                    " In {declared}, the unit of the theory, they would be out of proportion to its run."
                );
            }
            sentences.push(prefix.clone() + &text);
        }
        if let count @ 1.. = one.excluded_count() {
            let text = say!(language, "Values left out by hand: {count}. They are drawn, and count for nothing.");
            sentences.push(prefix.clone() + &text);
        }
        let fits = || outcome.observations.iter().filter(|fit| fit.record == record);
        if let Some(names) = names(&|place| one.observations[place].errors.is_some()) {
            let text = say!(
                language,
                "The values of {names} are weighted by the standard errors that stand beside them in the record."
            );
            sentences.push(prefix.clone() + &text);
        }
        if let Some(names) = names(&|place| fits().any(|fit| fit.observation == place && fit.derived)) {
            let text = say!(
                language,
                "{names} was computed from another column: it adds no independent information, and is not counted twice."
            );
            sentences.push(prefix.clone() + &text);
        }
        if let Some(origin) = outcome.origins.get(record) {
            let (clock, unit) = report.independent();
            let at = [clock, " = ", &written::quantity(*origin, unit, language.style())].concat();
            let mut text = match report.document.program.model.states.is_empty() {
                true => say!(language, "The clock of the formula was moved: its 0 is at {at}."),
                false => say!(language, "The initial values refer to {at}."),
            };
            let early: usize = fits().map(|fit| fit.early).sum();
            if early > 0 {
                text += &say!(language, " Nothing is predicted of the {early} values before.");
            }
            sentences.push(prefix + &text);
        }
    }
    sentences
}

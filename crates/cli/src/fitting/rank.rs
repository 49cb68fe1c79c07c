//! `meniscus rank`: several theories of the same data, best first.

use super::arguments::{Form, Rank as Arguments};
use super::carrying::carrying;
use super::fit::{FileKind, kind, notes, read, with_font};
use super::theory;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::fit::{Outcome, Ranked, rank as order, worth};
use report::{FitReport, Ranking, Report};
use runner::fitting::{Columns, Contender, FitSettings, Fitted, Theory, ranking_as_json, tied};
use std::fmt::Write;
use units::Unit;
use units::number::{Group, Style, plain};

/// Fits all theories and prints them, best first.
pub fn rank(arguments: &Arguments, terminal: Terminal) -> Result<(), Failure> {
    if arguments.models.len() < 2 {
        return Err(Failure::with_hint("there is only one theory", "name another one with --model DOC"));
    }
    let kind = arguments.output.as_deref().map(kind).transpose()?;
    if kind == Some(FileKind::Svg) {
        return Err(Failure::with_hint("a ranking is no figure", "end --output in .html, .xlsx or .csv"));
    }
    let mut theories: Vec<Theory> =
        arguments.models.iter().map(|path| theory::theory(path, terminal)).collect::<Result<_, _>>()?;
    let data = read(&arguments.data, &arguments.common, &mut theories, terminal)?;
    if arguments.common.format == Form::Text {
        // The table of theories does not contain these findings.
        for finding in data.iter().flat_map(|one| &one.findings) {
            terminal.note(finding);
        }
    }
    let settings = FitSettings::from(&arguments.common);
    let contend = |theory: Theory| {
        let progress = theory::progress(&theory.document.program.title);
        let asked = (&settings, arguments.predict_from.as_deref());
        let mut shown = |trials| {
            progress.set_position(trials as u64);
            true
        };
        let contender = Contender::complete(theory, &data, asked, &mut theory::note(terminal), &mut shown);
        progress.finish_and_clear();
        contender
    };
    let contenders: Vec<Contender> = theories.into_iter().map(contend).collect::<Result<_, _>>()?;
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let ranked = order(&outcomes);
    if let (Some(path), Some(kind)) = (&arguments.output, kind) {
        let notes: Vec<Vec<Vec<String>>> = contenders.iter().map(|one| notes(&data, &one.fitted.theory)).collect();
        let reports: Vec<Report> =
            contenders.iter().zip(&notes).map(|(one, notes)| one.fitted.report(notes, "")).collect();
        let command = crate::command::typed();
        let ranking = Ranking { theories: &reports, command: &command };
        let bytes = match kind {
            FileKind::Xlsx => report::ranking_workbook(&ranking),
            FileKind::Csv => report::ranking_csv(&ranking, false).into_bytes(),
            FileKind::Html | FileKind::Svg => {
                let fitted: Vec<&Fitted> = contenders.iter().map(|one| &one.fitted).collect();
                carrying(&with_font(&report::ranking_html(&ranking)), &fitted, &data, &arguments.common).into_bytes()
            }
        };
        output::file(path, &arguments.data, &bytes)?;
    }
    output::print(&match arguments.common.format {
        Form::Text => table(&contenders, &ranked, arguments),
        Form::Json => format!("{:#}\n", ranking_as_json(&contenders, &ranked, &data)),
    })
}

/// Number of parameters that the data determined: values minus degrees of freedom.
fn numbers(fitted: &Fitted) -> usize {
    fitted.outcome.n.saturating_sub(fitted.outcome.dof)
}

/// Common number format of the residuals of all theories.
fn residuals(contenders: &[Contender]) -> Group {
    let outcomes = || contenders.iter().map(|one| &one.fitted.outcome);
    let parts = contenders.iter().filter_map(|one| one.parts.as_ref()).flatten().filter(|part| part.n > 0);
    let sizes: Vec<f64> = outcomes().map(|outcome| outcome.rmse).chain(parts.map(|part| part.rmse)).collect();
    let unit = outcomes().find_map(|outcome| outcome.observations.first()).map(|one| one.unit.clone());
    Group::of_residuals(&unit.unwrap_or_else(Unit::dimensionless), &sizes, 3, Style::POINT)
}

fn table(contenders: &[Contender], ranked: &[Ranked], arguments: &Arguments) -> String {
    let mut columns = Columns::default();
    let predicts = contenders.iter().any(|one| one.parts.is_some());
    let moment = arguments.predict_from.as_deref().unwrap_or_default();
    let (before, after) = (format!("before {moment}"), format!("after {moment}"));
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<String>>();
    let mut head = words(&["", "theory", "numbers", "ΔAICc", "weight", "RMSE"]);
    if predicts {
        head.extend([before, after, "predicted".to_owned()]);
    }
    columns.push(head);
    let residuals = residuals(contenders);
    for ranked in ranked {
        let one = &contenders[ranked.index];
        let mut row = vec![
            format!("{}.", ranked.place),
            one.fitted.theory.document.program.title.clone(),
            numbers(&one.fitted).to_string(),
            if ranked.difference.is_finite() { format!("{:.1}", ranked.difference) } else { "–".to_owned() },
            if ranked.weight < 1e-3 { "< 0.001".to_owned() } else { format!("{:.3}", ranked.weight) },
            residuals.quantity(one.fitted.outcome.rmse),
        ];
        if let Some(parts) = one.parts {
            row.extend(parts.map(|part| if part.n > 0 { residuals.quantity(part.rmse) } else { "–".to_owned() }));
        }
        columns.push(row);
    }
    let mut text = columns.text(&[false, false, true, true, true, true, true, true, true]);
    for (_, sentence) in tied(contenders, ranked) {
        let _ = writeln!(text, "\n{sentence}");
    }
    let reports: Vec<FitReport> = contenders.iter().map(|one| one.fitted.fit_report()).collect();
    if let Some(first) = ranked.first() {
        let (best, report) = (&contenders[first.index].fitted.outcome, &reports[first.index]);
        let _ = writeln!(text, "\nOf the best: {}", report.verdict);
        let worth = worth(best);
        if worth < 0.8 {
            let _ = writeln!(
                text,
                "The residuals are autocorrelated: {} values are worth about {:.0} independent ones. ΔAICc and the weights \
                 count each value {} times, and the prediction is the better judge.",
                best.n,
                best.independent,
                plain(worth, 2, Style::POINT)
            );
        }
        for finding in &report.findings {
            let _ = writeln!(text, "{finding}");
        }
    }
    for (one, report) in contenders.iter().zip(&reports) {
        for warning in &report.warnings {
            let _ = writeln!(text, "{}: {warning}", one.fitted.theory.document.program.title);
        }
    }
    text
}

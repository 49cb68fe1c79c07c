//! Comparison of several theories of the same data.

use crate::findings;
use crate::markup::{self, Page, cell, escaped};
use crate::{FitReport, Report, drawing, page, results, written};
use analysis::csv::{self, Dialect};
use analysis::fit::{ObservationFit, Outcome, Ranked, Verdict, rank, ties, worth};
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use units::Language;
use units::number::{Group, fixed, plain};

/// Fits of several theories to the same data.
#[derive(Clone, Copy, Debug)]
pub struct Ranking<'a> {
    /// One finished fit per theory, in any order. Language, version and date are those of the first.
    pub theories: &'a [Report<'a>],
    /// Command that repeats the comparison; may be empty.
    pub command: &'a str,
}

/// Difference of AICc below which theories are equally good. `RULED_OUT`: difference from which a theory is ruled out
/// (Burnham & Anderson, Model Selection, 2002, section 2.6).
const ALIKE: f64 = 2.0;
const RULED_OUT: f64 = 10.0;

/// Row of a theory.
struct Row<'a> {
    report: &'a Report<'a>,
    ranked: Ranked,
    title: &'a str,
    /// Number of parameters that the data determined.
    numbers: usize,
    /// Root mean square of the predicted values of the first observation over all records, SI; `None` if all values were
    /// fitted.
    predicted: Option<f64>,
}

impl<'a> Ranking<'a> {
    fn language(&self) -> Language {
        self.theories.first().map_or(Language::English, |report| report.language)
    }

    /// The rows, best theory first.
    fn rows(&self) -> Vec<Row<'a>> {
        let tag = self.language().tag();
        let outcomes: Vec<&Outcome> = self.theories.iter().map(|report| report.outcome).collect();
        let row = |ranked: Ranked| {
            let report = self.theories.get(ranked.index)?;
            Some(Row {
                report,
                ranked,
                title: &report.document.program.edition(tag).title,
                numbers: report.outcome.n.saturating_sub(report.outcome.dof),
                predicted: report.outcome.predicted(),
            })
        };
        rank(&outcomes).into_iter().filter_map(row).collect()
    }

    /// One sentence per place that several theories share.
    fn ties(&self) -> Vec<(usize, String)> {
        let tag = self.language().tag();
        let outcomes: Vec<&Outcome> = self.theories.iter().map(|report| report.outcome).collect();
        let title = |index: usize| self.theories[index].document.program.edition(tag).title.clone();
        ties(&rank(&outcomes), &outcomes, self.language(), title)
    }

    /// Number of independent values per measured value, from 0 to 1, by the residuals of the best theory.
    fn worth(rows: &[Row<'_>]) -> f64 {
        rows.first().map_or(1.0, |row| worth(row.report.outcome))
    }
}

/// The comparison as one self-contained HTML page.
pub fn ranking_html(ranking: &Ranking<'_>) -> String {
    let language = ranking.language();
    let rows = ranking.rows();
    let title = language.say("Which theory do the data favour?");
    let mut page = Page::default();
    let first = ranking.theories.first();
    let (version, date) = first.map_or(("", ""), |report| (report.version, report.date));
    page.raw("<header>\n");
    page.element("p class=\"kicker\"", language.say("Comparison of theories"));
    page.element("h1", title);
    let names: Vec<String> =
        first.map_or_else(Vec::new, |report| report.task.records.iter().map(|record| record.name.clone()).collect());
    let mut meta = language.join(&names);
    if !date.is_empty() {
        meta.extend([" · ", date]);
    }
    page.element("p class=\"meta\"", &meta);
    page.raw("</header>\n");
    judgement(&mut page, language, &rows);
    ranking.ties().iter().for_each(|(_, sentence)| page.element("p", sentence));
    table(&mut page, language, &rows);
    caution(&mut page, language, &rows);
    residuals(&mut page, language, &rows);
    page.heading(language.say("What each theory finds"));
    for row in &rows {
        page.element("h3", row.title);
        let fit = FitReport::new(row.report);
        results::estimates(&mut page, row.report, fit.varied(), !row.report.intervals.is_empty());
        findings::warnings(&mut page, &fit);
    }
    if !ranking.command.is_empty() {
        page.heading(language.say("To repeat this"));
        page.wrapped("pre tabindex=\"0\"", &escaped(ranking.command));
    }
    page::footer(&mut page, language, version, date);
    markup::document(title, language.tag(), version, &page.out)
}

/// Adds the conclusion: the favoured theory, those that are equally good, those that are ruled out, and a theory that
/// predicts better.
fn judgement(page: &mut Page, language: Language, rows: &[Row<'_>]) {
    let Some(best) = rows.first().filter(|row| row.ranked.difference == 0.0) else {
        return;
    };
    let quoted = |row: &Row<'_>| {
        let [open, close] = language.say_all(["“", "”"]);
        [open, row.title, close].concat()
    };
    let apart = |from: f64, to: f64| rows.iter().skip(1).filter(move |row| (from..to).contains(&row.ranked.difference));
    let favoured = match best.predicted {
        Some(_) => language.say("By AICc the data favour "),
        None => language.say("The data favour "),
    };
    let mut text = [favoured, &quoted(best), "."].concat();
    let alike: Vec<String> = apart(0.0, ALIKE).map(quoted).collect();
    if !alike.is_empty() {
        let start = language.say(" They cannot tell it from ");
        text.extend([start, &language.join(&alike), "."]);
    }
    // A theory that predicts better is not ruled out.
    let better = |row: &&Row<'_>| row.predicted.zip(best.predicted).is_some_and(|(own, of_best)| own < of_best);
    let out: Vec<String> = apart(RULED_OUT, f64::MAX).filter(|row| !better(row)).map(quoted).collect();
    if !out.is_empty() {
        text.extend([language.say(" They rule out "), &language.join(&out), "."]);
    }
    let predictor = rows.iter().filter(better).min_by(|one, other| {
        one.predicted.unwrap_or(f64::INFINITY).total_cmp(&other.predicted.unwrap_or(f64::INFINITY))
    });
    match (predictor, best.predicted) {
        (Some(predictor), Some(of_best)) => {
            let sizes = [predictor.predicted.unwrap_or(f64::NAN), of_best];
            let group = Group::of_residuals(&best.report.outcome.rmse_unit, &sizes, 3, language.style());
            text.extend([
                language.say(" But "),
                &quoted(predictor),
                language.say(" predicts the later values better, with an error of "),
                &group.quantity(sizes[0]),
                language.say(" against "),
                &group.quantity(sizes[1]),
                language.say(". The prediction is the better judge: a flexible curve can fit well and predict badly."),
            ]);
        }
        (None, Some(_)) => {
            text.push_str(language.say(" It also predicts the later values best."));
        }
        _ => {}
    }
    let warns = findings::warns(best.report.outcome);
    let class = if warns || predictor.is_some() { "p class=\"verdict warn\"" } else { "p class=\"verdict\"" };
    page.element(class, &text);
    if warns {
        let text = match best.report.outcome.verdict() {
            Verdict::Structured | Verdict::Alternating => language
                .say(
                    "Even the best one leaves residuals that do not look random: none of these theories is the whole truth.",
                )
                .to_owned(),
            _ => best.report.outcome.verdict_text(language),
        };
        page.element("p", &text);
    }
}

fn table(page: &mut Page, language: Language, rows: &[Row<'_>]) {
    let style = language.style();
    let predicts = rows.iter().any(|row| row.predicted.is_some());
    let mut headings = vec![
        language.say("Theory"),
        language.say("#Free numbers"),
        language.say("#RMS residual"),
        "#ΔAICc",
        language.say("#Evidence"),
        "#Durbin-Watson",
    ];
    if predicts {
        headings.insert(3, language.say("#Predicted"));
    }
    page.table("wide theories", &headings);
    let Some(unit) = rows.first().map(|row| &row.report.outcome.rmse_unit) else {
        return page.end_table();
    };
    let sizes: Vec<f64> =
        rows.iter().flat_map(|row| [Some(row.report.outcome.rmse), row.predicted]).flatten().collect();
    let residuals = Group::of_residuals(unit, &sizes, 3, style);
    for row in rows {
        let outcome = row.report.outcome;
        let share = row.ranked.weight;
        let share = if share > 0.0 && share < 0.001 {
            ["< ", &fixed(0.1, 1, style), " %"].concat()
        } else {
            [&fixed(100.0 * share, 1, style), " %"].concat()
        };
        let mut cells = vec![
            escaped(row.title),
            cell(&row.numbers.to_string()),
            cell(&residuals.quantity(outcome.rmse)),
            cell(&fixed(row.ranked.difference, 1, style)),
            cell(&share),
            cell(&fixed(outcome.durbin_watson, 2, style)),
        ];
        if predicts {
            cells.insert(3, cell(&row.predicted.map_or_else(String::new, |rmse| residuals.quantity(rmse))));
        }
        let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
        page.row_of(if row.ranked.difference == 0.0 { "best" } else { "" }, &cells);
    }
    page.end_table();
}

/// Adds the explanation of AICc and the effect of correlated residuals on the comparison.
fn caution(page: &mut Page, language: Language, rows: &[Row<'_>]) {
    let mut text = language
        .say(
            "AICc weighs how well a theory fits against how many numbers it needs; a difference of 2 is nothing, one of 10 is much.",
        )
        .to_owned();
    let worth = Ranking::worth(rows);
    if let Some(best) = rows.first().filter(|_| worth < 0.8) {
        let n = best.report.outcome.n;
        let count = plain(best.report.outcome.independent.round(), 6, language.style());
        text.extend([
            language.say(" It supposes independent residuals. These are autocorrelated: the "),
            &n.to_string(),
            language.say(" values are worth about "),
            &count,
            language.say(" independent ones. The differences and the evidence count them in that proportion."),
        ]);
    }
    page.element("p class=\"note\"", &text);
}

/// Adds the residuals of all theories. Those of one record share one scale.
fn residuals(page: &mut Page, language: Language, rows: &[Row<'_>]) {
    page.heading(language.say("What they leave over"));
    let records = rows.iter().map(|row| row.report.task.records.len()).max().unwrap_or(0);
    let mut beyond = false;
    for record in 0..records {
        let of = |row: &Row<'_>| {
            row.report.outcome.observations.iter().position(|fit| fit.record == record && fit.observation == 0)
        };
        let fits: Vec<(&Row<'_>, &ObservationFit)> =
            rows.iter().filter_map(|row| Some((row, row.report.outcome.observations.get(of(row)?)?))).collect();
        let reach = fits.iter().map(|(_, fit)| 1.05 * drawing::telling(fit)).fold(0.0, f64::max);
        beyond |= fits.iter().any(|(_, fit)| drawing::greatest(fit) > reach);
        let last = record + 1 == records;
        if let Some((row, fit)) = fits.first().filter(|_| records > 1) {
            page.element("h3", findings::record(row.report, fit));
        }
        page.raw(if records > 1 { "<figure class=\"small\">\n" } else { "<figure>\n" });
        let width = if records > 1 { drawing::HALF } else { drawing::WIDTH };
        for (row, fit) in fits {
            page.raw(&drawing::residuals(row.report, fit, row.title, reach, width));
        }
        if last {
            let caption = if records > 1 {
                language.say("Measured minus fitted, those of one record on one scale.")
            } else {
                language.say("Measured minus fitted, all on one scale.")
            };
            let rest = language.say(" What lies beyond it is not drawn.");
            page.element("figcaption", &[caption, if beyond { rest } else { "" }].concat());
        }
        page.raw("</figure>\n");
    }
}

/// The table of theories with its header row.
fn numbers(ranking: &Ranking<'_>) -> Vec<Vec<Cell>> {
    let language = ranking.language();
    let rows = ranking.rows();
    let unit = rows.first().map_or("", |row| row.report.outcome.rmse_unit.text.as_str());
    let with = |name: &str| if unit.is_empty() { name.to_owned() } else { [name, " [", unit, "]"].concat() };
    let headings = vec![
        language.say("Theory").to_owned(),
        language.say("File").to_owned(),
        language.say("Free numbers").to_owned(),
        with(language.say("Root mean square residual")),
        with(language.say("Root mean square predicted")),
        "AICc".to_owned(),
        "ΔAICc".to_owned(),
        language.say("Share of the evidence").to_owned(),
        "BIC".to_owned(),
        "R²".to_owned(),
        "Durbin-Watson".to_owned(),
        language.say("Place").to_owned(),
    ];
    let own = |row: &Row<'_>| {
        let outcome = row.report.outcome;
        let size = |si: f64| Cell::Number(written::size(&outcome.rmse_unit, si));
        vec![
            row.title.into(),
            row.report.document_name.into(),
            Cell::Number(row.numbers as f64),
            size(outcome.rmse),
            row.predicted.map_or(Cell::Empty, size),
            outcome.aicc.map_or(Cell::Empty, Cell::Number),
            Cell::Number(row.ranked.difference),
            Cell::Number(row.ranked.weight),
            Cell::Number(outcome.bic),
            if outcome.reweighted.is_none() { Cell::Number(outcome.r2) } else { Cell::Empty },
            Cell::Number(outcome.durbin_watson),
            Cell::Number(row.ranked.place as f64),
        ]
    };
    let mut table = vec![headings.into_iter().map(Cell::from).collect()];
    table.extend(rows.iter().map(own));
    table
}

/// The comparison as a workbook: the table of theories on the first sheet, and the results of each theory on its own
/// sheet.
pub fn ranking_workbook(ranking: &Ranking<'_>) -> Vec<u8> {
    let language = ranking.language();
    let rows = numbers(ranking);
    let mut sheets = vec![Sheet { name: language.say("Theories").to_owned(), rows, header: true }];
    for row in ranking.rows() {
        let mut results = crate::export::results(row.report);
        results.name = row.title.to_owned();
        sheets.push(results);
    }
    Workbook { sheets }.xlsx()
}

/// The table of theories as CSV. Titles are in the first column, in quotation marks.
pub fn ranking_csv(ranking: &Ranking<'_>, decimal_comma: bool) -> String {
    let rows = numbers(ranking);
    let dialect = if decimal_comma { Dialect::Semicolons } else { Dialect::Commas };
    csv::write_rows(&rows, dialect)
}

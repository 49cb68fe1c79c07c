//! Fits, and their results.

use super::lanes::lanes;
use super::task::FitTask;
use crate::opening::Sources;
use crate::refusal::Refusal;
use analysis::fit::{Fit, FitError, Interval, Loss, Outcome, Scan, Task, Trace, profiles};
use document::Document;
use report::{FitReport, Report};
use units::Language;
use units::number::{Style, plain};

/// Relative difference of sums of squares below which two fits have ended at the same minimum.
const SAME_END: f64 = 1e-6;
/// Number of points of a drawn curve.
const POINTS: usize = 600;

/// A document used as a theory.
#[derive(Clone, Debug)]
pub struct Theory {
    /// Source files.
    pub sources: Sources,
    /// The document.
    pub document: Document,
}

/// A fitted theory.
#[derive(Debug)]
pub struct Fitted {
    /// The theory.
    pub theory: Theory,
    /// The task of the fit.
    pub task: Task,
    /// The result of the fit.
    pub outcome: Outcome,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    /// Profile intervals at 68 % and 95 %, one pair per varied parameter; empty without `--profile`.
    pub intervals: Vec<Option<[Interval; 2]>>,
}

impl Fitted {
    /// Runs a fit to its end, from each of its starts, and takes the best one. `progress` gets the number of trials after
    /// each, and ends the fit if it returns false.
    ///
    /// # Errors
    /// A task that cannot be fitted, a model without a finite curve, or a fit that `progress` has ended.
    pub fn complete(
        theory: Theory,
        FitTask { task, starts }: FitTask,
        with_profiles: bool,
        progress: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Self, Refusal> {
        let mut best: Option<(f64, Fit, Outcome, Task)> = None;
        let (mut ends, mut before, mut gave_up) = (Vec::new(), 0, false);
        for number in 0..starts.count() {
            let mut task = task.clone();
            for (place, start) in starts.combination(number) {
                task.varied[place].start = Some(start);
            }
            let mut fit = Fit::new(&theory.document.program.model, task.clone())
                .map_err(|error| refused(&theory, &task, &error))?;
            if with_profiles || task.records.len() > 1 {
                fit.use_lanes(lanes);
            }
            while !fit.advance() {
                if !progress(before + fit.trials()) {
                    return Err(Refusal::with_hint(
                        "the fit was ended before it was complete",
                        "vary fewer parameters, give fewer starts, or fit a shorter part of the record",
                    ));
                }
            }
            before += fit.trials();
            gave_up |= fit.gave_up();
            let Some(outcome) = fit.outcome() else { continue };
            let end = if task.loss == Loss::Squares { outcome.chi2 } else { outcome.bic };
            ends.push(end);
            if best.as_ref().is_none_or(|(least, ..)| end < *least) {
                best = Some((end, fit, outcome, task));
            }
        }
        let Some((least, mut fit, mut outcome, task)) = best else {
            return Err(match gave_up {
                true => Refusal::with_hint(
                    "the model needs too many steps of the integration wherever it was tried",
                    "give values from which it runs with --start NAME=VALUE, narrower ranges with --bounds NAME=LO..HI, or fit a shorter part of the record",
                ),
                false => Refusal::with_hint(
                    "the model has no finite curve anywhere it was tried",
                    "give values from which it runs with --start NAME=VALUE, and ranges with --bounds NAME=LO..HI",
                ),
            });
        };
        if starts.count() > 1 {
            let near = |end: &&f64| (**end - least).abs() <= SAME_END * least.abs().max(f64::MIN_POSITIVE);
            outcome.scan = Some(Scan { starts: starts.count(), ended: ends.iter().filter(near).count() });
        }
        let intervals = if with_profiles { profiles(&mut fit, &mut outcome) } else { Vec::new() };
        let traces = fit.traces(POINTS);
        Ok(Self { theory, task, outcome, traces, intervals })
    }

    /// The result as rows and sentences in English.
    pub fn fit_report(&self) -> FitReport {
        FitReport::new(&Report { language: Language::English, ..self.report(&[], "") })
    }

    /// The fit as input of a report.
    pub fn report<'a>(&'a self, notes: &'a [Vec<String>], command: &'a str) -> Report<'a> {
        let name = self.theory.sources.path().file_name().and_then(|name| name.to_str());
        Report {
            document: &self.theory.document,
            document_name: name.unwrap_or("the document"),
            language: Language::of(&self.theory.document.program.language),
            task: &self.task,
            outcome: &self.outcome,
            traces: &self.traces,
            intervals: &self.intervals,
            notes,
            films: &[],
            command,
            version: program::VERSION_AND_BITS,
            date: "",
        }
    }
}

fn refused(theory: &Theory, task: &Task, error: &FitError) -> Refusal {
    let model = &theory.document.program.model;
    let named = |place: usize| match task.varied.get(place).map(|varied| varied.target) {
        Some(analysis::fit::Target::Parameter(index)) => model.parameters[index].name.clone(),
        _ => "it".to_owned(),
    };
    let of_record = match error {
        FitError::RecordEmpty(record) | FitError::BadErrors { record, .. } => task.records.get(*record),
        _ => None,
    };
    let of_record = of_record.map(|record| format!("{}: ", record.name)).unwrap_or_default();
    let message = format!("{}: {of_record}{error}", theory.sources.path().display());
    match error {
        FitError::VariedTwice(place) => {
            Refusal::with_hint(message, format!("name {} once, in --vary or in --fix", named(*place)))
        }
        FitError::TooFew { .. } => Refusal::with_hint(message, "vary less, or fit a longer part of the record"),
        FitError::BadErrors { first, .. } => {
            let clock = &model.independent;
            let first =
                format!("{} = {} {}", clock.name, plain(clock.unit.from_si(*first), 6, Style::POINT), clock.unit);
            Refusal::with_hint(
                message,
                format!("the first is at {}; correct its error, or leave the row out of the file", first.trim()),
            )
        }
        FitError::NothingObserved | FitError::RecordEmpty(_) => {
            Refusal::with_hint(message, "look at --from and --until, and at the column")
        }
        _ => Refusal::request(message),
    }
}

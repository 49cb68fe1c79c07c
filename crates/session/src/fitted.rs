//! What has come of fits: kept side by side, ranked, written into the sliders.

use crate::fitting::Job;
use crate::{Announcement, Session, number};
use analysis::fit::{Estimate, Outcome, Task, Trace};
use document::Document;
use engine::Setup;
use units::Unit;

/// How many fits are kept.
pub const MOST_FITS: usize = 40;

/// A finished fit.
#[derive(Debug)]
pub(crate) struct Fitted {
    pub id: u32,
    /// The file of its theory; empty for the document that was open.
    pub file: String,
    /// The theory.
    pub document: Document,
    /// What was asked for.
    pub task: Task,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    pub record: u32,
    pub record_name: String,
    /// What was fitted of it: fits of different values cannot be ranked together.
    window: [Option<f64>; 2],
    columns: Vec<String>,
    pub outcome: Outcome,
}

/// A fit in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct FitView {
    /// Names it as long as it exists.
    pub id: u32,
    /// The file of its theory; empty for one that was open.
    pub file: String,
    /// The title of its theory.
    pub theory: String,
    /// The record's name.
    pub record: String,
    /// The number of values, and of numbers varied.
    pub counts: (usize, usize),
    /// The root of the mean square of the residuals, with its unit.
    pub rmse: String,
    /// The same outside the fitted part; empty where everything was fitted.
    pub predicted: String,
    /// By how much its AICc exceeds that of the best fit of the same values; a dash where there is none.
    pub difference: String,
    /// The weight of evidence among those, in per cent.
    pub weight: String,
    /// Whether its parameters are those of the document that is open.
    pub applicable: bool,
}

/// A number that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateView {
    /// Its name in the document.
    pub name: String,
    /// What it is called.
    pub label: String,
    /// `0.387 ± 0.004`, rounded as the uncertainty asks.
    pub value: String,
    /// Its unit.
    pub unit: String,
    /// What is to be said of it.
    pub remark: String,
    /// Whether it follows from what was varied.
    pub derived: bool,
}

/// A fit in detail.
#[derive(Clone, Debug, PartialEq)]
pub struct FitDetail {
    /// The title of its theory.
    pub theory: String,
    /// What was varied, and what follows from it.
    pub estimates: Vec<EstimateView>,
    /// What the residuals say, and what the data do not determine, in sentences.
    pub sentences: Vec<String>,
    /// Names and values of what else is known of it: R², Durbin-Watson and so on.
    pub statistics: Vec<(&'static str, String)>,
}

impl Session {
    pub(crate) fn take_outcome(&mut self, job: Job, task: Task, outcome: Outcome, traces: Vec<Trace>) {
        let id = self.fits.finished.iter().map(|fit| fit.id + 1).max().unwrap_or(0);
        let name = self.record(job.record).map(|record| record.name.clone()).unwrap_or_default();
        if self.fits.finished.len() >= MOST_FITS {
            self.fits.finished.remove(0);
        }
        let fitted = Fitted {
            id,
            file: job.file,
            document: job.document,
            task,
            traces,
            record: job.record,
            record_name: name,
            window: self.fits.window,
            columns: outcome.observations.iter().map(|one| one.name.clone()).collect(),
            outcome,
        };
        // The same theory of the same values with the same numbers varied replaces the earlier fit.
        self.fits.finished.retain(|fit| !fit.is_same(&fitted));
        self.fits.finished.push(fitted);
        if job.own {
            self.apply_fit(id);
        }
    }

    /// The finished fits: those of the same values together, the best of them first.
    pub fn fits(&self) -> Vec<FitView> {
        let mut groups: Vec<Vec<&Fitted>> = Vec::new();
        for fit in &self.fits.finished {
            match groups.iter_mut().find(|group| group.first().is_some_and(|one| one.same_values(fit))) {
                Some(group) => group.push(fit),
                None => groups.push(vec![fit]),
            }
        }
        groups.iter().flat_map(|group| self.ranked(group)).collect()
    }

    fn ranked(&self, group: &[&Fitted]) -> Vec<FitView> {
        let criteria: Vec<Option<f64>> = group.iter().map(|fit| fit.outcome.aicc).collect();
        let known = |value: f64, digits: usize| {
            if value.is_finite() { number::fixed(value, digits, self.style) } else { number::DASH.to_owned() }
        };
        let unit = fine_unit(group);
        let unit = &unit;
        let view = |place: analysis::fit::Ranked| {
            let fit = group.get(place.index)?;
            let outcome = &fit.outcome;
            let size = |value: f64| self.with_unit(number::plain(unit.from_si(value), 3, self.style), unit);
            let outside = outcome.observations.first().and_then(|one| one.outside);
            Some(FitView {
                id: fit.id,
                file: fit.file.clone(),
                theory: self.title_of(fit),
                record: fit.record_name.clone(),
                counts: (outcome.n, outcome.parameters.len()),
                rmse: size(outcome.rmse),
                predicted: outside.map(|outside| size(outside.rmse)).unwrap_or_default(),
                difference: known(place.difference, 1),
                weight: if group.len() > 1 { format!("{} %", known(100.0 * place.weight, 1)) } else { String::new() },
                applicable: self.is_applicable(fit),
            })
        };
        analysis::fit::rank(&criteria).into_iter().filter_map(view).collect()
    }

    fn title_of(&self, fit: &Fitted) -> String {
        fit.document.edition(&self.language).title.clone()
    }

    fn is_applicable(&self, fit: &Fitted) -> bool {
        fit.document.title == self.document.title
            && fit.outcome.settings.first().is_some_and(|all| all.len() == self.model().parameters.len())
    }

    /// A fit in detail.
    pub fn fit_detail(&self, id: u32) -> Option<FitDetail> {
        let fit = self.fits.finished.iter().find(|fit| fit.id == id)?;
        let outcome = &fit.outcome;
        let truth = self.record(fit.record).and_then(|record| record.truth.as_deref());
        let (varied, derived) = (outcome.parameters.iter(), outcome.derived.iter());
        let estimates = varied.map(|one| (one, false)).chain(derived.map(|one| (one, true)));
        let plain = |value: f64, digits: usize| number::plain(value, digits, self.style);
        let spanish = self.tongue == crate::Tongue::Spanish;
        let mut sentences = vec![outcome.verdict_text(spanish)];
        sentences.extend(outcome.undetermined.iter().map(|one| one.text(spanish)));
        if !outcome.converged {
            sentences.push(self.tongue.not_converged().to_owned());
        }
        Some(FitDetail {
            theory: self.title_of(fit),
            estimates: estimates.map(|(one, derived)| self.estimate_view(fit, one, derived, truth)).collect(),
            sentences,
            statistics: vec![
                ("R²", plain(outcome.r2, 6)),
                ("AICc", outcome.aicc.map_or_else(|| number::DASH.to_owned(), |value| plain(value, 6))),
                ("BIC", plain(outcome.bic, 6)),
                ("Durbin-Watson", plain(outcome.durbin_watson, 3)),
            ],
        })
    }

    fn estimate_view(
        &self,
        fit: &Fitted,
        one: &Estimate,
        derived: bool,
        truth: Option<&[(String, f64)]>,
    ) -> EstimateView {
        // The robust error, where there is one: residuals of films know of each other.
        let error = one.stderr_hac.or(one.stderr);
        let (value, spread) = (one.unit.from_si(one.value), error.map(|error| one.unit.from_si(error).abs()));
        let known = truth.and_then(|truth| truth.iter().find(|(name, _)| *name == one.name));
        let remark = if !one.determined {
            self.tongue.undetermined().to_owned()
        } else if one.at_bound {
            self.tongue.at_bound().to_owned()
        } else if let Some((_, value)) = known {
            let off = error.filter(|error| *error > 0.0).map(|error| (one.value - value) / error);
            let truth = self.quantity_text(*value, &one.unit);
            self.tongue.truth_is(&truth, off.map(|off| number::fixed(off, 1, self.style)).as_deref())
        } else {
            String::new()
        };
        let label = one.label.as_ref().map(|label| fit.document.text(&self.language, label).to_owned());
        EstimateView {
            name: one.name.clone(),
            label: label.unwrap_or_else(|| crate::symbol(&one.name)),
            value: if one.determined { number::uncertain(value, spread, self.style) } else { number::DASH.to_owned() },
            unit: number::unit_text(&one.unit.text),
            remark,
            derived,
        }
    }

    /// Writes what a fit has found into the sliders and runs through the record.
    pub fn apply_fit(&mut self, id: u32) {
        let Some(fit) = self.fits.finished.iter().find(|fit| fit.id == id && self.is_applicable(fit)) else { return };
        let Some(parameters) = fit.outcome.settings.first().cloned() else { return };
        let found = |ending: &str| {
            fit.outcome
                .parameters
                .iter()
                .find(|one| one.parameter.is_none() && one.name.ends_with(ending))
                .map(|one| one.value)
        };
        let (origin, offset, record) = (found("_origin"), found("_offset"), fit.record);
        let followed = fit.columns.first().cloned();
        let last = fit.outcome.observations.first().and_then(|one| one.times.last().copied()).unwrap_or_default();
        if let Some(record) = self.data.records.iter_mut().find(|one| one.id == record) {
            record.origin = origin;
            for used in &mut record.uses {
                let is = used.fitted && Some(&used.meaning.quantity) == followed.as_ref();
                used.offset = offset.filter(|_| is).unwrap_or(0.0);
            }
        }
        self.records_changed();
        let name = self.model().independent.name.clone();
        let autonomous = self.model().is_autonomous();
        let begins = self.record(record).map_or(0.0, |record| record.origin(&name, autonomous));
        self.playing = false;
        let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
        self.restart(setup);
        self.clear_ghost();
        self.run_through(last - begins);
        self.announce(Announcement::FitApplied);
    }

    /// Forgets a fit.
    pub fn remove_fit(&mut self, id: u32) {
        self.fits.finished.retain(|fit| fit.id != id);
        self.revision.fits += 1;
    }
}

/// The unit for residuals: its thousandth where they are small, so that nobody has to count zeros.
fn fine_unit(group: &[&Fitted]) -> Unit {
    let unit = group.first().map_or_else(Unit::dimensionless, |fit| fit.outcome.rmse_unit.clone());
    let least = group.iter().map(|fit| unit.from_si(fit.outcome.rmse)).fold(f64::INFINITY, f64::min);
    let thousandth = Unit::parse(&format!("m{}", unit.text)).ok().filter(|fine| fine.dimension == unit.dimension);
    thousandth.filter(|_| least < 0.01).unwrap_or(unit)
}

impl Fitted {
    fn is_same(&self, other: &Self) -> bool {
        let varied = |fit: &Self| {
            let mut names: Vec<String> = fit.outcome.parameters.iter().map(|one| one.name.clone()).collect();
            names.sort();
            names
        };
        self.same_values(other) && self.document.title == other.document.title && varied(self) == varied(other)
    }

    pub fn same_values(&self, other: &Self) -> bool {
        (self.record, self.window, &self.columns) == (other.record, other.window, &other.columns)
    }
}

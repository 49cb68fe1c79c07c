//! Results of fits: list, ranking, details.

use crate::fits::fit::{Fitted, Part};
use crate::fits::{Fits, ShownFits};
use crate::removed::Removed;
use crate::{Announcement, Changes, number, words};
use analysis::fit::{Estimate, Nearness, Outcome, Verdict};
use play::Play;
use report::{FitReport, FitRow};
use units::number::{Group, Style};
use units::order::sort;
use units::{Dimension, Language, Unit};

/// Maximum number of fits that are kept.
pub const MOST_FITS: usize = 40;

/// A fit in the list of results.
#[derive(Clone, Debug, PartialEq)]
pub struct FitView {
    /// Id of the fit.
    pub id: u32,
    /// Title of the theory.
    pub theory: String,
    /// Names of the records.
    pub records: Vec<String>,
    /// Number of values and number of varied parameters.
    pub counts: (usize, usize),
    /// Root mean square of the residuals, with its unit.
    pub rmse: String,
    /// Root mean square of the residuals outside the fitted window; empty if all values were fitted.
    pub predicted: String,
    /// Difference of the AICc from that of the best fit of the same values; a dash if undefined.
    pub difference: String,
    /// Akaike weight among the fits of the same values, in percent; empty for a single fit.
    pub weight: String,
    /// Sentence about other theories of the same rank; empty if there are none.
    pub tied: String,
    /// True if the open document has the title and the parameters of the theory, so that the fit can be applied.
    pub applicable: bool,
}

/// A fitted or derived number.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateView {
    /// Name in the document.
    pub name: String,
    /// Label shown to users.
    pub label: String,
    /// Name of the record that it belongs to; empty if it holds for all records.
    pub record: String,
    /// Value and standard error, `0.387 ± 0.004`, rounded to the precision of the error.
    pub value: String,
    /// Unit of the value.
    pub unit: String,
    /// Remark: undetermined, at a bound, or compared with the true value. Otherwise empty.
    pub remark: String,
    /// True if it is derived from the varied numbers.
    pub derived: bool,
}

/// Details of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FitDetail {
    /// Title of the theory.
    pub theory: String,
    /// Short reason to doubt the result; `None` if there is none.
    pub doubt: Option<String>,
    /// Varied and derived numbers: first those that hold for all records, then those of each record.
    pub estimates: Vec<EstimateView>,
    /// Sentences about the residuals, the search, undetermined numbers and the data.
    pub sentences: Vec<String>,
    /// Names and values of statistics.
    pub statistics: Vec<(&'static str, String)>,
    /// Nearness of the curve to the data, and a sentence about it; `None` if the values do not vary.
    pub nearness: Option<(Nearness, String)>,
    /// Index of the estimate that is shown first: the period, otherwise the first derived number.
    pub leading: Option<usize>,
}

impl Fits {
    /// Takes a finished fit and gives it an id. A fit with the same theory, values and varied numbers is replaced.
    /// `is_new`: false for a reconstructed fit, which does not replace a newer one; `None` is returned then.
    pub(super) fn take_fitted(&mut self, fitted: Fitted, is_new: bool) -> Option<u32> {
        let same = |fit: &Fitted| fit.is_same(&fitted);
        if !is_new && self.finished.iter().any(same) {
            return None;
        }
        let id = self.issued;
        self.issued += 1;
        self.finished.retain(|fit| !same(fit));
        if self.finished.len() >= MOST_FITS {
            self.finished.remove(0);
        }
        self.finished.push(Fitted { id, ..fitted });
        self.forget_applied();
        Some(id)
    }

    /// Removes a fit.
    pub fn remove(&mut self, play: &Play, id: u32) -> Changes {
        let Some(place) = self.finished.iter().position(|fit| fit.id == id) else { return Changes::NONE };
        let fit = self.finished.remove(place);
        let theory = fit.title(play);
        self.forget_applied();
        Changes::FITS.removing(Removed::Fit(place, Box::new(fit))).announcing(Announcement::FitRemoved(theory))
    }

    /// Clears the id of the applied fit if that fit is no longer in the list.
    fn forget_applied(&mut self) {
        let finished = &self.finished;
        self.applied = self.applied.filter(|id| finished.iter().any(|fit| fit.id == *id));
    }

    /// Puts a removed fit back, at most at the end of the list.
    pub(crate) fn put_back(&mut self, place: usize, fit: Fitted) -> Changes {
        self.finished.insert(place.min(self.finished.len()), fit);
        Changes::FITS
    }
}

impl ShownFits<'_> {
    /// The finished fits, grouped by the values that were fitted. Each group is ranked, best fit first.
    pub fn list(self) -> Vec<FitView> {
        let mut groups: Vec<Vec<&Fitted>> = Vec::new();
        for fit in &self.fits.finished {
            match groups.iter_mut().find(|group| group.first().is_some_and(|one| one.same_values(fit))) {
                Some(group) => group.push(fit),
                None => groups.push(vec![fit]),
            }
        }
        groups.iter().flat_map(|group| self.ranked(group)).collect()
    }

    fn ranked(self, group: &[&Fitted]) -> Vec<FitView> {
        let outcomes: Vec<&Outcome> = group.iter().map(|fit| &fit.outcome).collect();
        let known = |value: f64, digits: usize| {
            if value.is_finite() {
                number::fixed(value, digits, self.play.basis().style())
            } else {
                number::DASH.to_owned()
            }
        };
        let residuals = residuals(group, self.play.basis().style());
        let ranked = analysis::fit::rank(&outcomes);
        let ties = analysis::fit::ties(&ranked, &outcomes, self.play.basis().language(), |index| {
            group[index].title(self.play)
        });
        let view = |place: analysis::fit::Ranked| {
            let fit = group.get(place.index)?;
            let outcome = &fit.outcome;
            let size = |value: f64| residuals.quantity(value);
            Some(FitView {
                id: fit.id,
                theory: fit.title(self.play),
                records: fit.record_names(),
                counts: (outcome.n, outcome.parameters.len()),
                rmse: size(outcome.rmse),
                predicted: outcome.predicted().map(size).unwrap_or_default(),
                difference: known(place.difference, 1),
                weight: if group.len() > 1 { format!("{} %", known(100.0 * place.weight, 1)) } else { String::new() },
                tied: ties.iter().find(|(at, _)| *at == place.place).map(|(_, tie)| tie.clone()).unwrap_or_default(),
                applicable: self.is_applicable(fit),
            })
        };
        ranked.into_iter().filter_map(view).collect()
    }

    pub(crate) fn is_applicable(&self, fit: &Fitted) -> bool {
        let (fitted, present) = (&fit.document.program, &self.document.program);
        let names = |program: &program::Program| -> Vec<String> {
            program.model.parameters.iter().map(|parameter| parameter.name.clone()).collect()
        };
        fitted.title == present.title && names(fitted) == names(present)
    }

    /// Details of the fit of this id.
    pub fn detail(self, id: u32) -> Option<FitDetail> {
        let fit = self.fits.finished.iter().find(|fit| fit.id == id)?;
        let report = FitReport::new(&self.report(fit, &[], "", ""));
        let estimates = self.estimate_views(fit, &report);
        Some(FitDetail {
            theory: fit.title(self.play),
            doubt: doubt(self.play.basis().language(), &fit.outcome),
            nearness: fit.outcome.nearness_in_brief(self.play.basis().language()),
            leading: leading(&fit.outcome).and_then(|name| estimates.iter().position(|one| one.name == name)),
            estimates,
            sentences: report.sentences().cloned().chain(self.missing_errors(fit)).collect(),
            statistics: report.statistics.iter().map(|one| (one.name, one.full_text())).collect(),
        })
    }

    /// Sentences about the columns whose standard errors a fit ignored because some are missing.
    fn missing_errors(&self, fit: &Fitted) -> Vec<String> {
        let independent = &fit.document.program.model.independent.name;
        let mut sentences = Vec::new();
        for (part, task) in fit.definition.parts.iter().zip(&fit.task.records) {
            let Some(record) = self.records.get(part.record) else { continue };
            for one in task.observations.iter().filter(|one| one.errors.is_none()) {
                let column = part.uses.iter().position(|used| used.fitted && used.meaning.quantity == one.name);
                let errors = column.and_then(|column| record.errors_beside(&part.uses, column, independent));
                let missing = |errors: &Vec<f64>| errors.iter().filter(|error| !error.is_finite()).count();
                let known = errors.map(|errors| (missing(&errors), errors.len())).filter(|(missing, _)| *missing > 0);
                sentences.extend(
                    known.map(|counts| {
                        words::missing_errors(self.play.basis().language(), &part.name, &one.name, counts)
                    }),
                );
            }
        }
        sentences
    }

    /// Estimates that hold for all records, then those of each record. Within each group the varied numbers come first.
    fn estimate_views(&self, fit: &Fitted, report: &FitReport) -> Vec<EstimateView> {
        let several = fit.task.records.len() > 1;
        let place = |row: &FitRow| row.estimate.record.filter(|_| several);
        let groups = std::iter::once(None).chain((0..fit.task.records.len()).map(Some));
        // A quantity has the same unit and the same decimals in every record.
        let group = |name: &str| -> Group {
            let known: Vec<&Estimate> =
                report.rows.iter().map(|row| &row.estimate).filter(|one| one.name == name && one.determined).collect();
            let measured: Vec<(f64, f64)> =
                known.iter().map(|one| (one.value, error(one).map_or(f64::NAN, f64::abs))).collect();
            let unit = known.first().map_or_else(Unit::dimensionless, |one| one.unit.clone());
            Group::of_errors(&unit, &measured, self.play.basis().style())
        };
        let of = |group| report.rows.iter().filter(move |row| place(row) == group);
        groups.flat_map(of).map(|row| self.estimate_view(fit, row, &group(&row.estimate.name))).collect()
    }

    fn estimate_view(&self, fit: &Fitted, row: &FitRow, group: &Group) -> EstimateView {
        let one = &row.estimate;
        let error = error(one);
        let remark = match self.truth(fit, one).filter(|_| row.note.is_empty()) {
            Some(value) => {
                let off = error.filter(|error| *error > 0.0).map(|error| (one.value - value) / error);
                let truth = self.play.basis().quantity_text(value, group.unit());
                words::truth_is(
                    self.play.basis().language(),
                    &truth,
                    off.map(|off| number::fixed(off, 1, self.play.basis().style())).as_deref(),
                )
            }
            None => row.note.to_owned(),
        };
        let record = one.record.filter(|_| fit.task.records.len() > 1).and_then(|record| fit.task.records.get(record));
        EstimateView {
            name: one.name.clone(),
            label: if row.label.is_empty() { play::symbol(&one.name) } else { row.label.clone() },
            record: record.map(|record| record.name.clone()).unwrap_or_default(),
            value: match one.determined {
                true => group.with_error(one.value, error.map_or(f64::NAN, f64::abs)),
                false => number::DASH.to_owned(),
            },
            unit: if one.determined { group.unit_text() } else { number::unit_text(&one.unit.text) },
            remark,
            derived: row.is_derived,
        }
    }

    /// True value of an estimate, if its records are simulated and have the same value of it.
    fn truth(&self, fit: &Fitted, one: &Estimate) -> Option<f64> {
        let of = |place: usize| {
            let record = self.records.get(fit.definition.parts.get(place)?.record)?;
            record.truth()?.iter().find(|(name, _)| *name == one.name).map(|(_, value)| *value)
        };
        let Some(place) = one.record else {
            let first = of(0)?;
            return (1..fit.definition.parts.len()).all(|place| of(place) == Some(first)).then_some(first);
        };
        of(place)
    }

    /// Texts of the theory of a fit with their file names: the document first, then its translations.
    pub fn texts(self, id: u32) -> Vec<(String, String)> {
        let Some(fit) = self.fits.finished.iter().find(|fit| fit.id == id) else { return Vec::new() };
        let (document, file) = (&fit.document, &fit.definition.file);
        let stem = file.trim_end_matches(".md");
        let translations = document.translations.iter().zip(document.program.languages().skip(1));
        let translations = translations.map(|(text, language)| (format!("{stem}.{language}.md"), text.clone()));
        std::iter::once((file.clone(), document.source.clone())).chain(translations).collect()
    }
}

/// Reason to doubt a result, which is then not applied automatically; `None` if there is none.
pub(super) fn doubt(language: Language, outcome: &Outcome) -> Option<String> {
    if !outcome.rmse.is_finite() {
        return Some(words::not_finite(language).to_owned());
    }
    if !outcome.converged {
        return Some(words::not_converged(language).to_owned());
    }
    let why = match outcome.verdict() {
        _ if !outcome.undersampled.is_empty() => Some(words::undersampled(language)),
        Verdict::Misled => Some(words::misled(language)),
        Verdict::Missed => Some(words::missed(language)),
        _ => None,
    };
    if let Some(why) = why {
        return Some(why.to_owned());
    }
    let names: Vec<String> = outcome.stopped().map(|one| play::symbol(&one.name)).collect();
    (!names.is_empty()).then(|| words::stopped(language, &names.join(", ")))
}

/// Name of the derived number that is shown first: a time called `T`, with any index; otherwise the first that is determined.
fn leading(outcome: &Outcome) -> Option<&str> {
    let mut derived = outcome.derived.iter().filter(|one| one.determined);
    let is_period = |one: &&Estimate| one.unit.dimension == Dimension::TIME && one.name.split('_').next() == Some("T");
    derived.clone().find(is_period).or_else(|| derived.next()).map(|one| one.name.as_str())
}

/// Common number format of the residuals of fits that are ranked together.
fn residuals(group: &[&Fitted], style: Style) -> Group {
    let unit = group.first().map_or_else(Unit::dimensionless, |fit| fit.outcome.rmse_unit.clone());
    let sizes = group.iter().flat_map(|fit| [Some(fit.outcome.rmse), fit.outcome.predicted()]).flatten();
    Group::of_residuals(&unit, &sizes.collect::<Vec<f64>>(), 3, style)
}

/// Robust standard error of an estimate if known, because residuals of films are correlated; otherwise the ordinary
/// one.
fn error(one: &Estimate) -> Option<f64> {
    one.stderr_hac.or(one.stderr)
}

impl Fitted {
    /// Title of the theory in the language of the simulation.
    pub fn title(&self, play: &Play) -> String {
        self.document.program.edition(play.basis().tag()).title.clone()
    }

    fn is_same(&self, other: &Self) -> bool {
        let varied = |fit: &Self| {
            let mut names: Vec<String> = fit.outcome.parameters.iter().map(|one| one.name.clone()).collect();
            sort(&mut names);
            names
        };
        self.same_values(other)
            && self.document.program.title == other.document.program.title
            && varied(self) == varied(other)
    }

    /// True if both fits have the same records, columns in the same units, rows, window and loss, so that they can be ranked
    /// together.
    pub fn same_values(&self, other: &Self) -> bool {
        let scales = |part: &Part| -> Vec<f64> {
            part.uses.iter().filter(|used| used.fitted).map(|used| used.meaning.unit.to_si(1.0)).collect()
        };
        let values = |fit: &Self| {
            let parts = fit.definition.parts.iter();
            let records: Vec<_> = parts.map(|part| (part.record, scales(part), part.excluded.clone())).collect();
            let columns = fit.outcome.observations.iter().map(|one| (one.record, one.name.clone()));
            (records, fit.definition.window, fit.definition.loss, columns.collect::<Vec<_>>())
        };
        values(self) == values(other)
    }

    pub fn record_names(&self) -> Vec<String> {
        self.definition.parts.iter().map(|part| part.name.clone()).collect()
    }
}

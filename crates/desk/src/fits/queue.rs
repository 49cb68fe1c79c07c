//! The queue of fits: one fit per theory, computed by workers.

use crate::fits::fit::{Definition, Fitted, Job, Waiting};
use crate::fits::results::doubt;
use crate::fits::running::Running;
use crate::fits::workers::{Finding, FitNews, NothingFound, Workers};
use crate::fits::{FitData, Fits, ShownFits};
use crate::words::fit_error;
use crate::{Announcement, Changes, OpenDocument, Refusal};
use analysis::fit::{Fit, FitError, Varied};
use document::Document;
use program::{Model, Parameter};
use std::cmp::Reverse;
use units::order::sort_by_key;
use units::{Words, words};

/// Progress of the fits started by the user.
#[derive(Clone, Debug, PartialEq)]
pub struct FitProgress {
    /// Title of the theory that is being fitted.
    pub theory: String,
    /// Number of curves that were computed for it.
    pub trials: usize,
    /// Coefficient of determination (R²) of the best curve so far.
    pub explained: f64,
    /// Number of finished theories and number of all theories.
    pub finished: (usize, usize),
}

/// Result of a fit that was taken.
#[derive(Debug)]
pub(crate) struct Settled {
    /// Id of the fit, if it is to be applied: it is of the open document and not doubtful.
    pub applied: Option<u32>,
    /// Reason to doubt it, `None` if there is none. Outer `None` for a reconstructed fit.
    pub doubt: Option<Option<String>>,
}

impl Fits {
    /// Starts a fit of the open document, whose file name is `file`, to the records that take part.
    ///
    /// # Errors
    /// Nothing is varied, or no column is fitted.
    pub fn begin(&mut self, data: FitData<'_>, file: &str) -> (Result<(), Refusal>, Changes) {
        let (shown, OpenDocument { play, document }) = (self.shown(data), data.open);
        let varied = shown.varied();
        let definition = Definition {
            file: file.to_owned(),
            parts: shown.parts(document, &varied, true, &[]),
            varied,
            parameters: visible(play.model(), play.course().parameters()),
            window: self.setup.window,
            loss: self.setup.loss,
        };
        let job = Job { definition, document: document.clone(), own: true, found: None };
        self.start_queue(data, vec![job])
    }

    /// Starts fits of several documents to the records that take part. Each document states its varied parameters. The
    /// settings of shared and per-record values hold in every theory with a parameter of that name. The offset of the readings
    /// is varied in every theory that has no constant of its own. All theories read a column in the same unit.
    ///
    /// # Errors
    /// No column is fitted, or the unit of a column is asked for.
    pub fn begin_ranking(
        &mut self,
        data: FitData<'_>,
        theories: Vec<(String, Document)>,
    ) -> (Result<(), Refusal>, Changes) {
        let shown = self.shown(data);
        let units = match shown.shared_units(&theories) {
            Ok(units) => units,
            Err(refusal) => return (Err(refusal), Changes::NONE),
        };
        let job = |(file, document): (String, Document)| {
            let parameters = &document.program.model.parameters;
            let shared =
                |index: usize| parameters.get(index).is_some_and(|parameter| self.setup.is_same(&parameter.name, true));
            let varied =
                document.program.vary.iter().map(|&index| Varied { shared: shared(index), ..Varied::parameter(index) });
            let mut varied: Vec<Varied> = varied.collect();
            let parts = shown.parts(&document, &varied, false, &units);
            let offsets = shown.offsets_of(&document.program.model, &varied, &parts);
            varied.extend(offsets.into_iter().map(|place| shown.varied_offset(place)));
            let definition = Definition {
                file,
                parts,
                varied,
                parameters: visible(
                    &document.program.model,
                    &parameters.iter().map(|parameter| parameter.value).collect::<Vec<_>>(),
                ),
                window: self.setup.window,
                loss: self.setup.loss,
            };
            Job { definition, document, own: false, found: None }
        };
        let mut jobs: Vec<Job> = theories.into_iter().map(job).collect();
        // Theories with more states and more varied numbers take longer: begun last, one of them would leave the other workers
        // idle.
        let size = |job: &Job| (job.document.program.model.states.len(), job.definition.varied.len());
        sort_by_key(&mut jobs, |job| Reverse(size(job)));
        self.start_queue(data, jobs)
    }

    fn start_queue(&mut self, data: FitData<'_>, mut jobs: Vec<Job>) -> (Result<(), Refusal>, Changes) {
        self.set_aside();
        jobs.reverse();
        self.total = jobs.len();
        self.queue = jobs;
        self.left_out.clear();
        match self.next_fit(data) {
            Ok(changes) => (Ok(()), Changes::FITS | changes),
            Err(refusal) => (Err(refusal), Changes::FITS),
        }
    }

    /// Puts interrupted reconstructions back into the waiting list. Cancels all other running fits.
    fn set_aside(&mut self) {
        while let Some(Running { job, .. }) = self.running.pop_back() {
            if let Some(waiting) = Waiting::of(job) {
                self.waiting.push_front(waiting);
            }
        }
    }

    /// Adds the next fit of the queue, or else the next reconstruction, to the running ones. Of several theories, one that
    /// cannot be fitted is left out. All of these are announced after the last one.
    fn next_fit(&mut self, data: FitData<'_>) -> Result<Changes, Refusal> {
        let play = data.open.play;
        let alone = self.total == 1;
        while let Some(job) = self.queue.pop() {
            let theory = job.document.program.edition(play.basis().tag()).title.clone();
            match self.shown(data).ready(job) {
                Ok(running) => {
                    self.running.push_back(running);
                    return Ok(Changes::NONE);
                }
                Err(refusal) if alone => return Err(refusal),
                Err(refusal) => self.left_out.push(format!("{theory}: {}", refusal.text(play))),
            }
        }
        let mut changes = Changes::NONE;
        if !self.left_out.is_empty() {
            let left_out = std::mem::take(&mut self.left_out).join(" ");
            changes = changes.announcing(Announcement::TheoriesLeftOut(left_out));
        }
        while let Some(waiting) = self.waiting.pop_front() {
            let file = waiting.definition.file.clone();
            let job = waiting.job(&mut self.documents);
            let has_theory = job.is_some();
            if let Some(running) = job.and_then(|job| self.shown(data).ready(job).ok()) {
                self.running.push_back(running);
                break;
            }
            self.lost.push(match has_theory {
                true => words!("fit of {file}: the theory cannot be fitted to its records"),
                false => words!("fit of {file}: its document has errors or other parameters"),
            });
        }
        Ok(changes)
    }

    /// Ends what is not wanted any more, and begins as many fits as there are workers.
    fn hand_out(&mut self, data: FitData<'_>, workers: &mut dyn Workers) -> Changes {
        let mut changes = Changes::NONE;
        let wanted: Vec<u32> = self.running.iter().filter_map(|running| running.number).collect();
        workers.keep(&wanted);
        let is_open = |running: &Running| running.found.is_none();
        while self.running.iter().filter(|running| is_open(running)).count() < workers.count() {
            let before = self.running.len();
            if let Ok(more) = self.next_fit(data) {
                changes = changes | more;
            }
            if self.running.len() == before {
                break;
            }
        }
        let open = self.running.iter_mut().filter(|running| is_open(running));
        let (given, waiting): (Vec<_>, Vec<_>) = open.partition(|running| running.number.is_some());
        for running in waiting.into_iter().take(workers.count().saturating_sub(given.len())) {
            running.number = Some(workers.begin(running.work()));
        }
        changes
    }

    /// Gives the workers what they can do, and takes their news.
    pub(crate) fn take_news(&mut self, data: FitData<'_>, workers: &mut dyn Workers) -> Changes {
        let changes = self.hand_out(data, workers);
        for (number, news) in workers.news() {
            let Some(running) = self.running.iter_mut().find(|running| running.number == Some(number)) else {
                continue;
            };
            match news {
                FitNews::Trial { trials, explained } => running.progress = (trials, explained),
                FitNews::Lost => running.number = None,
                FitNews::Found(found) => running.found = Some(found),
            }
        }
        changes
    }

    /// Takes the next result in the order of the queue, so that results do not depend on the number of workers; `None` if
    /// it is not there yet.
    pub(crate) fn settle_next(&mut self, data: FitData<'_>) -> (Option<Settled>, Changes) {
        let Some(Running { job, task, found, .. }) = self.running.pop_front_if(|running| running.found.is_some())
        else {
            return (None, Changes::NONE);
        };
        let is_new = job.found.is_none();
        match found.unwrap_or(Err(NothingFound::NoCurve)) {
            Ok(finding) => {
                let Finding { mut outcome, traces } = *finding;
                if let Some(found) = &job.found {
                    found.complete(&mut outcome);
                }
                let own = job.own;
                let Job { definition, document, .. } = job;
                let id = self.take_fitted(Fitted { id: 0, definition, document, task, traces, outcome }, is_new);
                let fit = id.and_then(|id| self.finished.iter().find(|fit| fit.id == id)).filter(|_| own);
                let doubt = fit.and_then(|fit| doubt(data.open.language(), &fit.outcome));
                let applied = id.filter(|_| own && doubt.is_none());
                (Some(Settled { applied, doubt: is_new.then_some(doubt) }), Changes::FITS)
            }
            Err(nothing) => {
                let settled = Settled { applied: None, doubt: is_new.then_some(None) };
                let failed = Changes::FITS;
                (Some(settled), if is_new { failed.announcing(Announcement::FitFailed(nothing)) } else { failed })
            }
        }
    }

    /// Gives the workers more work after results were taken. `last`: reason to doubt the last of them that a person has
    /// begun. Returns true if there is more work.
    pub(crate) fn hand_out_again(
        &mut self,
        data: FitData<'_>,
        workers: &mut dyn Workers,
        last: Option<Option<String>>,
    ) -> (bool, Changes) {
        let mut changes = self.hand_out(data, workers);
        if let Some(doubt) = last
            && self.shown(data).progress().is_none()
        {
            changes = changes.announcing(Announcement::FitFinished(doubt));
        }
        (!self.running.is_empty(), changes)
    }

    /// Cancels the fits started by the user.
    pub fn cancel(&mut self) -> Changes {
        if self.running.iter().all(|running| running.job.found.is_some()) {
            return Changes::NONE;
        }
        self.set_aside();
        self.queue.clear();
        Changes::FITS.announcing(Announcement::FitCancelled)
    }
}

impl<'a> ShownFits<'a> {
    fn ready(self, mut job: Job) -> Result<Running, Refusal> {
        job.document.program.set_seat(self.play.program().seat);
        let task = self.task(&job)?;
        match Fit::check(&job.document.program.model, &task) {
            Ok(()) => Ok(Running { job, task, number: None, progress: (0, 0.0), found: None }),
            Err(error) => Err(Refusal::Fit { why: self.fit_error(&job, &error) }),
        }
    }

    /// A sentence for each stored fit that could not be reconstructed, with the reason.
    pub fn lost(self) -> &'a [Words] {
        &self.fits.lost
    }

    /// Progress of the fits started by the user, `None` while none runs.
    pub fn progress(self) -> Option<FitProgress> {
        let own = || self.fits.running.iter().filter(|running| running.job.found.is_none());
        let open = own().filter(|running| running.found.is_none()).count();
        let Running { job, progress: (trials, explained), .. } = own().next()?;
        Some(FitProgress {
            theory: job.document.program.edition(self.play.basis().tag()).title.clone(),
            trials: *trials,
            explained: *explained,
            finished: (self.fits.total - self.fits.queue.len() - open, self.fits.total),
        })
    }

    /// The fits that are being reconstructed.
    pub(crate) fn being_remade(self) -> impl Iterator<Item = &'a Job> {
        self.fits.running.iter().map(|running| &running.job).filter(|job| job.found.is_some())
    }

    /// Reason why a fit cannot be made, with the name of the record if it is one of several.
    fn fit_error(self, job: &Job, error: &FitError) -> String {
        let why = fit_error(self.play.basis().language(), error);
        let place = match error {
            FitError::RecordEmpty(record) | FitError::BadErrors { record, .. } => *record,
            _ => return why,
        };
        job.definition.parts.get(place).map_or_else(|| why.clone(), |part| format!("{}: {why}", part.name))
    }
}

/// Values of the parameters that readers see, NaN for the others, whose values are not stored.
fn visible(model: &Model, values: &[f64]) -> Vec<f64> {
    let value = |(own, value): (&Parameter, &f64)| if own.is_shown() { *value } else { f64::NAN };
    model.parameters.iter().zip(values).map(value).collect()
}

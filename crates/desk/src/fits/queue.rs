//! The queue of fits: one fit per theory, computed by workers.

use crate::fits::fit::{Definition, Job, Waiting};
use crate::fits::state::Running;
use crate::fits::workers::{Finding, FitNews, NothingFound, Workers};
use crate::words::fit_error;
use crate::{Announcement, Desk, Refusal};
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

impl Desk {
    /// Starts a fit of the open document, whose file name is `file`, to the records that take part.
    ///
    /// # Errors
    /// Nothing is varied, or no column is fitted.
    pub fn begin_fit(&mut self, file: &str) -> Result<(), Refusal> {
        let varied = self.varied();
        let definition = Definition {
            file: file.to_owned(),
            parts: self.parts(&self.document, &varied, true),
            varied,
            parameters: shown(self.play.model(), self.play.course().parameters()),
            window: self.fits.setup.window,
            loss: self.fits.setup.loss,
        };
        let job = Job { definition, document: self.document.clone(), own: true, found: None };
        self.start_queue(vec![job])
    }

    /// Starts fits of several documents to the records that take part. Each document states its varied parameters. The
    /// settings of shared and per-record values hold in every theory with a parameter of that name. The zero of the
    /// scale is varied for records of films in every theory that needs it.
    ///
    /// # Errors
    /// No column is fitted.
    pub fn begin_ranking(&mut self, theories: Vec<(String, Document)>) -> Result<(), Refusal> {
        let job = |(file, document): (String, Document)| {
            let parameters = &document.program.model.parameters;
            let shared = |index: usize| {
                parameters.get(index).is_some_and(|parameter| self.fits.setup.is_same(&parameter.name, true))
            };
            let varied =
                document.program.vary.iter().map(|&index| Varied { shared: shared(index), ..Varied::parameter(index) });
            let mut varied: Vec<Varied> = varied.collect();
            let parts = self.parts(&document, &varied, false);
            if self.varied_zero_of(&document.program.model, &varied, &parts) {
                varied.push(self.varied_zero());
            }
            let definition = Definition {
                file,
                parts,
                varied,
                parameters: shown(
                    &document.program.model,
                    &parameters.iter().map(|parameter| parameter.value).collect::<Vec<_>>(),
                ),
                window: self.fits.setup.window,
                loss: self.fits.setup.loss,
            };
            Job { definition, document, own: false, found: None }
        };
        let mut jobs: Vec<Job> = theories.into_iter().map(job).collect();
        // Theories with more states take longer: begun last, one of them would leave the other workers idle.
        sort_by_key(&mut jobs, |job| Reverse(job.document.program.model.states.len()));
        self.start_queue(jobs)
    }

    fn start_queue(&mut self, mut jobs: Vec<Job>) -> Result<(), Refusal> {
        self.set_aside();
        jobs.reverse();
        self.fits.total = jobs.len();
        self.fits.queue = jobs;
        self.fits.left_out.clear();
        self.revision.fits += 1;
        self.next_fit()
    }

    /// Puts interrupted reconstructions back into the waiting list. Cancels all other running fits.
    fn set_aside(&mut self) {
        while let Some(Running { job, .. }) = self.fits.running.pop_back() {
            if let Some(waiting) = Waiting::of(job) {
                self.fits.waiting.push_front(waiting);
            }
        }
    }

    /// Adds the next fit of the queue, or else the next reconstruction, to the running ones. Of several theories, one that
    /// cannot be fitted is left out. All of these are announced after the last one.
    fn next_fit(&mut self) -> Result<(), Refusal> {
        let alone = self.fits.total == 1;
        while let Some(job) = self.fits.queue.pop() {
            let theory = job.document.program.edition(self.play.basis().tag()).title.clone();
            match self.ready(job) {
                Ok(running) => {
                    self.fits.running.push_back(running);
                    return Ok(());
                }
                Err(refusal) if alone => return Err(refusal),
                Err(refusal) => self.fits.left_out.push(format!("{theory}: {}", self.refusal_text(&refusal))),
            }
        }
        if !self.fits.left_out.is_empty() {
            let left_out = std::mem::take(&mut self.fits.left_out).join(" ");
            self.announce(Announcement::TheoriesLeftOut(left_out));
        }
        while let Some(waiting) = self.fits.waiting.pop_front() {
            let file = waiting.definition.file.clone();
            let job = waiting.job(&mut self.opened);
            let has_theory = job.is_some();
            if let Some(running) = job.and_then(|job| self.ready(job).ok()) {
                self.fits.running.push_back(running);
                break;
            }
            self.fits.lost.push(match has_theory {
                true => words!("fit of {file}: the theory cannot be fitted to its records"),
                false => words!("fit of {file}: its document has errors or other parameters"),
            });
        }
        Ok(())
    }

    fn ready(&self, mut job: Job) -> Result<Running, Refusal> {
        job.document.program.set_seat(self.play.program().seat);
        let task = self.task(&job)?;
        match Fit::check(&job.document.program.model, &task) {
            Ok(()) => Ok(Running { job, task, number: None, progress: (0, 0.0), found: None }),
            Err(error) => Err(Refusal::Fit { why: self.fit_error(&job, &error) }),
        }
    }

    /// Computes one trial here. Returns true if there is more work.
    pub fn advance_fit(&mut self) -> bool {
        let mut here = std::mem::take(&mut self.fits.here);
        let has_more = self.advance_fits(&mut here);
        self.fits.here = here;
        has_more
    }

    /// Gives the workers what they can do, and takes what they have found. Results are taken in the order of the queue,
    /// so that they do not depend on the number of workers. Returns true if there is more work.
    pub fn advance_fits(&mut self, workers: &mut dyn Workers) -> bool {
        self.hand_out(workers);
        for (number, news) in workers.news() {
            let Some(running) = self.fits.running.iter_mut().find(|running| running.number == Some(number)) else {
                continue;
            };
            match news {
                FitNews::Trial { trials, explained } => running.progress = (trials, explained),
                FitNews::Lost => running.number = None,
                FitNews::Found(found) => running.found = Some(found),
            }
        }
        let mut last = None;
        while let Some(running) = self.fits.running.pop_front_if(|running| running.found.is_some()) {
            let again = running.job.found.is_some();
            let doubt = self.settle(running);
            last = if again { last } else { Some(doubt) };
            self.revision.fits += 1;
        }
        self.hand_out(workers);
        if let Some(doubt) = last
            && self.fit_progress().is_none()
        {
            self.announce(Announcement::FitFinished(doubt));
        }
        !self.fits.running.is_empty()
    }

    /// Ends what is not wanted any more, and begins as many fits as there are workers.
    fn hand_out(&mut self, workers: &mut dyn Workers) {
        let wanted: Vec<u32> = self.fits.running.iter().filter_map(|running| running.number).collect();
        workers.keep(&wanted);
        let is_open = |running: &Running| running.found.is_none();
        while self.fits.running.iter().filter(|running| is_open(running)).count() < workers.count() {
            let before = self.fits.running.len();
            let _ = self.next_fit();
            if self.fits.running.len() == before {
                break;
            }
        }
        let open = self.fits.running.iter_mut().filter(|running| is_open(running));
        let (given, waiting): (Vec<_>, Vec<_>) = open.partition(|running| running.number.is_some());
        for running in waiting.into_iter().take(workers.count().saturating_sub(given.len())) {
            running.number = Some(workers.begin(running.work()));
        }
    }

    /// Takes the result of a finished fit; the reason to doubt it is returned.
    fn settle(&mut self, Running { job, task, found, .. }: Running) -> Option<String> {
        match found.unwrap_or(Err(NothingFound::NoCurve)) {
            Ok(finding) => {
                let Finding { mut outcome, traces } = *finding;
                if let Some(found) = &job.found {
                    found.complete(&mut outcome);
                }
                self.take_outcome(job, task, outcome, traces)
            }
            Err(nothing) => {
                if job.found.is_none() {
                    self.announce(Announcement::FitFailed(nothing));
                }
                None
            }
        }
    }

    /// A sentence for each stored fit that could not be reconstructed, with the reason.
    pub fn lost_fits(&self) -> &[Words] {
        &self.fits.lost
    }

    /// Cancels the fits started by the user.
    pub fn cancel_fit(&mut self) {
        if self.fit_progress().is_some() {
            self.set_aside();
            self.fits.queue.clear();
            self.revision.fits += 1;
            self.announce(Announcement::FitCancelled);
        }
    }

    /// Progress of the fits started by the user, `None` while none runs.
    pub fn fit_progress(&self) -> Option<FitProgress> {
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
    pub(crate) fn being_remade(&self) -> impl Iterator<Item = &Job> {
        self.fits.running.iter().map(|running| &running.job).filter(|job| job.found.is_some())
    }

    /// Reason why a fit cannot be made, with the name of the record if it is one of several.
    fn fit_error(&self, job: &Job, error: &FitError) -> String {
        let why = fit_error(self.play.language(), error);
        let place = match error {
            FitError::RecordEmpty(record) | FitError::BadErrors { record, .. } => *record,
            _ => return why,
        };
        job.definition.parts.get(place).map_or_else(|| why.clone(), |part| format!("{}: {why}", part.name))
    }
}

/// Values of the parameters that readers see, NaN for the others, whose values are not stored.
fn shown(model: &Model, values: &[f64]) -> Vec<f64> {
    let value = |(own, value): (&Parameter, &f64)| if own.is_shown() { *value } else { f64::NAN };
    model.parameters.iter().zip(values).map(value).collect()
}

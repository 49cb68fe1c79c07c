//! Fits: what is varied, the work in slices, the theories in a queue.

use crate::fitted::Fitted;
use crate::recognise::observed;
use crate::record::Record;
use crate::{Announcement, Refusal, Session, number};
use analysis::fit::{Fit, FitError, Observation, Target, Task, Varied};
use document::Document;
use engine::Method;

/// Something that a fit can vary.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceView {
    /// Its place in the list, for [`Session::vary`].
    pub index: usize,
    /// Its name in the document; empty for the zeros of clock and scale.
    pub name: String,
    /// What it is called.
    pub label: String,
    /// Whether it is varied.
    pub varied: bool,
}

/// How far the fits have come.
#[derive(Clone, Debug, PartialEq)]
pub struct FitProgress {
    /// The title of the theory that is being fitted.
    pub theory: String,
    /// How many curves were tried for it.
    pub trials: usize,
    /// The part of the scatter that it explains so far.
    pub explained: f64,
    /// How many theories are finished, and how many there are.
    pub finished: (usize, usize),
}

/// What fits are asked for, and what has come of them.
#[derive(Debug, Default)]
pub(crate) struct Fits {
    /// Whether each parameter of the document is varied.
    pub varied: Vec<bool>,
    /// Whether the zero of the clock and that of the scale are.
    pub zeros: [bool; 2],
    /// What part of the record is fitted: readings of its clock, SI.
    pub window: [Option<f64>; 2],
    pub finished: Vec<Fitted>,
    queue: Vec<Job>,
    /// How many there were when the queue began.
    total: usize,
    running: Option<Running>,
}

/// A theory and the record that it is to be fitted to.
#[derive(Debug)]
pub(crate) struct Job {
    /// Its file.
    pub file: String,
    pub document: Document,
    /// Whether it is the document that is open.
    pub own: bool,
    pub record: u32,
    pub varied: Vec<Varied>,
    pub parameters: Vec<f64>,
}

/// So many points of a fitted curve are drawn in a report.
const POINTS_OF_A_CURVE: usize = 600;

#[derive(Debug)]
struct Running {
    job: Job,
    task: Task,
    fit: Fit,
}

impl Session {
    /// What a fit can vary: the parameters, the zero of the clock, the zero of the scale.
    pub fn fit_choices(&self) -> Vec<ChoiceView> {
        let parameters = self.model().parameters.iter().enumerate().map(|(index, parameter)| ChoiceView {
            index,
            name: parameter.name.clone(),
            label: self.parameter_label(index).to_owned(),
            varied: self.fits.varied.get(index).copied().unwrap_or(false),
        });
        let count = self.model().parameters.len();
        let zeros = self.tongue.zeros().into_iter().zip(self.fits.zeros).enumerate();
        let zeros = zeros.map(|(place, (label, varied))| ChoiceView {
            index: count + place,
            name: String::new(),
            label: label.to_owned(),
            varied,
        });
        parameters.chain(zeros).collect()
    }

    /// Lets a fit vary something or not.
    pub fn vary(&mut self, choice: usize, varied: bool) {
        let parameters = self.model().parameters.len();
        let place = match choice.checked_sub(parameters) {
            Some(zero) => self.fits.zeros.get_mut(zero),
            None => self.fits.varied.get_mut(choice),
        };
        if let Some(place) = place {
            *place = varied;
            self.revision.fits += 1;
        }
    }

    /// What part of the record is fitted, as its fields show it.
    pub fn fit_window(&self) -> [String; 2] {
        let unit = &self.model().independent.unit;
        self.fits.window.map(|end| end.map_or_else(String::new, |end| number::plain(unit.from_si(end), 6, self.style)))
    }

    /// Sets an end of that part from what was typed, 0 where it begins and 1 where it ends; nothing typed is no end.
    ///
    /// # Errors
    /// What is no time.
    pub fn set_fit_window(&mut self, end: usize, typed: &str) -> Result<(), Refusal> {
        let value = match typed.trim() {
            "" => None,
            typed => Some(self.read_value(typed, &self.model().independent.unit)?),
        };
        if let Some(place) = self.fits.window.get_mut(end) {
            *place = value;
        }
        self.revision.fits += 1;
        Ok(())
    }

    /// Begins to fit the document that is open to a record.
    ///
    /// # Errors
    /// Nothing to vary or to follow.
    pub fn begin_fit(&mut self, record: u32) -> Result<(), Refusal> {
        let mut varied: Vec<Varied> = self
            .fits
            .varied
            .iter()
            .enumerate()
            .filter(|(_, varied)| **varied)
            .map(|(index, _)| Varied::parameter(index))
            .collect();
        let zero = |target| Varied { target, shared: false, start: None, bounds: None };
        let [clock, scale] = self.fits.zeros;
        varied.extend(clock.then(|| zero(Target::Origin)));
        varied.extend(scale.then(|| zero(Target::Offset(0))));
        let job = Job {
            file: String::new(),
            document: self.document.clone(),
            own: true,
            record,
            varied,
            parameters: self.course.parameters().to_vec(),
        };
        // A slider is where the search begins.
        self.start_queue(vec![job])
    }

    /// Begins to fit each of these documents, with what it says is varied, to a record.
    ///
    /// # Errors
    /// Nothing to follow.
    pub fn begin_ranking(&mut self, record: u32, theories: Vec<(String, Document)>) -> Result<(), Refusal> {
        let job = |(file, document): (String, Document)| Job {
            file,
            own: false,
            record,
            varied: document.vary.iter().map(|&index| Varied::parameter(index)).collect(),
            parameters: document.model.parameters.iter().map(|parameter| parameter.value).collect(),
            document,
        };
        self.start_queue(theories.into_iter().map(job).collect())
    }

    fn start_queue(&mut self, mut jobs: Vec<Job>) -> Result<(), Refusal> {
        jobs.reverse();
        self.fits.total = jobs.len();
        self.fits.queue = jobs;
        self.fits.running = None;
        self.revision.fits += 1;
        self.next_fit()
    }

    /// Takes the next theory of the queue. Of several, one that cannot be fitted is passed over.
    fn next_fit(&mut self) -> Result<(), Refusal> {
        let alone = self.fits.total == 1;
        while let Some(job) = self.fits.queue.pop() {
            match self.task(&job).map(|task| (Fit::new(&job.document.model, task.clone()), task)) {
                Ok((Ok(fit), task)) => {
                    self.fits.running = Some(Running { job, task, fit });
                    return Ok(());
                }
                Ok((Err(error), _)) if alone => return Err(Refusal::Fit { why: self.tongue.fit_error(&error) }),
                Err(refusal) if alone => return Err(refusal),
                _ => {}
            }
        }
        Ok(())
    }

    /// Makes one trial. Whether there is more to do.
    pub fn advance_fit(&mut self) -> bool {
        let Some(running) = &mut self.fits.running else { return false };
        if !running.fit.advance() {
            return true;
        }
        if let Some(Running { job, task, mut fit }) = self.fits.running.take() {
            match fit.outcome() {
                Some(outcome) => {
                    let traces = fit.traces(POINTS_OF_A_CURVE);
                    self.take_outcome(job, task, outcome, traces);
                }
                None => self.announce(Announcement::FitFailed),
            }
        }
        let _ = self.next_fit();
        self.revision.fits += 1;
        if self.fits.running.is_none() {
            self.announce(Announcement::FitFinished);
        }
        self.fits.running.is_some()
    }

    /// Gives up what is being fitted.
    pub fn cancel_fit(&mut self) {
        if self.fits.running.take().is_some() {
            self.fits.queue.clear();
            self.revision.fits += 1;
            self.announce(Announcement::FitCancelled);
        }
    }

    /// How far the fits have come; none while nothing is fitted.
    pub fn fit_progress(&self) -> Option<FitProgress> {
        let Running { job, fit, .. } = self.fits.running.as_ref()?;
        Some(FitProgress {
            theory: job.document.edition(&self.language).title.clone(),
            trials: fit.trials(),
            explained: fit.explained(),
            finished: (self.fits.total - self.fits.queue.len() - 1, self.fits.total),
        })
    }

    /// The task of a job.
    fn task(&self, job: &Job) -> Result<Task, Refusal> {
        let unknown = || Refusal::Unknown { name: self.tongue.record().to_owned() };
        let mut record = self.record(job.record).ok_or_else(unknown)?.clone();
        let model = &job.document.model;
        if !job.own {
            let labels = |label: &str| {
                let languages = job.document.languages();
                languages.map(|language| job.document.text(language, label).to_lowercase()).collect()
            };
            record.origin = None;
            record.take_for(&job.document, &labels);
        }
        let method = job.document.method.as_deref().and_then(|name| name.parse::<Method>().ok()).unwrap_or_default();
        Ok(Task {
            parameters: job.parameters.clone(),
            method,
            origin: Some(record.origin(&model.independent.name, model.is_autonomous())),
            records: vec![analysis::fit::Record {
                name: record.name.clone(),
                observations: observations(&record, model),
                fixed: Vec::new(),
            }],
            varied: job.varied.clone(),
            from: self.fits.window[0],
            until: self.fits.window[1],
        })
    }
}

/// The columns that a fit follows.
fn observations(record: &Record, model: &model::Model) -> Vec<Observation> {
    let independent = &model.independent.name;
    let mut followed: Vec<usize> = Vec::new();
    let mut observations = Vec::new();
    for (column, used) in record.uses.iter().enumerate().filter(|(_, used)| used.fitted) {
        let name = &used.meaning.quantity;
        let Some(observed) = observed(model, name).filter(|_| !name.is_empty() && name != independent) else {
            continue;
        };
        if observed.dimension() != used.meaning.unit.dimension {
            continue;
        }
        let Some((times, values)) = record.series(column, independent) else { continue };
        let derived_from =
            record.computed_from(column).and_then(|source| followed.iter().position(|&own| own == source));
        followed.push(column);
        observations.push(Observation { name: name.clone(), observed, times, values, errors: None, derived_from });
    }
    observations
}

impl crate::words::Tongue {
    /// Why a fit cannot be made.
    pub(crate) fn fit_error(self, error: &FitError) -> String {
        let text = match error {
            FitError::NothingVaried => self.pick("Tick what is to be varied.", "Marca lo que debe variar."),
            FitError::NothingObserved => self.pick(
                "No column is ticked for the fit, or none of its values lies between the two times.",
                "Ninguna columna está marcada para el ajuste, o ninguno de sus valores cae entre los dos tiempos.",
            ),
            FitError::TooFew { values, varied } => {
                return self.pick(
                    format!("{values} values cannot determine {varied} numbers."),
                    format!("{values} valores no pueden determinar {varied} números."),
                );
            }
            FitError::TooLarge => self.pick(
                "There are too many values or too many varied numbers.",
                "Hay demasiados valores o demasiados números que varían.",
            ),
            FitError::VariedTwice(_) | FitError::BadBounds(_) => {
                self.pick("The ranges leave no room.", "Los intervalos no dejan sitio.")
            }
            FitError::Model(message) => return message.clone(),
        };
        text.to_owned()
    }
}

//! Documents as Python objects.

use crate::arguments::{Options, is_several};
use crate::diagnostic::Diagnostic;
use crate::disk::Disk;
use crate::errors::{diagnostics, failed, refused, unsound};
use crate::fit::Fit;
use crate::fitting;
use crate::keywords::in_keywords;
use crate::page;
use crate::settings::{Asked, Prepared};
use crate::sweeps::{self, Kept};
use crate::table::Table;
use engine::{Run, RunError, Subject};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use runner::fitting::Theory;
use runner::{Loaded, Refusal, Sources, place};
use std::path::Path;
use std::sync::{Arc, Mutex};
use units::Language;

/// Steps of a run after which signals are looked at.
const STEPS: u64 = 1 << 14;

/// Documents that were restored from pickles, the last one at the end. A worker gets the same document with each of its tasks.
static RESTORED: Mutex<Vec<Document>> = Mutex::new(Vec::new());

/// Greatest number of documents in [`RESTORED`].
const MOST_RESTORED: usize = 8;

/// A simulation: a document without errors.
#[pyclass(module = "meniscus", frozen, weakref)]
#[derive(Clone, Debug)]
pub struct Document {
    theory: Arc<Theory>,
    findings: Arc<[Diagnostic]>,
    /// Settings and plan of the last sweep; the next one with the same settings begins at once.
    prepared: Arc<Mutex<Option<Arc<Kept>>>>,
}

/// Opens a document.
///
/// `document` is a path (`pathlib.Path`, or a text without line breaks) of a document, a translation of it, an exported page or a
/// project; or the text of a document. `translations` are texts, for a document that is given as a text.
#[pyfunction]
#[pyo3(signature = (document, *, translations = Vec::new()))]
pub fn open(py: Python<'_>, document: &Bound<'_, PyAny>, translations: Vec<String>) -> PyResult<Document> {
    let sources = sources(document, translations)?;
    Document::open(py, sources)
}

/// All findings about a document, errors and warnings. The arguments are those of `open`.
#[pyfunction]
#[pyo3(signature = (document, *, translations = Vec::new()))]
pub fn check(py: Python<'_>, document: &Bound<'_, PyAny>, translations: Vec<String>) -> PyResult<Vec<Diagnostic>> {
    let sources = sources(document, translations)?;
    Ok(py.detach(|| diagnostics(&Loaded::open(sources))))
}

fn sources(document: &Bound<'_, PyAny>, translations: Vec<String>) -> PyResult<Sources> {
    if let Ok(text) = document.cast::<PyString>() {
        let text = text.to_str()?;
        if text.contains('\n') {
            return Ok(Sources::of_texts(named([text.to_owned()].into_iter().chain(translations))));
        }
    }
    let path: std::path::PathBuf = document.extract()?;
    let py = document.py();
    py.detach(|| runner::sources(&Disk, Path::new(&path))).map_err(|refusal| refused(py, &refusal))
}

/// Names of texts that are in no file.
fn named(texts: impl Iterator<Item = String>) -> Vec<(String, String)> {
    let name = |place: usize| if place == 0 { "document".to_owned() } else { format!("translation {place}") };
    texts.enumerate().map(|(place, text)| (name(place), text)).collect()
}

/// A run, or why there is none.
struct Made {
    table: runner::Table,
    notices: Vec<Diagnostic>,
    ended: Option<String>,
    /// Error that ended the run; its rows are lost.
    failure: Option<RunError>,
}

impl Document {
    fn open(py: Python<'_>, sources: Sources) -> PyResult<Self> {
        let loaded = py.detach(|| Loaded::open(sources));
        if loaded.opened.has_errors() {
            return Err(unsound(py, &loaded));
        }
        let findings = diagnostics(&loaded).into();
        let Some((sources, document)) = loaded.sound() else { return Err(crate::errors::value_error("no document")) };
        Ok(Self { theory: Arc::new(Theory { sources, document }), findings, prepared: Arc::default() })
    }

    /// The document as a theory of measured data.
    pub fn theory(&self) -> Theory {
        (*self.theory).clone()
    }

    fn texts(&self) -> Vec<(String, String)> {
        let texts = self.theory.sources.texts();
        texts.map(|(path, text)| (path.display().to_string(), text.to_owned())).collect()
    }
}

#[pymethods]
impl Document {
    /// Opens texts with their names, as pickles hold them: the document, then its translations.
    #[new]
    fn restore(py: Python<'_>, texts: Vec<(String, String)>) -> PyResult<Self> {
        let known = RESTORED.lock().ok().and_then(|known| known.iter().find(|one| one.texts() == texts).cloned());
        if let Some(known) = known {
            return Ok(known);
        }
        let document = Self::open(py, Sources::of_texts(texts))?;
        if let Ok(mut known) = RESTORED.lock() {
            if known.len() == MOST_RESTORED {
                known.remove(0);
            }
            known.push(document.clone());
        }
        Ok(document)
    }

    fn __getnewargs__(&self) -> (Vec<(String, String)>,) {
        (self.texts(),)
    }

    /// Identity for Dask: the texts.
    fn __dask_tokenize__(&self) -> Vec<(String, String)> {
        self.texts()
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.theory.sources.texts().eq(other.theory.sources.texts())
    }

    fn __hash__(&self) -> u64 {
        units::fnv::hashed(units::fnv::START, self.text().bytes())
    }

    fn __repr__(&self) -> String {
        format!("<Document {}>", self.title())
    }

    /// Title of the document.
    #[getter]
    fn title(&self) -> &str {
        &self.theory.document.program.title
    }

    /// Text of the document.
    #[getter]
    fn text(&self) -> &str {
        &self.theory.document.source
    }

    /// Parameters by name, each with its value in its declared unit, or with its word.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let model = &self.theory.document.program.model;
        let parameters = PyDict::new(py);
        for parameter in &model.parameters {
            match parameter.word(parameter.value, &model.texts) {
                Some(word) => parameters.set_item(&parameter.name, word)?,
                None => parameters.set_item(&parameter.name, parameter.unit.from_si(parameter.value))?,
            }
        }
        Ok(parameters)
    }

    /// Declared unit of each parameter by name; empty for pure numbers.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for parameter in &self.theory.document.program.model.parameters {
            units.set_item(&parameter.name, &parameter.unit.text)?;
        }
        Ok(units)
    }

    /// Page that plays the document: HTML for any browser, with the source inside.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        page::page(py, &self.theory)
    }

    /// The document in a notebook, as a widget of `anywidget`. Its `parameters` follow the sliders, and the sliders follow them.
    /// `height` in pixels.
    #[pyo3(signature = (*, height = 640))]
    fn widget<'py>(&self, py: Python<'py>, height: u32) -> PyResult<Bound<'py, PyAny>> {
        page::widget(py, &self.theory, self.parameters(py)?, height)
    }

    /// Findings about the document: its warnings, and with `claims` an error for each claim that its runs do not fulfil.
    #[pyo3(signature = (*, claims = false))]
    fn check(&self, py: Python<'_>, claims: bool) -> Vec<Diagnostic> {
        let mut findings = self.findings.to_vec();
        if claims {
            let Theory { sources, document } = &*self.theory;
            let failed = py.detach(|| runner::judged(document, Language::English));
            let failed = failed.iter().filter_map(runner::JudgedClaim::finding);
            findings.extend(failed.map(|finding| Diagnostic::new(sources, 0, &finding)));
        }
        findings
    }

    /// Runs the document from 0 to its end, or to `until`, and returns a table with a row for each step.
    ///
    /// Keyword arguments are values of parameters: a number in the declared unit, or a text with its own, `"3 cm"`. `set` is a
    /// dictionary of such values, for parameters with the name of an argument. `columns` chooses columns by their names.
    #[pyo3(signature = (**options))]
    #[pyo3(
        text_signature = "($self, *, until=None, columns=None, set=None, start=None, preset=None, press=None, draw=None, \
                             method=None, step=None, tolerance=None, seat=None, **parameters)"
    )]
    fn run(&self, py: Python<'_>, options: Option<&Bound<'_, PyDict>>) -> PyResult<Table> {
        let options = Options::new(py, options)?;
        let columns = options.names("columns")?;
        let asked = Asked::take(&options)?;
        let Theory { sources, .. } = &*self.theory;
        let prepared = py.detach(|| asked.prepare(&self.theory)).map_err(|refusal| refused(py, &refusal))?;
        let made = py.detach(|| made(&prepared, columns.as_deref(), sources))?;
        let made = made.map_err(|refusal| refused(py, &refusal))?;
        match made.failure {
            Some(error) => Err(failed(py, (sources, &prepared.document), &error)),
            None => Ok(Table::new(py, made.table, made.notices, made.ended)),
        }
    }

    /// Runs the document with many values of its parameters, on all processors, and returns a table with a row for each run.
    ///
    /// `over`: values by the name of the parameter, numbers in the declared unit, words of a choice, or a text such as `"0..100
    /// [kg/s] step 2"`; of several parameters, all combinations. `keep`: what is kept of each run, such as `"y at end"` or
    /// `"maximum(y) from 2 [s] in [cm]"`. `random` and `halton` take so many samples of the ranges instead of all combinations.
    /// `shard=(3, 16)` computes the third of 16 equal parts. The other arguments are those of `run`.
    #[pyo3(signature = (over, keep, **options))]
    #[pyo3(
        text_signature = "($self, over, keep, *, random=None, halton=None, seed=1, shard=None, until=None, set=None, start=None, \
                             preset=None, press=None, draw=None, method=None, step=None, tolerance=None, seat=None, **parameters)"
    )]
    fn sweep(
        &self,
        py: Python<'_>,
        over: &Bound<'_, PyAny>,
        keep: &Bound<'_, PyAny>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Table> {
        let options = Options::new(py, options)?;
        let request = sweeps::Request::take(over, keep, &options)?;
        let known = self.prepared.lock().ok().and_then(|prepared| prepared.clone());
        let kept = request.prepare(py, &self.theory, known)?;
        if let Ok(mut prepared) = self.prepared.lock() {
            *prepared = Some(kept.clone());
        }
        request.compute(py, &self.theory.sources, &kept)
    }

    /// Fits the document to measured data and returns a `Fit`.
    ///
    /// `data`: a path of a file, a `Table`, a DataFrame or a dictionary of columns, whose names may have units, `"t [s]"`; or a
    /// list of them, one for each run. `observe`: the measured quantity, or a dictionary with the column of each. `vary`, `fix`,
    /// `start`, `bounds`, `share` and `error` say what is varied and how the search begins, by the names of parameters.
    #[pyo3(signature = (data, observe, **options))]
    #[pyo3(
        text_signature = "($self, data, observe, *, vary=None, fix=None, start=None, bounds=None, share=None, error=None, \
                             loss='least-squares', begin=None, until=None, against=None, unit=None, seat=None, profile=False)"
    )]
    fn fit(
        &self,
        py: Python<'_>,
        data: &Bound<'_, PyAny>,
        observe: &Bound<'_, PyAny>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Fit> {
        let options = Options::new(py, options)?;
        let profile = options.get("profile")?.unwrap_or(false);
        let settings = fitting::settings(observe, &options)?;
        options.finish()?;
        let data = fitting::records(data, is_several(data))?;
        fitting::fit(py, self.theory(), &data, &settings, profile)
    }
}

/// Makes a run. The outer error is a signal, such as an interrupt by the keyboard.
fn made(prepared: &Prepared, columns: Option<&[String]>, sources: &Sources) -> PyResult<Result<Made, Refusal>> {
    let Prepared { document, setup, until } = prepared;
    let model = &document.program.model;
    let mut reader = match columns {
        None => engine::table::Table::new(model),
        Some(columns) => {
            let names: Vec<&str> = columns.iter().flat_map(|text| runner::names::names_in(text)).collect();
            match runner::chosen_columns(model, &names) {
                Ok(table) => table,
                Err(refusal) => return Ok(Err(refusal)),
            }
        }
    };
    let mut made = Made { table: runner::Table::of_run(&reader), notices: Vec::new(), ended: None, failure: None };
    let mut run = match Run::start(model, setup.clone()) {
        Ok(run) => run,
        Err(error) => return Ok(Ok(Made { failure: Some(error), ..made })),
    };
    let steps = match runner::steps(&run, *until) {
        Ok(steps) => steps,
        Err(refusal) => return Ok(Err(refusal)),
    };
    let failure = runner::follow(&mut run, (steps, *until), |history, rows, done| {
        made.table.take(&mut reader, history, rows);
        if done % STEPS == 0 { Python::attach(|py| py.check_signals()) } else { Ok(()) }
    })?;
    for notice in run.notices() {
        let span = place(document, notice.subject().unwrap_or(Subject::State(0))).unwrap_or_default();
        let found = model::Diagnostic::warning(notice.code(), notice.message(model), span).with_hint(notice.hint());
        made.notices.push(Diagnostic::new(sources, 0, &found));
    }
    match failure {
        Some(error) if error.is_end() => made.ended = Some(in_keywords(&error.message(model).english())),
        failure => made.failure = failure,
    }
    Ok(Ok(made))
}

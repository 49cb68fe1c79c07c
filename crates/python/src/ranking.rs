//! Rankings of documents from Python arguments.

use crate::arguments::{Options, is_several};
use crate::document::Document;
use crate::errors::refused;
use crate::fit::Fit;
use crate::fitting::{notes, read, records, settings};
use analysis::fit::Outcome;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use runner::Refusal;
use runner::fitting::{Contender, Theory, fit_as_text, ranking_as_json};

/// Fits several documents to the same data and returns the fits, best first by AICc. The arguments are those of `Document.fit`;
/// with `predict_from`, each document is also fitted to what is before that time alone.
#[pyfunction]
#[pyo3(signature = (data, documents, observe, **options))]
#[pyo3(
    text_signature = "(data, documents, observe, *, predict_from=None, vary=None, fix=None, start=None, bounds=None, share=None, \
                         error=None, loss='least-squares', begin=None, until=None, against=None, unit=None, seat=None)"
)]
pub fn rank(
    py: Python<'_>,
    data: &Bound<'_, PyAny>,
    documents: Vec<Py<Document>>,
    observe: &Bound<'_, PyAny>,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<Vec<Fit>> {
    let options = Options::new(py, options)?;
    let predict_from = options.value("predict_from")?;
    let settings = settings(observe, &options)?;
    options.finish()?;
    let records = records(data, is_several(data))?;
    let theories: Vec<Theory> = documents.iter().map(|document| document.get().theory()).collect();
    let done = py.detach(|| {
        let Some(first) = theories.first() else { return Err(Refusal::request("there are no documents")) };
        let data = read(&records, first, &settings)?;
        let contend = |theory: &Theory| {
            let asked = (&settings, predict_from.as_deref());
            Contender::complete(theory.clone(), &data, asked, &mut |_| {}, &mut |_| {})
        };
        let contenders: Vec<Contender> = theories.iter().map(contend).collect::<Result<_, _>>()?;
        let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
        let ranked = analysis::fit::rank(&outcomes);
        let json = ranking_as_json(&contenders, &ranked, &data);
        let rows = json.as_array().cloned().unwrap_or_default();
        let order: Vec<usize> = ranked.iter().map(|ranked| ranked.index).collect();
        let texts: Vec<String> =
            order.iter().map(|index| fit_as_text(&contenders[*index].fitted, &notes(&data))).collect();
        Ok((rows, order, texts, contenders))
    });
    let (rows, order, texts, contenders) = done.map_err(|refusal| refused(py, &refusal))?;
    let fits = rows.iter().zip(order).zip(texts);
    fits.map(|((row, index), text)| Fit::new(py, &row.to_string(), text, &contenders[index].fitted)).collect()
}

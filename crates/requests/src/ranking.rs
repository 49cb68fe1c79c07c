//! Rankings of documents by their fits.

use crate::arguments::{Given, text};
use crate::fault::{Fault, read};
use crate::fitting::{Answer, Asked, Record, records};
use crate::host::Host;
use crate::opened::Opened;
use crate::reply::Reply;
use analysis::fit::Outcome;
use runner::Refusal;
use runner::fitting::{Contender, ranking_as_json};
use serde::Deserialize;

/// A ranking that is asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    data: Vec<Record>,
    settings: Asked,
    predict_from: Option<Given>,
}

/// Fits several documents to the same data and returns the fits, best first by AICc.
pub fn rank(host: &dyn Host, documents: &[&Opened], request: &str, numbers: &[Vec<f64>]) -> Result<Reply, Fault> {
    let Request { data, settings, predict_from } = read(request)?;
    let (settings, predict_from) = (settings.settings()?, text(predict_from.as_ref()));
    let Some(first) = documents.first() else { return Err(Refusal::request("there are no documents").into()) };
    let data = records(host, &data, numbers, (first.theory(), &settings))?;
    let contend = |document: &&Opened| {
        let asked = (&settings, predict_from.as_deref());
        Contender::complete(document.theory().clone(), &data, asked, &mut |_| {}, &mut |_| {})
    };
    let contenders: Vec<Contender> = documents.iter().map(contend).collect::<Result<_, _>>()?;
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let ranked = analysis::fit::rank(&outcomes);
    let mut summaries = ranking_as_json(&contenders, &ranked, &data);
    let summaries = summaries.as_array_mut().map(std::mem::take).unwrap_or_default();
    let mut buffers = Vec::new();
    let fits = ranked.iter().zip(summaries);
    let fits =
        fits.map(|(ranked, summary)| Answer::new(summary, &contenders[ranked.index].fitted, &data, &mut buffers));
    let fits: Vec<Answer> = fits.collect();
    Ok(Reply::with_buffers(&fits, buffers)?)
}

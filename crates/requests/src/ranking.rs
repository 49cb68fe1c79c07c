//! Rankings of documents by their fits.

use crate::arguments::{Given, text};
use crate::fault::{Fault, read};
use crate::fitting::{Answer, Asked, Record, records};
use crate::host::Host;
use crate::opened::Opened;
use crate::reply::Reply;
use analysis::fit::Outcome;
use runner::fitting::{Contender, Theory, ranking_as_json};
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
    let mut theories: Vec<Theory> = documents.iter().map(|document| document.theory().clone()).collect();
    let data = records(host, &data, numbers, (&mut theories, &settings))?;
    let contend = |theory: Theory| {
        let asked = (&settings, predict_from.as_deref());
        Contender::complete(theory, &data, asked, &mut |_| {}, &mut |_| true)
    };
    let contenders: Vec<Contender> = theories.into_iter().map(contend).collect::<Result<_, _>>()?;
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

//! Requests by their names.

use crate::fault::{Fault, read};
use crate::host::Host;
use crate::opened::{self, Opened};
use crate::reply::Reply;
use crate::{fitting, ranking, runs, sweeps};

/// Fulfils a request. `documents`: those that it is about; `numbers`: the arrays to which it refers by their places.
pub fn call(host: &dyn Host, name: &str, documents: &[&Opened], request: &str, numbers: &[Vec<f64>]) -> Reply {
    let answered = match (name, documents) {
        ("check", []) => opened::check(host, request),
        ("nearest", []) => nearest(request),
        ("rank", _) => ranking::rank(host, documents, request, numbers),
        ("findings", [document]) => document.findings(request),
        ("page", [document]) => document.page(host),
        ("run", [document]) => runs::run(host, document, request),
        ("sweep", [document]) => sweeps::sweep(host, document, request, numbers),
        ("fit", [document]) => fitting::fit(host, document, request, numbers),
        _ => Err(Fault::Value(format!("there is no request `{name}` about {} documents", documents.len()))),
    };
    answered.unwrap_or_else(|fault| fault.reply())
}

/// The name that a person may have meant: `null` if none is near.
fn nearest(request: &str) -> Result<Reply, Fault> {
    let (name, known): (String, Vec<String>) = read(request)?;
    Ok(Reply::new(&units::nearest(&name, known.iter().map(String::as_str)))?)
}

//! Documents, opened once for all requests about them.

use crate::diagnostic::Diagnostic;
use crate::fault::{Fault, diagnostics, read};
use crate::host::Host;
use crate::prepared::Kept;
use crate::reply::Reply;
use runner::fitting::Theory;
use runner::{Loaded, Sources};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use units::Language;

/// A document without errors.
#[derive(Clone, Debug)]
pub struct Opened {
    theory: Arc<Theory>,
    findings: Arc<[Diagnostic]>,
    /// Settings and plan of the last sweep; the next one with the same settings begins at once.
    kept: Arc<Mutex<Option<Arc<Kept>>>>,
}

/// A document that is asked for.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Request {
    /// Path of a document, a translation, an exported page or a project.
    Path(PathBuf),
    /// Names and texts, the document first, then its translations.
    Texts(Vec<(String, String)>),
}

/// The part of an opened document that Python keeps.
#[derive(Serialize)]
struct Answer<'a> {
    title: &'a str,
    texts: Vec<(String, &'a str)>,
    /// Name, value in the declared unit or word, and declared unit of each parameter.
    parameters: Vec<(&'a str, Setting<'a>, &'a str)>,
}

/// Value of a parameter.
#[derive(Serialize)]
#[serde(untagged)]
enum Setting<'a> {
    Number(f64),
    Word(&'a str),
}

/// Opens a document. The reply has the errors of a document that is not opened.
pub fn open(host: &dyn Host, request: &str) -> (Option<Opened>, Reply) {
    let opened = loaded(host, request).and_then(Opened::new);
    let answered = opened.and_then(|opened| Ok((opened.answer()?, opened)));
    match answered {
        Ok((reply, opened)) => (Some(opened), reply),
        Err(fault) => (None, fault.reply()),
    }
}

/// All findings about a document, errors and warnings.
pub fn check(host: &dyn Host, request: &str) -> Result<Reply, Fault> {
    Ok(Reply::new(&diagnostics(&loaded(host, request)?))?)
}

fn loaded(host: &dyn Host, request: &str) -> Result<Loaded, Fault> {
    let sources = match read(request)? {
        Request::Path(path) => runner::sources(host, &path)?,
        Request::Texts(texts) => Sources::of_texts(texts),
    };
    Ok(Loaded::open(sources))
}

impl Opened {
    fn new(loaded: Loaded) -> Result<Self, Fault> {
        let findings = diagnostics(&loaded);
        match loaded.sound() {
            Some((sources, document)) => Ok(Self {
                theory: Arc::new(Theory { sources, document }),
                findings: findings.into(),
                kept: Arc::default(),
            }),
            None => Err(Fault::Document(findings)),
        }
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let program = &self.theory.document.program;
        let texts = self.theory.sources.texts();
        let parameters = program.model.parameters.iter().map(|parameter| {
            let value = match parameter.word(parameter.value, &program.model.texts) {
                Some(word) => Setting::Word(word),
                None => Setting::Number(parameter.unit.from_si(parameter.value)),
            };
            (parameter.name.as_str(), value, parameter.unit.text.as_str())
        });
        Ok(Reply::new(&Answer {
            title: &program.title,
            texts: texts.map(|(path, text)| (path.display().to_string(), text)).collect(),
            parameters: parameters.collect(),
        })?)
    }

    /// The document as a theory of measured data.
    pub(crate) fn theory(&self) -> &Theory {
        &self.theory
    }

    /// Preparation of the last sweep.
    pub(crate) fn last_sweep(&self) -> Option<Arc<Kept>> {
        self.kept.lock().ok().and_then(|kept| kept.clone())
    }

    pub(crate) fn keep(&self, prepared: &Arc<Kept>) {
        if let Ok(mut kept) = self.kept.lock() {
            *kept = Some(prepared.clone());
        }
    }

    /// Warnings about the document; with `claims` an error for each claim that its runs do not fulfil.
    pub(crate) fn findings(&self, request: &str) -> Result<Reply, Fault> {
        #[derive(Deserialize)]
        struct Request {
            claims: bool,
        }
        let Request { claims } = read(request)?;
        let mut findings = self.findings.to_vec();
        if claims {
            let Theory { sources, document } = &*self.theory;
            let failed = runner::judged(document, Language::English);
            let failed = failed.iter().filter_map(runner::JudgedClaim::finding);
            findings.extend(failed.map(|finding| Diagnostic::new(sources, 0, &finding)));
        }
        Ok(Reply::new(&findings)?)
    }

    /// Page that plays the document and contains its source.
    pub(crate) fn page(&self, host: &dyn Host) -> Result<Reply, Fault> {
        const WITHOUT: &str =
            "this package was built without the player: run `cargo xtask page`, then build the wheel again";
        let player = host.player().ok_or_else(|| Fault::Value(WITHOUT.to_owned()))?;
        let Theory { sources, document } = &*self.theory;
        Ok(Reply::new(&runner::page::played(&player, &sources.embedded(), &document.program)?)?)
    }
}

//! One proposed claim.

use units::{Language, Words};

/// A claim that follows from the text of a document.
#[derive(Clone, Debug)]
pub struct Proposal {
    /// Name of its kind in [`super::KINDS`].
    pub kind: &'static str,
    /// Name or names that the claim is about: `E`.
    pub subject: String,
    /// Assignments of its run, such as `b = 0 [kg/s]`; empty for the run of the document.
    pub setup: Vec<String>,
    /// Name of the claim, in the language of the document.
    pub name: String,
    /// The claim, such as `E within 0.01 % of E(0) always`.
    pub claim: String,
    /// Reason why the claim should hold.
    pub why: Words,
    /// Sentence for a claim that does not hold; `None` if a failure has a harmless reason.
    pub suspicion: Option<Words>,
    /// True if the claim says nothing new where it holds, so that only a failure is worth a look.
    pub routine: bool,
}

impl Proposal {
    /// Name under which an author declines it: `energy E`.
    pub fn key(&self) -> String {
        format!("{} {}", self.kind, self.subject)
    }

    /// The lines of a check, without a line end. A claim about the run of the document has to stand before other
    /// assignments.
    pub fn lines(&self) -> String {
        let claim = format!("\"{}\": {}", self.name, self.claim);
        if self.setup.is_empty() { claim } else { format!("set: {}\n{claim}", self.setup.join(", ")) }
    }
}

/// Text of a claim's name in the language of a document, without the quotation marks that would end it.
pub(super) fn named(language: &str, name: &Words) -> String {
    name.text(Language::of(language)).replace('"', "'")
}

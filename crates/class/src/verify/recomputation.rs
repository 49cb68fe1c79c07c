//! Computing the values of a hand-in from its work.

use desk::play::SeatView;
use desk::{Desk, OpenedDocuments, play};
use saved::hand_in::{Fact, Sender};
use saved::project::Project;
use units::{Words, words};

/// A laboratory in which the work of a hand-in is done again.
#[derive(Debug)]
pub struct Recomputation {
    desk: Desk,
    /// A sentence for each part that could not be restored.
    refused: Vec<Words>,
}

impl Recomputation {
    /// Opens the document of a work in its state, and restores its records, films, fits and answers.
    ///
    /// # Errors
    /// If the document has errors.
    pub fn begin(work: &Project) -> Result<Self, Words> {
        let mut documents = OpenedDocuments::default();
        let mut recomputation = Self::begin_with(work, &mut documents).ok_or_else(document_has_errors)?;
        recomputation.desk.exchange_documents(&mut documents);
        Ok(recomputation)
    }

    /// As [`Recomputation::begin`]; a document among `documents` is not opened again. `None` if the document has errors.
    pub fn begin_with(work: &Project, documents: &mut OpenedDocuments) -> Option<Self> {
        let texts: Vec<String> = work.documents.iter().map(|file| file.text.clone()).collect();
        let document = documents.open(&texts)?;
        let mut desk = Desk::open(document);
        let mut refused = Vec::new();
        if !work.state.is_empty()
            && let Err(why) = desk::restore(&mut desk, &work.state).1
        {
            refused.push(state_refused(&why));
        }
        refused.extend(desk::take_project_items(&mut desk, &work.items));
        Some(Self { desk, refused })
    }

    /// Opens a work and finishes its fits.
    ///
    /// # Errors
    /// If the document has errors.
    pub fn complete(work: &Project) -> Result<Self, Words> {
        let mut recomputation = Self::begin(work)?;
        while recomputation.advance() {}
        Ok(recomputation)
    }

    /// Works on the fits for one trial. Returns false if all are finished.
    pub fn advance(&mut self) -> bool {
        self.desk.advance_fit()
    }

    /// As [`Recomputation::advance`], with the same documents as in [`Recomputation::begin_with`].
    pub fn advance_with(&mut self, documents: &mut OpenedDocuments) -> bool {
        self.desk.exchange_documents(documents);
        let has_more = self.desk.advance_fit();
        self.desk.exchange_documents(documents);
        has_more
    }

    /// Number of parts of the work that could not be restored.
    pub fn refused(&self) -> usize {
        self.refused.len()
    }

    /// A sentence for each part of the work that could not be restored, and for each fit that could not be repeated.
    pub fn left_out(&self) -> impl Iterator<Item = &Words> {
        self.refused.iter().chain(self.desk.fits().lost())
    }

    /// The sender with the seat and the assignment of the work.
    ///
    /// # Errors
    /// If the document assigns values and the sender states another seat or assignment.
    pub(super) fn seated(&self, sender: Sender) -> Result<Sender, Words> {
        let Some(SeatView { assignment, number }) = self.desk.play().basis().seat() else { return Ok(sender) };
        if let Some(stated) = sender.seat.filter(|stated| number != Some(*stated)) {
            return Err(match number {
                Some(own) => words!("has the values of seat {own}, not of seat {stated}"),
                None => words!("has the values of no seat, not of seat {stated}"),
            });
        }
        if !sender.assignment.is_empty() && sender.assignment != assignment {
            return Err(words!("belongs to the assignment {assignment}, not to {stated}", stated = sender.assignment));
        }
        Ok(Sender { seat: number, assignment, ..sender })
    }

    /// The values that follow from the work.
    pub fn facts(self) -> Vec<Fact> {
        desk::facts(&self.desk)
    }

    /// The laboratory with the work, its texts in this language, and the values that follow from the work.
    pub(crate) fn finish(mut self, language: &str) -> (Desk, Vec<Fact>) {
        let facts = desk::facts(&self.desk);
        self.desk.set_language(language);
        (self.desk, facts)
    }
}

/// Reason why a hand-in cannot be computed.
pub(crate) fn document_has_errors() -> Words {
    words("the document of the hand-in has errors")
}

fn state_refused(why: &play::Refusal) -> Words {
    match why {
        play::Refusal::PartlyRestored { left_out } => {
            let parts = left_out.join(", ");
            words!("state of the run: these parts do not fit the document: {parts}")
        }
        _ => words("state of the run: it cannot be read"),
    }
}

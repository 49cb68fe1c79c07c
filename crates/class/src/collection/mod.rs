//! The hand-ins of a class. They are added as they arrive, and computed again one after the other in small steps, so that a
//! page reacts in between.
//!
//! The last hand-in of each sender counts. `Collection::advance` computes for one trial of a fit or one comparison of data;
//! all hand-ins are computed before data are compared. Everything shown is a fold over the finished `Work`s: curves,
//! questions, who is stuck.

mod computed;
mod curves;
mod documents;
mod live;
mod questions;
mod references;
mod snapshots;
mod stuck;
mod work;

pub use computed::{Calculator, Computed, WorkOrder};
pub use curves::{CurveGroup, Member};
pub use questions::{ErrorKind, QuestionTally};
pub use references::References;
pub use snapshots::{Snapshot, Snapshots};
pub use stuck::Stuck;
pub use work::Work;

use crate::grading::GivenAnswer;
use crate::results::{Quantity, quantities};
use crate::verify::documents::is_same;
use crate::verify::{Copied, Curve, DocumentDifference, Recomputation, copied, document_has_errors};
use desk::{OpenedDocuments, TheoryCurve};
use document::page::Source;
use saved::hand_in::{HAND_IN_ENDING, HandIn, HandInError};
use std::collections::{BTreeSet, VecDeque};
use units::{Language, Words, words};

/// A file that was added.
#[derive(Debug)]
pub struct Entry {
    file: String,
    content: Result<HandIn, HandInError>,
    state: State,
    /// The measured columns of a hand-in that counts, in the form in which copies are found.
    columns: Vec<Curve>,
    /// How its document differs from the teacher's or from that of most others.
    document: Option<DocumentDifference>,
}

/// State of a file.
#[derive(Debug)]
pub enum State {
    /// It cannot be read or computed, for this reason.
    Unreadable(Words),
    /// The hand-in of this index was made later by the same sender and counts.
    Repeated(usize),
    /// It will be computed again. Until then the work of its former form counts, if it has one.
    Waiting(Option<Box<Work>>),
    /// It was computed again.
    Done(Box<Work>),
}

impl Entry {
    /// Name of the file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The hand-in, if the file is one.
    pub fn hand_in(&self) -> Option<&HandIn> {
        self.content.as_ref().ok()
    }

    /// Pseudonym or name of the sender; the name of the file if there is none, as for a report.
    pub fn sender(&self) -> &str {
        let name = self.hand_in().map(|hand_in| &hand_in.sender.name);
        name.filter(|name| !name.is_empty()).unwrap_or(&self.file)
    }

    /// How its document differs from the teacher's, or without one from that of most others; `None` if it does not.
    pub fn document(&self) -> Option<&DocumentDifference> {
        self.document.as_ref()
    }

    /// True if it can be read and no later hand-in of the same sender counts.
    fn counts(&self) -> bool {
        !matches!(self.state, State::Repeated(_) | State::Unreadable(_))
    }

    /// State of the file.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The last computed work of a hand-in that counts.
    pub fn work(&self) -> Option<&Work> {
        match &self.state {
            State::Done(work) | State::Waiting(Some(work)) => Some(work),
            _ => None,
        }
    }
}

/// Work in progress.
#[derive(Debug)]
enum Step {
    /// The fits of a hand-in are repeated.
    Fitting(usize, Box<Recomputation>),
    /// The data of a hand-in are compared with those of the hand-ins from this index on.
    Comparing(usize, usize),
}

/// The hand-ins of a class.
#[derive(Debug)]
pub struct Collection {
    language: Language,
    entries: Vec<Entry>,
    step: Option<Step>,
    /// Hand-ins that are computed elsewhere.
    ordered: BTreeSet<usize>,
    /// Hand-ins of which a former form is being computed, here or elsewhere.
    superseded: BTreeSet<usize>,
    /// Documents opened for earlier hand-ins.
    documents: OpenedDocuments,
    /// Computed hand-ins whose data are still to be compared.
    uncompared: VecDeque<usize>,
    copies: Vec<Copied>,
    /// Curves of the theories, those of a theory from the first hand-in with it, and the index of that hand-in.
    theories: Vec<(usize, TheoryCurve)>,
    references: References,
    /// True if the documents were compared since the last change.
    are_documents_compared: bool,
}

impl Collection {
    /// An empty collection. `language`: language of the questions.
    pub fn new(language: Language) -> Self {
        Self {
            language,
            entries: Vec::new(),
            step: None,
            ordered: BTreeSet::new(),
            superseded: BTreeSet::new(),
            documents: OpenedDocuments::default(),
            uncompared: VecDeque::new(),
            copies: Vec::new(),
            theories: Vec::new(),
            references: References::default(),
            are_documents_compared: true,
        }
    }

    /// True if a file of a folder can be a hand-in, or a page that carries one, by its name.
    pub fn is_candidate(name: &str) -> bool {
        let name = name.to_lowercase();
        [HAND_IN_ENDING, ".html", ".htm"].iter().any(|ending| name.ends_with(ending))
    }

    /// Adds a file of a folder, as [`Collection::add`]. A page without the data of a hand-in is left out; the result is then
    /// false.
    pub fn add_of_folder(&mut self, file: &str, content: Result<HandIn, HandInError>) -> bool {
        let is_taken = content != Err(HandInError::NoData);
        if is_taken {
            self.add(file, content);
        }
        is_taken
    }

    /// Adds the file of this name. Of several hand-ins of a sender the one that was made last counts, of equal times the
    /// one added last. Reports have no sender, and each counts.
    pub fn add(&mut self, file: &str, content: Result<HandIn, HandInError>) {
        let index = self.entries.len();
        let mut state = State::Waiting(None);
        match &content {
            Err(error) => state = State::Unreadable(error.words()),
            Ok(hand_in) => {
                if let Some(counting) = self.counting(hand_in) {
                    let before = self.entries[counting].hand_in().map_or(0, |before| before.made);
                    if hand_in.made < before {
                        state = State::Repeated(counting);
                    } else {
                        self.replace(counting, index);
                    }
                }
            }
        }
        self.entries.push(Entry { file: file.to_owned(), content, state, columns: Vec::new(), document: None });
        self.are_documents_compared = false;
    }

    /// Index of the hand-in of the same sender that counts so far.
    fn counting(&self, hand_in: &HandIn) -> Option<usize> {
        if hand_in.sender.name.is_empty() {
            return None;
        }
        let counts = |entry: &Entry| !matches!(entry.state, State::Repeated(_));
        let same = |entry: &Entry| entry.hand_in().is_some_and(|other| other.sender == hand_in.sender);
        self.entries.iter().position(|entry| counts(entry) && same(entry))
    }

    /// Another hand-in counts instead of this one, and of those that it had replaced.
    fn replace(&mut self, former: usize, index: usize) {
        for (place, entry) in self.entries.iter_mut().enumerate() {
            if place == former {
                entry.columns.clear();
            }
            if place == former || matches!(entry.state, State::Repeated(counting) if counting == former) {
                entry.state = State::Repeated(index);
            }
        }
        self.copies.retain(|copied| copied.one.0 != former && copied.other.0 != former);
    }

    /// Removes everything.
    pub fn clear(&mut self) {
        let references = std::mem::take(&mut self.references);
        *self = Self { references, ..Self::new(self.language) };
    }

    /// The files in the order in which they were added.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Pseudonym or name of the sender of a hand-in; empty if there is none.
    pub fn sender(&self, hand_in: usize) -> &str {
        self.entries.get(hand_in).map_or("", Entry::sender)
    }

    /// The answer of a group at this place of [`Work::answers`].
    pub fn answer(&self, hand_in: usize, answer: usize) -> Option<&GivenAnswer> {
        self.entries.get(hand_in)?.work()?.answers.get(answer)
    }

    /// Number of hand-ins whose last form is computed.
    pub fn computed(&self) -> usize {
        self.entries.iter().filter(|entry| matches!(entry.state, State::Done(_))).count()
    }

    /// Number of hand-ins that are still to be computed.
    pub fn waiting(&self) -> usize {
        self.entries.iter().filter(|entry| matches!(entry.state, State::Waiting(_))).count()
    }

    /// Number of computed hand-ins whose data are still to be compared with those of others.
    pub fn uncompared(&self) -> usize {
        self.uncompared.len() + usize::from(matches!(self.step, Some(Step::Comparing(..))))
    }

    /// Measured data that two hand-ins share.
    pub fn copies(&self) -> &[Copied] {
        &self.copies
    }

    /// A derived quantity of a theory against a parameter, with the other values of the first fit with that theory.
    pub fn theory_curve(&self, theory: &str, quantity: &str, parameter: &str) -> Option<&TheoryCurve> {
        let is_asked = |curve: &&TheoryCurve| {
            (&*curve.theory, &*curve.quantity, &*curve.parameter) == (theory, quantity, parameter)
        };
        self.theories.iter().map(|(_, curve)| curve).find(is_asked)
    }

    /// Works for one trial of a fit or one comparison. All hand-ins are computed before their data are compared. Returns false
    /// if nothing is left to do.
    pub fn advance(&mut self) -> bool {
        match self.step.take() {
            None => return self.begin() || self.begin_comparing() || self.compare_documents(),
            Some(Step::Fitting(index, mut recomputation)) if self.is_waiting(index) => {
                if recomputation.advance_with(&mut self.documents) {
                    self.step = Some(Step::Fitting(index, recomputation));
                } else {
                    let is_known = |theory: &str| self.theories.iter().any(|(_, curve)| curve.theory == theory);
                    let items = self.entries[index].hand_in().map_or(&[][..], |hand_in| &hand_in.work.items);
                    let reference = self.other_reference(index);
                    let computed = Computed::of(*recomputation, (items, reference), self.language.tag(), is_known);
                    self.finish(index, Some(computed));
                }
            }
            Some(Step::Comparing(index, other)) if other < self.entries.len() => {
                self.compare(index, other);
                self.step = Some(Step::Comparing(index, other + 1));
            }
            Some(Step::Fitting(..) | Step::Comparing(..)) => {}
        }
        true
    }

    fn is_waiting(&self, index: usize) -> bool {
        self.entries.get(index).is_some_and(|entry| matches!(entry.state, State::Waiting(_)))
    }

    /// Opens the next hand-in. Returns false if there is none.
    fn begin(&mut self) -> bool {
        let Some(index) = self.next_waiting() else { return false };
        let Ok(hand_in) = &self.entries[index].content else { return false };
        match Recomputation::begin_with(&hand_in.work, &mut self.documents) {
            Some(recomputation) => self.step = Some(Step::Fitting(index, Box::new(recomputation))),
            None => self.finish(index, None),
        }
        true
    }

    /// The next hand-in that is neither computed nor ordered.
    fn next_waiting(&self) -> Option<usize> {
        (0..self.entries.len()).find(|index| self.is_waiting(*index) && !self.ordered.contains(index))
    }

    /// Orders the next hand-in to be computed elsewhere: its index, and what a [`Calculator`] needs. `None` if none waits.
    pub fn order(&mut self) -> Option<(usize, WorkOrder)> {
        let index = self.next_waiting()?;
        let hand_in = self.entries[index].hand_in()?;
        let order = WorkOrder::new(&hand_in.work, self.other_reference(index), self.language.tag());
        self.ordered.insert(index);
        Some((index, order))
    }

    /// The teacher's document of a hand-in whose own is not the same.
    fn other_reference(&self, index: usize) -> Option<&[Source]> {
        let files = &self.entries.get(index)?.hand_in()?.work.documents;
        self.reference(files).filter(|reference| !is_same(files, reference))
    }

    /// Takes what was ordered for the hand-in of this index; `None` if its document has errors.
    pub fn deliver(&mut self, index: usize, computed: Option<Computed>) {
        if self.ordered.remove(&index) && self.is_waiting(index) {
            self.finish(index, computed);
        }
    }

    /// The computation of the hand-in of this index has stopped because of a fault of the program.
    pub fn fail(&mut self, index: usize) {
        if self.ordered.remove(&index) && !self.superseded.remove(&index) && self.is_waiting(index) {
            self.entries[index].state = State::Unreadable(words(
                "its computation has stopped because of a fault in the program; verify it alone",
            ));
            self.uncompared.push_back(index);
        }
    }

    /// Takes the order of a hand-in back.
    pub fn take_back(&mut self, index: usize) {
        self.ordered.remove(&index);
        self.superseded.remove(&index);
    }

    /// Reads the columns of the next hand-in to be compared. Returns false if there is none.
    fn begin_comparing(&mut self) -> bool {
        let Some(index) = self.uncompared.pop_front() else { return false };
        if let Some(entry) = self.entries.get_mut(index)
            && let (Ok(hand_in), false) = (&entry.content, matches!(entry.state, State::Repeated(_)))
        {
            entry.columns = Curve::of(index, hand_in);
            self.step = Some(Step::Comparing(index, 0));
        }
        true
    }

    fn finish(&mut self, index: usize, computed: Option<Computed>) {
        let is_former = self.superseded.remove(&index);
        let entry = &mut self.entries[index];
        let Ok(hand_in) = &entry.content else { return };
        entry.state = match computed {
            None if is_former => return,
            Some(mut computed) => {
                take_curves(&mut self.theories, index, std::mem::take(&mut computed.theories));
                let work = Box::new(computed.work_of(hand_in));
                if is_former {
                    entry.state = State::Waiting(Some(work));
                    return;
                }
                State::Done(work)
            }
            None => State::Unreadable(document_has_errors()),
        };
        // A former form may have been compared.
        entry.columns.clear();
        self.copies.retain(|copied| copied.one.0 != index && copied.other.0 != index);
        self.uncompared.retain(|other| *other != index);
        self.uncompared.push_back(index);
    }

    /// Compares the data of a hand-in with those of another one that was computed before.
    fn compare(&mut self, index: usize, other: usize) {
        let columns = |index: usize| self.entries.get(index).map_or(&[][..], |entry| &entry.columns);
        if index == other {
            return;
        }
        let mut found = Vec::new();
        for column in columns(other) {
            found.extend(columns(index).iter().filter_map(|own| copied(column, own)));
        }
        // A pair is compared once: when the later of its two hand-ins is finished. A hand-in that is computed again has been
        // compared before.
        let known = |new: &Copied| self.copies.iter().any(|old| old.one == new.other && old.other == new.one);
        found.retain(|new| !known(new));
        self.copies.append(&mut found);
    }

    /// The hand-ins that count and are computed: index and work.
    pub fn works(&self) -> impl Iterator<Item = (usize, &Work)> {
        self.entries.iter().enumerate().filter_map(|(index, entry)| Some((index, entry.work()?)))
    }

    /// The quantities fitted by the groups, pooled.
    pub fn quantities(&self) -> Vec<Quantity> {
        quantities(self.works().map(|(index, work)| (index, work.facts.as_slice())))
    }
}

/// Takes the curves of a hand-in. Those of an earlier one stay, whichever was computed first.
fn take_curves(known: &mut Vec<(usize, TheoryCurve)>, index: usize, mut curves: Vec<TheoryCurve>) {
    let has = |theory: &str, curves: &[TheoryCurve]| curves.iter().any(|curve| curve.theory == theory);
    curves.retain(|new| known.iter().all(|(from, curve)| curve.theory != new.theory || *from > index));
    known.retain(|(_, curve)| !has(&curve.theory, &curves));
    known.extend(curves.into_iter().map(|curve| (index, curve)));
}

//! The documents of the hand-ins beside the teacher's, or beside the one that most hand-ins have.

use super::{Collection, References};
use crate::verify::documents::{ComparedWith, DocumentDifference, changed_lines, is_same, likeness};
use document::page::Source;

/// Least likeness of two forms of the same document.
const ALIKE: f64 = 0.5;
/// Maximum number of different documents with which a document is compared.
const MOST_GROUPS: usize = 20;

impl Collection {
    /// Sets the teacher's documents. Hand-ins that are computed already are compared with them, too; their answers keep their grades.
    pub fn set_references(&mut self, references: References) {
        self.references = references;
        self.are_documents_compared = false;
    }

    /// A document that may be that of the class: it is if a hand-in has exactly its text, and if none was given.
    pub fn offer_document(&mut self, document: Vec<Source>) {
        if !self.references.are_given {
            self.set_references(References { documents: vec![document], are_given: false });
        }
    }

    /// The teacher's document of a work: the same, or the most alike.
    pub(super) fn reference(&self, files: &[Source]) -> Option<&[Source]> {
        let References { documents, are_given } = &self.references;
        let has = |document: &Vec<Source>| self.hand_in_documents().any(|(_, files)| is_same(files, document));
        let own = documents.iter().filter(|document| *are_given || has(document));
        nearest(files, own.map(Vec::as_slice))
    }

    fn hand_in_documents(&self) -> impl Iterator<Item = (usize, &[Source])> {
        let entries = self.entries.iter().enumerate();
        entries.filter_map(|(index, entry)| Some((index, entry.hand_in()?.work.documents.as_slice())))
    }

    /// Compares all documents. Returns false if that was done since the last change, or if hand-ins are still to be computed.
    pub(super) fn compare_documents(&mut self) -> bool {
        if self.waiting() > 0 || std::mem::replace(&mut self.are_documents_compared, true) {
            return false;
        }
        // The different documents: one of the hand-ins with each, and their number.
        let mut groups: Vec<(&[Source], Vec<usize>)> = Vec::new();
        for (index, files) in self.hand_in_documents().filter(|(index, _)| self.entries[*index].counts()) {
            match groups.iter_mut().find(|(other, _)| *other == files || is_same(files, other)) {
                Some((_, members)) => members.push(index),
                None => groups.push((files, vec![index])),
            }
        }
        units::order::sort_by_key(&mut groups, |(_, members)| std::cmp::Reverse(members.len()));
        let mut differences = vec![None; self.entries.len()];
        for (files, members) in &groups {
            let difference = self.document_difference(files, members.len(), &groups);
            members.iter().for_each(|member| differences[*member].clone_from(&difference));
        }
        for (entry, difference) in self.entries.iter_mut().zip(differences) {
            entry.document = difference;
        }
        true
    }

    fn document_difference(
        &self,
        files: &[Source],
        count: usize,
        groups: &[(&[Source], Vec<usize>)],
    ) -> Option<DocumentDifference> {
        if let Some(reference) = self.reference(files) {
            let lines = changed_lines(files, reference);
            return (!lines.is_empty()).then_some(DocumentDifference { with: ComparedWith::Teacher, lines });
        }
        if self.references.are_given {
            return Some(DocumentDifference { with: ComparedWith::Teacher, lines: Vec::new() });
        }
        let others = groups
            .iter()
            .take(MOST_GROUPS)
            .filter(|(other, members)| members.len() >= count && !std::ptr::eq(*other, files));
        let nearest = nearest(files, others.map(|(other, _)| *other))?;
        let members = groups.iter().find(|(other, _)| std::ptr::eq(*other, nearest)).map_or(0, |(_, own)| own.len());
        Some(DocumentDifference { with: ComparedWith::Groups(members), lines: changed_lines(files, nearest) })
    }
}

/// Document among others that is equal to this one; otherwise the one that has the most lines in common with it, if these
/// are a share of at least [`ALIKE`].
fn nearest<'a>(files: &[Source], others: impl Iterator<Item = &'a [Source]>) -> Option<&'a [Source]> {
    let mut best: Option<(f64, &[Source])> = None;
    for other in others {
        if is_same(files, other) {
            return Some(other);
        }
        let own = likeness(files, other);
        if own >= ALIKE && best.is_none_or(|(before, _)| own > before) {
            best = Some((own, other));
        }
    }
    best.map(|(_, other)| other)
}

//! The independent variable of a record: from the file, from the document, or chosen by the user.

use crate::records::Records;
use crate::records::record::Record;
use crate::{Changes, OpenDocument};
use analysis::finding::Finding;
use analysis::inspection::{doubtful_times, inspect};
use analysis::origin::Reason;
use document::Document;
use units::Language;

/// Maximum number of single columns that are offered as the independent variable.
const MOST: usize = 24;

/// A choice of the independent variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VariableView {
    /// Indices of the independent columns: one for all columns, or several, each for the columns that belong to it.
    pub columns: Vec<usize>,
    /// Description in the chosen language.
    pub text: String,
    /// True if it is the present choice.
    pub chosen: bool,
}

impl Records {
    /// Sets the independent variable of a record: one column for all, or several, each for the columns that belong to
    /// it.
    pub fn set_variable(&mut self, open: OpenDocument<'_>, id: u32, columns: &[usize]) -> Changes {
        let record = self.get_mut(id);
        if let Some(record) = record.filter(|record| columns.iter().all(|column| *column < record.read_columns())) {
            record.against = columns.to_vec();
            // The uses of columns followed from the earlier choice.
            record.uses.clear();
            record.origin = None;
            record.take_for(open.document);
        }
        Changes::RECORDS
    }
}

impl Record {
    /// Applies the user's choice of the independent variable, or else the one that suits the document. Returns true if
    /// the roles of columns may have changed; derivatives are then removed.
    pub(crate) fn settle_variable(&mut self, document: &Document) -> bool {
        let before = self.settled;
        let variable = &document.program.model.independent;
        let suits = |record: &Self| record.table.suited(&variable.name, variable.unit.dimension, &[]);
        if !before && self.against.is_empty() && suits(self) == analysis::roles::Suited::AsRead {
            return false;
        }
        self.forget_made();
        if before {
            self.table.read_roles();
        }
        self.readings.clone_from(&self.table.readings);
        let remark = if self.against.is_empty() {
            self.table.suit(&variable.name, variable.unit.dimension, &[])
        } else {
            Some(self.table.against(&self.against, Reason::Person))
        };
        self.settled = remark.is_some();
        let inspection = inspect(&self.table);
        let settled = self.settled;
        let said = self.said.iter().filter(|finding| !settled || !matches!(finding, Finding::Role(_))).cloned();
        let doubtful = doubtful_times(&self.table).into_iter();
        self.findings = said
            .chain(remark.map(Finding::Role))
            .chain(inspection.findings)
            .chain(doubtful.filter(|finding| matches!(finding, Finding::NoTimes(_))))
            .collect();
        self.computed = inspection.derived.iter().map(|derived| (derived.column, derived.of)).collect();
        true
    }

    /// Possible choices of the independent variable, those of an ambiguous file first.
    pub(crate) fn variables(&self, language: Language) -> Vec<VariableView> {
        let table = &self.table;
        let now: Vec<usize> = table.clocks().filter(|index| *index < self.read_columns()).collect();
        let mut found = if table.readings.is_empty() { &self.readings } else { &table.readings }.clone();
        if table.readings.is_empty() && !found.contains(&now) {
            found.push(now.clone());
        }
        let filled = |index: &usize| table.columns.get(*index).is_some_and(|column| column.filled() > 1);
        for column in (0..self.read_columns()).filter(filled).take(MOST) {
            if !found.contains(&vec![column]) {
                found.push(vec![column]);
            }
        }
        let view = |columns: Vec<usize>| VariableView {
            text: table.reading_in_words(&columns, language),
            chosen: table.readings.is_empty() && columns == now,
            columns,
        };
        found.into_iter().map(view).collect()
    }
}

//! The independent variable of a record: as read, that of the document, or as a person has chosen.

use crate::Desk;
use crate::records::record::Record;
use analysis::finding::Finding;
use analysis::inspection::{doubtful_times, inspect};
use analysis::origin::Reason;
use document::Document;
use units::Language;

/// Most columns that are offered as the independent variable.
const MOST: usize = 24;

/// A choice of the independent variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VariableView {
    /// The columns that are independent variables: one for all, or several, each for its own columns.
    pub columns: Vec<usize>,
    /// It in the chosen language.
    pub text: String,
    /// True if it is chosen now.
    pub chosen: bool,
}

impl Desk {
    /// Measures the columns of a record against these: against one, or each against the one of several that it belongs to.
    pub fn set_record_variable(&mut self, id: u32, columns: &[usize]) {
        let mut records = std::mem::take(&mut self.data.records);
        let record = records.iter_mut().find(|record| record.id == id);
        if let Some(record) = record.filter(|record| columns.iter().all(|column| *column < record.read_columns())) {
            record.against = columns.to_vec();
            // What columns were taken for followed from the earlier choice.
            record.uses.clear();
            record.origin = None;
            record.take_for(&self.document, &|label| self.labels(label));
        }
        self.data.records = records;
        self.records_changed();
    }
}

impl Record {
    /// Takes the independent variable that a person has chosen, or else the one that suits the document. True if the roles of columns
    /// may have changed; what was made of columns is forgotten then.
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

    /// The choices of an independent variable, those that are in question first.
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

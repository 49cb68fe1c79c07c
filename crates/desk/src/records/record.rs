//! Records: measured data beside the model. A record does not depend on a document. The meanings of its columns are
//! recognised for each document.

use crate::records::recognise::{Meaning, observed, recognise};
use analysis::derivative::Differentiation;
use analysis::finding::Finding;
use analysis::table::Table;
use document::Document;
use program::Model;
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of records.
pub const MOST_RECORDS: usize = 8;

/// Maximum size of a file that the page reads as a record, in bytes: more than a million rows. The program reads larger
/// ones.
pub const LONGEST_RECORD: usize = 64 << 20;
/// Maximum length of the text of a workbook sheet, in bytes.
pub(crate) const LONGEST_TEXT: usize = LONGEST_RECORD;
/// Maximum length of the stored texts of all records together, in bytes. Browsers store a few megabytes per site.
pub const LONGEST_SAVED: usize = 1 << 20;

/// A record of measured data.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    /// Id of the record, never reused.
    pub(super) id: u32,
    /// Name: that of its file.
    pub(super) name: String,
    /// Text of the file, for the next visit; empty if it is too long to be stored.
    pub(super) text: String,
    /// Table that was read from the text.
    pub(super) table: Table,
    /// Findings about the text and the data, for the present independent variable.
    pub(super) findings: Vec<Finding>,
    /// Findings from reading the text, before any choice of the independent variable.
    pub(super) said: Vec<Finding>,
    /// Columns that the user has chosen as independent variables; empty if none were chosen.
    pub(super) against: Vec<usize>,
    /// True if the independent variable differs from the one suggested by the text.
    pub(super) settled: bool,
    /// Alternative sets of independent variables found in the file, if it is ambiguous. They remain available after a
    /// choice.
    pub(super) readings: Vec<Vec<usize>>,
    /// Columns that were computed from others: index of the column and of its source.
    pub(super) computed: Vec<(usize, usize)>,
    /// Derivatives computed at the user's request. They are the last columns of the table.
    pub(super) made: Vec<Made>,
    /// Use of each column.
    pub(super) uses: Vec<Use>,
    /// True if the record is drawn.
    pub(super) shown: bool,
    /// Clock reading at which the model begins in the applied fit.
    pub(super) origin: Option<Origin>,
    /// Rows of the table that are left out of fits.
    pub(super) excluded: BTreeSet<usize>,
    /// Values of parameters in this record, SI, by name, for fits of several records.
    pub(super) known: BTreeMap<String, f64>,
    /// True values of parameters, SI, by name; `None` unless the data are simulated.
    pub(super) truth: Option<Vec<(String, f64)>>,
}

/// Beginning of the model in a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    /// Reading of the record's clock, SI.
    pub reading: f64,
    /// True if a fit has found it, so that later fits start there too. False if it is only the beginning of the fitted
    /// part.
    pub found: bool,
}

/// Use of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Use {
    pub meaning: Meaning,
    /// True if fits use the column.
    pub fitted: bool,
    /// Zero of the scale, SI, found by a fit.
    pub offset: f64,
    /// True if the user has chosen the meaning, so that it is not recognised again.
    pub chosen: bool,
    /// True if the user has stated the unit.
    pub stated: bool,
}

/// Origin of a derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Made {
    /// Index of the source column.
    pub of: usize,
    /// Order of the derivative.
    pub order: usize,
    /// Method of differentiation.
    pub how: Differentiation,
}

impl Use {
    /// True if the document has the quantity, or the column is not used.
    fn fits(&self, model: &Model) -> bool {
        self.meaning.quantity.is_empty() || observed(model, &self.meaning.quantity).is_some()
    }
}

impl Record {
    /// Id of the record, never reused.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// Name: that of its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Table that was read from the text, followed by derivatives.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Use of each column.
    pub fn uses(&self) -> &[Use] {
        &self.uses
    }

    /// Findings about the text and the data, for the present independent variable.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// True if the record is drawn.
    pub fn is_shown(&self) -> bool {
        self.shown
    }

    /// Beginning of the model by the applied fit, `None` if no fit has been applied.
    pub fn fitted_origin(&self) -> Option<Origin> {
        self.origin
    }

    /// Rows of the table that are left out of fits, ascending.
    pub fn excluded(&self) -> &BTreeSet<usize> {
        &self.excluded
    }

    /// Values of parameters in this record, SI, by name, for fits of several records.
    pub fn known(&self) -> &BTreeMap<String, f64> {
        &self.known
    }

    /// True values of parameters, SI, by name; `None` unless the data are simulated.
    pub fn truth(&self) -> Option<&[(String, f64)]> {
        self.truth.as_deref()
    }

    /// Index of the source of a computed column; `None` for a measured one.
    pub fn computed_from(&self, column: usize) -> Option<usize> {
        self.computed.iter().find(|(computed, _)| *computed == column).map(|(_, source)| *source)
    }

    /// Recognises the meaning of all columns, except those set by the user.
    pub fn take_for(&mut self, document: &Document) {
        let labels = |label: &str| labels(document, label);
        let model = &document.program.model;
        let differentiated: Vec<_> = self.differentiated().collect();
        let settled = self.settle_variable(document);
        // Derivatives follow their source, so they take no part in the recognition.
        let made = self.table.columns.split_off(self.read_columns());
        let mut meanings = recognise(&self.table, document, &labels);
        if !self.table.readings.is_empty() {
            // An ambiguous table measures nothing until the user has chosen the independent variable.
            meanings.iter_mut().for_each(|meaning| meaning.quantity.clear());
        }
        self.table.columns.extend(made);
        // The fit uses the first column that was not computed from another one.
        let independent = |(column, meaning): (usize, &Meaning)| {
            !meaning.quantity.is_empty()
                && meaning.quantity != model.independent.name
                && self.computed_from(column).is_none()
        };
        let independent = meanings.iter().enumerate().position(independent);
        meanings.resize_with(self.table.columns.len(), Meaning::nothing);
        let fresh = meanings.into_iter().enumerate().map(|(column, meaning)| match self.uses.get(column) {
            Some(used) if used.chosen && used.fits(model) => used.clone(),
            _ => Use { meaning, fitted: Some(column) == independent, offset: 0.0, chosen: false, stated: false },
        });
        let fresh = fresh.collect();
        let before = std::mem::replace(&mut self.uses, fresh);
        self.assume_units(document, &before);
        if settled {
            self.restore_made(differentiated.into_iter(), document);
        } else {
            self.settle_made(document);
        }
    }
}

/// A label in every language of a document, in lower case.
fn labels(document: &Document, label: &str) -> Vec<String> {
    document.program.languages().map(|language| document.program.text(language, label).to_lowercase()).collect()
}

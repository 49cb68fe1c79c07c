//! Records: measured data beside the model. A record belongs to no document; which of the document's quantities its
//! columns measure is recognised for each document.

use crate::records::recognise::{Meaning, observed, recognise};
use analysis::derivative::Differentiation;
use analysis::finding::Finding;
use analysis::table::Table;
use document::Document;
use program::Model;
use std::collections::BTreeMap;

/// How many records there can be.
pub const MOST_RECORDS: usize = 8;

/// The largest file, in bytes, that the laboratory reads as a record: more than a million rows. The program takes larger
/// ones.
pub const LONGEST_RECORD: usize = 64 << 20;
/// The longest text, in bytes, that a sheet of a workbook may become.
pub(crate) const LONGEST_TEXT: usize = LONGEST_RECORD;
/// The longest texts, in bytes, that all records together keep for the next visit: browsers keep a few megabytes for a site.
pub(crate) const LONGEST_SAVED: usize = 1 << 20;

/// Measured data.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    /// Names it as long as it exists.
    pub id: u32,
    /// What it is called: its file's name.
    pub name: String,
    /// The text it was read from, for the next visit; empty where it is too long for that.
    pub text: String,
    /// What was read.
    pub table: Table,
    /// What the text hides.
    pub findings: Vec<Finding>,
    /// What was said of the text as it was read.
    pub said: Vec<Finding>,
    /// The columns that a person has made independent variables; empty where none was chosen.
    pub against: Vec<usize>,
    /// Whether the independent variable is another one than the text suggests.
    pub settled: bool,
    /// The readings of the file as read, where there are several; they stay on offer when one has been chosen.
    pub readings: Vec<Vec<usize>>,
    /// Columns that were computed from others: which, and from which.
    pub computed: Vec<(usize, usize)>,
    /// The last columns, which a person had made of others.
    pub made: Vec<Made>,
    /// What each column is taken for.
    pub uses: Vec<Use>,
    /// Whether it is drawn.
    pub shown: bool,
    /// Where the model begins in it, in the fit whose numbers are in the sliders.
    pub origin: Option<Origin>,
    /// Values that parameters have in this record, by name and SI, for fits of several.
    pub known: BTreeMap<String, f64>,
    /// The true values of parameters, by name and SI, if the data are simulated.
    pub truth: Option<Vec<(String, f64)>>,
}

/// Where the model begins in a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    /// The reading of the record's clock, SI.
    pub reading: f64,
    /// Whether a fit has found it, so that later fits begin there too. Otherwise it is only where the fitted part began.
    pub found: bool,
}

/// What a column is taken for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Use {
    pub meaning: Meaning,
    /// Whether a fit is to follow it.
    pub fitted: bool,
    /// The zero of its scale, SI, as a fit has found it.
    pub offset: f64,
    /// Whether a person has chosen it: then it is not recognised again.
    pub chosen: bool,
    /// Whether a person has stated the unit.
    pub stated: bool,
}

/// A column that was made of another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Made {
    /// What it was made of.
    pub of: usize,
    /// Which derivative it is.
    pub order: usize,
    /// How it was made.
    pub how: Differentiation,
}

impl Use {
    /// Whether the document has the quantity.
    fn fits(&self, model: &Model) -> bool {
        self.meaning.quantity.is_empty() || observed(model, &self.meaning.quantity).is_some()
    }
}

impl Record {
    /// Which column a column was computed from, if it was.
    pub fn computed_from(&self, column: usize) -> Option<usize> {
        self.computed.iter().find(|(computed, _)| *computed == column).map(|(_, source)| *source)
    }

    /// Takes the columns for what they seem to measure, except where a person has said what they do.
    pub fn take_for(&mut self, document: &Document, labels: &dyn Fn(&str) -> Vec<String>) {
        let model = &document.program.model;
        let differentiated: Vec<_> = self.differentiated().collect();
        let settled = self.settle_variable(document);
        // What was made follows its source and takes no quantity from another column.
        let made = self.table.columns.split_off(self.read_columns());
        let mut meanings = recognise(&self.table, document, labels);
        if !self.table.readings.is_empty() {
            // Until a person has chosen the independent variable nothing is measured.
            meanings.iter_mut().for_each(|meaning| meaning.quantity.clear());
        }
        self.table.columns.extend(made);
        // A fit follows the first column that was not computed from another one.
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
        self.uses = fresh.collect();
        if settled {
            self.restore_made(differentiated.into_iter(), document);
        } else {
            self.settle_made(document);
        }
    }
}

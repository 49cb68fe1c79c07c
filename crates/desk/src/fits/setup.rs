//! Fit settings chosen by the user.

use crate::records::record::Record;
use analysis::fit::{Loss, Target, Varied};
use program::Model;
use std::collections::{BTreeMap, BTreeSet};

/// Settings of a fit.
#[derive(Debug, Default)]
pub(crate) struct Setup {
    /// True for each parameter of the document that is varied.
    pub varied: Vec<bool>,
    /// The user's choice to vary the zero of the clock and that of the scale; `None` if not chosen.
    pub zeros: [Option<bool>; 2],
    /// True if all records share one value, by name of a parameter or zero. No entry if the user has not chosen.
    pub same: BTreeMap<String, bool>,
    /// Id of the chosen record. If it does not exist, the latest record is used.
    pub chosen: Option<u32>,
    /// Ids of the other records that take part.
    pub others: BTreeSet<u32>,
    /// Start and end of the fitted time window on the record clocks, SI; `None` is open.
    pub window: [Option<f64>; 2],
    /// Loss function of the residuals.
    pub loss: Loss,
}

impl Setup {
    /// True if all records share one value of a number. Default: each record has its own varied value, as on the
    /// command line, and all records share the slider's value of a fixed one.
    pub fn is_same(&self, name: &str, varied: bool) -> bool {
        self.same.get(name).copied().unwrap_or(!varied)
    }

    /// Fixed values of a record's own: index of the parameter in `model` and value, SI.
    pub fn fixed(&self, model: &Model, varied: &[Varied], record: &Record) -> Vec<(usize, f64)> {
        let own = |(index, parameter): (usize, &program::Parameter)| {
            let held = varied.iter().all(|varied| varied.target != Target::Parameter(index));
            let value =
                record.known().get(&parameter.name).filter(|_| held && !self.is_same(&parameter.name, false))?;
            Some((index, *value))
        };
        model.parameters.iter().enumerate().filter_map(own).collect()
    }
}

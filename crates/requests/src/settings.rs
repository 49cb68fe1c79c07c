//! Settings of a run.

use crate::arguments::{Given, GivenByName, assignments, text};
use crate::fault::Fault;
use crate::host::Host;
use document::Document;
use engine::Setup;
use program::Seat;
use runner::Settings;
use runner::fitting::Theory;
use runner::records::{Stated, measured};
use serde::Deserialize;
use std::path::PathBuf;

/// Settings of a run as they are asked for.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Asked {
    /// Parameters that are set, as keywords or in `set`.
    parameters: GivenByName,
    set: GivenByName,
    start: GivenByName,
    preset: Vec<String>,
    press: GivenByName,
    /// Files of two columns by the names of tables.
    draw: Vec<(String, PathBuf)>,
    method: Option<String>,
    step: Option<Given>,
    tolerance: Option<f64>,
    until: Option<Given>,
    seat: Option<u64>,
}

/// A document with the settings of its runs.
#[derive(Debug)]
pub struct Prepared {
    /// The document, perhaps with other sizes.
    pub document: Document,
    /// Setup of the runs.
    pub setup: Setup,
    /// End of the runs, SI.
    pub until: f64,
}

impl Asked {
    /// A copy of the document with these settings.
    pub fn prepare(&self, host: &dyn Host, theory: &Theory) -> Result<Prepared, Fault> {
        let mut set = assignments(&self.parameters);
        set.extend(assignments(&self.set));
        let settings = Settings {
            seat: seat(self.seat)?,
            set,
            start: assignments(&self.start),
            preset: self.preset.clone(),
            press: assignments(&self.press),
            method: self.method.clone(),
            step: text(self.step.as_ref()),
            tolerance: self.tolerance,
            until: text(self.until.as_ref()),
        };
        let mut document = theory.document.clone();
        let (mut setup, until) = runner::setup(&mut document, &settings)?;
        for (name, path) in &self.draw {
            let data = || measured(path.display().to_string(), host.record(path)?, Stated::default());
            runner::draw(&mut document, &mut setup, name, data)?;
        }
        Ok(Prepared { document, setup, until })
    }
}

/// The seat whose assigned values are taken.
pub fn seat(number: Option<u64>) -> Result<Option<Seat>, Fault> {
    let seat = |number: u64| runner::names::seat(&number.to_string()).map_err(Fault::Value);
    number.map(seat).transpose()
}

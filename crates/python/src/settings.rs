//! Settings of a run from keyword arguments.

use crate::arguments::Options;
use crate::disk::record;
use document::Document;
use engine::Setup;
use program::Seat;
use pyo3::prelude::*;
use runner::fitting::Theory;
use runner::records::{Stated, measured};
use runner::{Refusal, Settings};
use std::path::PathBuf;

/// Settings of a run, and the files with curves that are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    settings: Settings,
    draw: Vec<(String, PathBuf)>,
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
    /// Takes the settings of a run; what is left are parameters.
    pub fn take(options: &Options) -> PyResult<Self> {
        let settings = Settings {
            seat: seat(options)?,
            start: options.assignments("start")?,
            preset: options.names("preset")?.unwrap_or_default(),
            press: options.assignments("press")?,
            method: options.get("method")?,
            step: options.value("step")?,
            tolerance: options.get("tolerance")?,
            until: options.value("until")?,
            set: options.assignments("set")?,
        };
        let draw = options.paths("draw")?;
        let set = options.parameters()?.into_iter().chain(settings.set).collect();
        Ok(Self { settings: Settings { set, ..settings }, draw })
    }

    /// A copy of the document with these settings.
    pub fn prepare(&self, theory: &Theory) -> Result<Prepared, Refusal> {
        let mut document = theory.document.clone();
        let (mut setup, until) = runner::setup(&mut document, &self.settings)?;
        for (name, path) in &self.draw {
            let data = || measured(path.display().to_string(), record(path)?, Stated::default());
            runner::draw(&mut document, &mut setup, name, data)?;
        }
        Ok(Prepared { document, setup, until })
    }
}

/// The seat whose assigned values are taken.
pub fn seat(options: &Options) -> PyResult<Option<Seat>> {
    let number: Option<u64> = options.get("seat")?;
    let seat = |number: u64| runner::names::seat(&number.to_string()).map_err(crate::errors::value_error);
    number.map(seat).transpose()
}

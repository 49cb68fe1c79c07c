//! The surroundings that the machine gives: files, the player beside this library, and signals.

use pyo3::prelude::*;
use runner::records::{MOST_BYTES, bounded, too_large};
use runner::{Files, Refusal};
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::UNIX_EPOCH;

/// The surroundings of one call.
#[derive(Debug, Default)]
pub struct Surroundings {
    /// Exception of a signal that has ended the work.
    ended: Mutex<Option<PyErr>>,
}

impl Surroundings {
    /// Raises the exception of a signal that has ended the work.
    pub fn ended(self) -> PyResult<()> {
        self.ended.into_inner().ok().flatten().map_or(Ok(()), Err)
    }
}

impl Files for Surroundings {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        std::fs::read(path)
    }

    fn is_folder(&self, path: &Path) -> bool {
        path.is_dir()
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).into_iter().flatten();
        entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect()
    }
}

impl requests::Host for Surroundings {
    fn record(&self, path: &Path) -> Result<Vec<u8>, Refusal> {
        let failure = |error: io::Error| Refusal::file("read", path, &error);
        let mut file = File::open(path).map_err(failure)?;
        if file.metadata().map_err(failure)?.len() > MOST_BYTES {
            return Err(too_large(path));
        }
        bounded(&mut file, path)
    }

    fn player(&self) -> Option<String> {
        let package = Python::attach(|py| py.import("meniscus")?.getattr("__file__")?.extract::<PathBuf>()).ok()?;
        std::fs::read_to_string(package.with_file_name("shipped").join("player.html")).ok()
    }

    fn goes_on(&self) -> bool {
        let signal = Python::attach(|py| py.check_signals()).err();
        let goes_on = signal.is_none();
        if let (Some(signal), Ok(mut ended)) = (signal, self.ended.lock()) {
            *ended = Some(signal);
        }
        goes_on
    }

    fn seconds(&self) -> f64 {
        UNIX_EPOCH.elapsed().map_or(0.0, |since| since.as_secs_f64())
    }
}

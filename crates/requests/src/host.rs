//! The surroundings of requests, which the caller gives.

use runner::records::{MOST_BYTES, too_large};
use runner::{Files, Refusal};
use std::path::Path;

/// The surroundings of requests: files, the player, and a word in long work.
pub trait Host: Files {
    /// Bytes of a file of measured data.
    ///
    /// # Errors
    /// The file cannot be read, or is larger than [`MOST_BYTES`].
    fn record(&self, path: &Path) -> Result<Vec<u8>, Refusal> {
        let bytes = self.read(path).map_err(|error| Refusal::file("read", path, &error))?;
        if bytes.len() as u64 > MOST_BYTES { Err(too_large(path)) } else { Ok(bytes) }
    }

    /// The page that plays documents, without a document; `None` if the package was built without it.
    fn player(&self) -> Option<String>;

    /// False if the work shall end. Asked several times a second.
    fn goes_on(&self) -> bool;

    /// Reading of a clock, s, from any moment. It decides how often [`Host::goes_on`] is asked, and no result.
    fn seconds(&self) -> f64;

    /// Compiles steps of runs; `None` if they are interpreted.
    fn compiler(&self) -> Option<&dyn engine::Compiler> {
        None
    }
}

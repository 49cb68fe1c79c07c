//! Files of this computer.

use runner::records::{MOST_BYTES, bounded, too_large};
use runner::{Files, Refusal};
use std::fs::File;
use std::io;
use std::path::Path;

/// The files of this computer.
pub struct Disk;

impl Files for Disk {
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

/// Bytes of a file of measured data.
pub fn record(path: &Path) -> Result<Vec<u8>, Refusal> {
    let failure = |error: io::Error| Refusal::file("read", path, &error);
    let mut file = File::open(path).map_err(failure)?;
    if file.metadata().map_err(failure)?.len() > MOST_BYTES {
        return Err(too_large(path));
    }
    bounded(&mut file, path)
}

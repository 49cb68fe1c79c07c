//! Documents from files and from the standard input.

use crate::failure::Failure;
use runner::{Files, Sources, decoded};
use std::io::{self, Read};
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

/// Texts of the document at `path` with its translations; `-` is the standard input.
pub fn sources(path: &Path) -> Result<Sources, Failure> {
    if path == Path::new("-") {
        return Ok(Sources::of_input(&standard_input()?));
    }
    Ok(runner::sources(&Disk, path)?)
}

/// Text of one file; `-` is the standard input.
pub fn text_of(path: &Path) -> Result<String, Failure> {
    if path == Path::new("-") { standard_input() } else { Ok(runner::text_of(&Disk, path)?) }
}

fn standard_input() -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let read = io::stdin().lock().read_to_end(&mut bytes);
    read.map_err(|error| Failure::file("read", Path::new("the standard input"), &error))?;
    Ok(decoded(bytes, "the standard input")?)
}

//! Measured data from files and from the standard input.

use crate::failure::Failure;
use runner::records::{MOST_BYTES, Measured, Stated, bounded, measured, too_large};
use std::fs::File;
use std::path::Path;

/// Reads a file of measured data; `-` is the standard input.
pub fn read(path: &Path, stated: Stated) -> Result<Measured, Failure> {
    let (name, bytes) = if path == Path::new("-") {
        let name = "the standard input";
        (name.to_owned(), bounded(&mut std::io::stdin().lock(), Path::new(name))?)
    } else {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let metadata = std::fs::metadata(path).map_err(failure)?;
        if metadata.is_dir() {
            return Err(Failure::request(format!("cannot read {}: it is a directory", path.display())));
        }
        if metadata.len() > MOST_BYTES {
            return Err(too_large(path).into());
        }
        (path.display().to_string(), bounded(&mut File::open(path).map_err(failure)?, path)?)
    };
    Ok(measured(name, bytes, stated)?)
}

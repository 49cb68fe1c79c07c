//! What several targets claim of measured data.

use analysis::reading::{Reading, ReadingError};

/// A file that is read in slices gives the same result as one that is read at once, with at most so many bytes of text.
/// `begin` is one of the functions that begin to read a file.
///
/// # Panics
/// If it does not.
pub fn reads_the_same_in_slices(
    begin: fn(Vec<u8>, usize) -> Result<Reading, ReadingError>,
    bytes: Vec<u8>,
    most: usize,
) {
    let whole = begin(bytes.clone(), most).and_then(Reading::complete);
    let slices = begin(bytes, most).and_then(|mut reading| {
        while !reading.advance(100)? {}
        Ok(reading.finish())
    });
    match (whole, slices) {
        (Ok(whole), Ok(slices)) => assert_eq!(format!("{:?}", Some(whole)), format!("{slices:?}")),
        (whole, slices) => assert_eq!(whole.err(), slices.err()),
    }
}

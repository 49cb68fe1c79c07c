//! Seeded noise, and access to the measured records outside the project.

pub mod fitting;
pub mod instruments;
pub mod old_workbook;
pub mod packed;
pub mod variants;

use analysis::reading::{Contents, Reading, ReadingError};
use analysis::workbook::{Progress, SheetText, Workbook, WorkbookError};
use std::path::Path;
use units::split_mix::SplitMix64;

/// Random numbers that are the same in every run.
#[derive(Debug)]
pub struct Noise(SplitMix64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::new(seed))
    }

    /// Between 0 and 1, neither included.
    pub fn uniform(&mut self) -> f64 {
        ((self.0.bits() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Of mean 0 and standard deviation 1, by Box and Muller.
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(self.uniform())).sqrt();
        radius * libm::cos(core::f64::consts::TAU * self.uniform())
    }
}

/// Bytes of one of the measured records in `../shared/data/utube`, relative to the root of the project. They are not part
/// of it: tests that need them are ignored unless asked for.
pub fn utube_bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/utube").join(format!("{name}.txt"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The columns time, position, velocity and acceleration of a measured record.
pub fn utube(name: &str) -> Vec<Vec<f64>> {
    let text = String::from_utf8(utube_bytes(name)).expect("UTF-8");
    let mut columns = vec![Vec::new(); 4];
    for line in text.lines() {
        for (column, cell) in columns.iter_mut().zip(line.split(' ')) {
            column.push(cell.parse().expect("a number"));
        }
    }
    columns
}

/// All sheets of a workbook, read in slices of this many bytes.
pub fn all_sheets(mut workbook: Workbook, budget: u64) -> Result<Vec<SheetText>, WorkbookError> {
    let mut found = Vec::new();
    loop {
        match workbook.advance(budget)? {
            Progress::More => {}
            Progress::Sheet(sheet) => found.push(sheet),
            Progress::End => return Ok(found),
        }
    }
}

/// Content of a file of at most `most` bytes expanded, read in slices of this many bytes.
pub fn in_slices(bytes: Vec<u8>, most: usize, budget: usize) -> Result<Contents, ReadingError> {
    let mut reading = Reading::new(bytes, most)?;
    while !reading.advance(budget)? {
        assert!((0.0..=1.0).contains(&reading.progress()), "{}", reading.progress());
    }
    Ok(reading.finish().expect("it has ended"))
}

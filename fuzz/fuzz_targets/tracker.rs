//! Any bytes as a project of Tracker, as they are and in an archive that is whole: a table or a refusal with words, never a
//! panic, the same in slices.

#![no_main]

use analysis::spreadsheet::Archive;
use analysis::tracker;
use libfuzzer_sys::fuzz_target;
use meniscus_fuzz::reads_the_same_in_slices;
use units::Language;

/// No project may become more text.
const MOST: usize = 1 << 20;

fuzz_target!(|bytes: &[u8]| {
    read(bytes.to_vec());
    let mut archive = Archive::default();
    archive.add("a.trk", bytes);
    archive.add("videos/film.mp4", b"");
    read(archive.finish());
});

fn read(bytes: Vec<u8>) {
    match tracker::read(bytes.clone()) {
        Ok(opened) => opened.remarks().iter().for_each(|remark| {
            assert!(!remark.text(Language::English).is_empty() && !remark.text(Language::Spanish).is_empty());
        }),
        Err(error) => {
            assert!(!error.message(Language::English).is_empty() && !error.hint(Language::Spanish).is_empty())
        }
    }
    reads_the_same_in_slices(bytes, MOST);
}

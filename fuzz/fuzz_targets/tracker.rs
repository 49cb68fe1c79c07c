//! Any bytes as a project of Tracker, as they are and in an archive that is whole: a table or a refusal with words, never a
//! panic, the same in slices.

#![no_main]

use analysis::reading::Reading;
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
    let archive = archive.finish();
    gather(&archive);
    read(archive);
    gather(bytes);
});

/// No more is asked for than there is, and the gathered parts are read or refused.
fn gather(bytes: &[u8]) {
    let mut gathering = tracker::gathering(bytes.len() as u64);
    while let Some(range) = gathering.wanted() {
        gathering.supply(bytes[range.start as usize..range.end as usize].to_vec());
    }
    if let Some(mut reading) = Reading::of_gathered(gathering, MOST) {
        while matches!(reading.advance(1 << 16), Ok(false)) {}
    }
}

fn read(bytes: Vec<u8>) {
    match tracker::read(bytes.clone()) {
        Ok(opened) => opened.remarks().iter().for_each(|remark| {
            assert!(!remark.text(Language::English).is_empty() && !remark.text(Language::Spanish).is_empty());
        }),
        Err(error) => {
            assert!(!error.message(Language::English).is_empty() && !error.hint(Language::Spanish).is_empty())
        }
    }
    reads_the_same_in_slices(Reading::new, bytes, MOST);
}

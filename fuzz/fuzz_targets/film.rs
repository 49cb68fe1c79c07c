//! Any bytes as a film: frames that lie in the file or a refusal with words, never a panic, and no request without end.

#![no_main]

use film::containers::{MOST_SAMPLES, Opening};
use film::timing::Intervals;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut opening = Opening::new(bytes.len() as u64);
    let mut read = 0;
    let result = loop {
        match opening {
            Opening::Done(result) => break result,
            Opening::Needs(request) => {
                let range = request.range();
                read += 1;
                assert!(range.start < range.end && range.end <= bytes.len() as u64 && read <= 16 + bytes.len());
                opening = request.supply(bytes[range.start as usize..range.end as usize].to_vec());
            }
        }
    };
    match result {
        Ok(film) => {
            assert!(!film.samples.is_empty() && film.samples.len() <= MOST_SAMPLES);
            let inside = |offset: u64, size: u32| size > 0 && offset + u64::from(size) <= bytes.len() as u64;
            assert!(film.samples.iter().all(|sample| inside(sample.offset, sample.size)));
            assert!(film.notices.iter().all(|notice| !notice.words().is_empty()));
            if let Some(intervals) = Intervals::of(&film.times()) {
                assert!(intervals.rate > 0.0 && intervals.gaps.is_sorted_by_key(|gap| gap.after));
                assert!(intervals.findings(film.stated_rate).iter().all(|finding| !finding.words().is_empty()));
            }
        }
        Err(error) => assert!(!error.words().is_empty()),
    }
});

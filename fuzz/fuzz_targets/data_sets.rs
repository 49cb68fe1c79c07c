//! Any texts as the files of an archive that phyphox writes: a table or a refusal with words, never a panic, the same in slices.

#![no_main]

use analysis::reading::Reading;
use analysis::spreadsheet::Archive;
use libfuzzer_sys::fuzz_target;
use meniscus_fuzz::reads_the_same_in_slices;

/// All files together may become so many bytes of text.
const MOST: usize = 1 << 20;
/// The files, in the order in which the bytes have their contents.
const FILES: [&str; 5] = ["meta/device.csv", "meta/time.csv", "Accelerometer.csv", "Gyroscope.csv", "GPS Location.csv"];
/// Ends the content of a file.
const END: &[u8] = b"=====\n";

fuzz_target!(|bytes: &[u8]| {
    let mut archive = Archive::default();
    let mut rest = bytes;
    for name in FILES {
        let end = rest.windows(END.len()).position(|window| window == END);
        let (content, next) = end.map_or((rest, None), |end| (&rest[..end], Some(&rest[end + END.len()..])));
        archive.add(name, content);
        let Some(next) = next else { break };
        rest = next;
    }
    reads_the_same_in_slices(Reading::new, archive.finish(), MOST);
});

//! Any bytes as an old workbook (XLS), and as the stream of one: a table or a refusal with words, never a panic, never more
//! text than was asked for.

#![no_main]

use analysis::reading::Reading;
use analysis::workbook::{Progress, Workbook};
use libfuzzer_sys::fuzz_target;
use meniscus_fuzz::reads_the_same_in_slices;
use units::Language;

/// All sheets together may become so many bytes of text.
const MOST: usize = 1 << 20;
/// A line is complete before its length is compared.
const LINE: usize = 1 << 18;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(mut workbook) = Workbook::open(bytes.to_vec(), MOST) {
        let mut length = 0;
        loop {
            match workbook.advance(1000) {
                Ok(Progress::More) => {}
                Ok(Progress::Sheet(sheet)) => length += sheet.text.len(),
                Ok(Progress::End) => break,
                Err(error) => {
                    let words = [Language::English, Language::Spanish].map(|language| error.message(language));
                    assert!(words.iter().all(|message| !message.is_empty()));
                    break;
                }
            }
        }
        assert!(length <= MOST + LINE);
    }
    reads_the_same_in_slices(Reading::new, bytes.to_vec(), MOST);
});

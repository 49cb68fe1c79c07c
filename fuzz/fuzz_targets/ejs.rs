//! Any bytes as a simulation of EJS, WebEJS or an archive with one: a document without errors and without a line over 200 characters, or a
//! refusal with words, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;

fn first_error(text: &str) -> Option<String> {
    document::open(text, &[]).first_error().map(|error| error.message.english())
}

fuzz_target!(|bytes: &[u8]| {
    match ejss::import(bytes, &mut |text| first_error(text).map_or(Ok(()), Err)) {
        Ok(imported) => {
            assert_eq!(first_error(&imported.document), None, "{}", imported.document);
            assert!(imported.document.lines().all(|line| line.chars().count() <= 200), "{}", imported.document);
            imported.report.entries().iter().for_each(|entry| _ = entry.sentence(units::Language::English));
        }
        Err(refusal) => assert!(!refusal.words().english().is_empty()),
    }
});

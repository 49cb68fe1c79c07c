//! Any text as a sheet of answers to a survey; five copies of what is read are counted and shown as a page in every language.

#![no_main]

use class::survey::{page, results};
use libfuzzer_sys::fuzz_target;
use saved::survey::Sheet;
use units::Language;

fuzz_target!(|text: &str| {
    let Ok(sheet) = Sheet::read(text) else { return };
    let surveys = results(&vec![sheet; 5]);
    for language in Language::ALL {
        let page = page::html(&surveys, true, language, "0.1.0");
        assert!(!page.contains("<script"), "a text of a sheet is markup");
    }
});

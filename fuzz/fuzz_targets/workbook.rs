//! Any bytes as a workbook, and any XML as its parts in an archive that is whole: a table or a refusal with words, never a
//! panic, never more text than was asked for.

#![no_main]

use analysis::reading::Reading;
use analysis::spreadsheet::Archive;
use analysis::workbook::{Progress, Workbook};
use libfuzzer_sys::fuzz_target;
use meniscus_fuzz::reads_the_same_in_slices;
use units::Language;

/// No sheet may become more text.
const MOST: usize = 1 << 20;

fuzz_target!(|bytes: &[u8]| {
    read(bytes.to_vec());
    read(xlsx(bytes));
    read(archive(&[("content.xml", bytes)]));
});

fn read(bytes: Vec<u8>) {
    if let Ok(mut workbook) = Workbook::open(bytes.clone(), MOST) {
        loop {
            match workbook.advance(1000) {
                Ok(Progress::More) => {}
                Ok(Progress::Sheet(sheet)) => assert!(sheet.text.len() <= 2 * MOST),
                Ok(Progress::End) => break,
                Err(error) => {
                    assert!(
                        !error.message(Language::English).is_empty() && !error.message(Language::Spanish).is_empty()
                    );
                    break;
                }
            }
        }
    }
    reads_the_same_in_slices(Reading::new, bytes, MOST);
}

/// The bytes as the one sheet of a workbook, and as its texts and styles.
fn xlsx(bytes: &[u8]) -> Vec<u8> {
    const LIST: &[u8] = br#"<workbook><sheets><sheet name="a" r:id="a"/></sheets></workbook>"#;
    const RELATIONS: &[u8] = br#"<Relationships><Relationship Id="a" Type="/worksheet" Target="a.xml"/><Relationship Id="b" Type="/sharedStrings" Target="a.xml"/><Relationship Id="c" Type="/styles" Target="a.xml"/></Relationships>"#;
    archive(&[
        ("[Content_Types].xml", b""),
        ("xl/workbook.xml", LIST),
        ("xl/_rels/workbook.xml.rels", RELATIONS),
        ("xl/a.xml", bytes),
    ])
}

fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = Archive::default();
    files.iter().for_each(|(name, content)| archive.add(name, content));
    archive.finish()
}

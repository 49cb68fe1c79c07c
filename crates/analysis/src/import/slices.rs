//! Test that the work of one slice of an import does not grow with the file.

use super::{Importer, number};
use std::borrow::Cow;

/// Greatest number of scans per slice while a text is read in small slices, and the number of slices.
fn most_at_once(text: &str) -> (usize, usize) {
    const BUDGET: usize = 2000;
    let count = || number::SCANNED.with(|count| count.replace(0));
    count();
    let mut importer = Importer::new(Cow::Borrowed(text)).expect("a table");
    let (mut most, mut slices, mut part) = (count(), 1, 0.0);
    while !importer.advance(BUDGET) {
        most = most.max(count());
        slices += 1;
        assert!(importer.progress() >= part, "{part}");
        part = importer.progress();
    }
    importer.finish().expect("a table");
    (most.max(count()), slices)
}

#[test]
fn the_work_of_a_slice_does_not_grow_with_the_file() {
    type Line = fn(usize) -> String;
    let kinds: [(&str, Line); 6] = [
        ("points between commas", |row| format!("{row}.25,{}.5,{row}", row % 7)),
        ("commas in quotation marks", |row| format!("\"{row},25\",\"{},5\"", row % 7)),
        ("both signs between tabs", |row| format!("{row}.25\t{},5\t{row}", row % 7)),
        ("groups between semicolons", |row| format!("{row};{},{:03}", 1 + row % 7, row % 900 + 100)),
        ("points between semicolons", |row| format!("{row}.25;{}.5", row % 7)),
        ("stamps", |row| format!("10:{:02}:{:02}.5 -> {row}.5,{}", row / 60 % 60, row % 60, row % 7)),
    ];
    for (kind, line) in kinds {
        let text = |rows: usize| (0..rows).map(|row| line(row) + "\n").collect::<String>();
        let [(small, few), (large, many)] = [2000, 8000].map(|rows| most_at_once(&text(rows)));
        assert!(
            large <= small + small / 4,
            "{kind}: {small} numbers at once, {large} in a file of four times the length"
        );
        assert!(many > 3 * few, "{kind}: {few} and {many} slices");
    }
}

//! Old workbooks (XLS): contents of their cells, and limits for hostile files.

use crate::support::old_workbook::{Cell, OldWorkbook, compound};
use crate::support::{all_sheets, in_slices};
use analysis::workbook::{self, Progress, SheetText, Workbook, WorkbookError};
use calamine::{Data, Reader, Xls};
use std::io::Cursor;
use units::Language;
use units::split_mix::SplitMix64;

/// Limit above the size of all sheets of these tests.
const MOST: usize = 1 << 20;

fn sheets(bytes: Vec<u8>, budget: u64) -> Result<Vec<SheetText>, WorkbookError> {
    all_sheets(Workbook::open(bytes, MOST)?, budget)
}

fn one(cells: Vec<(u16, u16, Cell)>) -> OldWorkbook {
    OldWorkbook { sheets: vec![("Film", cells)], ..OldWorkbook::default() }
}

/// A number of 30 bits: an integer, perhaps in hundredths.
fn compact(integer: i32, hundredths: bool) -> u32 {
    (integer << 2) as u32 | 2 | u32::from(hundredths)
}

#[test]
fn cells_of_old_workbooks_are_read_as_they_are_shown() {
    let high = (1.5_f64.to_bits() >> 32) as u32;
    let cases = [
        (vec![(0, 0, Cell::Number(1.0)), (0, 1, Cell::Number(-2.5e-3))], "1.0\t-0.0025"),
        (vec![(0, 0, Cell::Number(0.1 + 0.2)), (0, 1, Cell::Number(1e300))], "0.30000000000000004\t1e300"),
        (
            vec![(1, 2, Cell::Number(1.0)), (4, 26, Cell::Number(2.0))],
            "\n\t\t1.0\n\n\n\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t2.0",
        ),
        (vec![(0, 0, Cell::Rk(compact(7, false))), (0, 1, Cell::Rk(compact(-125, true)))], "7.0\t-1.25"),
        (vec![(0, 0, Cell::Rk(high)), (0, 1, Cell::Rk(high | 1))], "1.5\t0.015"),
        (vec![(0, 1, Cell::Rks(vec![compact(1, false), compact(2, true), high]))], "\t1.0\t0.02\t1.5"),
        (vec![(0, 0, Cell::Label("a\tb\n\"c\"")), (0, 1, Cell::Label("Δφ (°)"))], "a b  c \tΔφ (°)"),
        (vec![(0, 0, Cell::Formula(0.5_f64.to_le_bytes())), (0, 1, Cell::TextFormula("größe"))], "0.5\tgröße"),
        (vec![(0, 0, Cell::Formula([1, 0, 1, 0, 0, 0, 0xff, 0xff]))], "TRUE"),
        (vec![(0, 0, Cell::Formula([2, 0, 7, 0, 0, 0, 0xff, 0xff])), (0, 1, Cell::Number(1.0))], "#DIV/0!\t1.0"),
        (vec![(0, 0, Cell::Formula([3, 0, 0, 0, 0, 0, 0xff, 0xff])), (0, 1, Cell::Number(1.0))], "\t1.0"),
        (vec![(0, 0, Cell::Code(0, 0)), (0, 1, Cell::Code(1, 0)), (0, 2, Cell::Code(0x2a, 1))], "FALSE\tTRUE\t#N/A"),
        (vec![(0, 0, Cell::Formatted(0.05, 1)), (0, 1, Cell::Formatted(0.0525, 6))], "5%\t5.25%"),
        // A sign in quotation marks is no percentage.
        (vec![(0, 0, Cell::Formatted(5.0, 5)), (0, 1, Cell::Formatted(5.0, 0))], "5.0\t5.0"),
        (
            vec![(0, 0, Cell::Formatted(45413.5000005787, 4)), (0, 1, Cell::Formatted(1.5, 3))],
            "2024-05-01T12:00:00.05\t36:00:00",
        ),
        (vec![(0, 0, Cell::Formatted(45413.0, 2))], "2024-05-01T00:00:00"),
        // Records out of order, and two for one cell: the last one holds.
        (
            vec![
                (1, 1, Cell::Number(4.0)),
                (1, 0, Cell::Number(3.0)),
                (0, 0, Cell::Number(9.0)),
                (0, 0, Cell::Number(1.0)),
            ],
            "1.0\n3.0\t4.0",
        ),
        (vec![(0, 0, Cell::Number(f64::NAN)), (0, 1, Cell::Number(2.0))], "\t2.0"),
    ];
    for (cells, expected) in cases {
        let mut book = one(cells);
        for five in [false, true] {
            book.five = five;
            // Single-byte texts contain no letters of other alphabets.
            if five && expected.contains('Δ') {
                continue;
            }
            assert_eq!(sheets(book.bytes(), u64::MAX).expect("a workbook").remove(0).text, expected, "{book:?}");
            assert_eq!(sheets(book.stream(), 1).expect("a stream").remove(0).text, expected, "{book:?}");
        }
    }
    let from_1904 = OldWorkbook { from_1904: true, ..one(vec![(0, 0, Cell::Formatted(43951.5, 4))]) };
    assert_eq!(sheets(from_1904.bytes(), 7).expect("a workbook").remove(0).text, "2024-05-01T12:00:00");
}

#[test]
fn shared_texts_go_on_in_further_records() {
    let texts = vec![
        vec![("t [s]", false)],
        vec![("Größe ", false), ("Δ", true), (" [cm]", false)],
        vec![("値", true), ("", false), ("x", false)],
        vec![("😀", true)],
        vec![("", false)],
    ];
    let cells = (0..5).map(|index| (0, index as u16, Cell::Shared(index))).collect();
    let book = OldWorkbook { texts, ..one(cells) };
    assert_eq!(sheets(book.bytes(), 3).expect("a workbook").remove(0).text, "t [s]\tGröße Δ [cm]\t値x\t😀");
    let missing = OldWorkbook { texts: book.texts.clone(), ..one(vec![(0, 0, Cell::Shared(5))]) };
    assert_eq!(sheets(missing.bytes(), 3), Err(WorkbookError::Damaged));
}

/// A table of some rows in a workbook of any size, small and large streams.
fn table(rows: u16, seed: u64) -> OldWorkbook {
    let mut random = SplitMix64::new(seed);
    let mut cells = vec![(0, 0, Cell::Shared(0)), (0, 1, Cell::Shared(1))];
    for row in 1..=rows {
        let value = (random.bits() >> 40) as f64 / 7.0;
        cells.push((row, 0, Cell::Rk(compact(row.into(), true))));
        cells.push((
            row,
            1,
            if random.bits().is_multiple_of(3) { Cell::Rk(compact(7, true)) } else { Cell::Number(value) },
        ));
    }
    let texts = vec![vec![("t [s]", false)], vec![("y ", false), ("[cm]", true)]];
    OldWorkbook {
        sheets: vec![("Notes", vec![(0, 0, Cell::Label("none"))]), ("Film", cells)],
        texts,
        ..OldWorkbook::default()
    }
}

#[test]
fn another_reader_finds_the_same_numbers() {
    for (rows, seed) in [(2, 1), (40, 2), (300, 3), (5000, 4)] {
        let bytes = table(rows, seed).bytes();
        let mut other: Xls<_> = Xls::new(Cursor::new(bytes.clone())).expect("a workbook");
        let range = other.worksheet_range("Film").expect("a sheet");
        let found = in_slices(bytes.clone(), MOST, usize::MAX).expect("a table");
        let columns = &found.import.table.columns;
        assert_eq!((columns[0].name.as_str(), columns[1].name.as_str(), found.import.findings.len()), ("t", "y", 1));
        assert_eq!(columns[0].values.len(), usize::from(rows));
        for (index, column) in columns.iter().enumerate() {
            let expected: Vec<f64> = range
                .rows()
                .skip(1)
                .map(|row| match row[index] {
                    Data::Float(value) => value,
                    Data::Int(value) => value as f64,
                    ref other => panic!("{other:?}"),
                })
                .collect();
            assert_eq!(column.values, expected);
        }
        assert_eq!(format!("{found:?}"), format!("{:?}", in_slices(bytes, MOST, 100).expect("a table")));
    }
}

#[test]
fn what_is_no_old_workbook_is_refused_in_words() {
    let refused = |bytes: Vec<u8>| sheets(bytes, u64::MAX).expect_err("refused");
    let book = table(20, 1);
    assert_eq!(refused(OldWorkbook { encrypted: true, ..book.clone() }.bytes()), WorkbookError::Protected);
    assert_eq!(refused(compound("EncryptedPackage", &[0; 5000])), WorkbookError::Protected);
    assert_eq!(refused(compound("WordDocument", &[0; 5000])), WorkbookError::NoCells);
    for old in [[9, 0, 4, 0, 2, 0, 0x10, 0], [9, 2, 6, 0, 0, 0, 0x10, 0], [9, 4, 6, 0, 0, 0, 0x10, 0]] {
        assert!(workbook::is_workbook(&old));
        assert_eq!(refused(old.to_vec()), WorkbookError::TooOld);
        assert_eq!(refused(compound("Book", &old)), WorkbookError::TooOld);
    }
    assert_eq!(
        refused([b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", &[0; 32 << 20][..]].concat()),
        WorkbookError::TooLarge { most: 32 }
    );
    assert!(matches!(refused(one(vec![(0, 256, Cell::Number(1.0))]).bytes()), WorkbookError::Place { .. }));
    // Sheets that share their cells would be read repeatedly.
    let mut bytes = table(20, 1).stream();
    let entry = |bytes: &[u8], from: usize| from + bytes[from..].windows(2).position(|pair| pair == [0x85, 0]).unwrap();
    let (first, place) = (entry(&bytes, 0), 4);
    let second = entry(&bytes, first + 1);
    bytes.copy_within(first + place..first + place + 4, second + place);
    assert_eq!(refused(bytes), WorkbookError::Damaged);
    for language in [Language::English, catalogues::with(Language::Spanish)] {
        for error in [WorkbookError::TooOld, WorkbookError::NoCells, WorkbookError::Protected] {
            assert!(!error.message(language).is_empty() && !error.hint(language).is_empty());
        }
    }
}

/// A shared text of 32,000 characters in 20,000 cells exceeds the memory.
#[test]
fn text_that_cells_repeat_is_bounded() {
    let long: &'static str = "x".repeat(8000).leak();
    let cells = (0..20_000).map(|index| (index / 200, index % 200, Cell::Shared(0))).collect();
    let book = OldWorkbook { texts: vec![vec![(long, false)]], ..one(cells) };
    let mut workbook = Workbook::open(book.bytes(), 256 << 20).expect("a workbook");
    let refused = loop {
        match workbook.advance(u64::MAX) {
            Ok(Progress::More) => {}
            other => break other,
        }
    };
    assert_eq!(refused, Err(WorkbookError::TooLarge { most: 9 }));
}

/// Changes of the header, the tables of sectors, the directory and the records; cut, doubled and overwritten.
#[test]
fn any_change_of_an_old_workbook_is_read_or_refused() {
    let mut random = SplitMix64::new(26);
    let seeds = [
        table(3, 1).bytes(),
        table(120, 2).bytes(),
        table(60, 3).stream(),
        OldWorkbook { five: true, ..table(30, 4) }.bytes(),
    ];
    let (mut read_again, mut refused) = (0, 0);
    for round in 0..1200 {
        let mut bytes = seeds[round % seeds.len()].clone();
        for _ in 0..1 + random.bits() % 4 {
            let length = bytes.len() as u64;
            // Every second change is among the sizes.
            let at = (random.bits() % if random.bits().is_multiple_of(2) { length.min(1600) } else { length }) as usize;
            match random.bits() % 5 {
                0 => bytes[at] = random.bits() as u8,
                1 => bytes[at] ^= 1 << (random.bits() % 8),
                2 => bytes[at..].iter_mut().take(4).for_each(|byte| *byte = 0xff),
                3 => bytes[at..].iter_mut().take(4).for_each(|byte| *byte = random.bits() as u8),
                _ => bytes.truncate(at.max(8)),
            }
        }
        match in_slices(bytes, MOST, 1 << 12) {
            Ok(_) => read_again += 1,
            Err(error) => {
                refused += 1;
                assert!(
                    !error.message(Language::English).is_empty()
                        && !error.hint(catalogues::with(Language::Spanish)).is_empty()
                );
            }
        }
    }
    assert!(read_again > 100 && refused > 100, "{read_again} {refused}");
}

/// A chain of sectors that leads back to itself, wherever it begins.
#[test]
fn circles_of_sectors_end() {
    let whole = table(120, 2).bytes();
    let tables = whole.len() - 512;
    for entry in (0..128).step_by(3) {
        for target in [0_u32, 1, 2, 3, entry] {
            let mut bytes = whole.clone();
            let at = tables + 4 * entry as usize;
            bytes[at..at + 4].copy_from_slice(&target.to_le_bytes());
            let _ = sheets(bytes, u64::MAX);
        }
    }
    for at in [44, 48, 60, 64, 68, 72, 76, 80] {
        for value in [0_u32, 1, 2, 127, 0x7fff_ffff, 0xffff_fff0] {
            let mut bytes = whole.clone();
            bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
            let _ = sheets(bytes, u64::MAX);
        }
    }
}

//! Encodings, refusals and limits of reading text, and the columns that are found in it.

use crate::import::{read, shown};
use crate::support::utube_bytes;
use analysis::import;
use units::Language;

#[test]
fn other_encodings_are_read() {
    let text = "Zeit [µs];Höhe [cm]\n0;1,5\n1;2,5\n";
    let expected = read(text.as_bytes());
    assert_eq!(expected.table.columns[0].unit.as_ref().map(|unit| unit.factor), Some(1e-6));
    let latin: Vec<u8> = text.chars().map(|character| u8::try_from(u32::from(character)).expect("Latin-1")).collect();
    assert_eq!(read(&latin), expected);
    let little: Vec<u8> = [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    assert_eq!(read(&little), expected);
    let big: Vec<u8> = [0xfe, 0xff].into_iter().chain(text.encode_utf16().flat_map(u16::to_be_bytes)).collect();
    assert_eq!(read(&big), expected);
}

#[test]
fn what_is_no_table_is_refused_with_place_and_reason() {
    let cases: &[(&[u8], &str)] = &[
        (b"", "the file is empty"),
        (b" \r\n\n", "the file is empty"),
        (b"PK\x03\x04rest", "this is not text but a ZIP archive, as XLSX, ODS and TRZ are"),
        (b"\x7fELF\x02\x01\x01\0\0\0", "this is not text: it has bytes that no text has"),
        (
            b"<?xml version=\"1.0\"?>\n<object class=\"org.opensourcephysics.cabrillo.tracker\">",
            "this is XML, or HTML without a table",
        ),
        (b"Dear Ann,\nhow are you?\n", "line 1: there is no table: no line has numbers; the first is `Dear Ann,`"),
        (b"y\n1.5\n2.5\n", "line 2: there is only one column of numbers; a measurement needs the time and a quantity"),
        (b"t,y\n0,1\n", "line 2: there are fewer than two rows of numbers"),
        (
            b"t,y\n0,5,1,5\n0,6,2,5\n",
            "line 2: 4 numbers for 2 names: the comma seems to be both delimiter and decimal sign",
        ),
        (
            b"t y z\n0 1 2\na 2 b\nc 3 d\ne 4 f\n5 g h\n7 i j\n",
            "line 3: `a` in column 1 is not a number, and there are more words than numbers",
        ),
    ];
    for (bytes, expected) in cases {
        match import::text(bytes) {
            Ok(import) => panic!("{expected}: read as\n{}", shown(&import)),
            Err(error) => {
                assert_eq!(error.message(Language::English), *expected);
                assert!(
                    !error.message(catalogues::with(Language::Spanish)).is_empty()
                        && !error.hint(catalogues::with(Language::Spanish)).is_empty()
                        && !error.hint(Language::English).is_empty()
                );
            }
        }
    }
}

#[test]
fn columns_are_found_by_name_body_and_number() {
    let table = read(b"A\t\tB\t\nt\ty\tt\tY\n0\t1\t0\t3\n1\t2\t1\t4\n").table;
    for (which, expected) in [
        ("y", Some(1)),
        ("Y", Some(3)),
        ("A.y", Some(1)),
        ("b.y", Some(3)),
        (" B.Y ", Some(3)),
        ("T", Some(0)),
        ("4", Some(3)),
        ("0", None),
        ("5", None),
        ("", None),
        ("z", None),
        ("A.", None),
    ] {
        assert_eq!(table.column(which).ok(), expected, "{which}");
    }
    assert_eq!(table.independent().collect::<Vec<_>>(), [0, 2]);
    assert_eq!(table.observed_columns().collect::<Vec<_>>(), [1, 3]);
    assert_eq!(table.times_of(3), [0.0, 1.0]);
    assert_eq!(table.times_of(9), [0.0; 0]);
    assert_eq!([0, 1, 2, 3].map(|index| table.label(index)), ["A.t", "y", "B.t", "Y"]);
}

#[test]
fn a_comma_that_is_rare_is_found() {
    let mut text = String::new();
    for row in 0..5000 {
        let value = if row % 10 == 9 && row > 400 { "0,5" } else { "1" };
        text.push_str(&format!("{row}\t{value}\n"));
    }
    let import = read(text.as_bytes());
    assert_eq!(import.format.decimal, b',');
    assert_eq!(import.findings, []);
    assert_eq!(import.table.columns[1].values[4999], 0.5);
}

#[test]
fn a_small_file_cannot_ask_for_much_memory() {
    let mut text = "1;2\n".repeat(100_000);
    text.push_str(&"1;".repeat(100_000));
    let import = read(text.as_bytes());
    assert!(import.table.columns.len() * import.table.rows() <= 4_000_000);
    assert!(import.findings.iter().any(|finding| finding.text(Language::English).contains("the first in line 100001")));
    // Also with a header wider than the table.
    let text = format!("{}\n{}", "t\ty [?]\t".repeat(100_000), "1\t2\n".repeat(10_000));
    let import = read(text.as_bytes());
    assert!(import.table.columns.len() * import.table.rows() <= 4_000_000);
    assert!(import.findings.len() <= 21, "{}", import.findings.len());
    assert!(analysis::inspection::inspect(&import.table).findings.is_empty());
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn measured_records_have_four_columns_and_all_rows() {
    for (name, rows) in [("U1", 226), ("U2", 238), ("U3", 267), ("U4", 271)] {
        let bytes = utube_bytes(name);
        let import = read(&bytes);
        assert_eq!(import.format.text(catalogues::with(Language::Spanish)), "espacios, punto decimal, sin encabezado");
        assert_eq!((import.table.columns.len(), import.table.rows(), import.findings.len()), (4, rows, 0), "{name}");
        assert_eq!(import.table.observed_columns().collect::<Vec<_>>(), [1, 2, 3]);
    }
}

//! Workbooks of other programs: contents of their cells, and limits for hostile files.

use crate::support::packed::{Pack, ods, xlsx, xlsx_with};
use crate::support::{all_sheets, in_slices};
use analysis::finding::Finding;
use analysis::import::DateOrder;
use analysis::reading::{self, Reading, ReadingError};
use analysis::workbook::{Progress, SheetText, Workbook, WorkbookError};
use proptest::prelude::*;
use units::Language;

/// Limit above the size of all sheets of these tests.
const MOST: usize = 1 << 20;

/// All sheets, read in slices of this many bytes.
fn sheets(bytes: Vec<u8>, budget: u64) -> Result<Vec<SheetText>, WorkbookError> {
    all_sheets(Workbook::open(bytes, MOST)?, budget)
}

fn text(bytes: Vec<u8>) -> String {
    sheets(bytes, u64::MAX).expect("a workbook").remove(0).text
}

#[test]
fn cells_of_office_open_xml_are_read_as_they_are_shown() {
    // Rows of a sheet, and the lines that they become. Styles: 1 is a date and time, 2 a duration, 3 per cent, 4 a time of day.
    let cases = [
        (r#"<row r="1"><c r="A1"><v>1</v></c><c r="B1"><v>-2.5E-3</v></c></row>"#, "1\t-2.5E-3"),
        (r#"<row><c><v>1</v></c><c><v>2</v></c></row><row><c><v>3</v></c></row>"#, "1\t2\n3"),
        (
            r#"<row r="2"><c r="C2"><v>1</v></c></row><row r="5"><c r="AA5"><v>2</v></c></row>"#,
            "\n\t\t1\n\n\n\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t\t2",
        ),
        (
            r#"<row r="1"><c r="A1" t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c><c r="C1" t="s"><v>9</v></c></row>"#,
            "t [s]\ty & <z> [cm]",
        ),
        (r#"<row r="1"><c r="A1" t="inlineStr"><is><r><t>a&#10;b</t></r><r><t>"c"</t></r></is></c></row>"#, "a b c "),
        (r#"<row r="1"><c r="A1"><f>B1/0</f><v>7</v></c><c r="B1" t="str"><f>"x"</f><v>x</v></c></row>"#, "7\tx"),
        (r##"<row r="1"><c r="A1" t="e"><v>#DIV/0!</v></c><c r="B1" t="b"><v>1</v></c></row>"##, "#DIV/0!\tTRUE"),
        (
            r#"<row r="1"><c r="A1" s="1"><v>45413.5000005787</v></c><c r="B1" s="2"><v>1.5</v></c></row>"#,
            "2024-05-01T12:00:00.05\t36:00:00",
        ),
        (r#"<row r="1"><c r="A1" s="3"><v>0.05</v></c><c r="B1" s="4"><v>0.5</v></c></row>"#, "5%\t12:00:00"),
        (
            r#"<row r="1"><c r="A1" t="d"><v>2024-05-01T12:00:00</v></c><c r="B1" s="1" t="s"><v>0</v></c></row>"#,
            "2024-05-01T12:00:00\tt [s]",
        ),
        // Cells that are formatted but empty, such as those of a merged range.
        (r#"<row r="1"><c r="A1" s="1"/><c r="B1"><v>2</v></c></row><row r="9"><c r="A9" s="1"/></row>"#, "\t2"),
        // The date that spreadsheets cannot show stays a number.
        (r#"<row r="1"><c r="A1" s="1"><v>1e9</v></c></row>"#, "1e9"),
    ];
    for (rows, expected) in cases {
        assert_eq!(text(xlsx(&[("Film", rows)])), expected, "{rows}");
    }
    let from_1904 = r#"<workbookPr date1904="true"/>"#;
    let row = r#"<row r="1"><c r="A1" s="1"><v>43951.5</v></c><c r="B1" s="4"><v>0.5</v></c></row>"#;
    assert_eq!(text(xlsx_with(from_1904, &[("Film", row)], Pack::Deflated)), "2024-05-01T12:00:00\t12:00:00");
}

#[test]
fn cells_of_open_document_are_read_as_they_are_shown() {
    let cases = [
        (
            r#"<table:table-row><table:table-cell office:value-type="float" calcext:value-type="string" office:value="0.1"><text:p>0,10</text:p></table:table-cell></table:table-row>"#,
            "0.1",
        ),
        (
            r#"<table:table-row><table:table-cell office:value-type="string"><text:p>a<text:s/>b</text:p><text:p>c</text:p></table:table-cell></table:table-row>"#,
            "a b c",
        ),
        (
            r#"<table:table-row><table:table-cell table:number-columns-repeated="2"/><table:table-cell office:value-type="float" office:value="1" table:number-columns-repeated="2"/></table:table-row>"#,
            "\t\t1\t1",
        ),
        (
            r#"<table:table-row table:number-rows-repeated="2"><table:table-cell/></table:table-row><table:table-row table:number-rows-repeated="3"><table:table-cell office:value-type="float" office:value="1"/></table:table-row><table:table-row><table:table-cell office:value-type="float" office:value="2"/></table:table-row>"#,
            "\n\n1\n1\n1\n2",
        ),
        (
            r#"<table:table-row><table:table-cell office:value-type="date" office:date-value="2024-05-01T12:00:00.050"/><table:table-cell office:value-type="time" office:time-value="PT00H00M00.05S"/></table:table-row>"#,
            "2024-05-01T12:00:00.05\t00:00:00.05",
        ),
        (
            r#"<table:table-row><table:table-cell office:value-type="percentage" office:value="0.05"/><table:table-cell office:value-type="boolean" office:boolean-value="false"/></table:table-row>"#,
            "5%\tFALSE",
        ),
        // A number format with a unit, and a currency.
        (
            r#"<table:table-row><table:table-cell office:value-type="float" office:value="3.14159"><text:p>3,14 ms</text:p></table:table-cell><table:table-cell office:value-type="float" office:value="-2"><text:p>-2.0°C</text:p></table:table-cell><table:table-cell office:value-type="currency" office:value="5"><text:p>5,00 €</text:p></table:table-cell><table:table-cell office:value-type="float" office:value="1500"><text:p>1.5E3</text:p></table:table-cell></table:table-row>"#,
            "3.14159 ms\t-2 °C\t5\t1500",
        ),
        // A remark is not content of its cell, and cells covered by a merged one are empty.
        (
            r#"<table:table-row><table:table-cell office:value-type="float" office:value="1"><office:annotation><text:p>why?</text:p></office:annotation></table:table-cell><table:covered-table-cell/><table:table-cell office:value-type="float" office:value="3"/></table:table-row>"#,
            "1\t\t3",
        ),
        (
            r#"<table:table-row table:number-rows-repeated="1048576"><table:table-cell table:number-columns-repeated="16384"/></table:table-row>"#,
            "",
        ),
    ];
    for (rows, expected) in cases {
        assert_eq!(text(ods(&[("Film", rows)])), expected, "{rows}");
    }
}

/// A few rows of a table.
const TABLE: &str = r#"<row r="1"><c r="A1" t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c></row><row r="2"><c r="A2"><v>0</v></c><c r="B2"><v>1</v></c></row><row r="3"><c r="A3"><v>0.1</v></c><c r="B3"><v>2</v></c></row>"#;
const WORDS: &str = r#"<row r="1"><c r="A1" t="inlineStr"><is><t>Filmed in May</t></is></c></row>"#;

#[test]
fn dates_typed_as_texts_follow_the_stated_order() {
    let row = |number: usize, date: &str, value: usize| {
        format!(
            r#"<row r="{number}"><c r="A{number}" t="inlineStr"><is><t>{date}</t></is></c><c r="B{number}"><v>{value}</v></c></row>"#
        )
    };
    let rows: String = [("02/03/2024", 1), ("03/03/2024", 2), ("05/03/2024", 4)]
        .iter()
        .enumerate()
        .map(|(place, (date, value))| row(place + 1, date, *value))
        .collect();
    let read = |order| Reading::new(xlsx(&[("Film", &rows)]), MOST).expect("a workbook").with_dates(order).complete();
    let error = read(None).expect_err("the order is open");
    assert!(error.is_of_dates(), "{error:?}");
    for (order, second, third) in [(DateOrder::DayFirst, 1.0, 3.0), (DateOrder::MonthFirst, 29.0, 90.0)] {
        let contents = read(Some(order)).expect("a table");
        let days: Vec<f64> = contents.import.table.columns[0].values.iter().map(|time| time / 86_400.0).collect();
        assert_eq!(days, [0.0, second, third], "{order:?}");
        assert_eq!(analysis::import::text(contents.text.as_bytes()).expect("a table").table, contents.import.table);
    }
}

#[test]
fn the_first_sheet_with_a_table_is_read_and_named() {
    let read = |sheets: &[(&str, &str)]| reading::read(xlsx(sheets), MOST).expect("a table").import;
    let alone = read(&[("Film", TABLE)]);
    assert_eq!((alone.table.rows(), alone.findings.len()), (2, 0));
    for sheets in [[("Notes", WORDS), ("Film", TABLE)], [("Film", TABLE), ("More", TABLE)]] {
        let import = read(&sheets);
        assert_eq!(import.table, alone.table);
        assert_eq!(import.findings, [Finding::Sheet("Film".to_owned())]);
    }
    let error = reading::read(xlsx(&[("Notes", WORDS)]), MOST).expect_err("no table");
    assert!(matches!(&error, ReadingError::Sheet { name, .. } if name == "Notes"), "{error:?}");
    // The text of a sheet can be read again.
    let contents = reading::read(xlsx(&[("Film", TABLE)]), MOST).expect("a table");
    assert_eq!(analysis::import::text(contents.text.as_bytes()).expect("a table").table, contents.import.table);
}

#[test]
fn cells_where_no_sheet_has_any_are_refused_unwritten() {
    let cell = |reference: &str| format!(r#"<row><c r="{reference}"><v>1</v></c></row>"#);
    for reference in ["A4294967295", "A4294967296", "A1048577", "XFE1", "ZZZZZZZZ1", "A0", "A", "1", "A-1"] {
        let refused = sheets(xlsx(&[("Film", &cell(reference))]), u64::MAX);
        assert_eq!(refused, Err(WorkbookError::Place { cell: reference.to_owned() }), "{reference}");
    }
    for rows in [
        r#"<row r="4294967295"><c><v>1</v></c></row>"#,
        r#"<row r="99999999999999999999"><c r="A1"><v>1</v></c></row>"#,
        // Cells out of order.
        r#"<row r="3"><c><v>1</v></c></row><row r="2"><c><v>1</v></c></row>"#,
        r#"<row r="3"><c r="C3"><v>1</v></c><c r="B3"><v>1</v></c></row>"#,
    ] {
        let refused = sheets(xlsx(&[("Film", rows)]), u64::MAX);
        assert!(matches!(refused, Err(WorkbookError::Place { .. })), "{rows}: {refused:?}");
    }
    // The last possible cell is read, and a sheet of many such rows is too large.
    let mut workbook = Workbook::open(xlsx(&[("Film", &cell("XFD1048576"))]), 2 * MOST).expect("a workbook");
    while workbook.advance(u64::MAX).expect("the last cell of all") == Progress::More {}
    let wide: String = (1..200).map(|row| format!(r#"<row r="{row}"><c r="XFD{row}"><v>1</v></c></row>"#)).collect();
    assert_eq!(sheets(xlsx(&[("Film", &wide)]), u64::MAX), Err(WorkbookError::TooLarge { most: MOST >> 20 }));
    for repeated in ["1048577", "4294967295"] {
        let row = format!(
            r#"<table:table-row table:number-rows-repeated="{repeated}"><table:table-cell office:value-type="float" office:value="1"/></table:table-row>"#
        );
        assert_eq!(sheets(ods(&[("Film", &row)]), u64::MAX), Err(WorkbookError::TooLarge { most: MOST >> 20 }));
    }
    let row = r#"<table:table-row><table:table-cell office:value-type="float" office:value="1" table:number-columns-repeated="4294967295"/></table:table-row>"#;
    assert!(matches!(sheets(ods(&[("Film", row)]), u64::MAX), Err(WorkbookError::Place { .. })));
}

#[test]
fn what_would_expand_too_much_is_refused_before_it_is_expanded() {
    // 20 MB of cells in 20 kB, as its directory says.
    let bomb = r#"<row><c r="A1"><v>1</v></c></row>"#.repeat(600_000);
    let bytes = xlsx(&[("Film", &bomb)]);
    assert!(bytes.len() < 100_000, "{}", bytes.len());
    let refused = sheets(bytes, u64::MAX);
    assert!(matches!(refused, Err(WorkbookError::Expands { .. })), "{refused:?}");
    // If the directory states a smaller size, the expansion ends there.
    let understated = xlsx_with("", &[("Film", &bomb)], Pack::Understated);
    assert_eq!(sheets(understated, 1 << 16), Err(WorkbookError::Damaged));
    let kind = |bytes: Vec<u8>| sheets(bytes, u64::MAX).expect_err("refused");
    assert_eq!(kind(xlsx_with("", &[("Film", TABLE)], Pack::WrongChecksum)), WorkbookError::Damaged);
    assert_eq!(kind(xlsx_with("", &[("Film", TABLE)], Pack::Encrypted)), WorkbookError::Protected);
    assert_eq!(kind(xlsx(&[])), WorkbookError::NoCells);
    // Tags without end, and tags within tags.
    assert_eq!(kind(xlsx(&[("Film", &format!("<row {}>", "a='b' ".repeat(190_000)))])), WorkbookError::Damaged);
    assert_eq!(kind(xlsx(&[("Film", &"<x>".repeat(300))])), WorkbookError::Damaged);
    let texts = "<![CDATA[0123456789]]>".repeat(30_000);
    assert_eq!(kind(xlsx(&[("Film", &format!("<row><c><v>{texts}</v></c></row>"))])), WorkbookError::Damaged);
    // Any truncated file is a workbook or is refused.
    let whole = xlsx(&[("Film", TABLE)]);
    for end in 0..whole.len() {
        assert!(sheets(whole[..end].to_vec(), u64::MAX).is_err(), "{end}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_file_is_the_same_in_slices_as_at_once(
        rows in prop::collection::vec((-1e3..1e3_f64, prop::option::of(-1e3..1e3_f64)), 2..60),
        budget in 1_usize..400,
        ends in prop::sample::select(vec!["\n", "\r\n", "\r"]),
        word in 0_usize..60,
    ) {
        let cell = |(row, (x, y)): (usize, &(f64, Option<f64>))| {
            let y = y.map(|y| format!("{y:?}")).unwrap_or_default();
            if row == word { format!("{x:?}\toops") } else { format!("{x:?}\t{y}") }
        };
        let lines: Vec<String> = rows.iter().enumerate().map(cell).collect();
        let text = format!("t [s]\ty [cm]{ends}{}{ends}", lines.join(ends));
        let bytes = text.into_bytes();
        // Compared as text, because NaN is not equal to itself.
        prop_assert_eq!(format!("{:?}", in_slices(bytes.clone(), MOST, budget)), format!("{:?}", reading::read(bytes, MOST)));
        let number = |reference: String, value: f64| format!(r#"<c r="{reference}"><v>{value:?}</v></c>"#);
        let row = |(row, (x, y)): (usize, &(f64, Option<f64>))| {
            let row = row + 2;
            let y = y.map(|y| number(format!("B{row}"), y)).unwrap_or_default();
            format!(r#"<row r="{row}">{}{y}</row>"#, number(format!("A{row}"), *x))
        };
        let sheet: String = rows.iter().enumerate().map(row).collect();
        let bytes = xlsx(&[("Notes", WORDS), ("Film", &sheet)]);
        // Compared as text, because NaN is not equal to itself.
        prop_assert_eq!(format!("{:?}", in_slices(bytes.clone(), MOST, budget)), format!("{:?}", reading::read(bytes, MOST)));
    }

    #[test]
    fn any_change_of_a_workbook_is_read_or_refused(at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        for mut bytes in [xlsx(&[("Film", TABLE)]), ods(&[("Film", "<table:table-row/>")])] {
            let at = at.index(bytes.len());
            bytes[at] = byte;
            if let Err(error) = sheets(bytes, 100) {
                prop_assert!(!error.message(catalogues::with(Language::Spanish)).is_empty() && !error.hint(catalogues::with(Language::Spanish)).is_empty());
            }
        }
    }
}

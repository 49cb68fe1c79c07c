//! Workbooks and CSV files as read by other programs.

use analysis::csv::{self, Dialect};
use analysis::import;
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use calamine::{Data, Reader, Xlsx};
use std::io::Cursor;
use std::process::Command;

fn workbook() -> Workbook {
    let data = Sheet::of_columns("Data", &["t [s]", "y [cm]"], &[&[0.0, 0.1, 0.3], &[-1.5e-9, f64::NAN]]);
    let results = Sheet {
        name: "Results: [1/2]".to_owned(),
        rows: vec![
            vec![Cell::from("<b> & \"c\""), Cell::Empty, Cell::from(1e300)],
            vec![Cell::from("=1+1"), Cell::from(" γ\u{1} ")],
        ],
        header: false,
    };
    let wide = Sheet {
        name: "data".to_owned(),
        rows: vec![(0..800).map(|n| Cell::from(f64::from(n))).collect()],
        header: false,
    };
    Workbook { sheets: vec![data, results, wide] }
}

#[test]
fn a_workbook_is_read_by_another_library() {
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(workbook().xlsx())).expect("a workbook");
    assert_eq!(book.sheet_names(), ["Data", "Results- -1-2-", "data 3"]);
    let data = book.worksheet_range("Data").expect("a sheet");
    let cell = |row, column| data.get_value((row, column)).cloned().unwrap_or_default();
    assert_eq!(cell(0, 0), Data::String("t [s]".to_owned()));
    assert_eq!(cell(0, 1), Data::String("y [cm]".to_owned()));
    assert_eq!(cell(3, 0), Data::Float(0.3));
    assert_eq!(cell(1, 1), Data::Float(-1.5e-9));
    assert_eq!((cell(2, 1), cell(3, 1)), (Data::Empty, Data::Empty));
    let results = book.worksheet_range("Results- -1-2-").expect("a sheet");
    assert_eq!(results.get_value((0, 0)), Some(&Data::String("<b> & \"c\"".to_owned())));
    assert_eq!(results.get_value((0, 2)), Some(&Data::Float(1e300)));
    assert_eq!(results.get_value((1, 0)), Some(&Data::String("=1+1".to_owned())));
    assert_eq!(results.get_value((1, 1)), Some(&Data::String(" γ\u{fffd} ".to_owned())));
    let wide = book.worksheet_range("data 3").expect("a sheet");
    for column in [0, 25, 26, 701, 702, 799] {
        assert_eq!(wide.get_value((0, column)), Some(&Data::Float(f64::from(column))), "{column}");
    }
}

#[test]
fn a_workbook_has_the_same_bytes_every_time_and_may_be_empty() {
    assert_eq!(workbook().xlsx(), workbook().xlsx());
    let book: Xlsx<_> = Xlsx::new(Cursor::new(Workbook::default().xlsx())).expect("a workbook");
    assert_eq!(book.sheet_names(), ["1"]);
}

#[test]
#[ignore = "needs LibreOffice"]
fn libreoffice_opens_a_workbook() {
    let directory = std::env::temp_dir().join(format!("meniscus-workbook-{}", std::process::id()));
    std::fs::create_dir_all(&directory).expect("a directory");
    std::fs::write(directory.join("book.xlsx"), workbook().xlsx()).expect("it can be written");
    let profile = format!("-env:UserInstallation=file://{}/profile", directory.display());
    let converted = Command::new("soffice")
        .args([profile.as_str(), "--headless", "--convert-to", "csv", "book.xlsx"])
        .current_dir(&directory)
        .output()
        .expect("LibreOffice");
    let text = std::fs::read_to_string(directory.join("book.csv")).unwrap_or_else(|_| panic!("{converted:?}"));
    // The notation of small numbers depends on the version.
    let text = text.replace("-0.0000000015", "-1.5E-09");
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    assert_eq!(lines, ["t [s],y [cm]", "0,-1.5E-09", "0.1,", "0.3,"]);
    std::fs::remove_dir_all(&directory).expect("it is ours");
}

#[test]
fn csv_files_are_written_in_both_dialects_and_read_back() {
    let headers = ["t [s]", "y, \"raw\"", "=cmd"];
    let columns: [&[f64]; 3] = [&[0.0, 0.1, 1e-7], &[-2.5, f64::NAN, 3e20], &[1.0, 2.0]];
    let commas = csv::write(&headers, &columns, Dialect::Commas);
    assert_eq!(commas, "t [s],\"y, \"\"raw\"\"\",\"'=cmd\"\r\n0,-2.5,1\r\n0.1,,2\r\n1E-7,3E20,\r\n");
    let semicolons = csv::write(&headers, &columns, Dialect::Semicolons);
    assert_eq!(semicolons, "\u{feff}t [s];\"y, \"\"raw\"\"\";\"'=cmd\"\r\n0;-2,5;1\r\n0,1;;2\r\n1E-7;3E20;\r\n");
    for text in [commas, semicolons] {
        let table = import::text(text.as_bytes()).expect("a table").table;
        assert_eq!(table.columns[0].values, columns[0]);
        assert_eq!((table.columns[1].values[0], table.columns[1].values[2]), (-2.5, 3e20));
        assert!(table.columns[1].values[1].is_nan() && table.columns[2].values[2].is_nan());
        assert_eq!(table.columns[0].unit.as_ref().map(|unit| unit.text.as_str()), Some("s"));
    }
}

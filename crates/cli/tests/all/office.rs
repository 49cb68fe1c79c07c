//! Exchange with spreadsheet programs: their files are read, and they open the files written here.

use crate::common::{meniscus, numbers};
use analysis::spreadsheet::Archive;
use calamine::{Data, Ods, Reader};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::Command;

/// An oscillation in centimetres, at 30 frames a second; the tenth frame is missing.
fn rows() -> Vec<(f64, f64)> {
    let level = |t: f64| 5.0 * libm::exp(-0.4 * t) * libm::cos(9.6 * t) + 0.01 * libm::sin(170.0 * t * t);
    let times = (0..120).filter(|frame| *frame != 9).map(|frame| f64::from(frame) / 30.0);
    times.map(|t| (t, level(t))).collect()
}

fn written(directory: &Path, name: &str, bytes: &[u8]) -> PathBuf {
    let path = directory.join(name);
    std::fs::write(&path, bytes).expect("it can be written");
    path
}

fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// Asserts that the cycles found in a file are those of the rows.
fn reads(path: &Path) {
    let text: String = rows().iter().map(|(t, y)| format!("{t:?}\t{y:?}\n")).collect();
    let plain = written(path.parent().expect("a directory"), "plain.txt", format!("t [s]\ty [cm]\n{text}").as_bytes());
    let cycles = |path: &Path| {
        let done = meniscus(&["cycles", word(path), "--format", "csv"]);
        assert_eq!(done.code, 0, "{}: {}", path.display(), done.stderr);
        done.stdout
    };
    let (found, expected) = (cycles(path), cycles(&plain));
    assert_eq!(found.lines().next(), expected.lines().next(), "{}", path.display());
    let (found, expected) = (numbers(&found), numbers(&expected));
    assert_eq!(found.len(), expected.len(), "{}", path.display());
    for (one, other) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((one - other).abs() <= 1e-6 * other.abs().max(1e-6), "{}: {one} is not {other}", path.display());
    }
}

/// An OpenDocument spreadsheet (ISO/IEC 26300) as other programs write it: repeated cells, and a first sheet of text.
fn ods() -> Vec<u8> {
    let mut content = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><office:document-content \
         xmlns:office=\"urn:oasis:names:tc:opendocument:xmlns:office:1.0\" \
         xmlns:table=\"urn:oasis:names:tc:opendocument:xmlns:table:1.0\" \
         xmlns:text=\"urn:oasis:names:tc:opendocument:xmlns:text:1.0\" office:version=\"1.2\"><office:body>\
         <office:spreadsheet><table:table table:name=\"Notes\"><table:table-row><table:table-cell \
         office:value-type=\"string\"><text:p>Filmed in May</text:p></table:table-cell></table:table-row></table:table>\
         <table:table table:name=\"Film\"><table:table-column table:number-columns-repeated=\"2\"/><table:table-row>",
    );
    for head in ["t [s]", "y [cm]"] {
        content +=
            &format!("<table:table-cell office:value-type=\"string\"><text:p>{head}</text:p></table:table-cell>");
    }
    content += "</table:table-row>";
    for (t, y) in rows() {
        content += "<table:table-row>";
        for value in [t, y] {
            content += &format!(
                "<table:table-cell office:value-type=\"float\" office:value=\"{value:?}\"><text:p>{value:.2}</text:p></table:table-cell>"
            );
        }
        content += "<table:table-cell table:number-columns-repeated=\"1022\"/></table:table-row>";
    }
    content += "<table:table-row table:number-rows-repeated=\"1048000\"><table:table-cell \
                table:number-columns-repeated=\"1024\"/></table:table-row></table:table></office:spreadsheet>\
                </office:body></office:document-content>";
    let kind = "application/vnd.oasis.opendocument.spreadsheet";
    let manifest = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><manifest:manifest \
         xmlns:manifest=\"urn:oasis:names:tc:opendocument:xmlns:manifest:1.0\"><manifest:file-entry \
         manifest:full-path=\"/\" manifest:media-type=\"{kind}\"/><manifest:file-entry \
         manifest:full-path=\"content.xml\" manifest:media-type=\"text/xml\"/></manifest:manifest>"
    );
    let mut archive = Archive::default();
    archive.add("mimetype", kind.as_bytes());
    archive.add("META-INF/manifest.xml", manifest.as_bytes());
    archive.add("content.xml", content.as_bytes());
    archive.finish()
}

/// An Office Open XML workbook (ECMA-376) as other programs write it: a table of shared texts, numbers with all digits,
/// cells with styles, a dimension.
fn xlsx() -> Vec<u8> {
    const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    const RELATIONS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006";
    const KIND: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml";
    let part =
        |name: &str, kind: &str| format!("<Override PartName=\"/xl/{name}.xml\" ContentType=\"{KIND}.{kind}+xml\"/>");
    let relation = |id: usize, kind: &str, target: &str| {
        format!("<Relationship Id=\"rId{id}\" Type=\"{RELATIONS}/{kind}\" Target=\"{target}\"/>")
    };
    let mut sheet = format!(
        "<worksheet xmlns=\"{MAIN}\"><dimension ref=\"A1:B120\"/><sheetData><row r=\"1\" spans=\"1:2\"><c r=\"A1\" s=\"1\" \
         t=\"s\"><v>0</v></c><c r=\"B1\" s=\"1\" t=\"s\"><v>1</v></c></row>"
    );
    for (index, (t, y)) in rows().into_iter().enumerate() {
        let row = index + 2;
        sheet += &format!(
            "<row r=\"{row}\" spans=\"1:2\"><c r=\"A{row}\"><v>{t:.17}</v></c><c r=\"B{row}\"><v>{y:.17}</v></c></row>"
        );
    }
    sheet += "</sheetData><pageMargins left=\"0.7\" right=\"0.7\" top=\"0.75\" bottom=\"0.75\" header=\"0.3\" footer=\"0.3\"/></worksheet>";
    let files = [
        (
            "[Content_Types].xml",
            format!(
                "<Types xmlns=\"{PACKAGE}/content-types\"><Default Extension=\"rels\" \
                 ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"xml\" \
                 ContentType=\"application/xml\"/>{}{}{}</Types>",
                part("workbook", "sheet.main"),
                part("worksheets/sheet1", "worksheet"),
                part("sharedStrings", "sharedStrings")
            ),
        ),
        (
            "_rels/.rels",
            format!(
                "<Relationships xmlns=\"{PACKAGE}/relationships\">{}</Relationships>",
                relation(1, "officeDocument", "xl/workbook.xml")
            ),
        ),
        (
            "xl/workbook.xml",
            format!(
                "<workbook xmlns=\"{MAIN}\" xmlns:r=\"{RELATIONS}\"><sheets><sheet name=\"Film\" sheetId=\"7\" r:id=\"rId3\"/></sheets></workbook>"
            ),
        ),
        (
            "xl/_rels/workbook.xml.rels",
            format!(
                "<Relationships xmlns=\"{PACKAGE}/relationships\">{}{}</Relationships>",
                relation(3, "worksheet", "worksheets/sheet1.xml"),
                relation(4, "sharedStrings", "sharedStrings.xml")
            ),
        ),
        (
            "xl/sharedStrings.xml",
            format!(
                "<sst xmlns=\"{MAIN}\" count=\"2\" uniqueCount=\"2\"><si><t>t [s]</t></si><si><r><t>y </t></r><r><t>[cm]</t></r></si></sst>"
            ),
        ),
        ("xl/worksheets/sheet1.xml", sheet),
    ];
    let mut archive = Archive::default();
    for (name, content) in files {
        archive
            .add(name, format!("<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n{content}").as_bytes());
    }
    archive.finish()
}

#[test]
fn workbooks_of_other_programs_are_read() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    reads(&written(directory.path(), "film.ods", &ods()));
    reads(&written(directory.path(), "film.xlsx", &xlsx()));
}

/// Converts a file in its directory with LibreOffice, with separate settings.
fn converted(directory: &Path, file: &str, to: &str) {
    let profile = format!("-env:UserInstallation=file://{}/profile", directory.display());
    let done = Command::new("soffice")
        .args([profile.as_str(), "--headless", "--convert-to", to, "--outdir", "converted", file])
        .current_dir(directory)
        .output()
        .expect("LibreOffice");
    assert!(done.status.success(), "{done:?}");
}

#[test]
#[ignore = "needs LibreOffice"]
fn libreoffice_opens_the_workbook_of_a_fit_and_its_files_are_read() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let text: String = rows().iter().map(|(t, y)| format!("{t:?},{y:?}\n")).collect();
    let data = written(directory.path(), "film.csv", format!("t [s],y [cm]\n{text}").as_bytes());
    let book = directory.path().join("fit.xlsx");
    let done =
        meniscus(&["fit", "simulations/theories/cosine.md", word(&data), "--observe", "y", "--output", word(&book)]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    converted(directory.path(), "fit.xlsx", "ods");
    let bytes = std::fs::read(directory.path().join("converted/fit.ods")).expect("it was opened");
    let mut opened = Ods::new(Cursor::new(bytes)).expect("a spreadsheet");
    assert_eq!(opened.sheet_names(), ["Results", "Data", "Curves", "Correlations", "About"]);
    let sheet = opened.worksheet_range("Data").expect("a sheet");
    for (row, (t, y)) in (1..).zip(rows()) {
        for (column, expected) in [(0, t), (1, y / 100.0)] {
            let Some(Data::Float(value)) = sheet.get_value((row, column)) else { panic!("row {row}, column {column}") };
            assert!((value - expected).abs() < 1e-9, "row {row}: {value} is not {expected}");
        }
    }
    // No cell is an error or a formula: each has the written content.
    for name in opened.sheet_names() {
        let sheet = opened.worksheet_range(&name).expect("a sheet");
        assert!(!sheet.used_cells().any(|(_, _, cell)| matches!(cell, Data::Error(_))), "{name}");
        assert!(opened.worksheet_formula(&name).expect("a sheet").is_empty(), "{name}");
    }
    // Files written by LibreOffice are read, regardless of their source.
    for form in ["ods", "xlsx", "xls"] {
        converted(directory.path(), "film.csv", form);
        reads(&directory.path().join("converted").join(format!("film.{form}")));
    }
}

#[test]
#[ignore = "needs LibreOffice"]
fn a_csv_with_decimal_commas_opens_in_libreoffice_as_numbers() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let text: String = rows().iter().map(|(t, y)| format!("{t:?},{y:?}\n")).collect();
    let data = written(directory.path(), "film.csv", format!("t [s],y [cm]\n{text}").as_bytes());
    let commas = directory.path().join("comas.csv");
    let done = meniscus(&["derivatives", word(&data), "--observe", "y", "--decimal-comma", "--output", word(&commas)]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    // Opened with the settings of Spain: semicolons (59), UTF-8 (76), language 1034, numbers recognised.
    let directory = directory.path();
    let profile = format!("-env:UserInstallation=file://{}/profile", directory.display());
    let filter = "--infilter=Text - txt - csv (StarCalc):59,34,76,1,,1034,false,true,false";
    let done = Command::new("soffice")
        .args([profile.as_str(), "--headless", filter, "--convert-to", "ods", "--outdir", "converted", "comas.csv"])
        .current_dir(directory)
        .output();
    let output = done.expect("LibreOffice");
    let bytes = std::fs::read(directory.join("converted/comas.ods")).unwrap_or_else(|_| panic!("{output:?}"));
    let mut opened = Ods::new(Cursor::new(bytes)).expect("a spreadsheet");
    let name = opened.sheet_names().remove(0);
    let sheet = opened.worksheet_range(&name).expect("a sheet");
    assert_eq!(sheet.get_value((0, 1)), Some(&Data::String("y [cm]".to_owned())));
    for (row, (t, y)) in (1..).zip(rows()) {
        for (column, expected) in [(0, t), (1, y)] {
            let Some(Data::Float(value)) = sheet.get_value((row, column)) else { panic!("row {row}, column {column}") };
            // LibreOffice keeps fifteen digits.
            assert!((value - expected).abs() < 1e-13, "row {row}: {value} is not {expected}");
        }
    }
}

//! Writer of XLSX workbooks: a few XML files (Office Open XML, ECMA-376) in a ZIP archive without compression.

mod zip;

use crate::scale_line;
use std::fmt::Write;
use units::markup::escaped;
pub use zip::Archive;

/// Workbook.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Workbook {
    /// Sheets, in the order of their tabs.
    pub sheets: Vec<Sheet>,
}

/// Sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// Name of the tab; characters that a spreadsheet does not allow are replaced.
    pub name: String,
    /// Rows of cells. The first is bold and frozen if `header` is set.
    pub rows: Vec<Vec<Cell>>,
    /// True if the first row is a header.
    pub header: bool,
}

/// Content of a cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Cell {
    /// Empty cell.
    #[default]
    Empty,
    /// Number; written as an empty cell if not finite.
    Number(f64),
    /// Text, never interpreted as a formula.
    Text(String),
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl Sheet {
    /// Sheet with columns of numbers, each below its header; columns may differ in length.
    pub fn of_columns(name: &str, headers: &[&str], columns: &[&[f64]]) -> Self {
        let length = columns.iter().map(|column| column.len()).max().unwrap_or(0);
        let mut rows = Vec::with_capacity(length + 1);
        rows.push(headers.iter().map(|header| Cell::from(*header)).collect());
        for row in 0..length {
            rows.push(
                columns
                    .iter()
                    .map(|column| column.get(row).map_or(Cell::Empty, |value| Cell::Number(*value)))
                    .collect(),
            );
        }
        Self { name: name.to_owned(), rows, header: true }
    }

    /// Sheet of a film as in [`Self::of_columns`], below a row with the relative standard error of its scale, if there is
    /// one.
    pub fn of_film(name: &str, headers: &[&str], columns: &[&[f64]], scale_error: Option<f64>) -> Self {
        let mut sheet = Self::of_columns(name, headers, columns);
        if let Some(error) = scale_error {
            sheet.rows.insert(0, vec![scale_line(error).into()]);
        }
        sheet
    }
}

/// Limits of a sheet in spreadsheet programs.
const MOST_ROWS: usize = 1_048_576;
const MOST_COLUMNS: usize = 16_384;
const LONGEST_TEXT: usize = 32_767;

const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const RELATIONS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006";

impl Workbook {
    /// Bytes of the file. Rows, columns and texts beyond the limits of spreadsheet programs are left out.
    pub fn xlsx(&self) -> Vec<u8> {
        let sheets: &[Sheet] = if self.sheets.is_empty() {
            &[Sheet { name: String::new(), rows: Vec::new(), header: false }]
        } else {
            &self.sheets
        };
        let mut archive = Archive::default();
        archive.add("[Content_Types].xml", content_types(sheets.len()).as_bytes());
        let office = format!(
            "{DECLARATION}<Relationships xmlns=\"{PACKAGE}/relationships\"><Relationship Id=\"rId1\" \
             Type=\"{RELATIONS}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
        );
        archive.add("_rels/.rels", office.as_bytes());
        let (workbook, relations) = workbook(sheets);
        archive.add("xl/workbook.xml", workbook.as_bytes());
        archive.add("xl/_rels/workbook.xml.rels", relations.as_bytes());
        archive.add("xl/styles.xml", styles().as_bytes());
        for (index, sheet) in sheets.iter().enumerate() {
            archive.add(&format!("xl/worksheets/sheet{}.xml", index + 1), worksheet(sheet).as_bytes());
        }
        archive.finish()
    }
}

fn content_types(sheets: usize) -> String {
    const KIND: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml";
    let mut xml = format!(
        "{DECLARATION}<Types xmlns=\"{PACKAGE}/content-types\"><Default Extension=\"rels\" \
         ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Override \
         PartName=\"/xl/workbook.xml\" ContentType=\"{KIND}.sheet.main+xml\"/><Override PartName=\"/xl/styles.xml\" \
         ContentType=\"{KIND}.styles+xml\"/>"
    );
    for number in 1..=sheets {
        let _ = write!(
            xml,
            "<Override PartName=\"/xl/worksheets/sheet{number}.xml\" ContentType=\"{KIND}.worksheet+xml\"/>"
        );
    }
    xml + "</Types>"
}

/// XML of the list of sheets, and of their relations.
fn workbook(sheets: &[Sheet]) -> (String, String) {
    let mut list = format!("{DECLARATION}<workbook xmlns=\"{MAIN}\" xmlns:r=\"{RELATIONS}\"><sheets>");
    let mut relations = format!("{DECLARATION}<Relationships xmlns=\"{PACKAGE}/relationships\">");
    let mut names: Vec<String> = Vec::new();
    for (index, sheet) in sheets.iter().enumerate() {
        let number = index + 1;
        let name = tab(&sheet.name, number, &names);
        list.push_str("<sheet name=\"");
        list.push_str(&escaped(&name));
        let _ = write!(list, "\" sheetId=\"{number}\" r:id=\"rId{number}\"/>");
        let _ = write!(
            relations,
            "<Relationship Id=\"rId{number}\" Type=\"{RELATIONS}/worksheet\" Target=\"worksheets/sheet{number}.xml\"/>"
        );
        names.push(name.to_lowercase());
    }
    let _ = write!(
        relations,
        "<Relationship Id=\"rId{}\" Type=\"{RELATIONS}/styles\" Target=\"styles.xml\"/></Relationships>",
        sheets.len() + 1
    );
    (list + "</sheets></workbook>", relations)
}

/// Valid name of a tab: at most 31 characters, none of `[]:*?/\`, no apostrophe at the ends, not empty, and different from
/// those of the other sheets.
fn tab(name: &str, number: usize, others: &[String]) -> String {
    let plain: String = name
        .chars()
        .map(|character| if "[]:*?/\\".contains(character) || character.is_control() { '-' } else { character })
        .take(27)
        .collect();
    let plain = plain.trim_matches(['\'', ' ']);
    if plain.is_empty() || others.contains(&plain.to_lowercase()) {
        return format!("{plain} {number}").trim().to_owned();
    }
    plain.to_owned()
}

/// Two styles: normal, and bold for headers.
fn styles() -> String {
    format!(
        "{DECLARATION}<styleSheet xmlns=\"{MAIN}\"><fonts count=\"2\"><font><sz val=\"11\"/><name val=\"Calibri\"/></font>\
         <font><b/><sz val=\"11\"/><name val=\"Calibri\"/></font></fonts><fills count=\"2\"><fill><patternFill \
         patternType=\"none\"/></fill><fill><patternFill patternType=\"gray125\"/></fill></fills><borders \
         count=\"1\"><border><left/><right/><top/><bottom/><diagonal/></border></borders><cellStyleXfs count=\"1\"><xf \
         numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\"/></cellStyleXfs><cellXfs count=\"2\"><xf numFmtId=\"0\" \
         fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\"/><xf numFmtId=\"0\" fontId=\"1\" fillId=\"0\" borderId=\"0\" \
         xfId=\"0\" applyFont=\"1\"/></cellXfs></styleSheet>"
    )
}

fn worksheet(sheet: &Sheet) -> String {
    let mut xml = format!("{DECLARATION}<worksheet xmlns=\"{MAIN}\">");
    if sheet.header {
        xml.push_str(
            "<sheetViews><sheetView workbookViewId=\"0\"><pane ySplit=\"1\" topLeftCell=\"A2\" activePane=\"bottomLeft\" \
             state=\"frozen\"/></sheetView></sheetViews>",
        );
    }
    let widths = widths(sheet);
    if !widths.is_empty() {
        xml.push_str("<cols>");
        for (index, width) in widths.iter().enumerate() {
            let number = index + 1;
            let _ = write!(xml, "<col min=\"{number}\" max=\"{number}\" width=\"{width}\" customWidth=\"1\"/>");
        }
        xml.push_str("</cols>");
    }
    xml.push_str("<sheetData>");
    for (index, row) in sheet.rows.iter().take(MOST_ROWS).enumerate() {
        let bold = if sheet.header && index == 0 { " s=\"1\"" } else { "" };
        let _ = write!(xml, "<row r=\"{}\">", index + 1);
        for (column, cell) in row.iter().take(MOST_COLUMNS).enumerate() {
            match cell {
                Cell::Number(value) if value.is_finite() => {
                    xml.push_str("<c r=\"");
                    push_place(&mut xml, column, index);
                    let _ = write!(xml, "\"{bold}><v>{value:?}</v></c>");
                }
                Cell::Text(text) if !text.is_empty() => {
                    xml.push_str("<c r=\"");
                    push_place(&mut xml, column, index);
                    let _ = write!(xml, "\"{bold} t=\"inlineStr\"><is><t xml:space=\"preserve\">");
                    let end = text.char_indices().nth(LONGEST_TEXT).map_or(text.len(), |(end, _)| end);
                    xml.push_str(&escaped(&text[..end]));
                    xml.push_str("</t></is></c>");
                }
                _ => {}
            }
        }
        xml.push_str("</row>");
    }
    xml + "</sheetData></worksheet>"
}

/// Column widths in characters, from the texts within limits and from the usual length of a number.
fn widths(sheet: &Sheet) -> Vec<usize> {
    let mut widths: Vec<usize> = Vec::new();
    for row in sheet.rows.iter().take(200) {
        for (column, cell) in row.iter().take(MOST_COLUMNS).enumerate() {
            let needed = match cell {
                Cell::Empty => 0,
                Cell::Number(_) => 10,
                Cell::Text(text) => text.chars().count(),
            };
            if widths.len() <= column {
                widths.push(0);
            }
            widths[column] = widths[column].max(needed);
        }
    }
    widths.into_iter().map(|width| width.clamp(6, 60) + 2).collect()
}

/// Appends a cell reference: `B3` for the second column of the third row.
fn push_place(out: &mut String, column: usize, row: usize) {
    let mut letters = [b'A'; 4];
    let mut length = 0;
    let mut rest = column + 1;
    while rest > 0 && length < letters.len() {
        letters[length] = b'A' + ((rest - 1) % 26) as u8;
        rest = (rest - 1) / 26;
        length += 1;
    }
    out.extend(letters[..length].iter().rev().map(|letter| char::from(*letter)));
    let _ = write!(out, "{}", row + 1);
}

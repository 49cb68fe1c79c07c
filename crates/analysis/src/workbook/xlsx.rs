//! Office Open XML (ECMA-376): list of sheets, shared texts, and cells of a sheet.

use super::moment::Moment;
use super::refusal::WorkbookError;
use super::sheet::{LONGEST_VALUE, Lines, MOST_ROWS};
use super::styles::{self, NumberFormat};
use super::texts::Texts;
use packed::Archive;
use packed::{Tag, Token, Xml};
use std::collections::BTreeMap;
use units::order::sort_by_key;

/// Upper bound of the size of the parts that describe the workbook, in bytes.
const SMALL: Option<u64> = Some(16 << 20);
/// Upper bound of the number of sheets.
const MOST_SHEETS: usize = 1000;

/// Path of the part with the list of sheets, unless the archive states another one.
pub(super) const BOOK: &str = "xl/workbook.xml";

/// Entry in the list of sheets.
#[derive(Clone, Debug)]
pub(super) struct SheetEntry {
    pub name: String,
    /// Path of its part in the archive.
    pub part: String,
    hidden: bool,
}

/// Properties common to all sheets.
#[derive(Debug)]
pub(super) struct Book {
    pub sheets: Vec<SheetEntry>,
    styles: Vec<NumberFormat>,
    from_1904: bool,
    /// Path of the part with the shared texts, if there is one.
    pub texts: Option<String>,
}

impl Book {
    /// Reads the description of the workbook.
    pub fn open(archive: &Archive) -> Result<Self, WorkbookError> {
        let of_package = relations(archive, "_rels/.rels")?;
        let document = of_package.into_values().find(|target| target.kind == "officeDocument");
        let path = document.map_or_else(|| BOOK.to_owned(), |target| target.path);
        if !archive.has(&path) {
            return Err(WorkbookError::NoSheets { found: archive.first_names() });
        }
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", &path));
        let targets = relations(archive, &format!("{folder}/_rels/{file}.rels"))?;
        let of_kind = |kind: &str| {
            let target = targets.values().find(|target| target.kind == kind)?;
            Some(resolved(folder, &target.path)).filter(|path| archive.has(path))
        };
        let styles = match of_kind("styles") {
            Some(path) => styles::read(Xml::new(archive.part(&path, SMALL)?))?,
            None => Vec::new(),
        };
        let mut book = Self { sheets: Vec::new(), styles, from_1904: false, texts: of_kind("sharedStrings") };
        let mut xml = Xml::new(archive.part(&path, SMALL)?);
        loop {
            match xml.next_token()? {
                Token::Open(tag) if tag.name() == "workbookPr" => {
                    book.from_1904 = tag.attribute("date1904").is_some_and(|value| value == "1" || value == "true");
                }
                Token::Open(tag) if tag.name() == "sheet" && book.sheets.len() < MOST_SHEETS => {
                    let target = tag.attribute("id").and_then(|id| targets.get(&id));
                    // A chart sheet has no cells.
                    let path = target.filter(|target| target.kind == "worksheet").map(|target| &target.path);
                    book.sheets.extend(path.map(|path| SheetEntry {
                        name: tag.attribute("name").unwrap_or_default(),
                        part: resolved(folder, path),
                        hidden: tag.attribute("state").is_some_and(|state| state != "visible"),
                    }));
                }
                Token::End => break,
                _ => {}
            }
        }
        // Visible sheets before hidden ones.
        sort_by_key(&mut book.sheets, |sheet| sheet.hidden);
        if book.sheets.is_empty() { Err(WorkbookError::NoCells) } else { Ok(book) }
    }
}

/// Target of a relation.
struct Target {
    /// Last part of its type, such as `worksheet`.
    kind: String,
    path: String,
}

/// Relations in a part, by their ids; empty if there is no such part.
fn relations(archive: &Archive, path: &str) -> Result<BTreeMap<String, Target>, WorkbookError> {
    let mut targets = BTreeMap::new();
    if !archive.has(path) {
        return Ok(targets);
    }
    let mut xml = Xml::new(archive.part(path, SMALL)?);
    loop {
        match xml.next_token()? {
            Token::Open(tag) if tag.name() == "Relationship" && targets.len() < 10 * MOST_SHEETS => {
                let kind = tag.attribute("Type").unwrap_or_default();
                let kind = kind.rsplit('/').next().unwrap_or_default().to_owned();
                let target = Target { kind, path: tag.attribute("Target").unwrap_or_default() };
                targets.insert(tag.attribute("Id").unwrap_or_default(), target);
            }
            Token::End => return Ok(targets),
            _ => {}
        }
    }
}

/// Absolute path for a path relative to a folder.
fn resolved(folder: &str, path: &str) -> String {
    if path.starts_with('/') || folder.is_empty() {
        return path.trim_start_matches('/').to_owned();
    }
    let mut parts: Vec<&str> = folder.split('/').collect();
    for part in path.split('/') {
        match part {
            "." | "" => {}
            ".." => drop(parts.pop()),
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// Reads about `budget` more bytes of the part with the shared texts. Returns true at the end.
pub(super) fn read_texts(
    texts: &mut Texts,
    xml: &mut Xml,
    budget: u64,
    inside: &mut Inside,
) -> Result<bool, WorkbookError> {
    let end = xml.position().saturating_add(budget);
    while xml.position() < end {
        let token = xml.next_token()?;
        match &token {
            Token::End => return Ok(true),
            Token::Text(text) if inside.is_text() => texts.open().push_str(text),
            _ if token.closes("si") => texts.close(),
            _ => inside.follow(&token),
        }
        texts.check()?;
    }
    Ok(false)
}

/// Position of the stream relative to a text and to a phonetic text, which is not shown.
#[derive(Debug, Default)]
pub(super) struct Inside {
    text: bool,
    phonetic: bool,
}

impl Inside {
    fn is_text(&self) -> bool {
        self.text && !self.phonetic
    }

    fn follow(&mut self, token: &Token<'_>) {
        match token {
            _ if token.opens("t") => self.text = true,
            _ if token.closes("t") => self.text = false,
            _ if token.opens("rPh") => self.phonetic = true,
            _ if token.closes("rPh") => self.phonetic = false,
            _ => {}
        }
    }
}

/// Sheet being read.
#[derive(Debug)]
pub(super) struct SheetReader {
    xml: Xml,
    lines: Lines,
    /// Row and column of the next cell without a reference.
    next: (u32, u32),
    cell: Option<Cell>,
    inside: Inside,
    /// True inside the value of a cell.
    in_value: bool,
}

/// Cell being read.
#[derive(Debug, Default)]
struct Cell {
    place: (u32, u32),
    /// Reference as written in the sheet.
    called: String,
    /// Type: `s`, `str`, `inlineStr`, `b`, `e`, `d`; empty or `n` for a number.
    kind: String,
    style: usize,
    value: String,
}

impl SheetReader {
    pub fn new(xml: Xml, most: usize) -> Self {
        Self { xml, lines: Lines::new(most), next: (0, 0), cell: None, inside: Inside::default(), in_value: false }
    }

    pub fn progress(&self) -> f64 {
        self.xml.progress()
    }

    /// Reads about `budget` more bytes. Returns true at the end.
    pub fn read(&mut self, budget: u64, book: &Book, texts: &Texts) -> Result<bool, WorkbookError> {
        let end = self.xml.position().saturating_add(budget);
        while self.xml.position() < end {
            let token = self.xml.next_token()?;
            match (&token, &mut self.cell) {
                (Token::End, _) => return Ok(true),
                (Token::Open(tag), None) if tag.name() == "row" => {
                    let row = tag.attribute("r");
                    self.next = (row_number(row.as_deref(), self.next.0)?, 0);
                }
                (Token::Open(tag), None) if tag.name() == "c" => self.cell = Some(Cell::of(tag, self.next)?),
                (Token::Open(tag), Some(_)) if tag.name() == "v" => self.in_value = true,
                (Token::Close(_), Some(_)) if token.closes("v") => self.in_value = false,
                (Token::Close(_), Some(_)) if token.closes("c") => {
                    if let Some(cell) = self.cell.take() {
                        self.next = (cell.place.0, cell.place.1 + 1);
                        cell.write(&mut self.lines, book, texts)?;
                    }
                }
                (Token::Close(_), None) if token.closes("row") => self.next = (self.next.0 + 1, 0),
                (Token::Close(_), None) if token.closes("sheetData") => return Ok(true),
                (Token::Text(text), Some(cell)) if self.in_value || self.inside.is_text() => {
                    cell.value.push_str(text);
                    if cell.value.len() > LONGEST_VALUE {
                        return Err(WorkbookError::Damaged);
                    }
                }
                (_, Some(_)) => self.inside.follow(&token),
                _ => {}
            }
        }
        Ok(false)
    }

    pub fn finish(self) -> String {
        self.lines.finish()
    }
}

/// Row of a reference, from 0; `next` without a reference.
fn row_number(reference: Option<&str>, next: u32) -> Result<u32, WorkbookError> {
    let Some(reference) = reference else { return Ok(next) };
    let row = reference.trim().parse::<u32>().ok().and_then(|row| row.checked_sub(1));
    row.filter(|row| *row < MOST_ROWS)
        .ok_or_else(|| WorkbookError::Place { cell: reference.chars().take(40).collect() })
}

impl Cell {
    fn of(tag: &Tag<'_>, next: (u32, u32)) -> Result<Self, WorkbookError> {
        let called = tag.attribute("r").unwrap_or_default();
        let place = if called.is_empty() { Some(next) } else { place(&called) };
        Ok(Self {
            place: place.ok_or_else(|| WorkbookError::Place { cell: called.chars().take(40).collect() })?,
            called,
            kind: tag.attribute("t").unwrap_or_default(),
            style: tag.number("s").unwrap_or(0) as usize,
            value: String::new(),
        })
    }

    fn write(&self, lines: &mut Lines, book: &Book, texts: &Texts) -> Result<(), WorkbookError> {
        let value = match self.kind.as_str() {
            "s" => self.value.trim().parse().ok().and_then(|index| texts.get(index)).unwrap_or_default(),
            _ => &self.value,
        };
        if value.is_empty() {
            return Ok(());
        }
        let (row, column) = self.place;
        lines.go_to(row, column, &|| self.called.clone())?;
        match self.kind.as_str() {
            "" | "n" => {
                let format = book.styles.get(self.style).copied().unwrap_or_default();
                lines.formatted(value, format, book.from_1904);
            }
            "d" => match Moment::of_iso(value) {
                Some(moment) => lines.moment(moment),
                None => lines.word(value),
            },
            "b" => lines.word(if value.trim() == "1" { "TRUE" } else { "FALSE" }),
            _ => lines.word(value),
        }
        Ok(())
    }
}

/// Row and column of a reference such as `AB12`, from 0; `None` if it is invalid.
fn place(reference: &str) -> Option<(u32, u32)> {
    let reference = reference.trim();
    let letters = reference.bytes().take_while(u8::is_ascii_alphabetic).count();
    if !(1..=3).contains(&letters) {
        return None;
    }
    let (letters, digits) = reference.split_at(letters);
    let column =
        letters.bytes().fold(0, |column, letter| 26 * column + u32::from(letter.to_ascii_uppercase() - b'A') + 1);
    let row: u32 = digits.parse().ok()?;
    Some((row.checked_sub(1)?, column - 1))
}

//! A file of measured data, text or workbook, read in slices: the page never stands still, and the program reads by the
//! same rules.

use crate::finding::Finding;
use crate::import::{self, Import, ImportError, Importer};
use crate::workbook::{self, Progress, Workbook, WorkbookError};
use std::borrow::Cow;
use units::Language::{self, Spanish};

/// A file that is being read.
#[derive(Debug)]
pub struct Reading {
    stage: Stage,
    /// The first sheet that was no table, and why.
    passed: Option<(String, ImportError)>,
}

#[derive(Debug)]
enum Stage {
    /// Bytes of a text.
    Bytes(Vec<u8>),
    /// A text of which nothing is known yet, and the sheet it is of.
    Text(String, Option<Sheet>),
    Rows(Box<Importer<'static>>, Option<Sheet>),
    Sheets(Box<Workbook>),
    Finished(Box<Contents>),
    Failed,
}

/// The sheet that a text was made of, and the rest of its workbook.
#[derive(Debug)]
struct Sheet {
    name: String,
    /// Whether it was not the first.
    others: bool,
    workbook: Box<Workbook>,
}

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Contents {
    /// The table and what was noticed.
    pub import: Import,
    /// The text it was read from; that of a workbook's sheet can be read again by [`import::text`].
    pub text: String,
}

/// Why a file was not read.
#[derive(Clone, Debug, PartialEq)]
pub enum ReadingError {
    /// The text is no table.
    Text(ImportError),
    /// No sheet is a table; this is what was wrong with the first.
    Sheet {
        /// Its name.
        name: String,
        /// Why it is none.
        error: ImportError,
    },
    /// The workbook cannot be read.
    Workbook(WorkbookError),
}

impl ReadingError {
    /// What is wrong, where and why.
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Text(error) => error.message(language),
            Self::Sheet { name, error } if language == Spanish => format!("hoja «{name}», {}", error.message(language)),
            Self::Sheet { name, error } => format!("sheet `{name}`, {}", error.message(language)),
            Self::Workbook(error) => error.message(language),
        }
    }

    /// What to do.
    pub fn hint(&self, language: Language) -> &'static str {
        match self {
            Self::Text(error) | Self::Sheet { error, .. } => error.hint(language),
            Self::Workbook(error) => error.hint(language),
        }
    }
}

impl Reading {
    /// Begins to read a file, of which a sheet may become `most` bytes of text.
    ///
    /// # Errors
    /// What is a workbook that cannot be read.
    pub fn new(bytes: Vec<u8>, most: usize) -> Result<Self, ReadingError> {
        let stage = if workbook::is_workbook(&bytes) {
            Stage::Sheets(Box::new(Workbook::open(bytes, most).map_err(ReadingError::Workbook)?))
        } else {
            Stage::Bytes(bytes)
        };
        Ok(Self { stage, passed: None })
    }

    /// Reads on for about `budget` bytes. Whether it has come to the end.
    ///
    /// # Errors
    /// What is no table. There is nothing more to read then.
    pub fn advance(&mut self, budget: usize) -> Result<bool, ReadingError> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Failed) {
            Stage::Bytes(bytes) => Stage::Text(import::decode(bytes).map_err(ReadingError::Text)?, None),
            Stage::Text(text, sheet) => {
                let text = Cow::Owned(text);
                let importer = if sheet.is_some() { Importer::of_sheet(text) } else { Importer::new(text) };
                match importer {
                    Ok(importer) => Stage::Rows(Box::new(importer), sheet),
                    Err(error) => self.next_sheet(error, sheet)?,
                }
            }
            Stage::Rows(mut importer, sheet) => {
                if importer.advance(budget) {
                    self.finish_rows(*importer, sheet)?
                } else {
                    Stage::Rows(importer, sheet)
                }
            }
            Stage::Sheets(mut workbook) => match workbook.advance(budget as u64).map_err(ReadingError::Workbook)? {
                Progress::More => Stage::Sheets(workbook),
                Progress::Sheet(sheet) => {
                    let others = self.passed.is_some();
                    Stage::Text(sheet.text, Some(Sheet { name: sheet.name, others, workbook }))
                }
                Progress::End => {
                    return Err(match self.passed.take() {
                        Some((name, error)) => ReadingError::Sheet { name, error },
                        None => ReadingError::Workbook(WorkbookError::NoSheets),
                    });
                }
            },
            Stage::Finished(contents) => Stage::Finished(contents),
            Stage::Failed => return Ok(true),
        };
        Ok(matches!(self.stage, Stage::Finished(_)))
    }

    /// Which part has been read, from 0 to 1. A workbook takes most of its time before its text.
    pub fn progress(&self) -> f64 {
        const WORKBOOK: f64 = 0.8;
        match &self.stage {
            Stage::Sheets(workbook) => WORKBOOK * workbook.progress(),
            Stage::Rows(importer, None) => importer.progress(),
            Stage::Text(_, Some(_)) => WORKBOOK,
            Stage::Rows(importer, Some(_)) => WORKBOOK + (1.0 - WORKBOOK) * importer.progress(),
            Stage::Finished(_) => 1.0,
            Stage::Bytes(_) | Stage::Text(_, None) | Stage::Failed => 0.0,
        }
    }

    /// What the file holds, once it has been read.
    pub fn finish(self) -> Option<Contents> {
        if let Stage::Finished(contents) = self.stage { Some(*contents) } else { None }
    }

    /// The rest of the workbook, after a sheet that is no table.
    fn next_sheet(&mut self, error: ImportError, sheet: Option<Sheet>) -> Result<Stage, ReadingError> {
        let Some(Sheet { name, workbook, .. }) = sheet else { return Err(ReadingError::Text(error)) };
        self.passed.get_or_insert((name, error));
        Ok(Stage::Sheets(workbook))
    }

    fn finish_rows(&mut self, importer: Importer<'static>, sheet: Option<Sheet>) -> Result<Stage, ReadingError> {
        match importer.finish() {
            Ok((mut import, text)) => {
                if let Some(mut sheet) = sheet
                    && (sheet.others || sheet.workbook.has_more())
                {
                    import.findings.insert(0, Finding::Sheet(sheet.name));
                }
                Ok(Stage::Finished(Box::new(Contents { import, text: text.into_owned() })))
            }
            Err(error) => self.next_sheet(error, sheet),
        }
    }
}

/// Reads a file at once.
///
/// # Errors
/// What is no table.
pub fn read(bytes: Vec<u8>, most: usize) -> Result<Contents, ReadingError> {
    let mut reading = Reading::new(bytes, most)?;
    while !reading.advance(usize::MAX)? {}
    reading.finish().ok_or(ReadingError::Workbook(WorkbookError::Damaged))
}

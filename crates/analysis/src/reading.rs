//! Reading of a file of measured data in slices: text, workbook, archive of texts or Tracker project. Page and command line
//! use the same rules.

use crate::data_sets::DataSets;
use crate::finding::Finding;
use crate::import::{self, DateOrder, Import, ImportError, Importer, Refusal};
use crate::tracker::{self, Gathering, Opening, Project, TrackerError};
use crate::workbook::{self, Progress, SheetText, Workbook, WorkbookError};
use packed::Archive;
use std::borrow::Cow;
use units::{Language, say};

/// Reading of a file.
#[derive(Debug)]
pub struct Reading {
    stage: Stage,
    /// Upper bound of the text of a sheet or project, in bytes.
    most: usize,
    /// Name of the first sheet that was not a table, with its error.
    passed: Option<(String, ImportError)>,
    /// Sheets read so far, if each is a data set.
    sets: DataSets,
    /// Order of day and month that a person stated.
    dates: Option<DateOrder>,
}

#[derive(Debug)]
enum Stage {
    /// Bytes of a text, with its source.
    Bytes(Vec<u8>, Source),
    /// Decoded text, with its source.
    Text(String, Source),
    Rows(Box<Importer<'static>>, Source),
    Sheets(Box<Workbook>),
    Project(Box<Opening>),
    Finished(Box<Contents>),
    Failed,
}

/// Source of a text.
#[derive(Debug)]
enum Source {
    /// The file itself.
    File,
    Sheet(Sheet),
    /// A project, with the findings about it.
    Project(Box<Project>, Vec<Finding>),
}

/// Sheet that is the source of a text, and the rest of its workbook.
#[derive(Debug)]
struct Sheet {
    name: String,
    /// True if a sheet before it was not a table.
    others: bool,
    workbook: Box<Workbook>,
}

/// Contents of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Contents {
    /// Table with its findings.
    pub import: Import,
    /// Text from which the table was read; that of a sheet or project can be read again by [`import::text`]. Empty if the
    /// table has several data sets.
    pub text: String,
    /// Tracker project that is the source of the table, if its film is in the same archive.
    pub project: Option<Box<Project>>,
}

/// Reason why a file was not read.
#[derive(Clone, Debug, PartialEq)]
pub enum ReadingError {
    /// The text is not a table.
    Text(ImportError),
    /// No file of an archive is a table; the error of the first.
    File {
        /// Name of the file.
        name: String,
        /// Error of the file.
        error: ImportError,
    },
    /// No sheet is a table; the error of the first.
    Sheet {
        /// Name of the sheet.
        name: String,
        /// Error of the sheet.
        error: ImportError,
    },
    /// The workbook cannot be read.
    Workbook(WorkbookError),
    /// The Tracker project cannot be read.
    Project(TrackerError),
}

impl ReadingError {
    /// Message for users: place and reason.
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Text(error) => error.message(language),
            Self::File { name, error } => say!(language, "file `{name}`, {}", error.message(language)),
            Self::Sheet { name, error } => say!(language, "sheet `{name}`, {}", error.message(language)),
            Self::Workbook(error) => error.message(language),
            Self::Project(error) => error.message(language),
        }
    }

    /// True if nothing in the file tells day and month of its dates apart: a person can state their order.
    pub fn is_of_dates(&self) -> bool {
        let (Self::Text(error) | Self::File { error, .. } | Self::Sheet { error, .. }) = self else { return false };
        matches!(error.reason, Refusal::Dates { .. })
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match self {
            Self::Text(error) | Self::File { error, .. } | Self::Sheet { error, .. } => error.hint(language),
            Self::Workbook(error) => error.hint(language),
            Self::Project(error) => error.hint(language),
        }
    }
}

impl Reading {
    /// Begins to read a file. A sheet or a project may become at most `most` bytes of text.
    ///
    /// # Errors
    /// The workbook cannot be read.
    pub fn new(bytes: Vec<u8>, most: usize) -> Result<Self, ReadingError> {
        let stage = if packed::is_archive(&bytes) {
            let archive = Archive::open(bytes).map_err(|defect| ReadingError::Workbook(defect.into()))?;
            match Opening::of_archive(archive) {
                Ok(project) => Stage::Project(Box::new(project)),
                Err(archive) => {
                    Stage::Sheets(Box::new(Workbook::of_archive(archive, most).map_err(ReadingError::Workbook)?))
                }
            }
        } else if workbook::is_old(&bytes) {
            Stage::Sheets(Box::new(Workbook::open(bytes, most).map_err(ReadingError::Workbook)?))
        } else if tracker::is_project(&bytes) {
            Stage::Project(Box::new(Opening::of_xml(bytes)))
        } else {
            Stage::Bytes(bytes, Source::File)
        };
        Ok(Self { stage, most, passed: None, sets: DataSets::default(), dates: None })
    }

    /// Begins to read the project in a partly read archive; `most` as in [`Reading::new`]. `None` without a project.
    pub fn of_gathered(gathering: Gathering, most: usize) -> Option<Self> {
        let project = Opening::of_archive(gathering.finish()?).ok()?;
        Some(Self {
            stage: Stage::Project(Box::new(project)),
            most,
            passed: None,
            sets: DataSets::default(),
            dates: None,
        })
    }

    /// Reading with the order of day and month that a person stated.
    pub fn with_dates(self, dates: Option<DateOrder>) -> Self {
        Self { dates, ..self }
    }

    /// Reads about `budget` more bytes. Returns true at the end.
    ///
    /// # Errors
    /// The file is not a table. Nothing more can be read then.
    pub fn advance(&mut self, budget: usize) -> Result<bool, ReadingError> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Failed) {
            Stage::Bytes(bytes, source) => match import::decode(bytes) {
                Ok(text) => Stage::Text(text, source),
                Err(error) => self.next_sheet(error, source)?,
            },
            Stage::Text(text, source) => {
                let is_text = match &source {
                    Source::File => true,
                    Source::Sheet(sheet) => sheet.workbook.holds_texts(),
                    Source::Project(..) => false,
                };
                let text = match self.dates {
                    Some(order) => import::state_dates(&text, order),
                    None => Ok(text),
                };
                let begin = if is_text { Importer::new } else { Importer::of_sheet };
                match text.and_then(|text| begin(Cow::Owned(text))) {
                    Ok(importer) => Stage::Rows(Box::new(importer), source),
                    Err(error) => self.next_sheet(error, source)?,
                }
            }
            Stage::Rows(mut importer, source) => {
                if importer.advance(budget) {
                    self.finish_rows(*importer, source)?
                } else {
                    Stage::Rows(importer, source)
                }
            }
            Stage::Sheets(mut workbook) => match workbook.advance(budget as u64).map_err(ReadingError::Workbook)? {
                Progress::More => Stage::Sheets(workbook),
                Progress::Sheet(sheet)
                    if workbook.holds_data_sets() && self.sets.describe(&sheet.name, &sheet.text) =>
                {
                    Stage::Sheets(workbook)
                }
                Progress::Sheet(SheetText { name, text }) => {
                    let others = self.passed.is_some();
                    let is_text = workbook.holds_texts();
                    let source = Source::Sheet(Sheet { name, others, workbook });
                    if is_text { Stage::Bytes(text.into_bytes(), source) } else { Stage::Text(text, source) }
                }
                Progress::End if !self.sets.is_empty() => {
                    let (import, text) =
                        std::mem::take(&mut self.sets).join().ok_or(ReadingError::Workbook(WorkbookError::Damaged))?;
                    Stage::Finished(Box::new(Contents { import, text, project: None }))
                }
                Progress::End => {
                    return Err(match self.passed.take() {
                        Some((name, error)) if workbook.holds_texts() => ReadingError::File { name, error },
                        Some((name, error)) => ReadingError::Sheet { name, error },
                        None => ReadingError::Workbook(WorkbookError::NoCells),
                    });
                }
            },
            Stage::Project(mut project) => {
                if project.advance(budget).map_err(ReadingError::Project)? {
                    self.take_project(*project)?
                } else {
                    Stage::Project(project)
                }
            }
            Stage::Finished(contents) => Stage::Finished(contents),
            Stage::Failed => return Ok(true),
        };
        Ok(matches!(self.stage, Stage::Finished(_)))
    }

    /// Reads to the end.
    ///
    /// # Errors
    /// The file is not a table.
    pub fn complete(mut self) -> Result<Contents, ReadingError> {
        while !self.advance(usize::MAX)? {}
        self.finish().ok_or(ReadingError::Workbook(WorkbookError::Damaged))
    }

    /// Progress, from 0 to 1. A workbook or project takes most of its time before its text is available.
    pub fn progress(&self) -> f64 {
        const BEFORE: f64 = 0.8;
        match &self.stage {
            Stage::Sheets(workbook) => BEFORE * workbook.progress(),
            Stage::Project(project) => BEFORE * project.progress(),
            Stage::Rows(importer, Source::File) => importer.progress(),
            Stage::Bytes(_, Source::File) | Stage::Text(_, Source::File) | Stage::Failed => 0.0,
            Stage::Bytes(..) | Stage::Text(..) => BEFORE,
            Stage::Rows(importer, _) => BEFORE + (1.0 - BEFORE) * importer.progress(),
            Stage::Finished(_) => 1.0,
        }
    }

    /// Contents of the file; `None` before the end.
    pub fn finish(self) -> Option<Contents> {
        if let Stage::Finished(contents) = self.stage { Some(*contents) } else { None }
    }

    /// Table of a project that has been read.
    fn take_project(&self, project: Opening) -> Result<Stage, ReadingError> {
        let opened = project.finish().ok_or(ReadingError::Project(TrackerError::Damaged))?;
        let text = opened.project.table(self.most).map_err(ReadingError::Project)?;
        let findings = opened.remarks().into_iter().map(Finding::Project).collect();
        Ok(Stage::Text(text, Source::Project(Box::new(opened.project), findings)))
    }

    /// Continues with the rest of the workbook after a sheet that is not a table.
    fn next_sheet(&mut self, error: ImportError, source: Source) -> Result<Stage, ReadingError> {
        let Source::Sheet(Sheet { name, workbook, .. }) = source else { return Err(ReadingError::Text(error)) };
        if workbook.holds_data_sets() {
            self.sets.pass_over(&name);
        }
        self.passed.get_or_insert((name, error));
        Ok(Stage::Sheets(workbook))
    }

    fn finish_rows(&mut self, importer: Importer<'static>, source: Source) -> Result<Stage, ReadingError> {
        let (mut import, text) = match importer.finish() {
            Ok(finished) => finished,
            Err(error) => return self.next_sheet(error, source),
        };
        let mut project = None;
        match source {
            Source::File => {}
            Source::Sheet(sheet) if sheet.workbook.holds_data_sets() => {
                self.sets.add(sheet.name, import, text.into_owned());
                return Ok(Stage::Sheets(sheet.workbook));
            }
            Source::Sheet(mut sheet) => {
                if sheet.others || sheet.workbook.has_more() {
                    import.findings.insert(0, Finding::Sheet(sheet.name));
                }
            }
            Source::Project(own, findings) => {
                import.findings.splice(0..0, findings);
                project = Some(own).filter(|own| own.film.as_ref().is_some_and(|film| film.packed.is_some()));
            }
        }
        Ok(Stage::Finished(Box::new(Contents { import, text: text.into_owned(), project })))
    }
}

/// Reads a file at once; `most` as in [`Reading::new`].
///
/// # Errors
/// The file is not a table.
pub fn read(bytes: Vec<u8>, most: usize) -> Result<Contents, ReadingError> {
    Reading::new(bytes, most)?.complete()
}

//! Reports and spreadsheets of finished fits.

use crate::fits::ShownFits;
use crate::fits::fit::Fitted;
use crate::number::Style;
use crate::words;
use analysis::csv::Dialect;
use report::{Ranking, Report};

/// A file to be saved.
#[derive(Clone, Debug, PartialEq)]
pub struct Export {
    /// File name.
    pub name: String,
    /// Content of the file.
    pub bytes: Vec<u8>,
    /// Media type.
    pub kind: &'static str,
}

/// Maximum length of a file name without its extension, in characters.
const LONGEST_NAME: usize = 60;

/// File formats of exported fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportKind {
    /// An HTML page for reading and printing.
    Report,
    /// A spreadsheet workbook.
    Workbook,
    /// Comma-separated values; semicolons if the decimal sign is a comma.
    Csv,
}

/// Data of a report that the page supplies.
#[derive(Clone, Copy, Debug, Default)]
pub struct Imprint<'a> {
    /// Date of the report as text; may be empty.
    pub date: &'a str,
    /// Font of the equations, WOFF2 in base64; empty if there is none.
    pub math_font: &'a str,
}

impl Imprint<'_> {
    /// Embeds the font in a page.
    fn page(self, page: &str) -> Vec<u8> {
        if self.math_font.is_empty() {
            return page.to_owned().into_bytes();
        }
        report::with_math_font(page, self.math_font).into_bytes()
    }
}

impl ExportKind {
    /// File extension and media type.
    fn file(self) -> (&'static str, &'static str) {
        match self {
            Self::Report => ("html", "text/html"),
            Self::Workbook => ("xlsx", "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"),
            Self::Csv => ("csv", "text/csv"),
        }
    }
}

impl ShownFits<'_> {
    /// Exports a fit as a file.
    pub fn export(self, id: u32, kind: ExportKind, imprint: Imprint<'_>) -> Option<Export> {
        let fit = self.fits.finished.iter().find(|fit| fit.id == id)?;
        let (command, notes, films) = (self.how_to_repeat(fit), self.notes(fit), self.films.of_fit(self.play, fit));
        let report = Report { films: &films, ..self.report(fit, &notes, command, imprint.date) };
        let bytes = match kind {
            ExportKind::Report => imprint.page(&report::html(&report)),
            ExportKind::Workbook => report::workbook(&report),
            ExportKind::Csv => report::csv(&report, self.play.basis().style().decimal_comma).into_bytes(),
        };
        Some(export(&name(fit), kind, bytes))
    }

    /// Exports all fits of the same values as one ranked file.
    pub fn export_ranking(self, id: u32, kind: ExportKind, imprint: Imprint<'_>) -> Option<Export> {
        let fit = self.fits.finished.iter().find(|fit| fit.id == id)?;
        let group: Vec<&Fitted> = self.fits.finished.iter().filter(|other| other.same_values(fit)).collect();
        let (command, notes) = (self.how_to_repeat(fit), self.notes(fit));
        let date = imprint.date;
        let theories: Vec<Report<'_>> = group.iter().map(|fit| self.report(fit, &notes, command, date)).collect();
        let ranking = Ranking { theories: &theories, command };
        let bytes = match kind {
            ExportKind::Report => imprint.page(&report::ranking_html(&ranking)),
            ExportKind::Workbook => report::ranking_workbook(&ranking),
            ExportKind::Csv => report::ranking_csv(&ranking, self.play.basis().style().decimal_comma).into_bytes(),
        };
        Some(export(&name(fit), kind, bytes))
    }

    /// Input of a report of a fit. `notes`: findings about the data of each record.
    pub(super) fn report<'a>(
        &'a self,
        fit: &'a Fitted,
        notes: &'a [Vec<String>],
        command: &'a str,
        date: &'a str,
    ) -> Report<'a> {
        let file = fit.definition.file.rsplit('/').next();
        Report {
            document: &fit.document,
            document_name: file.filter(|name| !name.is_empty()).unwrap_or(&fit.document.program.title),
            language: self.play.basis().language(),
            task: &fit.task,
            outcome: &fit.outcome,
            traces: &fit.traces,
            intervals: &[],
            notes,
            films: &[],
            command,
            version: program::VERSION_AND_BITS,
            date,
        }
    }

    fn how_to_repeat(self, fit: &Fitted) -> &'static str {
        words::how_to_repeat(self.play.basis().language(), fit.definition.parts.len() > 1)
    }

    /// Findings about the data of a fit, one list per record.
    fn notes(&self, fit: &Fitted) -> Vec<Vec<String>> {
        let records = self.records.shown(self.open()).list();
        let of = |id: u32| records.iter().find(|record| record.id == id).map(|record| record.findings.clone());
        fit.definition.parts.iter().map(|part| of(part.record).unwrap_or_default()).collect()
    }
}

/// File name from the record names: `u3` for `u3.txt`, `u1-u2` for two records.
fn name(fit: &Fitted) -> String {
    let stems: Vec<&str> = fit.definition.parts.iter().map(|part| stem(&part.name)).collect();
    stems.join("-").chars().take(LONGEST_NAME).collect()
}

/// Name of a record without its file extension.
pub(crate) fn stem(record: &str) -> &str {
    record.rsplit_once('.').map_or(record, |(stem, _)| stem)
}

/// File with a safe name: lower case, with hyphens in place of all characters but letters and digits.
pub(crate) fn export(name: &str, kind: ExportKind, bytes: Vec<u8>) -> Export {
    let (ending, kind) = kind.file();
    let plain: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    let name = if plain.is_empty() { "fit".to_owned() } else { plain.to_lowercase() };
    Export { name: format!("{name}.{ending}"), bytes, kind }
}

/// CSV dialect that spreadsheets with this decimal sign open correctly.
pub(crate) fn dialect(style: Style) -> Dialect {
    if style.decimal_comma { Dialect::Semicolons } else { Dialect::Commas }
}

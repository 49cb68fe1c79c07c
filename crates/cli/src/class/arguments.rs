//! Arguments of `meniscus class`.

use clap::{Args, Subcommand, ValueEnum};
use program::Seat;
use std::path::{Path, PathBuf};

/// The commands for a class.
#[derive(Debug, Subcommand)]
pub enum Class {
    /// List the assigned values of all seats, and the right answers with them
    #[command(after_help = ASSIGN_EXAMPLES)]
    Assign(Assign),
    /// Pool the results of a class: what all groups have fitted, outliers, and the common value
    #[command(after_help = REPORT_EXAMPLES)]
    Report(Report),
    /// Count the answers to a survey: shares, frequent words, comments
    #[command(after_help = SURVEY_EXAMPLES)]
    Survey(Survey),
    #[command(flatten)]
    Server(super::server_arguments::ClassServer),
}

const SURVEY_EXAMPLES: &str = "\
Examples:
  meniscus class survey answers/                                shares and frequent words
  meniscus class survey answers/ --output survey.html           a page with bars and word clouds
  meniscus class survey answers/ --comments --output survey.csv

Each file NAME.survey counts as one person. An item is shown from five answers on, and a word if two persons have used it. Comments are
left out unless --comments releases them.";

/// `meniscus class survey`
#[derive(Debug, Args)]
pub struct Survey {
    /// Files with answers, or folders of them
    #[arg(value_name = "FILE", required = true)]
    pub paths: Vec<PathBuf>,

    /// Release the comments
    #[arg(long)]
    pub comments: bool,

    /// The form of the result [default: by the ending of FILE, or text]
    #[arg(long, value_enum)]
    pub format: Option<SurveyFormat>,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Forms of the results of a survey.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SurveyFormat {
    /// Lines for people
    Text,
    /// A page with figures
    Html,
    /// One row for each answer, word and comment
    Csv,
    /// One object for each document
    Json,
}

impl SurveyFormat {
    /// The form asked for; without one by the ending of the file, or text.
    pub fn chosen(asked: Option<Self>, output: Option<&Path>) -> Self {
        let is_page = output.and_then(Path::extension).is_some_and(|ending| ending.eq_ignore_ascii_case("html"));
        let by_ending = match ListFormat::chosen(None, output) {
            ListFormat::Text if is_page => Self::Html,
            ListFormat::Text => Self::Text,
            ListFormat::Csv => Self::Csv,
            ListFormat::Json => Self::Json,
        };
        asked.unwrap_or(by_ending)
    }
}

const REPORT_EXAMPLES: &str = "\
Examples:
  meniscus class report hand-ins/                               every fitted quantity, group by group, and its pooled value
  meniscus class report hand-ins/ --output class.html           a page: curves, results, answers, who is stuck, verification
  meniscus class report hand-ins/ --output class.xlsx           a workbook of results, attempts and hand-ins
  meniscus class report hand-ins/ --output class.csv            the results
  meniscus class report hand-ins/ --format gradebook --output marks.csv    marks by seat and question, for Moodle
  meniscus class report hand-ins/ --against 1/L --power omega_0^2    with the straight line of omega_0^2 over 1/L

The fits are computed again from the curves of the hand-ins. The pooled value is that of random effects (Paule-Mandel, Hartung-Knapp),
which allows for groups that really differ. Outliers are marked with their likely reason; the pooled value is given with and without them.";

/// `meniscus class report`
#[derive(Debug, Args)]
pub struct Report {
    /// Hand-ins, or folders of them
    #[arg(value_name = "FILE", required = true)]
    pub paths: Vec<PathBuf>,

    /// The document of the lesson: hand-ins with another one are named, and answers are graded by it. Can be repeated
    #[arg(long, value_name = "DOC")]
    pub document: Vec<PathBuf>,

    /// The form of the report [default: by the ending of FILE, or text]
    #[arg(long, value_enum)]
    pub format: Option<ReportFormat>,

    /// Set the results against a parameter that each group held fixed, or a power of it, as L, L^2, 1/L, with a straight line
    #[arg(long, value_name = "POWER")]
    pub against: Option<String>,

    /// Of all quantities, set this one or a power of it against the parameter
    #[arg(long, value_name = "POWER", requires = "against")]
    pub power: Option<String>,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Forms of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// The results and their pooled values
    Text,
    /// A page with figures
    Html,
    /// A workbook
    Xlsx,
    /// One row for each result
    Csv,
    /// The results and their pooled values as a list of objects
    Json,
    /// Marks by seat and question as CSV, for the import of grades in Moodle
    Gradebook,
}

impl ReportFormat {
    /// The form asked for; without one by the ending of the file, or text.
    pub fn chosen(asked: Option<Self>, output: Option<&Path>) -> Self {
        let ending = output.and_then(|path| path.extension()?.to_str()).map(str::to_ascii_lowercase);
        let by_ending = match ending.as_deref() {
            Some("html" | "htm") => Self::Html,
            Some("xlsx") => Self::Xlsx,
            Some("csv") => Self::Csv,
            Some("json") => Self::Json,
            _ => Self::Text,
        };
        asked.unwrap_or(by_ending)
    }

    /// True if it has more than the fitted quantities.
    pub fn has_answers(self) -> bool {
        matches!(self, Self::Html | Self::Xlsx | Self::Gradebook)
    }
}

impl ListFormat {
    /// The form asked for; without one by the ending of the file, or text.
    pub fn chosen(asked: Option<Self>, output: Option<&Path>) -> Self {
        let ending = output.and_then(|path| path.extension()?.to_str());
        let by_ending = match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("csv") => Self::Csv,
            Some("json") => Self::Json,
            _ => Self::Text,
        };
        asked.unwrap_or(by_ending)
    }
}

const ASSIGN_EXAMPLES: &str = "\
Examples:
  meniscus class assign tube.md --seats 40                      a table to read
  meniscus class assign tube.md --seats 40 --format csv         for a spreadsheet
  meniscus run tube.md --seat 7                                 the run of one seat

The values depend on the line `assignment: NAME` of the document, the names of the parameters and the seat, and on nothing else:
correcting the text changes nobody's values. The list has hidden values and answers: keep it to yourself.";

/// `meniscus class assign`
#[derive(Debug, Args)]
pub struct Assign {
    /// The document
    #[arg(value_name = "DOC")]
    pub document: PathBuf,

    /// Number of seats
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(Seat::MOST)))]
    pub seats: u32,

    /// The form of the list [default: by the ending of FILE, or text]
    #[arg(long, value_enum)]
    pub format: Option<ListFormat>,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Forms of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ListFormat {
    /// A table with headings
    Text,
    /// One row for each seat
    Csv,
    /// One object
    Json,
}

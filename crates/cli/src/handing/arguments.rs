//! Arguments of `meniscus hand-in` and `meniscus verify`.

use clap::Args;
use std::path::PathBuf;

/// Shown after the help of `meniscus hand-in`.
pub const HAND_IN_EXAMPLES: &str = "\
Examples:
  meniscus hand-in tube.meniscus --name 'blue heron 17'                 writes tube.hand-in
  meniscus hand-in tube.meniscus --name 'group 3' --seat 3 --output group-3.hand-in

A project is what the laboratory saves with *Share*, *Save project*. The hand-in holds it and the values that follow from it: results of
fits, grades, tables of films. `meniscus verify` computes them again.";

/// `meniscus hand-in`
#[derive(Debug, Args)]
pub struct HandIn {
    /// The project, NAME.meniscus
    #[arg(value_name = "PROJECT")]
    pub project: PathBuf,

    /// Pseudonym or name of the group
    #[arg(long, value_name = "NAME")]
    pub name: String,

    /// Seat whose values were assigned, from 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub seat: Option<u32>,

    /// Identifier of the assignment
    #[arg(long, value_name = "ID", default_value = "", hide_default_value = true)]
    pub assignment: String,

    /// The file to write [default: the project's name with .hand-in]
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Shown after the help of `meniscus verify`.
pub const VERIFY_EXAMPLES: &str = "\
Examples:
  meniscus verify group-3.hand-in             computes every value again from the data, and compares the bits
  meniscus verify report.html                 a report that carries its data
  meniscus verify hand-ins/                   all hand-ins and reports in a folder, and data that two of them share
  meniscus verify hand-ins/ --document tube.md   also compares their documents with this one
  meniscus verify hand-ins/ --format json

The exit code is 1 if a value does not follow from its data, a file is damaged, a document is not that of --document, or two hand-ins
share measured data. Equal values show that the results follow from the data; they do not show who took the data or did the work.";

/// `meniscus verify`
#[derive(Debug, Args)]
pub struct Verify {
    /// Hand-ins, reports that carry their data, or folders of them
    #[arg(value_name = "FILE", required = true)]
    pub paths: Vec<PathBuf>,

    /// The document of the lesson: hand-ins with another one are named, and answers are graded by it. Can be repeated
    #[arg(long, value_name = "DOC")]
    pub document: Vec<PathBuf>,

    /// Form of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// Form of the result of a verification.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Lines for people
    Text,
    /// One JSON object
    Json,
}

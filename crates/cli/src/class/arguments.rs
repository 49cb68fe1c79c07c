//! Arguments of `meniscus class`.

use clap::{Args, Subcommand, ValueEnum};
use program::Seat;
use std::path::PathBuf;

/// The commands for a class.
#[derive(Debug, Subcommand)]
pub enum Class {
    /// List the assigned values of all seats, and the right answers with them
    #[command(after_help = ASSIGN_EXAMPLES)]
    Assign(Assign),
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

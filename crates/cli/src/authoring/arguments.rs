//! Arguments of `meniscus new`, `meniscus import` and `meniscus format`.

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use document::TEMPLATES;
use std::path::PathBuf;

/// Shown after the help of `meniscus new`.
pub const NEW_EXAMPLES: &str = "\
Examples:
  meniscus new spring                               spring/spring.md, a mass on a spring
  meniscus new bounce --template projectile         with a throw that bounces
  meniscus new resorte --language es                in Spanish

The document runs at once: `meniscus serve spring/spring.md` shows it while you write it. `meniscus build spring --output site`
makes a web site of the folder. An existing file is not overwritten.";

/// `meniscus new`
#[derive(Debug, Args)]
pub struct New {
    /// The folder, whose name the document gets; it may exist
    #[arg(value_name = "DIR")]
    pub directory: PathBuf,

    /// Template of the document
    #[arg(long, value_name = "NAME", default_value = "oscillator")]
    #[arg(value_parser = PossibleValuesParser::new(TEMPLATES.map(|template| template.name)))]
    pub template: String,
}

/// Shown after the help of `meniscus import`.
pub const IMPORT_EXAMPLES: &str = "\
Examples:
  meniscus import pendulum.ejss                          writes pendulum.md and says what is missing
  meniscus import pendulum_source.json --output bob.md   a simulation of WebEJS
  meniscus import pendulum.zip --report json             the report for programs

Easy JavaScript Simulations (.ejss), WebEJS (_source.json), and a ZIP archive with one of these. A model of plain differential
equations is translated; any other is listed, with its variables, equations and code. Nothing of the file is executed.";

/// `meniscus import`
#[derive(Debug, Args)]
pub struct Import {
    /// The simulation
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// The document to write; `-` is the standard output [default: NAME.md in this folder, if there is none yet]
    #[arg(long, short, value_name = "DOC")]
    pub output: Option<PathBuf>,

    /// The form of the report
    #[arg(long, value_name = "FORMAT", value_enum, default_value = "text")]
    pub report: ReportFormat,
}

/// Form of the report of an import.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// A list of sentences
    Text,
    /// One object
    Json,
}

/// Shown after the help of `meniscus format`.
pub const FORMAT_EXAMPLES: &str = "\
Examples:
  meniscus format simulations/utube.md              writes the file in the layout
  meniscus format simulations/*.md --check          changes nothing; exit code 1 if a layout differs
  meniscus format - < spring.md                     reads the standard input, writes the standard output

The layout: one blank around operators and after commas, statements without indentation, what stands in columns in columns,
no blanks at the ends of lines. Line breaks, comments, spellings, prose and the order of everything stay; the document means the same
afterwards. A block with errors of syntax is left as it is, and that is said.";

/// `meniscus format`
#[derive(Debug, Args)]
pub struct Format {
    /// The documents and translations; `-` reads the standard input and writes the standard output
    #[arg(value_name = "DOC", required = true)]
    pub documents: Vec<PathBuf>,

    /// Write nothing, only say whose layout differs
    #[arg(long)]
    pub check: bool,
}

//! Arguments of the command line.

pub(crate) mod run_settings;

use crate::authoring::arguments::{
    FORMAT_EXAMPLES, Format as FormatDocuments, IMPORT_EXAMPLES, Import, NEW_EXAMPLES, New,
};
use crate::class::arguments::Class;
use crate::fitting::arguments::{FIT_EXAMPLES, Fit, RANK_EXAMPLES, Rank};
use crate::handing::arguments::{HAND_IN_EXAMPLES, HandIn, VERIFY_EXAMPLES, Verify};
use crate::mcp::arguments::{MCP_EXAMPLES, Mcp};
use crate::sweep::arguments::{SWEEP_EXAMPLES, Sweep};
use crate::track::arguments::{TRACK_EXAMPLES, Track};
use analysis::import::DateOrder;
use clap::{Args, Parser, Subcommand, ValueEnum};
use run_settings::RunSettings;
use runner::names::{Assignment, Observe, assignment, date_order, observe};
use std::path::PathBuf;
use units::Language;

/// A virtual laboratory for oscillations: one text document is the simulation.
#[derive(Debug, Parser)]
#[command(name = "meniscus", version = program::VERSION_AND_BITS, after_help = EXIT_CODES, disable_help_subcommand = true)]
pub struct Arguments {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,

    /// Colours in messages [auto: on a terminal, unless NO_COLOR is set]
    #[arg(long, global = true, value_enum, value_name = "WHEN", display_order = 100)]
    #[arg(default_value_t = Color::Auto, hide_default_value = true)]
    pub color: Color,

    /// Language of messages, en or es [default: as LC_ALL, LC_MESSAGES or LANG]
    #[arg(long, global = true, value_parser = crate::terminal::language::parse, value_name = "TAG", display_order = 101)]
    pub language: Option<Language>,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the document has errors, its run failed, a claim of it does not hold, its layout differs (format --check), or a hand-in does not
     hold (verify)
  2  wrong arguments, or a file that cannot be read or written";

/// Choice of coloured messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Open the laboratory in the browser
    #[command(after_help = SERVE_EXAMPLES)]
    Serve(Serve),
    /// Run a document and write its table
    #[command(after_help = RUN_EXAMPLES)]
    Run(Run),
    /// Run a document with many values of its parameters and write what is kept of each run
    #[command(after_help = SWEEP_EXAMPLES)]
    Sweep(Sweep),
    /// Check documents and say what is wrong with them
    #[command(after_help = CHECK_EXAMPLES)]
    Check(Check),
    /// Measure an oscillation cycle by cycle: period, amplitude, damping
    #[command(after_help = CYCLES_EXAMPLES)]
    Cycles(Cycles),
    /// Compute velocity and acceleration from a measured column
    #[command(after_help = DERIVATIVES_EXAMPLES)]
    Derivatives(Derivatives),
    /// Fit a document to measured data
    #[command(after_help = FIT_EXAMPLES)]
    Fit(Fit),
    /// Compare several documents as theories of the same data
    #[command(after_help = RANK_EXAMPLES)]
    Rank(Rank),
    /// Track a liquid's surface or a body in films
    #[command(after_help = TRACK_EXAMPLES)]
    Track(Track),
    /// Make a hand-in from a project: the work, and the values that follow from it
    #[command(after_help = HAND_IN_EXAMPLES)]
    HandIn(HandIn),
    /// Compute the values of hand-ins again from their data
    #[command(after_help = VERIFY_EXAMPLES)]
    Verify(Verify),
    /// Make one offline page of a document, with its source inside
    #[command(after_help = EXPORT_EXAMPLES)]
    Export(Export),
    /// Prepare a lesson: the assigned values of a class
    #[command(subcommand)]
    Class(Class),
    /// Begin a document in a folder of its own
    #[command(after_help = NEW_EXAMPLES)]
    New(New),
    /// Make a document of a simulation of Easy JavaScript Simulations or WebEJS
    #[command(after_help = IMPORT_EXAMPLES)]
    Import(Import),
    /// Give documents their one layout
    #[command(after_help = FORMAT_EXAMPLES)]
    Format(FormatDocuments),
    /// Help editors with documents, as a language server on standard input and output
    #[command(after_help = LSP_EXAMPLES)]
    Lsp,
    /// Give assistants tools for documents, as an MCP server on standard input and output
    #[command(after_help = MCP_EXAMPLES)]
    Mcp(Mcp),
    /// Print the language of documents in short
    #[command(after_help = GUIDE_EXAMPLES)]
    Guide,
    /// Make a web site of all documents in a folder, for any host
    #[command(after_help = BUILD_EXAMPLES)]
    Build(Build),
}

const SERVE_EXAMPLES: &str = "\
Examples:
  meniscus serve                            the laboratory with the document it comes with
  meniscus serve simulations/utube.md       your document; the page follows the file, with its time and values
  meniscus serve --port 8080 --no-open      on that port only, and without opening a browser

The laboratory is served to this computer alone, at 127.0.0.1. Ctrl-C ends it.";

/// `meniscus serve`
#[derive(Debug, Args)]
pub struct Serve {
    /// The document (NAME.md, its translation NAME.es.md, or an exported page); without one, the laboratory's own
    #[arg(value_name = "DOC")]
    pub document: Option<PathBuf>,

    /// This port and no other [default: 4242, or the next one that is free]
    #[arg(long, value_name = "N")]
    pub port: Option<u16>,

    /// Say the address without opening it in the browser
    #[arg(long)]
    pub no_open: bool,
}

const RUN_EXAMPLES: &str = "\
Methods:
  fixed step: euler, euler-richardson, velocity-verlet, rk4
  adaptive:   dormand-prince, rosenbrock (for stiff equations)

Examples:
  meniscus run simulations/utube.md                          as the document says, as CSV
  meniscus run utube.md --set b=200 --set h_l='40 [dm]'      in the declared unit or another
  meniscus run tube.md --seat 7                              the values assigned to this seat
  meniscus run utube.md --preset Mercury --until 20          a preset, for 20 s
  meniscus run kicked.md --press Kick=3.2 --press Kick=5     presses its button Kick at 3.2 s and at 5 s
  meniscus run utube.md --method dormand-prince --tolerance 1e-9
  meniscus run utube.md --columns t,y,E --output run.csv     these columns, into a file
  meniscus run utube.md --format jsonl | head -3             one JSON object a line";

/// `meniscus run`
#[derive(Debug, Args)]
pub struct Run {
    /// The document; `-` reads it from the standard input
    #[arg(value_name = "DOC")]
    pub document: PathBuf,

    /// Parameters, start, method and end of the run
    #[command(flatten)]
    pub settings: RunSettings,

    /// Columns in this order, also constants and parameters [default: all that changes]
    #[arg(long, value_name = "NAMES")]
    pub columns: Option<Vec<String>>,

    /// The form of the table [default: by the ending of FILE, or csv]
    #[arg(long, value_enum)]
    pub format: Option<Format>,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Formats of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// One header row with units, then numbers that read back exactly
    Csv,
    /// One array of objects
    Json,
    /// One object a line
    Jsonl,
}

const LSP_EXAMPLES: &str = "\
Editors start it by themselves: set `meniscus lsp` as the language server of Markdown files. It reports errors with their
remedies, completes and explains names, functions and units, and renames quantities.

Example (Helix, languages.toml):
  [language-server.meniscus]
  command = \"meniscus\"
  args = [\"lsp\"]";

const GUIDE_EXAMPLES: &str = "\
Examples:
  meniscus guide > guide.md      for an assistant that writes a document

It consists of parts of docs/language.md, which says everything.";

const CHECK_EXAMPLES: &str = "\
Examples:
  meniscus check simulations/utube.md            for people
  meniscus check simulations/*.md --format json  for programs
  meniscus check simulations/*.md --run          and whether what their check blocks claim holds
  meniscus check simulations/utube.md --propose  and which claims its check block could make

With --propose each proposal has its reason, its result and its lines for a check block. ✓ holds; ? does not hold and should,
which is a suspicion and no error. The comment `# declined energy E: why` in a check block declines the proposal energy E. In
JSON the findings are one part of an object then, and documents have proposals, untested and declined.

With --run each document without errors is run for its claims, and each claim gets one line: ✓ or ✗, its name, the worst
value and when that was. In JSON a claim that does not hold is a finding of the code check-failed.

JSON is one array of findings: file, severity (error or warning), code (stable), message, line and column (from 1, in
characters), end (the line and column after the place), labels (further places, with their words), notes, hints, dimensions (found and
needed, of a mismatch) and fixes (a title, and edits of the text from line and column to end).";

/// `meniscus check`
#[derive(Debug, Args)]
pub struct Check {
    /// The documents; the translations beside a document (NAME.es.md) are checked with it
    #[arg(value_name = "DOC", required = true)]
    pub documents: Vec<PathBuf>,

    /// Run the documents and see whether the claims of their check blocks hold
    #[arg(long)]
    pub run: bool,

    /// Propose claims that follow from the equations and the labels, each run before it is shown
    #[arg(long)]
    pub propose: bool,

    /// The form of the findings
    #[arg(long, value_enum, default_value_t = Findings::Text)]
    pub format: Findings,
}

/// Formats of findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Findings {
    /// With the line of the source and a mark under the place
    Text,
    /// One array
    Json,
}

const CYCLES_EXAMPLES: &str = "\
Examples:
  meniscus cycles run3.txt                        the column that moves most
  meniscus cycles run3.txt --observe y=3          the third column, called y
  meniscus cycles film.xlsx --observe mass_A.y --from 1 --until '6000 [ms]'
  meniscus cycles run3.txt --output cycles.svg    each quantity against time and amplitude
  meniscus cycles run3.txt --output cycles.csv    the table for a spreadsheet

DATA is text as Tracker, loggers and spreadsheets write it, XLSX, XLS or ODS, or a project of Tracker (TRK, TRZ): time, then
one or more quantities. docs/data.md has the rules. In the linear theory frequency and damping are the same in every cycle.";

/// `meniscus cycles`
#[derive(Debug, Args)]
pub struct Cycles {
    /// The measured data; `-` reads text from the standard input
    #[arg(value_name = "DATA")]
    pub data: PathBuf,

    /// Observed quantity, and its column by name, body.name or number [default: the column that moves most]
    #[arg(long, value_name = "y[=COLUMN]", value_parser = observe)]
    pub observe: Option<Observe>,

    /// The independent variable [default: the time, or the first column]; of several, each for its own columns
    #[arg(long, value_name = "COLUMN", value_delimiter = ',')]
    pub against: Vec<String>,

    /// State the unit of a column that the file does not, such as t=ms
    #[arg(long, value_name = "NAME=UNIT", value_parser = assignment)]
    pub unit: Vec<Assignment>,

    /// The order of dates such as 02/03/2024, day-first or month-first, where their numbers do not show it
    #[arg(long, value_name = "ORDER", value_parser = date_order)]
    pub dates: Option<DateOrder>,

    /// Leave out what is before this time, in the unit of the file or as '500 [ms]'
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub from: Option<String>,

    /// Leave out what is after this time
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub until: Option<String>,

    /// The form of the result [default: by the ending of FILE, or text]
    #[arg(long, value_enum)]
    pub format: Option<CyclesFormat>,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

const DERIVATIVES_EXAMPLES: &str = "\
Examples:
  meniscus derivatives film.txt --observe y                  as Tracker makes them
  meniscus derivatives film.txt --observe y --smooth 9       polynomials over 9 rows, which also smooth
  meniscus derivatives film.txt --observe y=2 --decimal-comma --output film.csv

The stencils are, for the velocity and the acceleration,
  central:   (x[i+1] - x[i-1])/(2 dt)   and  (2x[i+2] - x[i+1] - 2x[i] - x[i-1] + 2x[i-2])/(7 dt^2)
  forward:   (x[i+1] - x[i])/dt         and  (x[i+1] - 2x[i] + x[i-1])/dt^2
  backward:  (x[i] - x[i-1])/dt         and  (x[i+1] - 2x[i] + x[i-1])/dt^2
Where a neighbour is missing the cell is empty. Smoothing polynomials (Savitzky and Golay) bridge single gaps.";

/// `meniscus derivatives`
#[derive(Debug, Args)]
pub struct Derivatives {
    /// The measured data; `-` reads text from the standard input
    #[arg(value_name = "DATA")]
    pub data: PathBuf,

    /// Quantity to differentiate, and its column by name, body.name or number
    #[arg(long, value_name = "y[=COLUMN]", value_parser = observe)]
    pub observe: Observe,

    /// The independent variable [default: the time, or the first column]; of several, each for its own columns
    #[arg(long, value_name = "COLUMN", value_delimiter = ',')]
    pub against: Vec<String>,

    /// State the unit of a column that the file does not, such as t=ms
    #[arg(long, value_name = "NAME=UNIT", value_parser = assignment)]
    pub unit: Vec<Assignment>,

    /// The order of dates such as 02/03/2024, day-first or month-first, where their numbers do not show it
    #[arg(long, value_name = "ORDER", value_parser = date_order)]
    pub dates: Option<DateOrder>,

    /// The finite differences
    #[arg(long, value_enum, default_value_t = Difference::Central, conflicts_with = "smooth")]
    pub stencil: Difference,

    /// Polynomials over so many rows instead, an odd number
    #[arg(long, value_name = "ROWS")]
    pub smooth: Option<usize>,

    /// Their degree
    #[arg(long, value_name = "N", default_value_t = 3, requires = "smooth")]
    pub degree: usize,

    /// Semicolons and decimal commas, for spreadsheets that expect them
    #[arg(long)]
    pub decimal_comma: bool,

    /// Write into this file, which appears whole or not at all [default: the standard output]
    #[arg(long, short, value_name = "FILE.csv")]
    pub output: Option<PathBuf>,
}

/// Stencils of finite differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Difference {
    /// As Tracker makes them
    Central,
    /// From a row to the next
    Forward,
    /// From the row before
    Backward,
}

/// Formats of the result of `cycles`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CyclesFormat {
    /// A table with words about it
    Text,
    /// One object
    Json,
    /// One row for each turning point
    Csv,
    /// A figure
    Svg,
}

const EXPORT_EXAMPLES: &str = "\
Examples:
  meniscus export simulations/utube.md --output utube.html         a page that plays the document
  meniscus export simulations/utube.md --output lab.html --lab     the whole laboratory with it
  meniscus export utube.md --for scorm12 --output utube.zip        a package for a course in Moodle

The page needs nothing else: it opens from a file, from any web server and inside a course page, and works offline.
Its source is inside: `serve`, `run`, `check` and `export` take an exported page wherever they take a document, and
a project (NAME.meniscus) that the laboratory has saved.";

/// `meniscus export`
#[derive(Debug, Args)]
pub struct Export {
    /// The document
    #[arg(value_name = "DOC")]
    pub document: PathBuf,

    /// The page or the package, which appears whole or not at all; `-` is the standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,

    /// A package for a course: a ZIP archive with the page and what this kind of platform wants
    #[arg(long = "for", value_name = "PLATFORM", value_enum, conflicts_with = "lab")]
    pub platform: Option<Platform>,

    /// The whole laboratory with this document, to measure and to fit, and not only a page that plays it
    #[arg(long)]
    pub lab: bool,
}

/// Kinds of course packages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Platform {
    /// SCORM 1.2: Moodle and most other platforms
    Scorm12,
    /// SCORM 2004, 4th edition: more room for the state
    Scorm2004,
    /// cmi5: platforms with a store for xAPI statements
    Cmi5,
    /// The page alone, for an editor or a server that takes a folder of files
    Web,
}

const BUILD_EXAMPLES: &str = "\
Examples:
  meniscus build simulations --output site      a page for each document, their list, and the laboratory

The site is a folder of files for any static host, also in a subfolder of one. Its pages share what they have in common,
and work offline after the first visit. NAME.md becomes NAME.html; with its translations it is one page. Building
again replaces what was built before and leaves other files in the folder alone.";

/// `meniscus build`
#[derive(Debug, Args)]
pub struct Build {
    /// The folder with the documents; folders in it become folders of the site
    #[arg(value_name = "DIR")]
    pub directory: PathBuf,

    /// The folder of the site: a new one, an empty one, or one that was built before
    #[arg(long, short, value_name = "SITE")]
    pub output: PathBuf,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn the_help_names_every_method() {
        for method in engine::Method::ALL {
            assert!(RUN_EXAMPLES.contains(method.name()), "{method}");
        }
    }
}

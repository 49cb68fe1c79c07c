//! Arguments of `meniscus fit` and `meniscus rank`.

use analysis::fit::Loss;
use analysis::import::DateOrder;
use clap::{Args, ValueEnum};
use program::Seat;
use runner::fitting::FitSettings;
use runner::names::{Assignment, Observe, assignment, date_order, observe, seat};
use std::path::PathBuf;

/// Shown after the help of `meniscus fit`.
pub const FIT_EXAMPLES: &str = "\
Examples:
  meniscus fit linear.md run3.txt --observe y                     vary what the document says
  meniscus fit linear.md run3.txt --observe y=2 --vary gamma,y_0,v_0 --fix L='21 [cm]'
  meniscus fit linear.md run3.txt --observe y --from 1 --until 6  the rest is predicted
  meniscus fit linear.md *.txt --observe y --share L --vary L,gamma,y_0,v_0
  meniscus fit linear.md run1.txt run2.txt --observe y --tie 'L:2=2*L:1'  the second column is twice as long
  meniscus fit linear.md run3.txt --observe y --error y='1 [mm]' --profile
  meniscus fit linear.md run3.txt --observe y --loss tukey        outliers count less
  meniscus fit linear.md run3.txt --observe y --exclude 17,20..30 --exclude t=1.5..2
  meniscus fit driven.md run3.txt --observe y --start 'w=3..9 step 1'  the best of seven searches
  meniscus fit linear.md run3.txt --observe y --output report.html

DATA is text as Tracker, loggers and spreadsheets write it, XLSX, XLS or ODS, or a project of Tracker (TRK, TRZ);
docs/data.md has the rules. NAME is a parameter of the document, or t_origin (the clock's reading at the model's 0), or
y_offset (the offset of the readings of y). Without --vary the offset is varied, too, unless a varied parameter is such a
constant; --fix y_offset=0 leaves it out.";

/// Shown after the help of `meniscus rank`.
pub const RANK_EXAMPLES: &str = "\
Examples:
  meniscus rank run3.txt --model linear.md --model quadratic.md --observe y
  meniscus rank run3.txt --model linear.md --model quadratic.md --observe y --from 1 --predict-from 6

The best theory, by AICc, comes first. With --predict-from T each theory is also fitted to what is before T alone, and the
error of what it then predicts is shown: that is what tells a theory from a flexible curve.";

/// Arguments common to `fit` and `rank`.
#[derive(Clone, Debug, Args)]
pub struct Common {
    /// Observed quantity, and its column by name, body.name or number; the columns in turn in a file without a header
    #[arg(long, value_name = "y[=COLUMN]", value_parser = observe, required = true)]
    pub observe: Vec<Observe>,

    /// The independent variable [default: the time, or what suits the document]; of several, each for its own columns
    #[arg(long, value_name = "COLUMN", value_delimiter = ',')]
    pub against: Vec<String>,

    /// State the unit of a column that the file does not, such as t=ms
    #[arg(long, value_name = "NAME=UNIT", value_parser = assignment)]
    pub unit: Vec<Assignment>,

    /// The order of dates such as 02/03/2024, day-first or month-first, where their numbers do not show it
    #[arg(long, value_name = "ORDER", value_parser = date_order)]
    pub dates: Option<DateOrder>,

    /// Take the assigned values of this seat
    #[arg(long, value_name = "N", value_parser = seat)]
    pub seat: Option<Seat>,

    /// Parameters to vary, also t_origin and y_offset [default: as the document's front matter says, and the offset]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub vary: Vec<String>,

    /// Varied numbers that have one value in all records
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub share: Vec<String>,

    /// Hold a parameter; with several records perhaps a value for each, L=0.2,0.3
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub fix: Vec<Assignment>,

    /// Tie a parameter to others, L2=2*L1; L:2 is L in the second record
    #[arg(long, value_name = "NAME=EXPRESSION", value_parser = assignment)]
    pub tie: Vec<Assignment>,

    /// Begin the search here; of a list w=3,5,8 or a range w='3..9 step 1' the best search counts
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub start: Vec<Assignment>,

    /// Search between these [default: the parameter's own range]
    #[arg(long, value_name = "NAME=LO..HI", value_parser = assignment)]
    pub bounds: Vec<Assignment>,

    /// The standard error of what is observed: a value, or the column that holds it
    #[arg(long, value_name = "y=VALUE", value_parser = assignment)]
    pub error: Vec<Assignment>,

    /// Cost of residuals: with huber or tukey, values far from the curve count less
    #[arg(long, value_enum, default_value_t = LossName::LeastSquares)]
    pub loss: LossName,

    /// Fit from this time on, in the unit of the model's or as '500 [ms]'
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub from: Option<String>,

    /// Fit up to this time
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub until: Option<String>,

    /// Leave out rows, 17 or 20..30 (2:20..30 of the second record), a range of a column, t=1.5..2, or a column that is not 0 in them
    #[arg(long, value_name = "ROWS", value_delimiter = ',')]
    pub exclude: Vec<String>,

    /// The form of what is printed
    #[arg(long, value_enum, default_value_t = Form::Text)]
    pub format: Form,
}

impl From<&Common> for FitSettings {
    fn from(arguments: &Common) -> Self {
        let arguments = arguments.clone();
        Self {
            observe: arguments.observe,
            against: arguments.against,
            dates: arguments.dates,
            unit: arguments.unit,
            seat: arguments.seat,
            vary: arguments.vary,
            share: arguments.share,
            fix: arguments.fix,
            tie: arguments.tie,
            start: arguments.start,
            bounds: arguments.bounds,
            error: arguments.error,
            loss: arguments.loss.into(),
            from: arguments.from,
            until: arguments.until,
            exclude: arguments.exclude,
        }
    }
}

/// `meniscus fit`
#[derive(Debug, Args)]
pub struct Fit {
    /// The document: a closed form or equations of motion
    #[arg(value_name = "DOC")]
    pub document: PathBuf,

    /// The measured data, a file for each run; `-` reads text from the standard input
    #[arg(value_name = "DATA", required = true)]
    pub data: Vec<PathBuf>,

    /// Observed quantities, and varied and fixed parameters.
    #[command(flatten)]
    pub common: Common,

    /// Intervals from the profile of the likelihood as well
    #[arg(long)]
    pub profile: bool,

    /// Write a report (.html), a workbook (.xlsx), a table (.csv) or a figure (.svg), which appears whole or not at all
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// `meniscus rank`
#[derive(Debug, Args)]
pub struct Rank {
    /// The measured data, a file for each run
    #[arg(value_name = "DATA", required = true)]
    pub data: Vec<PathBuf>,

    /// A theory; twice or more
    #[arg(long = "model", value_name = "DOC", required = true)]
    pub models: Vec<PathBuf>,

    /// Observed quantities, and varied and fixed parameters.
    #[command(flatten)]
    pub common: Common,

    /// Also fit what is before this time alone, and show the error of what is predicted from there on
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub predict_from: Option<String>,

    /// Write a report (.html) or a table (.csv), which appears whole or not at all
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Loss functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LossName {
    /// The sum of squares
    LeastSquares,
    /// Squares up to 1.345 standard deviations, then straight lines
    Huber,
    /// The biweight: nothing beyond 4.685 standard deviations counts
    Tukey,
}

impl From<LossName> for Loss {
    fn from(name: LossName) -> Self {
        match name {
            LossName::LeastSquares => Self::Squares,
            LossName::Huber => Self::Huber,
            LossName::Tukey => Self::Tukey,
        }
    }
}

/// Formats of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// Tables with words about them
    Text,
    /// One object
    Json,
}

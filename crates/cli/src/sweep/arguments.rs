//! Arguments of `meniscus sweep`.

use crate::arguments::run_settings::RunSettings;
use clap::Args;
use std::num::NonZeroU64;
use std::path::PathBuf;

/// Examples of `meniscus sweep`.
pub const SWEEP_EXAMPLES: &str = "\
Values of a parameter (bare numbers are in its declared unit):
  --over 'b in 0..100 [kg/s] step 2'     from 0 to 100 kg/s; without a step for samples
  --over 'h_l = 2, 3, 4 [m]'             these values; for a switch or a choice its words

What is kept of each run, as in plots over a parameter:
  --keep 'y at end'                      a value at the end of the run
  --keep 'maximum(y) from 2 [s] in [cm]' maximum, minimum, mean or integral, from a time on

Examples:
  meniscus sweep utube.md --over 'b in 0..400 step 50' --keep 'maximum(y), y at end'
  meniscus sweep pendulum.md --over 'theta_0 = 10, 45, 90 [deg]' --over 'b in 0..1 step 0.1' --keep 'mean(E)'
  meniscus sweep utube.md --over 'b in 0..400' --over 'h_l in 2..4' --random 10000 --keep 'y at end' --output runs.csv
  meniscus sweep utube.md .. --shard 3/16 --output runs-03.csv     one of 16 jobs; together their rows are the whole table
  meniscus sweep utube.md .. --output runs.arrow                   for pyarrow, pandas, polars or R, with the units of the columns

Each row has the number of its run, the values of the parameters and what was kept. The rows are the same on any number of
processors and in any division into shards. A run that cannot be computed has empty cells; why is said at the end.";

/// `meniscus sweep`
#[derive(Debug, Args)]
pub struct Sweep {
    /// The document; `-` reads it from the standard input
    #[arg(value_name = "DOC")]
    pub document: PathBuf,

    /// A parameter and its values; of several, all combinations are computed
    #[arg(long, value_name = "VALUES", required = true)]
    pub over: Vec<String>,

    /// Numbers that are kept of each run
    #[arg(long, value_name = "NUMBERS", required = true)]
    pub keep: Vec<String>,

    /// Instead of all combinations this many random ones, each value with the same probability
    #[arg(long, value_name = "N")]
    pub random: Option<u64>,

    /// Instead of all combinations this many that fill the ranges evenly (sequence of Halton)
    #[arg(long, value_name = "N", conflicts_with = "random")]
    pub halton: Option<u64>,

    /// The draws of --random
    #[arg(long, value_name = "N", default_value_t = 1, requires = "random")]
    pub seed: u64,

    /// Compute one of N equal parts of the runs
    #[arg(long, value_name = "I/N", value_parser = shard, default_value = "1/1", hide_default_value = true)]
    pub shard: Shard,

    /// Use this many processors [default: all]
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// The other settings of the runs
    #[command(flatten)]
    pub settings: RunSettings,

    /// Write into this file, which appears whole or not at all: Arrow's format if it ends with .arrow, otherwise CSV [default: the standard output]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// One of several equal parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Its number, from 0.
    pub number: u64,
    /// Number of parts.
    pub of: NonZeroU64,
}

/// Parses `3/16`, which counts from 1.
fn shard(text: &str) -> Result<Shard, String> {
    let read = || {
        let (number, of) = text.split_once('/')?;
        let (number, of) = (number.trim().parse::<u64>().ok()?, of.trim().parse::<NonZeroU64>().ok()?);
        (1..=of.get()).contains(&number).then(|| Shard { number: number - 1, of })
    };
    read().ok_or_else(|| "write I/N, such as 3/16 for the third of 16 parts".to_owned())
}

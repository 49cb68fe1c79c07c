//! What the plot of the cycles shows.

use analysis::cycles::{Cycle, Quantity};
use figure::Interval;

/// What is drawn of the cycles, in the units of the axes.
#[derive(Debug, Default)]
pub(crate) struct CyclePlot {
    pub measured: Points,
    /// The mean of all, where the linear theory has the same for all.
    pub constant: Vec<f64>,
    pub run: Points,
    pub limits: Option<Interval>,
    /// The cycles of the run that is recorded, and which run that is.
    pub of_run: Vec<Cycle>,
    pub seen: Option<(u64, u64)>,
}

#[derive(Debug, Default)]
pub(crate) struct Points {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub errors: Vec<f64>,
}

impl Points {
    pub fn of(cycles: &[Cycle], quantity: Quantity, against_amplitude: bool) -> Self {
        let across = |cycle: &Cycle| if against_amplitude { cycle.amplitude.value } else { cycle.time.value };
        let measured: Vec<_> = cycles.iter().map(|cycle| quantity.of(cycle)).collect();
        Self {
            x: cycles.iter().map(across).collect(),
            y: measured.iter().map(|one| one.value).collect(),
            errors: measured.iter().map(|one| one.error).collect(),
        }
    }
}

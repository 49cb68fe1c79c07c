//! Data of the plot of cycles.

use analysis::cycles::{Cycle, Quantity};
use figure::Interval;

/// Series of the plot of cycles, in the units of the axes.
#[derive(Debug, Default)]
pub(crate) struct CyclePlot {
    pub measured: Points,
    /// Weighted mean of all measured cycles, repeated once per cycle. Empty for the amplitude, which is not constant in
    /// a damped linear theory.
    pub constant: Vec<f64>,
    pub run: Points,
    pub limits: Option<Interval>,
    /// Cycles of the recorded run. `seen` is that run: its revision of the parameters and its number of rows.
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

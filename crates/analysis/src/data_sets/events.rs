//! Starts and pauses of an experiment. The experiment time of phyphox stops in a pause.

use super::remark::Remark;
use crate::import::cells_of;
use crate::table::Table;
use units::Dimension;

/// Upper bound of the number of events.
const MOST_EVENTS: usize = 10_000;
/// Tolerance of the clocks of the phone, s: the system time is in milliseconds.
const TOLERANCE: f64 = 0.01;

/// Pauses in the order of time.
#[derive(Debug, Default)]
pub(super) struct Events {
    pauses: Vec<Pause>,
}

/// Pause of an experiment.
#[derive(Clone, Copy, Debug)]
struct Pause {
    /// Experiment time at its begin, s.
    from: f64,
    /// Experiment time at its end, s.
    until: f64,
    /// Duration by the system time, s; NaN if unknown.
    length: f64,
}

impl Pause {
    /// Part of the pause that the experiment time omits, s; 0 within the tolerance.
    fn missing(self) -> f64 {
        let missing = self.length - (self.until - self.from);
        if missing > TOLERANCE { missing } else { 0.0 }
    }
}

impl Events {
    /// Reads lines of `"event","experiment time","system time","system time text"`.
    pub fn read(text: &str) -> Self {
        let mut pauses = Vec::new();
        let mut paused: Option<(f64, f64)> = None;
        for cells in cells_of(text).skip(1).take(MOST_EVENTS) {
            let number = |index: usize| cells.get(index)?.replace(',', ".").parse::<f64>().ok();
            let Some(time) = number(1).filter(|time| time.is_finite()) else { continue };
            let system = number(2).unwrap_or(f64::NAN);
            match cells.first().copied() {
                Some("PAUSE") => paused = Some((time, system)),
                Some("START") => {
                    if let Some((from, before)) = paused.take()
                        && time >= from
                    {
                        pauses.push(Pause { from, until: time, length: system - before });
                    }
                }
                _ => {}
            }
        }
        Self { pauses }
    }

    /// Adds the missing part of each pause to the times after it. Returns true if any were changed.
    pub fn spread(&self, table: &mut Table) -> bool {
        let Some(last) = self.pauses.last().map(|pause| pause.until) else { return false };
        let clocks: Vec<usize> = table.independent().collect();
        let mut moved = false;
        for index in clocks {
            let Some(column) = table.columns.get_mut(index) else { continue };
            let Some(unit) = column.unit.as_ref().filter(|unit| unit.dimension == Dimension::TIME) else { continue };
            // A delay or a period is not an experiment time.
            let end =
                column.values.iter().rev().find(|time| time.is_finite()).map_or(f64::NAN, |time| unit.to_si(*time));
            if end.is_nan() || end <= last {
                continue;
            }
            let missing: Vec<(f64, f64)> =
                self.pauses.iter().map(|pause| (unit.from_si(pause.from), unit.from_si(pause.missing()))).collect();
            for time in &mut column.values {
                let shift: f64 = missing.iter().take_while(|(from, _)| *time > *from).map(|(_, length)| length).sum();
                if shift > 0.0 {
                    *time += shift;
                    moved = true;
                }
            }
        }
        moved
    }

    /// Remark on the pauses, if there are any; `moved` is true if times were shifted by them.
    pub fn remark(&self, moved: bool) -> Option<Remark> {
        let first = self.pauses.first()?;
        let length = first.length.is_finite().then_some(first.length.max(first.until - first.from));
        Some(Remark::Pauses { count: self.pauses.len(), from: first.from, length, moved })
    }
}

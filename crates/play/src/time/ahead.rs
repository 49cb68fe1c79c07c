//! The first part of a run, computed ahead: plots have its range from the beginning, so that their axes do not jump.

use super::course::Course;
use crate::Basis;
use crate::motion::Motion;
use crate::plots::traces::{Columns, Traces};
use figure::Interval;

/// Work for the first part, an eighth of that of a tick; of a longer part only the beginning counts.
const WORK: u64 = 125_000;

/// Range of each column in the first part of a run with the settings of this one, in the units of the columns; `None` for a
/// column without finite values.
pub(super) fn ranges(basis: &Basis, motion: Motion, course: &Course, columns: &mut Columns) -> Vec<Option<Interval>> {
    let mut ahead = Course::start(motion, course.begun().clone(), 0);
    let mut left = WORK;
    ahead.proceed(basis.first_part(&ahead), &mut left);
    let (mut present, mut traces) = (Vec::new(), Traces::default());
    columns.present(&ahead, &mut present);
    traces.follow(&ahead, columns, &present);
    (0..columns.nodes().len()).map(|column| Interval::around(traces.column(column).iter().copied())).collect()
}

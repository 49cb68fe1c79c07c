//! Times: dates and clocks as they are written, time stamps of loggers, serial days of spreadsheets, counters that overflow.

pub(super) mod clock;
pub(super) mod date;
pub(super) mod overflow;
pub(super) mod serial_days;
pub(super) mod settle;
pub(super) mod stamp;

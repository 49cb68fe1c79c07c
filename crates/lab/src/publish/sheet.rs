//! The chosen parts of the worksheet.

use view::views::*;

/// The chosen parts of the worksheet. They hold as long as the page is open.
#[derive(Clone, Copy)]
pub struct Sheet {
    /// Names of the parts that are left out.
    pub left_out: Signal<Vec<&'static str>>,
    /// True if the solutions follow at the end.
    pub solves: Signal<bool>,
}

impl Sheet {
    /// All parts, without the solutions.
    pub fn new() -> Self {
        Self { left_out: create_signal(Vec::new()), solves: create_signal(false) }
    }
}

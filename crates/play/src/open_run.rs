//! The program and its run, as the other parts read them.

use crate::{Basis, Course, TimeLine};

/// The program and its run at the moment shown.
#[derive(Clone, Copy, Debug)]
pub struct OpenRun<'a> {
    pub(crate) basis: &'a Basis,
    pub(crate) line: &'a TimeLine,
}

impl<'a> OpenRun<'a> {
    /// The run: its rows, parameters and state.
    pub(crate) fn course(self) -> &'a Course {
        self.line.course()
    }
}

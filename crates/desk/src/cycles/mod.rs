//! Analysis of an oscillation cycle by cycle.

mod drawn;
mod found;
mod plot;
mod view;

pub use view::{CycleColumn, CyclesView};

use crate::OpenDocument;
use crate::records::Records;
use analysis::cycles::Quantity;
use drawn::CyclePlot;
use found::Found;
use play::PlotId;

/// The cycles of a column, the settings of their view, and their plot, which is one of the simulation: the operations
/// that draw get the simulation passed.
#[derive(Debug)]
pub struct Cycles {
    view: CycleView,
    /// The cycles of the chosen column; `None` while the view is closed or there is no column.
    found: Option<Found>,
    drawn: CyclePlot,
    /// The plot of the cycles.
    plot: PlotId,
}

/// Settings of the view of cycles.
#[derive(Debug)]
struct CycleView {
    /// True if the view is open.
    open: bool,
    /// Id of the record and index of the column.
    chosen: Option<(u32, usize)>,
    /// The quantity that is plotted.
    quantity: Quantity,
    /// True if the abscissa is the amplitude, false if it is the time.
    against_amplitude: bool,
}

/// The cycles as shown with the simulation and the records.
#[derive(Clone, Copy, Debug)]
pub struct ShownCycles<'a> {
    cycles: &'a Cycles,
    open: OpenDocument<'a>,
    records: &'a Records,
}

impl Cycles {
    /// Closed view. `plot`: the plot of the cycles.
    pub(crate) fn new(plot: PlotId) -> Self {
        let view = CycleView { open: false, chosen: None, quantity: Quantity::Period, against_amplitude: false };
        Self { view, found: None, drawn: CyclePlot::default(), plot }
    }

    /// The cycles as shown with the simulation and the records.
    pub(crate) fn shown<'a>(&'a self, open: OpenDocument<'a>, records: &'a Records) -> ShownCycles<'a> {
        ShownCycles { cycles: self, open, records }
    }
}

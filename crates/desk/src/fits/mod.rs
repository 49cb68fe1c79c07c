//! Fits: settings, queue, results, application to the sliders, reports.
//!
//! Fits are computed by `Workers` (`workers.rs`): a desk gives out a `FitWork`, which needs nothing else, and takes
//! `FitNews`. Results are taken in the order of the queue, so that they do not depend on the number of workers. `InProcess`
//! computes here, one trial at a time.

mod applied;
mod choices;
mod curves;
pub(crate) mod fit;
mod queue;
mod ranges;
mod replacement;
pub(crate) mod reporting;
mod results;
mod running;
mod setup;
mod shared_units;
mod stored;
mod task;
mod theory;
mod workers;
mod zero;

pub use choices::{ChoiceView, FitRecordView, KnownView};
pub use curves::FittedCurve;
pub use queue::FitProgress;
pub use ranges::{PeriodComparison, PeriodQuestion};
pub use reporting::{Export, ExportKind, Imprint};
pub use results::{EstimateView, FitDetail, FitView, MOST_FITS};
pub use stored::write_varied;
pub use theory::TheoryCurve;
pub use workers::{Finding, FitComputation, FitNews, FitWork, InProcess, NothingFound, Workers};

use crate::films::Films;
use crate::opened::{OpenDocument, OpenedDocuments};
use crate::records::Records;
use document::Document;
use fit::{Fitted, Job, Waiting};
use play::Play;
use running::Running;
use setup::Setup;
use std::collections::VecDeque;
use units::Words;

/// The fits of a desk: settings, queue and results.
#[derive(Debug, Default)]
pub struct Fits {
    setup: Setup,
    finished: Vec<Fitted>,
    /// Id of the fit whose values are set on the sliders.
    applied: Option<u32>,
    /// Fits of an earlier visit that are to be reconstructed.
    waiting: VecDeque<Waiting>,
    /// The documents from which fits are reconstructed.
    documents: OpenedDocuments,
    /// Number of ids issued so far. Ids are never reused, because old references may exist.
    issued: u32,
    /// Theories of the queue that could not be fitted, each with the reason.
    left_out: Vec<String>,
    /// A sentence for each fit that could not be reconstructed.
    lost: Vec<Words>,
    queue: Vec<Job>,
    /// Length of the queue when it was started.
    total: usize,
    /// Fits that are being computed, in the order of the queue, in which their results are taken.
    running: VecDeque<Running>,
}

/// Parts of a desk that fits read: the open document, the records and their films.
#[derive(Clone, Copy, Debug)]
pub struct FitData<'a> {
    pub(crate) open: OpenDocument<'a>,
    pub(crate) records: &'a Records,
    pub(crate) films: &'a Films,
}

/// The fits as shown with the data that they read.
#[derive(Clone, Copy, Debug)]
pub struct ShownFits<'a> {
    fits: &'a Fits,
    play: &'a Play,
    document: &'a Document,
    records: &'a Records,
    films: &'a Films,
}

impl<'a> FitData<'a> {
    /// The simulation.
    pub fn play(self) -> &'a Play {
        self.open.play
    }
}

impl Fits {
    /// The fits as shown with the data that they read.
    pub(crate) fn shown<'a>(&'a self, FitData { open, records, films }: FitData<'a>) -> ShownFits<'a> {
        let OpenDocument { play, document } = open;
        ShownFits { fits: self, play, document, records, films }
    }

    /// Exchanges the documents from which fits are reconstructed for others.
    pub(crate) fn exchange_documents(&mut self, documents: &mut OpenedDocuments) {
        std::mem::swap(&mut self.documents, documents);
    }
}

impl<'a> ShownFits<'a> {
    /// The finished fits, oldest first.
    pub(crate) fn finished(self) -> &'a [Fitted] {
        &self.fits.finished
    }

    fn open(self) -> OpenDocument<'a> {
        OpenDocument { play: self.play, document: self.document }
    }
}

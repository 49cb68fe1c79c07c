//! The laboratory without a screen: a simulation, measured records and fits.

use crate::announcement::{Announcement, Announcements};
use crate::cycles::drawn::CyclePlot;
use crate::cycles::found::CycleView;
use crate::films::state::Films;
use crate::fits::state::Fits;
use crate::measured::data::Data;
use crate::opened::OpenedDocuments;
use crate::records::incoming::Intake;
use crate::removed::Removed;
use crate::writing::{Sketching, Writing};
use document::Document;
use play::{Play, PlotId};

/// Counters of changes, so that the page redraws only what has changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Revision {
    /// Changes of the simulation.
    pub play: play::Revision,
    /// Changes of the records and of the meanings of their columns.
    pub records: u64,
    /// Changes of the fit settings, of running fits and of results.
    pub fits: u64,
    /// Changes of the open film and of the work on it.
    pub films: u64,
}

/// A laboratory with one document open.
#[derive(Debug)]
pub struct Desk {
    pub(crate) play: Play,
    /// The document of the simulation. Reports and stored fits need its text.
    pub(crate) document: Document,
    pub(crate) revision: Revision,
    pub(crate) announcements: Announcements,
    pub(crate) data: Data,
    pub(crate) fits: Fits,
    /// The documents from which fits are reconstructed.
    pub(crate) opened: OpenedDocuments,
    pub(crate) films: Films,
    /// The file that is being read.
    pub(crate) intake: Option<Intake>,
    pub(crate) cycle_view: CycleView,
    pub(crate) cycles: CyclePlot,
    /// Plot of the residuals. `cycle_plot` is the plot of the cycles.
    pub(crate) residual_plot: PlotId,
    pub(crate) cycle_plot: PlotId,
    /// The last removal and its number.
    pub(crate) removed: Option<(u32, Removed)>,
    /// The texts in the editor.
    pub(crate) writing: Writing,
    /// The parsed drawing of the document; `None` until it is edited by hand.
    pub(crate) sketching: Option<Sketching>,
}

impl Desk {
    /// Opens a document. The first row is drawn and the run is paused at time 0.
    pub fn open(document: Document) -> Self {
        let mut play = Play::open(document.program.clone());
        let (residual_plot, cycle_plot) = (play.add_plot(), play.add_plot());
        let mut desk = Self {
            play,
            revision: Revision::default(),
            announcements: Announcements::default(),
            data: Data::default(),
            fits: Fits::default(),
            opened: OpenedDocuments::default(),
            films: Films::default(),
            intake: None,
            cycle_view: CycleView::default(),
            cycles: CyclePlot::default(),
            residual_plot,
            cycle_plot,
            removed: None,
            writing: Writing::default(),
            sketching: None,
            document,
        };
        let program = &desk.document.program;
        desk.fits.setup.varied =
            (0..program.model.parameters.len()).map(|index| program.vary.contains(&index)).collect();
        desk.records_changed();
        desk
    }

    /// The simulation.
    #[must_use]
    pub fn play(&self) -> &Play {
        &self.play
    }

    /// The simulation, for changes. Call [`Desk::follow`] afterwards to update measured data.
    pub fn play_mut(&mut self) -> &mut Play {
        &mut self.play
    }

    /// Exchanges the documents from which fits are reconstructed for others, so that several desks can share them one
    /// after the other.
    pub fn exchange_documents(&mut self, documents: &mut OpenedDocuments) {
        std::mem::swap(&mut self.opened, documents);
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The plot of the residuals.
    pub fn residual_plot(&self) -> PlotId {
        self.residual_plot
    }

    /// The plot of the cycles.
    pub fn cycle_plot(&self) -> PlotId {
        self.cycle_plot
    }

    /// Sets the language of all texts from a language tag. Any tag is accepted.
    pub fn set_language(&mut self, language: &str) {
        self.play.set_language(language);
        self.begin_outline();
        self.label_residuals();
        self.label_cycles();
    }

    /// The counters of changes.
    pub fn revision(&self) -> Revision {
        Revision { play: self.play.revision(), ..self.revision }
    }

    /// Updates residuals, cycles and the outline to the present state of the run. Must be called before plots are
    /// drawn.
    pub fn follow(&mut self) {
        if let Some(time) = self.play.take_rewritten() {
            self.truncate_residuals(time);
        }
        self.follow_residuals();
        self.follow_cycles();
        self.follow_outline();
    }

    /// Takes the next announcement. Announcements of the simulation come first.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        let of_play = self.play.take_announcement().map(Announcement::Play);
        of_play.or_else(|| self.announcements.take())
    }

    pub(crate) fn announce(&mut self, announcement: Announcement) {
        self.announcements.push(announcement);
    }

    /// Drops all announcements that have not been taken.
    pub(crate) fn forget_announcements(&mut self) {
        self.announcements.clear();
        while self.play.take_announcement().is_some() {}
    }
}

//! State of fits that the strip under the plots and the tab *Measure* share.

use desk::PeriodQuestion;
use view::views::*;

/// State of starting and showing fits; it lives as long as the page.
#[derive(Clone, Copy)]
pub struct Fitting {
    /// Number of fits that were started or cancelled: only the last wish counts.
    pub presses: Signal<u32>,
    /// Reason why the last fit was refused.
    pub refusal: Signal<Option<String>>,
    /// Id of the result that the user has chosen.
    pub chosen: Signal<Option<u32>>,
    /// Result shown unless the user chooses: the best one after a ranking, otherwise the last one.
    pub ranked: Signal<bool>,
    /// Question that was asked last about the open document and the record.
    pub asked: Signal<Option<PeriodQuestion>>,
    /// True while its answer is being computed.
    pub waits: Signal<bool>,
    /// Reason why the open document cannot hold the record, if any: the last answer.
    pub reason: Signal<Option<String>>,
    /// True if the user has chosen the open document in spite of the reason.
    pub insists: Signal<bool>,
    /// True for each step in the panel that is unfolded.
    pub unfolded: [Signal<bool>; 3],
}

impl Fitting {
    /// Nothing has been started.
    pub fn new() -> Self {
        Self {
            presses: create_signal(0),
            refusal: create_signal(None),
            chosen: create_signal(None),
            ranked: create_signal(true),
            asked: create_signal(None),
            waits: create_signal(false),
            reason: create_signal(None),
            insists: create_signal(false),
            unfolded: [(); 3].map(|()| create_signal(false)),
        }
    }

    /// Drops what has not begun yet. Returns the number of the wish.
    pub fn press(self) -> u32 {
        self.presses.update(|count| *count += 1);
        self.presses.get_untracked()
    }

    /// Reason why the open document is not the theory of the next fit, if any.
    pub fn objection(self) -> Option<String> {
        if self.insists.get() { None } else { self.reason.get_clone() }
    }

    /// Shows the best result, or the last one.
    pub fn show(self, ranked: bool) {
        self.ranked.set(ranked);
        self.chosen.set(None);
    }
}

//! Passing a simulation on to another program of the page, which has opened the same document.

use super::share::Extent;
use crate::Play;
use crate::plots::traces::Traces;
use crate::time::kept::Ghost;
use serde::{Deserialize, Serialize};

/// State of a simulation: everything that shows, except answers, which the page stores.
#[derive(Debug, Serialize, Deserialize)]
pub struct Passed {
    /// State as in a link, with every change during the run.
    state: String,
    playing: bool,
    /// For each kept run, true if it is drawn.
    kept: Vec<bool>,
    ghost: Option<Traces>,
    /// Greatest magnitudes so far of states, quantities, and values of the scene, SI; they decide the digits.
    scales: [Vec<f64>; 3],
}

impl Play {
    /// State of the simulation, for [`Play::take_over`].
    pub fn pass_on(&mut self) -> Passed {
        let [quantities, scene] = self.values.scales();
        Passed {
            state: self.share_within(Extent::Exact),
            playing: self.line.is_playing(),
            kept: self.line.kept(&self.basis).into_iter().map(|kept| kept.shown).collect(),
            ghost: self.line.take_ghost().map(|ghost| ghost.traces),
            scales: [self.line.scales().to_vec(), quantities, scene],
        }
    }

    /// Continues a simulation of the same document. Nothing is announced.
    pub fn take_over(&mut self, passed: Passed) {
        // Written by this program for this document: every part of it fits.
        let _ = self.restore_within(&passed.state, usize::MAX, &mut { u64::MAX });
        for (view, shown) in self.line.kept(&self.basis).into_iter().zip(passed.kept) {
            self.show_kept(view.id, shown);
        }
        if let Some(traces) = passed.ghost {
            let changes = self.line.set_ghost(Ghost { traces });
            self.note(changes);
        }
        let [states, quantities, scene] = passed.scales;
        self.line.set_scales(states);
        self.values.set_scales([quantities, scene]);
        if passed.playing {
            let changes = self.line.play();
            self.note(changes);
        }
        self.announcements.clear();
    }
}

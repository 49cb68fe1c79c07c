//! Steps of the guided start. Each is recognised by what the simulation announces.

use play::{Announcement, Play};

/// Parameter that damps the motion.
const DAMPING: &str = "b";

/// Least time (s) at which a paused run shows a whole period.
const PERIOD: f64 = 1.0;

/// Next action that the visitor is asked for.
#[derive(Clone, Copy, PartialEq)]
pub enum Step {
    /// Lift the liquid by hand.
    Lift,
    /// Let the run play.
    LetGo,
    /// Change the damping from this value.
    Damp(f64),
    /// Pause and read the period in the plot.
    Read,
    /// Nothing more.
    Done,
}

impl Step {
    /// The step after an announcement of the simulation.
    pub fn after(self, announcement: &Announcement, play: &Play) -> Self {
        let damping = || {
            let place = play.program().model.parameters.iter().position(|parameter| parameter.name == DAMPING);
            place.and_then(|place| play.course().parameters().get(place)).copied().unwrap_or_default()
        };
        match (self, announcement) {
            (Self::Lift, Announcement::StateSet(..) | Announcement::StartSet { .. }) => Self::LetGo,
            (Self::LetGo, Announcement::Playing) => Self::Damp(damping()),
            (Self::Damp(before), _) if before.to_bits() != damping().to_bits() => Self::Read,
            (Self::Read, Announcement::Paused(time) | Announcement::Ended(time)) if *time >= PERIOD => Self::Done,
            (step, _) => step,
        }
    }
}

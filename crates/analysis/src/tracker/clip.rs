//! The frames of a project and their times.

/// Factors closer to 1 come from rounding: the project states times to 0.001 ms.
const UNSTRETCHED: f64 = 1e-4;

/// Which frames of the film a project uses, and when they were taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// The first frame.
    pub first: u32,
    /// The distance of two frames that are used, at least 1.
    pub step: u32,
    /// How many frames are used.
    pub count: u32,
    /// What is added to a frame of the project to get that of the film; old versions could shift them.
    pub shift: i64,
    /// The time of the first frame in seconds.
    pub start: f64,
    /// The mean duration of a frame of the film in seconds; NaN where the project states none.
    pub interval: f64,
    /// The time of each frame of the film in seconds, if the project lists them (Tracker 6).
    pub times: Vec<f64>,
}

impl Default for Clip {
    fn default() -> Self {
        Self { first: 0, step: 1, count: u32::MAX, shift: 0, start: 0.0, interval: f64::NAN, times: Vec::new() }
    }
}

impl Clip {
    /// Whether the clip contains a frame.
    pub fn includes(&self, frame: u32) -> bool {
        let step = self.step.max(1);
        let behind = frame.checked_sub(self.first);
        behind.is_some_and(|behind| behind % step == 0 && behind / step < self.count)
    }

    /// The frame of the film that a frame of the project is.
    pub fn film_frame(&self, frame: u32) -> Option<usize> {
        usize::try_from(i64::from(frame).checked_add(self.shift)?).ok()
    }

    /// The time of a frame in seconds, as Tracker computes it (`StepperClipControl.getStepTime`): the frame's own time where
    /// the project lists it, stretched so that the mean duration of a frame is as stated; else that duration times the number
    /// of frames since the first.
    pub fn time(&self, frame: u32) -> f64 {
        let own = self.stretch().and_then(|stretch| Some(stretch * (self.listed(frame)? - self.listed(self.first)?)));
        self.start + own.unwrap_or_else(|| (f64::from(frame) - f64::from(self.first)) * self.interval)
    }

    /// The factor by which listed times are stretched: not 1 where somebody stated another frame rate, such as that of a slow
    /// motion. `None` where the project lists no times that rise.
    pub fn stretch(&self) -> Option<f64> {
        let last = self.count.checked_sub(1)?.saturating_mul(self.step.max(1)).saturating_add(self.first);
        let end = i64::try_from(self.times.len()).ok()?.checked_sub(1)?.checked_sub(self.shift)?;
        let last = last.min(u32::try_from(end).ok()?);
        let frames = last.checked_sub(self.first).filter(|frames| *frames > 0)?;
        let duration = self.listed(last)? - self.listed(self.first)?;
        // Without a stated duration the times are taken as they are.
        let stretch = if self.is_timed() { self.interval * f64::from(frames) / duration } else { 1.0 };
        if !(stretch.is_finite() && duration > 0.0) {
            return None;
        }
        Some(if (stretch - 1.0).abs() < UNSTRETCHED { 1.0 } else { stretch })
    }

    /// Whether the duration of a frame is stated.
    pub fn is_timed(&self) -> bool {
        self.interval > 0.0 && self.interval.is_finite()
    }

    /// The listed time of a frame of the project.
    fn listed(&self, frame: u32) -> Option<f64> {
        let index = i64::from(frame).checked_add(self.shift)?;
        self.times.get(usize::try_from(index).ok()?).copied()
    }
}

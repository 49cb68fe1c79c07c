//! Frames of a project and their times.

/// Stretch factors within this of 1 are rounding: the project states times to 0.001 ms.
const UNSTRETCHED: f64 = 1e-4;

/// Frames of the film used by a project, and their times.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// First frame.
    pub first: u32,
    /// Step between used frames, at least 1.
    pub step: u32,
    /// Number of used frames.
    pub count: u32,
    /// Offset from a frame of the project to that of the film; old versions could shift them.
    pub shift: i64,
    /// Time of the first frame, s.
    pub start: f64,
    /// Mean duration of a frame of the film, s; NaN if the project does not state it.
    pub interval: f64,
    /// Time of each frame of the film, s, if the project lists them (Tracker 6); else empty.
    pub times: Vec<f64>,
}

impl Default for Clip {
    fn default() -> Self {
        Self { first: 0, step: 1, count: u32::MAX, shift: 0, start: 0.0, interval: f64::NAN, times: Vec::new() }
    }
}

impl Clip {
    /// True if the clip contains a frame.
    pub fn includes(&self, frame: u32) -> bool {
        let step = self.step.max(1);
        let behind = frame.checked_sub(self.first);
        behind.is_some_and(|behind| behind % step == 0 && behind / step < self.count)
    }

    /// Frame of the film for a frame of the project.
    pub fn film_frame(&self, frame: u32) -> Option<usize> {
        usize::try_from(i64::from(frame).checked_add(self.shift)?).ok()
    }

    /// Time of a frame, s, as Tracker computes it (`StepperClipControl.getStepTime`). If the project lists times, these are
    /// stretched so that the mean duration of a frame is the stated one. Otherwise it is that duration times the number of
    /// frames since the first.
    pub fn time(&self, frame: u32) -> f64 {
        let own = self.stretch().and_then(|stretch| Some(stretch * (self.listed(frame)? - self.listed(self.first)?)));
        self.start + own.unwrap_or_else(|| (f64::from(frame) - f64::from(self.first)) * self.interval)
    }

    /// Factor by which listed times are stretched. It differs from 1 if the user stated another frame rate, such as that of
    /// slow motion. `None` if the project lists no increasing times.
    pub fn stretch(&self) -> Option<f64> {
        let last = self.count.checked_sub(1)?.saturating_mul(self.step.max(1)).saturating_add(self.first);
        let end = i64::try_from(self.times.len()).ok()?.checked_sub(1)?.checked_sub(self.shift)?;
        let last = last.min(u32::try_from(end).ok()?);
        let frames = last.checked_sub(self.first).filter(|frames| *frames > 0)?;
        let duration = self.listed(last)? - self.listed(self.first)?;
        // Without a stated duration the listed times are used unchanged.
        let stretch = if self.is_timed() { self.interval * f64::from(frames) / duration } else { 1.0 };
        if !(stretch.is_finite() && duration > 0.0) {
            return None;
        }
        Some(if (stretch - 1.0).abs() < UNSTRETCHED { 1.0 } else { stretch })
    }

    /// True if the duration of a frame is stated.
    pub fn is_timed(&self) -> bool {
        self.interval > 0.0 && self.interval.is_finite()
    }

    /// Listed time of a frame of the project.
    fn listed(&self, frame: u32) -> Option<f64> {
        let index = i64::from(frame).checked_add(self.shift)?;
        self.times.get(usize::try_from(index).ok()?).copied()
    }
}

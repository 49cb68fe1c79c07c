//! Loss of a body: its likely reason, and what helps.

use super::track::{Point, Track};
use units::{Words, words};

/// Greatest number of positions before a loss that is due to the click.
const FEW: usize = 12;
/// Distance from the edge of the picture, in radii, at which a body leaves it.
const EDGE: f64 = 1.5;

/// Loss of a body that does not come back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loss {
    /// First frame without it.
    pub frame: usize,
    /// Its likely reason.
    pub reason: LossReason,
}

/// Likely reason of a loss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LossReason {
    /// Its path leads out of the picture.
    Left,
    /// It moves by more than its own size from frame to frame.
    Fast,
    /// It was lost soon after the click: its circle holds other things, too.
    Circle,
    /// It is hidden, or looks otherwise.
    Unlike,
}

impl Track {
    /// Loss of a body that is not found again, in an upright picture of `size` px.
    pub fn loss(&self, size: [f64; 2]) -> Option<Loss> {
        let frame = self.lost.filter(|lost| self.points.last().is_none_or(|last| last.frame < *lost))?;
        let radius = self.outline.map_or(0.0, |outline| outline.radius);
        let step = match self.points.as_slice() {
            [.., before, last] => velocity(before, last),
            _ => [0.0; 2],
        };
        let leaves = self.points.last().is_some_and(|last| {
            let frames = (frame - last.frame) as f64;
            (0..2).any(|axis| {
                let next = last.position[axis] + frames * step[axis];
                next < EDGE * radius || next > size[axis] - EDGE * radius
            })
        });
        let reason = if leaves {
            LossReason::Left
        } else if libm::hypot(step[0], step[1]) > 2.0 * radius {
            LossReason::Fast
        } else if self.points.len() <= FEW {
            LossReason::Circle
        } else {
            LossReason::Unlike
        };
        Some(Loss { frame, reason })
    }
}

/// Displacement from frame to frame, px.
fn velocity(before: &Point, last: &Point) -> [f64; 2] {
    let frames = last.frame.saturating_sub(before.frame).max(1) as f64;
    std::array::from_fn(|axis| (last.position[axis] - before.position[axis]) / frames)
}

impl LossReason {
    /// Name in JSON.
    pub fn code(self) -> &'static str {
        match self {
            Self::Left => "left-the-picture",
            Self::Fast => "fast",
            Self::Circle => "circle",
            Self::Unlike => "unlike",
        }
    }

    /// Reason, and what helps.
    pub fn words(self) -> Words {
        match self {
            Self::Left => words("its path leads out of the picture; if it comes back, click it again there"),
            Self::Fast => words(
                "it moves by more than its own size from frame to frame; click it again in a later frame, or film at a higher rate",
            ),
            Self::Circle => words(
                "soon after the click, so that the circle may hold wall or shadow beside the body; set a smaller radius, or click it in another frame",
            ),
            Self::Unlike => words(
                "nothing resembles what was clicked: it is hidden, or looks otherwise; click it again where it is seen",
            ),
        }
    }
}

impl Loss {
    /// Frame, reason and what helps. `time`: presentation time of the frame, as shown.
    pub fn words(self, time: Words) -> Words {
        words!(
            "lost from frame {frame} on (counted from 1; {time} s of the film): {reason}",
            frame = Words::same((self.frame + 1).to_string()),
            reason = self.reason.words(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::super::track::Outline;
    use super::*;

    /// Track of a body of radius 10 px at these positions, lost in the frame after them.
    fn track(positions: &[[f64; 2]]) -> Track {
        let point = |(frame, position): (usize, &[f64; 2])| Point {
            frame,
            time: frame as f64 / 30.0,
            position: *position,
            sigma: [0.1; 2],
            score: 0.9,
            doubtful: false,
        };
        let points: Vec<Point> = positions.iter().enumerate().map(point).collect();
        let outline = Some(Outline { offset: [0.0; 2], radius: 10.0 });
        Track { lost: Some(points.len()), points, outline, ..Track::default() }
    }

    #[test]
    fn the_likely_reason_is_found() {
        let line = |from: [f64; 2], step: [f64; 2], count: usize| -> Vec<[f64; 2]> {
            (0..count).map(|frame| [0, 1].map(|axis| from[axis] + frame as f64 * step[axis])).collect()
        };
        for (positions, expected) in [
            (line([320.0, 240.0], [8.0, 0.0], 39), LossReason::Left),
            (line([320.0, 40.0], [0.0, -7.0], 4), LossReason::Left),
            (line([100.0, 240.0], [25.0, 0.0], 9), LossReason::Fast),
            (line([320.0, 240.0], [1.0, 1.0], 3), LossReason::Circle),
            (Vec::new(), LossReason::Circle),
            (line([320.0, 240.0], [1.0, 0.0], 60), LossReason::Unlike),
        ] {
            let lost = track(&positions);
            assert_eq!(
                lost.loss([640.0, 480.0]),
                Some(Loss { frame: positions.len(), reason: expected }),
                "{positions:?}"
            );
            let mut again = lost.clone();
            again.lost = Some(0);
            assert_eq!(again.loss([640.0, 480.0]).is_some(), positions.is_empty(), "it is found again");
        }
    }
}

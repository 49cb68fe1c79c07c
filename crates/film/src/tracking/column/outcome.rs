//! Result of the search of a path, and whether its motion is that of a surface.

use crate::tracking::column::certainty::Certainty;
use crate::tracking::column::regions::Regions;

/// For a frame, the maximum motion since the previous frame in rows, and the first and last row of an anchor.
pub(crate) type Limit = (usize, Option<(usize, usize)>);

/// Best path with its residuals.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub path: Vec<usize>,
    pub regions: Regions,
    pub certainties: Vec<Certainty>,
    pub limits: Vec<Limit>,
    /// Row of least cost in the clicked frame.
    pub favourite: usize,
    /// Sum of the absolute residuals, grey values.
    pub left: f64,
    /// Ratio of mean to median absolute residual, in the median frame; 1.18 for pure noise.
    pub unexplained: f64,
}

impl Outcome {
    /// Steps of the path in units of the maximum motion, from the first frame to the second on.
    fn speeds(&self, limits: &[Limit]) -> Vec<f64> {
        let steps = self.path.windows(2).map(|pair| pair[1] as f64 - pair[0] as f64);
        steps.zip(limits.iter().skip(1)).map(|(step, (reach, _))| step / (*reach).max(1) as f64).collect()
    }

    /// Number of frames in doubt.
    pub(crate) fn doubts(&self) -> usize {
        self.certainties.iter().filter(|certainty| certainty.is_doubtful()).count()
    }

    /// True if a step of the path is as long as the maximum motion. A faster surface is then elsewhere.
    pub(crate) fn is_bound(&self) -> bool {
        self.speeds(&self.limits).iter().any(|speed| speed.abs() >= 1.0)
    }

    /// True if all steps beyond some limits are no longer than both steps beside them together, as in an oscillation with six frames or more
    /// in a period.
    pub(crate) fn is_smooth_beyond(&self, limits: &[Limit]) -> bool {
        let speeds = self.speeds(limits);
        let beside = |at: Option<usize>, own: f64| at.and_then(|at| speeds.get(at)).map_or(own, |other| *other);
        speeds.iter().enumerate().filter(|(_, own)| own.abs() > 1.0).all(|(at, own)| {
            let both = beside(at.checked_sub(1), *own) + beside(Some(at + 1), *own);
            both * own.signum() >= own.abs()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracking::column::regions::Shape;

    #[test]
    fn a_fast_oscillation_is_smooth_and_a_jump_is_not() {
        let swing = |period: f64| -> Vec<usize> {
            let row = |n: i32| 200.0 + 100.0 * libm::sin(std::f64::consts::TAU * f64::from(n) / period);
            (0..40).map(|n| row(n) as usize).collect()
        };
        let still = |n: usize| if n < 20 { 100 } else { 190 };
        let spike = |n: usize| if n == 20 { 190 } else { 100 };
        // Path, whether it reaches 40 rows in a frame, and whether it is smooth beyond.
        let cases = [
            (swing(7.0), true, true),
            (swing(11.0), true, true),
            (swing(30.0), false, true),
            ((0..40).map(still).collect(), true, false),
            ((0..40).map(spike).collect(), true, false),
        ];
        for (path, is_bound, is_smooth) in cases {
            let limits = vec![(40, None); path.len()];
            let shape = Shape { rows: 400, channels: 1, half: 5 };
            let outcome = Outcome {
                path,
                regions: Regions::new(shape),
                certainties: Vec::new(),
                limits: limits.clone(),
                favourite: 0,
                left: 0.0,
                unexplained: 0.0,
            };
            assert_eq!(outcome.is_bound(), is_bound, "{:?}", outcome.path);
            assert_eq!(outcome.is_smooth_beyond(&limits), is_smooth, "{:?}", outcome.path);
        }
    }
}

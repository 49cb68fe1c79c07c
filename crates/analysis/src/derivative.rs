//! Velocity and acceleration computed from a measured column.

use crate::smoothing::{WIDEST, savitzky_golay};
use crate::stencil::{Stencil, differentiate};

/// Method of differentiating a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Differentiation {
    /// Central differences; the second derivative uses five rows, as in Tracker.
    Central,
    /// Difference to the next row.
    Forward,
    /// Difference to the row before.
    Backward,
    /// Local polynomials (Savitzky and Golay), which also smooth.
    Smooth {
        /// Number of rows of a window; odd, up to [`crate::smoothing::WIDEST`].
        window: usize,
        /// Degree of the polynomials: from 2 to 7, and below the number of rows.
        degree: usize,
    },
}

impl Differentiation {
    /// True unless it is a polynomial with an invalid window or degree.
    pub fn is_possible(self) -> bool {
        match self {
            Self::Smooth { window, degree } => {
                window % 2 == 1 && window <= WIDEST && (2..=7).contains(&degree) && degree < window
            }
            Self::Central | Self::Forward | Self::Backward => true,
        }
    }

    /// Values (smoothed for polynomials), first and second derivative, in the units of values and times. NaN where a value
    /// or a neighbour is missing; all NaN if nothing can be differentiated.
    pub fn derivatives(self, times: &[f64], values: &[f64]) -> [Vec<f64>; 3] {
        let (first, second) = match self {
            Self::Central => (Stencil::Central, Stencil::FivePoint),
            Self::Forward => (Stencil::Forward, Stencil::Second),
            Self::Backward => (Stencil::Backward, Stencil::Second),
            Self::Smooth { window, degree } => {
                return [0, 1, 2].map(|order| savitzky_golay(times, values, window, degree, order));
            }
        };
        [values.to_vec(), differentiate(times, values, first), differentiate(times, values, second)]
    }

    /// Short name, read by [`Differentiation::from_code`].
    pub fn code(self) -> String {
        match self {
            Self::Central => "central".to_owned(),
            Self::Forward => "forward".to_owned(),
            Self::Backward => "backward".to_owned(),
            Self::Smooth { window, degree } => format!("smooth-{window}-{degree}"),
        }
    }

    /// Method with this [`Differentiation::code`]; `None` for an unknown code.
    pub fn from_code(code: &str) -> Option<Self> {
        match code {
            "central" => Some(Self::Central),
            "forward" => Some(Self::Forward),
            "backward" => Some(Self::Backward),
            _ => {
                let (window, degree) = code.strip_prefix("smooth-")?.split_once('-')?;
                let smooth = Self::Smooth { window: window.parse().ok()?, degree: degree.parse().ok()? };
                Some(smooth).filter(|smooth| smooth.is_possible())
            }
        }
    }
}

/// Text of the unit of a derivative of this order: `cm/s^2`. Empty if the unit of the values is unknown.
pub fn unit(of_values: &str, of_times: &str, order: usize) -> String {
    match order {
        _ if of_values.is_empty() => String::new(),
        0 => of_values.to_owned(),
        1 => format!("{of_values}/{of_times}"),
        _ => format!("{of_values}/{of_times}^{order}"),
    }
}

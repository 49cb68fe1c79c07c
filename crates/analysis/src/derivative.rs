//! Velocity and acceleration computed from a measured column.

use crate::smoothing::{WIDEST, savitzky_golay};
use crate::stencil::{Stencil, differentiate};

/// How a column is differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Differentiation {
    /// Central differences, over five rows for the second derivative: as Tracker makes them.
    Central,
    /// The difference to the next row.
    Forward,
    /// The difference to the row before.
    Backward,
    /// Polynomials of a degree over so many rows, which smooth as well (Savitzky and Golay).
    Smooth {
        /// How many rows; an odd number up to [`crate::smoothing::WIDEST`].
        window: usize,
        /// The degree of the polynomials: from 2 to 7, and below the number of rows.
        degree: usize,
    },
}

impl Differentiation {
    /// Whether there is such a polynomial, if it is one.
    pub fn is_possible(self) -> bool {
        match self {
            Self::Smooth { window, degree } => {
                window % 2 == 1 && window <= WIDEST && (2..=7).contains(&degree) && degree < window
            }
            Self::Central | Self::Forward | Self::Backward => true,
        }
    }

    /// The values themselves (smoothed, if they are), their first and their second derivative. NaN where a value or a
    /// neighbour is missing; all NaN where nothing can be differentiated.
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

    /// A short name that [`Differentiation::from_code`] reads.
    pub fn code(self) -> String {
        match self {
            Self::Central => "central".to_owned(),
            Self::Forward => "forward".to_owned(),
            Self::Backward => "backward".to_owned(),
            Self::Smooth { window, degree } => format!("smooth-{window}-{degree}"),
        }
    }

    /// What [`Differentiation::code`] has written.
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

/// The unit of a derivative of this order, as it is written: `cm/s^2`. Empty where that of the values is not known.
pub fn unit(of_values: &str, of_times: &str, order: usize) -> String {
    match order {
        _ if of_values.is_empty() => String::new(),
        0 => of_values.to_owned(),
        1 => format!("{of_values}/{of_times}"),
        _ => format!("{of_values}/{of_times}^{order}"),
    }
}

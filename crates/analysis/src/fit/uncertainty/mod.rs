//! Uncertainties of the fitted numbers: covariance, autocorrelated residuals, profiles, and undetermined numbers.

pub(in crate::fit) mod covariance;
pub(in crate::fit) mod estimate;
pub(in crate::fit) mod exchange;
pub(in crate::fit) mod hac;
pub(in crate::fit) mod identify;
pub(in crate::fit) mod profile;
mod profile_end;
pub(in crate::fit) mod student;

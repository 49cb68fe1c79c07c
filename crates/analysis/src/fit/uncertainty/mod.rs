//! How certain the numbers of a fit are: covariance, correlated residuals, profiles, and what the data cannot determine.

pub(in crate::fit) mod covariance;
pub(in crate::fit) mod estimate;
pub(in crate::fit) mod exchange;
pub(in crate::fit) mod hac;
pub(in crate::fit) mod identify;
pub(in crate::fit) mod profile;
pub(in crate::fit) mod student;

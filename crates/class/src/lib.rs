//! Work of a class with Meniscus, without files, network, clock and DOM.
//!
//! | module | content |
//! |---|---|
//! | [`pooling`] | the pooled value of the results of groups, and outliers |
//! | [`results`] | the quantities that several groups have fitted |
//! | [`verify`] | hand-ins: making them, computing them again, and data that two of them share |

pub mod pooling;
pub mod results;
pub mod verify;

//! What a class does with Meniscus, without files, network, clock and DOM.
//!
//! | module | content |
//! |---|---|
//! | [`verify`] | hand-ins: making them, computing them again, and data that two of them share |

pub mod verify;

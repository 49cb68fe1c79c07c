//! A hand-in as it is written: its answers, its facts, and the parts of the file.
//!
//! `saved` reads hand-ins and writes them with this crate, as does a page of one simulation, in which a library for JSON would take
//! more room than all of its hand-in. A class server stores the parts and puts them together again.
//!
//! | module | content |
//! |---|---|
//! | [`answer`] | an answer as an item of a project |
//! | [`fact`] | a value that follows from the work |
//! | [`parts`] | the parts of a hand-in, and the file that they make |
//! | [`json`] | writing of JSON |

pub mod answer;
pub mod fact;
pub mod json;
mod number;
pub mod parts;

pub use number::Number;

//! A hand-in as it is written: its answers, its facts, and the parts of the file.
//!
//! `saved` reads hand-ins and writes them with this crate, as does a page of one simulation, in which a library for JSON
//! would take more room than all of its hand-in. A class server stores the parts and puts them together again.
//!
//! | module | content |
//! |---|---|
//! | [`answer`] | an answer as an item of a project |
//! | [`fact`] | a value that follows from the work |
//! | [`parts`] | the parts of a hand-in, and the file that they make |
//! | [`json`] | writing of JSON |
//!
//! `Parts::text` makes the file, `Parts::named` the parts that a class server stores one by one. This crate is the only
//! writer of hand-ins. What is written here is read by `saved` alone.
//!
//! - **Invariant:** no dependency that a page of one simulation does not have anyway.
//!
//! ```
//! use handed::parts::{Head, Parts, documents};
//!
//! let parts = Parts {
//!     head: Head { version: handed::parts::HAND_IN_VERSION, ..Head::default() },
//!     documents: documents([("spring.md", "A spring")]).into(),
//!     state: "\"\"".into(),
//!     facts: "[]".into(),
//!     ..Parts::default()
//! };
//! assert!(parts.text().starts_with("{\"meniscus hand-in\":2"));
//! ```

pub mod answer;
pub mod fact;
pub mod json;
mod number;
pub mod parts;

pub use number::Number;

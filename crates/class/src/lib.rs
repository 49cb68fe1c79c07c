//! Work of a class with Meniscus, without files, network, clock and DOM.
//!
//! | module | content |
//! |---|---|
//! | [`against`] | a straight line through results of groups against a parameter |
//! | [`collection`] | the hand-ins of a class, computed again one after the other, and what follows from all of them |
//! | [`course`] | packages of a page for learning platforms |
//! | [`grading`] | the grades of answers by a document and a seat |
//! | [`page`] | a report of a class as a page and as a workbook, and its figures |
//! | [`pooling`] | the pooled value of the results of groups, and outliers |
//! | [`results`] | the quantities that several groups have fitted |
//! | [`share`] | shares with their intervals |
//! | [`survey`] | the answers to a survey: tallies, frequent words, marked comments |
//! | [`verify`] | hand-ins: making them, computing them again, and data that two of them share |
//!
//! A class server, a report and a dashboard count the grades of [`grading`], which needs no run (`play::Marker`). [`page`]
//! draws for the program and for the dashboard of `lab/src/class`, which draws its parts one after the other (`room.rs`), so
//! that no task lasts long. Assigned values are of `program` (`assigned`, `seating.rs`): a seat replaces the defaults of the
//! assigned parameters, from which links, answers and restoring follow.
//!
//! - **Invariant:** no clock: the time of a hand-in comes in. Texts of a hand-in are bounded and shown as text.
//! - **Invariant:** values are compared exactly only where [`program::BITS`] is equal.

pub mod against;
pub mod collection;
pub mod course;
mod grades;
pub mod grading;
pub mod page;
pub mod pooling;
pub mod results;
pub mod share;
pub mod survey;
pub mod verify;

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

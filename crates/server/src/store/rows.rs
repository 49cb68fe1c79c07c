//! What is stored, for both stores.

use crate::codes::Hash;

/// A class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClassRow {
    /// Identifier.
    pub class: String,
    /// Code with which students join.
    pub code: String,
    /// Title.
    pub title: String,
    /// Token with which any student of the class sends answers to surveys.
    pub survey: String,
    /// Times in milliseconds since 1970.
    pub created: u64,
    /// End of the class; then it is erased.
    pub expires: u64,
}

/// A seat.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeatRow {
    /// Number, from 1.
    pub seat: u32,
    /// Pseudonym.
    pub pseudonym: String,
    /// Hash of the key for another device.
    pub key: Hash,
    /// False while the teacher has not let the student in.
    pub approved: bool,
}

/// An event to store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewEvent {
    /// Number in the seat, from 1.
    pub seq: u64,
    /// Kind.
    pub kind: &'static str,
    /// Content.
    pub body: String,
}

/// A stored event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EventRow {
    /// Order of arrival.
    pub number: u64,
    /// Seat; 0 is the teacher's.
    pub seat: u32,
    /// Number in the seat.
    pub seq: u64,
    /// Time of arrival by the server's clock, in milliseconds since 1970.
    pub at: u64,
    /// Kind.
    pub kind: String,
    /// Content.
    pub body: String,
}

/// Maximum number of answers to surveys in a class: those of 2,000 students to five surveys.
pub const MOST_SHEETS: i64 = 10_000;

/// Bytes that an event or a sheet takes besides its text, about: its row and its entry in an index. Also in [`SIZES`].
pub const ROW: u64 = 100;

/// Query for the bytes that each seat of a class has stored, in both databases; what belongs to no seat counts as seat 0. Its parameter is
/// the class.
pub const SIZES: &str = "SELECT seat, CAST(sum(size) AS BIGINT) FROM (
    SELECT seat, octet_length(body) + 100 AS size FROM event WHERE class=$1
    UNION ALL SELECT 0, octet_length(body) + 100 FROM sheet WHERE class=$1) AS stored GROUP BY seat";

/// Result of [`super::Store::append`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Number of events that were new.
    pub added: usize,
    /// Highest number of the seat.
    pub highest: u64,
    /// Highest order of arrival in the store.
    pub number: u64,
}

/// A seat to store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewSeat {
    /// Pseudonym, with [`NewSeat::NUMBER`] in the place of the number of the seat.
    pub pseudonym: String,
    /// Hash of the key for another device.
    pub key: Hash,
    /// False if the student waits for the teacher.
    pub approved: bool,
}

impl NewSeat {
    /// Stands for the number of the seat in its pseudonym.
    pub const NUMBER: &str = "#";
}

/// Place in the changes that all servers make.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cursor {
    /// Order of arrival of the latest event.
    pub event: u64,
    /// Number of the latest change of classes, seats and tokens.
    pub change: u64,
}

/// Changes of a store. What was changed several times has its latest state.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct News {
    /// Place after them; the default if there is none.
    pub cursor: Cursor,
    /// Classes, also those that have changed otherwise.
    pub classes: Vec<ClassRow>,
    /// Classes of which `tokens` has all tokens of teachers.
    pub teachers: Vec<String>,
    /// Erased seats with their class; seat 0 is the class.
    pub erased: Vec<(String, u32)>,
    /// Seats that are new or approved, with their class.
    pub seats: Vec<(String, SeatRow)>,
    /// Tokens of changed seats and classes.
    pub tokens: Vec<(Hash, String, u32)>,
    /// Classes with new events and the order of arrival of the latest.
    pub latest: Vec<(String, u64)>,
    /// Classes whose settings have changed.
    pub settings: Vec<String>,
}

/// A number as the tables hold it.
pub fn signed(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

//! Reasons why the store did not do what was asked.

use std::fmt;
use units::{Words, words};

/// Reason why the store did not do what was asked.
#[derive(Clone, Debug)]
pub enum Fault {
    /// The disk is full, or cannot be written for another reason. Nothing was stored.
    Unwritable(String),
    /// The database does not answer. Something may have been stored; sending it again adds nothing.
    Away(String),
    /// There is no such file.
    NoFile,
    /// The file exists already.
    Exists,
    /// The address of a database cannot be read.
    Address,
    /// The file is no store, or one of a later version.
    NoStore(String),
    /// Another event has this number already. Holds the highest number of the seat.
    Taken(u64),
    /// The seat has stored as much as it may.
    SeatFull,
    /// The class has stored as much as it may.
    ClassFull,
    /// The class has as many answers to surveys as it may.
    SheetsFull,
    /// There is no such class, seat or file.
    Missing,
    /// The server is ending.
    Ending,
}

impl Fault {
    /// Description for the user.
    pub fn words(&self) -> Words {
        match self {
            Self::Unwritable(why) => words!("cannot be written: {}", why),
            Self::Away(why) => words!("cannot be reached: {}", why),
            Self::NoFile => words("does not exist; `--store` names the file"),
            Self::Exists => words("exists already"),
            Self::Address => words("is no address of a database; for example `--store postgres://USER@HOST/DATABASE`"),
            Self::NoStore(why) => words!("is no store of classes: {}", why),
            Self::Taken(_) => words("has another event of this number"),
            Self::SeatFull => words("has no more room for this seat"),
            Self::ClassFull => words("has no more room for this class"),
            Self::SheetsFull => words("has no more room for answers to surveys in this class"),
            Self::Missing => words("has no such class or seat"),
            Self::Ending => words("is being closed"),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.words().english())
    }
}

impl std::error::Error for Fault {}

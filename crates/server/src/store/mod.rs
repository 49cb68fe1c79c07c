//! The log of events of all classes: in one SQLite file, or in a Postgres database that several servers share.
//!
//! | module | content |
//! |---|---|
//! | [`location`] | where a store is: a file or a database |
//! | [`rows`] | what is stored, for both stores |
//! | [`sqlite`] | the file: one thread writes |
//! | [`postgres`] | the database: one task of each server writes, and servers tell each other of changes |
//! | [`backup`] | backups, which are SQLite files whatever the store is |
//!
//! Both take up to 256 waiting changes into one transaction and answer each when the transaction is on disk. Their tables are the
//! same (`sqlite/schema.rs`, `postgres/schema.rs`).
//!
//! The table of events is append-only, `event(class, seat, seq, at, kind, body)`, unique by the first three. Nothing outside
//! of this folder distinguishes the two stores.
//!
//! With Postgres, memory is a copy of the database that is brought up to date before each request: `Classes::catch_up` asks
//! `Store::news` for everything after a `Cursor`, once for all requests that wait at that moment. The table `change` names
//! classes and seats that have changed; `LISTEN` only wakes those who follow streams. Transactions of all servers are made
//! one after the other under an advisory lock, so that numbers are in the order in which they become visible: who has read up
//! to a number misses no lower one. Each change is one statement that cannot fail for its own reasons but says what it found,
//! so that a group is sent without waiting for single answers.

mod backup;
mod fault;
mod group;
mod location;
mod postgres;
mod rows;
mod sqlite;
mod taking;

pub use backup::{back_up, restore};
pub use fault::Fault;
pub use location::Location;
pub use rows::{ClassRow, Cursor, EventRow, NewEvent, NewSeat, News, Outcome, ROW, SeatRow};
pub use sqlite::files_beside;

use crate::codes::Hash;
use postgres::Postgres;
use sqlite::Sqlite;
use std::time::Duration;
use tokio::time::sleep;

/// Time between two looks for what commands have erased in a file.
const LOOK: Duration = Duration::from_secs(2);

/// A store; cheap to clone.
#[derive(Clone, Debug)]
pub struct Store {
    location: Location,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Sqlite(Sqlite),
    Postgres(Postgres),
}

/// Calls a method of the store that there is.
macro_rules! of {
    ($store:expr, $method:ident($($argument:expr),*)) => {
        match &$store.kind {
            Kind::Sqlite(store) => store.$method($($argument),*).await,
            Kind::Postgres(store) => store.$method($($argument),*).await,
        }
    };
}

impl Store {
    /// Opens a store, or makes it.
    ///
    /// # Errors
    /// The store cannot be written, or there is something else.
    pub async fn open(location: &Location) -> Result<Self, Fault> {
        let kind = match location {
            Location::File(path) => Kind::Sqlite(Sqlite::open(path)?),
            Location::Database(config) => Kind::Postgres(Postgres::open(config, true).await?),
        };
        Ok(Self { location: location.clone(), kind })
    }

    /// Opens a store that exists.
    ///
    /// # Errors
    /// There is no store, or it cannot be written.
    pub async fn existing(location: &Location) -> Result<Self, Fault> {
        match location {
            Location::File(path) if !path.exists() => Err(Fault::NoFile),
            Location::File(_) => Self::open(location).await,
            Location::Database(config) => {
                let kind = Kind::Postgres(Postgres::open(config, false).await?);
                Ok(Self { location: location.clone(), kind })
            }
        }
    }

    /// Where the store is.
    pub fn location(&self) -> &Location {
        &self.location
    }

    /// Stores a new class. `is_first`: does nothing if there is one.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn add_class(&self, class: ClassRow, is_first: bool) -> Result<(), Fault> {
        of!(self, add_class(class, is_first))
    }

    /// Stores a seat under the next number, which no seat of the class has ever had, and the hash of its first token.
    ///
    /// # Errors
    /// The class has `most` seats already; the store cannot be written.
    pub async fn add_seat(&self, class: String, seat: NewSeat, token: Hash, most: u32) -> Result<SeatRow, Fault> {
        of!(self, add_seat(class, seat, token, most))
    }

    /// Stores the hash of a further token of a seat.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn add_token(&self, class: String, seat: u32, token: Hash) -> Result<(), Fault> {
        of!(self, add_token(class, seat, token))
    }

    /// Stores the hash of a one-time link of the teacher. In a file it ends with the server, in a database after a day.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn add_link(&self, class: String, link: Hash) -> Result<(), Fault> {
        of!(self, add_link(class, link))
    }

    /// Uses up a one-time link and stores the hash of a token of the teacher. Returns the class; `None` if the link was used, or
    /// never existed.
    ///
    /// # Errors
    /// The store cannot be written; the link can be used again then.
    pub async fn exchange(&self, link: Hash, token: Hash) -> Result<Option<String>, Fault> {
        of!(self, exchange(link, token))
    }

    /// Changes the code of a class.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn set_code(&self, class: String, code: String) -> Result<(), Fault> {
        of!(self, set_code(class, code))
    }

    /// Revokes the tokens of the teacher of a class but the one of this hash, and the links that nobody has used.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn revoke_teachers(&self, class: String, but: Hash) -> Result<(), Fault> {
        of!(self, revoke_teachers(class, but))
    }

    /// Erased seats with their classes; seat 0 is the class itself, of which nothing else is left.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn erased(&self) -> Result<Vec<(String, u32)>, Fault> {
        of!(self, erased())
    }

    /// Lets a student in.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn approve(&self, class: String, seat: u32) -> Result<(), Fault> {
        of!(self, approve(class, seat))
    }

    /// Stores events of a seat, all or none. An event that is stored already adds nothing.
    ///
    /// # Errors
    /// Another event has one of the numbers; there is no such seat; the store cannot be written.
    pub async fn append(&self, class: String, seat: u32, at: u64, events: Vec<NewEvent>) -> Result<Outcome, Fault> {
        of!(self, append(class, seat, at, events))
    }

    /// Stores an event of the teacher under the next number. Returns its order of arrival.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn append_of_teacher(
        &self,
        class: String,
        at: u64,
        kind: &'static str,
        body: String,
    ) -> Result<u64, Fault> {
        of!(self, append_of_teacher(class, at, kind, body))
    }

    /// Stores the answers of one person to a survey. Answers with an identifier that is stored already add nothing. Returns true if these
    /// were new.
    ///
    /// # Errors
    /// The class has as many as it may; the store cannot be written.
    pub async fn add_sheet(&self, class: String, id: [u8; 16], body: String) -> Result<bool, Fault> {
        of!(self, add_sheet(class, id, body))
    }

    /// All classes, the latest first.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn classes(&self) -> Result<Vec<ClassRow>, Fault> {
        of!(self, classes())
    }

    /// Seats of a class.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn seats(&self, class: String) -> Result<Vec<SeatRow>, Fault> {
        of!(self, seats(class))
    }

    /// Sizes of what the seats of a class have stored, in bytes; seat 0 has what belongs to no seat.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn sizes(&self, class: String) -> Result<Vec<(u32, u64)>, Fault> {
        of!(self, sizes(class))
    }

    /// Hashes of the tokens of a class with their seats.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn tokens(&self, class: String) -> Result<Vec<(Hash, u32)>, Fault> {
        of!(self, tokens(class))
    }

    /// Events of a class after `since` in the order of arrival, at most `most`. An event that is stored later has a higher number.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn events(&self, class: String, since: u64, most: u32) -> Result<Vec<EventRow>, Fault> {
        of!(self, events(class, since, most))
    }

    /// Events of a seat in the order of their numbers.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn events_of_seat(&self, class: String, seat: u32) -> Result<Vec<EventRow>, Fault> {
        of!(self, events_of_seat(class, seat))
    }

    /// Highest order of arrival; 0 for an empty store.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn last_number(&self) -> Result<u64, Fault> {
        of!(self, last_number())
    }

    /// The latest event of the teacher of this kind.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn latest_of_teacher(&self, class: String, kind: &'static str) -> Result<Option<EventRow>, Fault> {
        of!(self, latest_of_teacher(class, kind))
    }

    /// Answers to surveys, in the random order of their keys.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn sheets(&self, class: String) -> Result<Vec<String>, Fault> {
        of!(self, sheets(class))
    }

    /// Erases seats. Only their numbers stay, so that no backup brings them back.
    ///
    /// # Errors
    /// There is no such seat, or the store cannot be written.
    pub async fn erase_seats(&self, class: String, seats: Vec<u32>) -> Result<(), Fault> {
        of!(self, erase_seats(class, seats))
    }

    /// Erases a class with everything in it.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn erase_class(&self, class: String) -> Result<(), Fault> {
        of!(self, erase_class(class))
    }

    /// Erases the classes whose time is over. Returns their identifiers.
    ///
    /// # Errors
    /// The store cannot be read or written.
    pub async fn erase_expired(&self, now: u64) -> Result<Vec<String>, Fault> {
        let over: Vec<String> =
            self.classes().await?.into_iter().filter(|class| class.expires <= now).map(|class| class.class).collect();
        for class in &over {
            self.erase_class(class.clone()).await?;
        }
        Ok(over)
    }

    /// Writes the tables once more without the places of erased rows. A file overwrites these places when it erases; a database
    /// keeps everyone waiting meanwhile.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn rewrite(&self) -> Result<(), Fault> {
        match &self.kind {
            Kind::Sqlite(_) => Ok(()),
            Kind::Postgres(store) => store.rewrite().await,
        }
    }

    /// Place in the changes of other servers from which [`Store::news`] goes on.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn cursor(&self) -> Result<Cursor, Fault> {
        of!(self, cursor())
    }

    /// Everything that any server has changed after this place, until the call. A file has one server: its news is what commands have
    /// erased beside it.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn news(&self, since: Cursor) -> Result<News, Fault> {
        of!(self, news(since))
    }

    /// Waits until some server has changed something; with a file until it is time to look. One task at a time may wait.
    pub async fn changed(&self) {
        match &self.kind {
            Kind::Sqlite(_) => sleep(LOOK).await,
            Kind::Postgres(store) => store.changed().await,
        }
    }
}

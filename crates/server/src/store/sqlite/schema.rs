//! Tables of the store.

use super::super::fault::Fault;
use rusqlite::Connection;

/// Version of the tables, in `user_version`.
const VERSION: i64 = 1;

/// Marks a file as a store of classes, in `application_id`: "Mcls".
const KIND: i64 = 0x4d63_6c73;

/// `event` is the log. `(class, seat, seq)` is unique: sending an event again adds nothing. `number` gives the order of arrival, by
/// which streams are resumed. Seat 0 is the teacher's. `survey` is the token
/// that all students of a class share for their answers to surveys. `sheet` has neither seat nor time, and its random key no order.
const TABLES: &str = "
CREATE TABLE class(class TEXT PRIMARY KEY, code TEXT NOT NULL, title TEXT NOT NULL, survey TEXT NOT NULL,
  created INTEGER NOT NULL, expires INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE seat(class TEXT NOT NULL, seat INTEGER NOT NULL, pseudonym TEXT NOT NULL, key BLOB NOT NULL,
  approved INTEGER NOT NULL, PRIMARY KEY(class, seat)) WITHOUT ROWID;
CREATE TABLE token(hash BLOB PRIMARY KEY, class TEXT NOT NULL, seat INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE event(number INTEGER PRIMARY KEY AUTOINCREMENT, class TEXT NOT NULL, seat INTEGER NOT NULL,
  seq INTEGER NOT NULL, at INTEGER NOT NULL, kind TEXT NOT NULL, body TEXT NOT NULL, UNIQUE(class, seat, seq));
CREATE TABLE sheet(class TEXT NOT NULL, id BLOB NOT NULL, body TEXT NOT NULL, PRIMARY KEY(class, id)) WITHOUT ROWID;
CREATE TABLE erased(class TEXT NOT NULL, seat INTEGER NOT NULL, PRIMARY KEY(class, seat)) WITHOUT ROWID;
";

/// Makes the tables in an empty file, and checks them in any other.
pub fn prepare(connection: &Connection) -> Result<(), Fault> {
    let number = |name: &str| connection.pragma_query_value(None, name, |row| row.get::<_, i64>(0));
    let (kind, version) = (number("application_id")?, number("user_version")?);
    let tables: i64 = connection.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
    match (kind, version, tables) {
        (KIND, VERSION, _) => Ok(()),
        (0, 0, 0) => Ok(connection.execute_batch(&format!(
            "BEGIN;{TABLES}PRAGMA application_id={KIND}; PRAGMA user_version={VERSION}; COMMIT;"
        ))?),
        (KIND, later, _) => Err(Fault::NoStore(format!("version {later}"))),
        _ => Err(Fault::NoStore("SQLite".to_owned())),
    }
}

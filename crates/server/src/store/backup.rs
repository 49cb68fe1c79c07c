//! Backups: SQLite files, whatever the store is. They carry the times at which their classes end.

use super::fault::Fault;
use super::location::Location;
use super::{postgres, sqlite};
use std::path::Path;

/// Columns of an event in a backup; the order of arrival is given anew.
const EVENT: &str = "class, seat, seq, at, kind, body";

/// Writes all classes of a store, also of one that servers use at the moment, into a new file.
///
/// # Errors
/// There is no store at `from`, or `to` exists or cannot be written.
pub async fn back_up(from: &Location, to: &Path) -> Result<(), Fault> {
    if to.exists() {
        return Err(Fault::Exists);
    }
    match from {
        Location::File(path) => sqlite::backup::back_up(path, to),
        Location::Database(config) => postgres::backup::back_up(config, to).await,
    }
}

/// Takes classes from a backup into a store, which is made if there is none. What the store has already stays. Classes whose time
/// is over and erased seats are left out. Returns the number of events that came back.
///
/// # Errors
/// There is no backup at `from`, or `into` cannot be written.
pub async fn restore(from: &Path, into: &Location, now: u64) -> Result<u64, Fault> {
    match into {
        Location::File(path) => sqlite::backup::restore(from, path, now),
        Location::Database(config) => postgres::backup::restore(from, config, now).await,
    }
}

/// Statement that takes the numbers of erased seats from the tables of one schema to those of another one.
pub fn taking_erased(backup: &str, store: &str) -> String {
    format!("INSERT INTO {store}.erased SELECT * FROM {backup}.erased WHERE true ON CONFLICT DO NOTHING")
}

/// Statements that take everything else, the events last. Their parameter is the present time. Both databases understand them.
pub fn taking(backup: &str, store: &str) -> [String; 5] {
    let erased = format!("(SELECT class, seat FROM {store}.erased)");
    // An erased class is seat 0 of it.
    let kept = format!("class IN (SELECT class FROM {backup}.class WHERE expires>$1) AND (class, 0) NOT IN {erased}");
    let take = |into: &str, columns: &str, rest: &str| {
        let table = into.split('(').next().unwrap_or_default();
        format!(
            "INSERT INTO {store}.{into} SELECT {columns} FROM {backup}.{table} WHERE {kept} {rest} ON CONFLICT DO NOTHING"
        )
    };
    let seats = format!("AND (class, seat) NOT IN {erased}");
    [
        take("class", "*", ""),
        take("sheet", "*", ""),
        take("seat", "*", &seats),
        take("token", "*", &seats),
        take(&format!("event({EVENT})"), EVENT, &format!("{seats} ORDER BY number")),
    ]
}

/// Query for the classes of a schema whose time is over. Its parameter is the present time.
pub fn over(store: &str) -> String {
    format!("SELECT class FROM {store}.class WHERE expires<=$1")
}

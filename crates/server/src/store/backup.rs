//! Backups. A backup is a store like any other and carries the times at which its classes end.

use super::erase::erase_class;
use super::fault::Fault;
use super::{connection, schema};
use rusqlite::{Connection, params};
use std::path::Path;

/// Writes all classes of a store, also of one that a server uses at the moment, into a new file.
///
/// # Errors
/// `from` is no store, or `to` exists or cannot be written.
pub fn back_up(from: &Path, to: &Path) -> Result<(), Fault> {
    let store = existing(from)?;
    if to.exists() {
        return Err(Fault::Unwritable(std::io::Error::from(std::io::ErrorKind::AlreadyExists).to_string()));
    }
    let name = to.to_str().ok_or(Fault::Missing)?;
    store.execute("VACUUM INTO ?", [name])?;
    Ok(())
}

/// Takes classes from a backup into a store, which is made if there is none. What the store has already stays. Classes whose time
/// is over and erased seats are left out. Returns the number of events that came back.
///
/// # Errors
/// `from` is no store, or `into` cannot be written.
pub fn restore(from: &Path, into: &Path, now: u64) -> Result<usize, Fault> {
    drop(existing(from)?);
    let store = connection(into)?;
    schema::prepare(&store)?;
    store.execute("ATTACH ? AS backup", [from.to_str().ok_or(Fault::Missing)?])?;
    let transaction = store.unchecked_transaction()?;
    transaction.execute("INSERT OR IGNORE INTO erased SELECT * FROM backup.erased", [])?;
    let now = i64::try_from(now).unwrap_or(i64::MAX);
    // An erased class is seat 0 of it.
    let kept = "class IN (SELECT class FROM backup.class WHERE expires>?) AND (class, 0) NOT IN (SELECT class, seat FROM erased)";
    let seats = "(class, seat) NOT IN (SELECT class, seat FROM erased)";
    transaction
        .execute(&format!("INSERT OR IGNORE INTO class SELECT * FROM backup.class WHERE {kept}"), params![now])?;
    transaction
        .execute(&format!("INSERT OR IGNORE INTO sheet SELECT * FROM backup.sheet WHERE {kept}"), params![now])?;
    for table in ["seat", "token"] {
        let copy = format!("INSERT OR IGNORE INTO {table} SELECT * FROM backup.{table} WHERE {kept} AND {seats}");
        transaction.execute(&copy, params![now])?;
    }
    let columns = "class, seat, seq, at, kind, body";
    let copy = format!(
        "INSERT OR IGNORE INTO event({columns}) SELECT {columns} FROM backup.event WHERE {kept} AND {seats} ORDER BY number"
    );
    let events = transaction.execute(&copy, params![now])?;
    for class in over(&transaction, now)? {
        erase_class(&transaction, &class)?;
    }
    transaction.commit()?;
    store.execute_batch("DETACH backup")?;
    Ok(events)
}

/// Classes of a store whose time is over.
fn over(store: &Connection, now: i64) -> Result<Vec<String>, Fault> {
    let mut query = store.prepare("SELECT class FROM main.class WHERE expires<=?")?;
    let rows = query.query_map([now], |row| row.get(0))?;
    Ok(rows.collect::<Result<_, _>>()?)
}

fn existing(path: &Path) -> Result<Connection, Fault> {
    if !path.exists() {
        return Err(Fault::NoStore(std::io::Error::from(std::io::ErrorKind::NotFound).to_string()));
    }
    let store = connection(path)?;
    schema::prepare(&store)?;
    Ok(store)
}

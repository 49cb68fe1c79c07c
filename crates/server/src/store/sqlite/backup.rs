//! Backups of a file, and restoring into it.

use super::super::fault::Fault;
use super::super::rows::signed;
use super::super::taking::{over, taking, taking_erased};
use super::erase::erase_class;
use super::{connection, schema};
use rusqlite::Connection;
use std::path::Path;

/// Copies a store, also one that a server uses at the moment, into a new file.
pub fn back_up(from: &Path, to: &Path) -> Result<(), Fault> {
    let name = to.to_str().ok_or(Fault::Missing)?;
    existing(from)?.execute("VACUUM INTO ?", [name])?;
    Ok(())
}

/// Removes all classes but one from a backup.
pub fn keep_only(backup: &Path, class: &str) -> Result<(), Fault> {
    let store = existing(backup)?;
    let transaction = store.unchecked_transaction()?;
    for table in ["event", "token", "seat", "sheet", "erased", "class"] {
        transaction.execute(&format!("DELETE FROM {table} WHERE class<>?"), [class])?;
    }
    transaction.commit()?;
    Ok(store.execute_batch("VACUUM")?)
}

/// Takes classes from a backup into a store. Returns the number of events that came back.
pub fn restore(from: &Path, into: &Path, now: u64) -> Result<u64, Fault> {
    drop(existing(from)?);
    let store = connection(into)?;
    schema::prepare(&store)?;
    store.execute("ATTACH ? AS backup", [from.to_str().ok_or(Fault::Missing)?])?;
    let transaction = store.unchecked_transaction()?;
    transaction.execute(&taking_erased("backup", "main"), [])?;
    let mut events = 0;
    for statement in taking("backup", "main") {
        events = transaction.execute(&statement, [signed(now)])?;
    }
    let over: Vec<String> =
        transaction.prepare(&over("main"))?.query_map([signed(now)], |row| row.get(0))?.collect::<Result<_, _>>()?;
    for class in over {
        erase_class(&transaction, &class)?;
    }
    transaction.commit()?;
    store.execute_batch("DETACH backup")?;
    Ok(events as u64)
}

/// A store that exists.
pub fn existing(path: &Path) -> Result<Connection, Fault> {
    if !path.exists() {
        return Err(Fault::NoStore(std::io::Error::from(std::io::ErrorKind::NotFound).to_string()));
    }
    let store = connection(path)?;
    schema::prepare(&store)?;
    Ok(store)
}

/// A new store.
pub fn new(path: &Path) -> Result<Connection, Fault> {
    let store = connection(path)?;
    schema::prepare(&store)?;
    Ok(store)
}

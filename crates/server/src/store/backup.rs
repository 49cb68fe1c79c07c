//! Backups: SQLite files, whatever the store is. They carry the times at which their classes end.

use super::fault::Fault;
use super::location::Location;
use super::{postgres, sqlite};
use std::path::Path;

/// Writes all classes of a store, also of one that servers use at the moment, into a new file. `class`: this class alone.
///
/// # Errors
/// There is no store at `from`, or `to` exists or cannot be written.
pub async fn back_up(from: &Location, to: &Path, class: Option<&str>) -> Result<(), Fault> {
    if to.exists() {
        return Err(Fault::Exists);
    }
    match from {
        Location::File(path) => sqlite::backup::back_up(path, to),
        Location::Database(config) => postgres::backup::back_up(config, to).await,
    }?;
    let Some(class) = class else { return Ok(()) };
    let kept = sqlite::backup::keep_only(to, class);
    if kept.is_err() {
        // It would hold more than was asked for.
        let _ = std::fs::remove_file(to);
    }
    kept
}

/// Takes classes from a backup into a store, which is made if there is none. What the store has already stays. Classes whose time
/// is over and erased seats are left out, and so are the tokens of teachers: those may have been revoked after the backup. Returns the
/// number of events that came back.
///
/// # Errors
/// There is no backup at `from`, or `into` cannot be written.
pub async fn restore(from: &Path, into: &Location, now: u64) -> Result<u64, Fault> {
    match into {
        Location::File(path) => sqlite::backup::restore(from, path, now),
        Location::Database(config) => postgres::backup::restore(from, config, now).await,
    }
}

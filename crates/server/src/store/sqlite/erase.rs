//! Erasing: no byte of a text stays in the file or in its write-ahead log.

use super::super::fault::Fault;
use super::Sqlite;
use rusqlite::{Connection, params};

impl Sqlite {
    pub async fn erase_seats(&self, class: String, seats: Vec<u32>) -> Result<(), Fault> {
        self.change(move |connection| seats.iter().try_for_each(|&seat| erase_seat(connection, &class, seat))).await?;
        self.empty_log().await
    }

    pub async fn erase_class(&self, class: String) -> Result<(), Fault> {
        self.change(move |connection| {
            erase_class(connection, &class)?;
            // Seat 0 stands for the class.
            connection.execute("INSERT OR IGNORE INTO erased VALUES(?, 0)", [class])?;
            Ok(())
        })
        .await?;
        self.empty_log().await
    }

    /// Copies the write-ahead log into the file and empties it. Readers that keep the log are waited for.
    async fn empty_log(&self) -> Result<(), Fault> {
        self.alone(|connection| {
            let busy: i64 = connection.query_row("PRAGMA wal_checkpoint(TRUNCATE)", [], |row| row.get(0))?;
            if busy == 0 { Ok(()) } else { Err(Fault::Unwritable("wal_checkpoint".to_owned())) }
        })
        .await
    }
}

fn erase_seat(connection: &Connection, class: &str, seat: u32) -> Result<(), Fault> {
    if connection.execute("DELETE FROM seat WHERE class=? AND seat=?", params![class, seat])? == 0 {
        // It is erased once more if the log could not be emptied before.
        let erased = "SELECT 1 FROM erased WHERE class=? AND seat=?";
        connection.query_row(erased, params![class, seat], |_| Ok(()))?;
    }
    for table in ["event", "token"] {
        connection.execute(&format!("DELETE FROM {table} WHERE class=? AND seat=?"), params![class, seat])?;
    }
    connection.execute("INSERT OR IGNORE INTO erased VALUES(?,?)", params![class, seat])?;
    Ok(())
}

/// Deletes all rows of a class.
pub(super) fn erase_class(connection: &Connection, class: &str) -> Result<(), Fault> {
    for table in ["event", "token", "seat", "sheet", "class"] {
        connection.execute(&format!("DELETE FROM {table} WHERE class=?"), [class])?;
    }
    Ok(())
}

//! Erasing: no byte of a text stays in the file or in its write-ahead log.

use super::Store;
use super::fault::Fault;
use rusqlite::{Connection, params};

impl Store {
    /// Erases a seat. Only its number stays, so that no backup brings it back.
    ///
    /// # Errors
    /// There is no such seat, or the store cannot be written.
    pub async fn erase_seat(&self, class: String, seat: u32) -> Result<(), Fault> {
        self.change(move |connection| erase_seat(connection, &class, seat)).await?;
        self.empty_log().await
    }

    /// Erases a class with everything in it.
    ///
    /// # Errors
    /// The store cannot be written.
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

//! A store in one SQLite file.
//!
//! One thread writes. It takes up to 256 waiting changes into one transaction and answers each when the transaction is on
//! disk (`synchronous=FULL`). Readers have connections of their own, which the write-ahead log lets work meanwhile.

pub mod backup;
mod erase;
mod rows;
mod schema;
mod writer;

use super::fault::Fault;
use super::group::QUEUE;
use crate::codes::Hash;
use rusqlite::{Connection, OpenFlags};
use std::collections::HashMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::sync::{mpsc, oneshot};
use writer::{Job, Task};

/// Time for which a connection waits for another process.
const BUSY: Duration = Duration::from_secs(5);

/// A store in a file; cheap to clone. The writing thread ends when the last clone is dropped.
#[derive(Clone)]
pub struct Sqlite {
    path: Arc<Path>,
    jobs: mpsc::Sender<Job>,
    readers: Arc<Mutex<Vec<Connection>>>,
    /// One-time links of teachers with their classes.
    links: Arc<Mutex<HashMap<Hash, String>>>,
}

impl fmt::Debug for Sqlite {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Sqlite").field("path", &self.path).finish_non_exhaustive()
    }
}

impl Sqlite {
    /// Opens the file, or makes it.
    pub fn open(path: &Path) -> Result<Self, Fault> {
        let connection = connection(path)?;
        schema::prepare(&connection)?;
        let (jobs, waiting) = mpsc::channel(QUEUE);
        std::thread::Builder::new()
            .name("store".to_owned())
            .spawn(move || writer::write(connection, waiting))
            .map_err(|error| Fault::Unwritable(error.to_string()))?;
        Ok(Self { path: path.into(), jobs, readers: Arc::default(), links: Arc::default() })
    }

    /// Makes a change together with others that wait, and returns when it is on disk. A change that fails leaves nothing
    /// behind.
    async fn change<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Connection) -> Result<T, Fault> + Send + 'static,
    ) -> Result<T, Fault> {
        self.send(work, Job::Change).await
    }

    /// Does something outside of a transaction.
    async fn alone<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Connection) -> Result<T, Fault> + Send + 'static,
    ) -> Result<T, Fault> {
        self.send(work, Job::Alone).await
    }

    async fn send<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Connection) -> Result<T, Fault> + Send + 'static,
        job: fn(Box<dyn writer::Pending>) -> Job,
    ) -> Result<T, Fault> {
        let (reply, answer) = oneshot::channel();
        self.jobs.send(job(Task::boxed(work, reply))).await.map_err(|_| Fault::Ending)?;
        answer.await.map_err(|_| Fault::Ending)?
    }

    /// Reads with a connection of its own, on a thread for blocking work.
    async fn read<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Connection) -> Result<T, Fault> + Send + 'static,
    ) -> Result<T, Fault> {
        let store = self.clone();
        let task = tokio::task::spawn_blocking(move || {
            let idle = store.readers.lock().map_err(|_| Fault::Ending)?.pop();
            let reader = match idle {
                Some(reader) => reader,
                None => reading(&store.path)?,
            };
            let result = work(&reader);
            store.readers.lock().map_err(|_| Fault::Ending)?.push(reader);
            result
        });
        task.await.map_err(|_| Fault::Ending)?
    }
}

/// A connection that writes.
fn connection(path: &Path) -> Result<Connection, Fault> {
    let connection = Connection::open(path)?;
    connection.busy_timeout(BUSY)?;
    // Deleted bytes are overwritten; an answer is given when its bytes are on disk.
    connection.execute_batch(
        "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA secure_delete=ON; PRAGMA trusted_schema=OFF;",
    )?;
    Ok(connection)
}

fn reading(path: &Path) -> Result<Connection, Fault> {
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let connection = Connection::open_with_flags(path, flags)?;
    connection.busy_timeout(BUSY)?;
    Ok(connection)
}

/// Files that SQLite keeps beside the store.
pub fn files_beside(path: &Path) -> [PathBuf; 2] {
    ["-wal", "-shm"].map(|ending| {
        let mut name = path.as_os_str().to_owned();
        name.push(ending);
        name.into()
    })
}

impl From<rusqlite::Error> for Fault {
    fn from(error: rusqlite::Error) -> Self {
        match error {
            rusqlite::Error::QueryReturnedNoRows => Self::Missing,
            rusqlite::Error::SqliteFailure(failure, _) if failure.code == rusqlite::ErrorCode::NotADatabase => {
                Self::NoStore(failure.to_string())
            }
            error => Self::Unwritable(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests;

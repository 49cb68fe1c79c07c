//! A store in a Postgres database, which several servers share.
//!
//! Each server has a connection that writes, one that listens to the others, and a few that read. Changes of all servers are made
//! one transaction after the other ([`schema::BEGIN`]), each of up to 256 changes, and are answered when it is on disk.
//! Nothing is kept that another server could change without notice: [`Postgres::news`] asks the database.

pub mod backup;
mod line;
mod news;
mod read;
mod schema;
mod tls;
mod write;
mod writer;

use super::fault::Fault;
use super::group::QUEUE;
use line::{Line, NAME, configured, fault};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tokio::sync::{Notify, mpsc, oneshot};
use tokio::time::sleep;
use tokio_postgres::types::{FromSql, ToSql};
use tokio_postgres::{Config, Row};
use writer::{Change, Value};

/// Number of connections that read.
const READERS: usize = 3;

/// Pause between two attempts to listen again.
const RETRY: Duration = Duration::from_millis(500);

/// A store in a database; cheap to clone. The writing task ends when the last clone is dropped.
#[derive(Clone, Debug)]
pub struct Postgres(Arc<Lines>);

#[derive(Debug)]
struct Lines {
    changes: mpsc::Sender<Change>,
    /// Listens, and asks for news.
    listener: Line,
    told: Arc<Notify>,
    readers: [Line; READERS],
    next: AtomicUsize,
}

impl Postgres {
    /// Opens the store. `makes`: makes the tables if there are none.
    pub async fn open(config: &Config, makes: bool) -> Result<Self, Fault> {
        let config = configured(config);
        let told = Arc::new(Notify::new());
        let writer = Line::new(&config, None);
        schema::prepare(&*writer.session().await?, makes).await?;
        let (changes, waiting) = mpsc::channel(QUEUE);
        tokio::spawn(writer::write(writer, waiting));
        Ok(Self(Arc::new(Lines {
            changes,
            listener: Line::new(&config, Some(told.clone())),
            told,
            readers: std::array::from_fn(|_| Line::new(&config, None)),
            next: AtomicUsize::new(0),
        })))
    }

    /// Makes a change together with others that wait, and returns when it is on disk.
    async fn change(&self, sql: &'static str, values: Vec<Value>) -> Result<Vec<Row>, Fault> {
        let (reply, answer) = oneshot::channel();
        self.0.changes.send(Change { sql, values, reply }).await.map_err(|_| Fault::Ending)?;
        answer.await.map_err(|_| Fault::Ending)?
    }

    /// A connection that reads.
    fn reader(&self) -> &Line {
        &self.0.readers[self.0.next.fetch_add(1, Ordering::Relaxed) % READERS]
    }

    async fn rows(&self, sql: &'static str, values: &[&(dyn ToSql + Sync)]) -> Result<Vec<Row>, Fault> {
        self.reader().rows(sql, values).await
    }

    /// Waits until some server has changed something, or a lost connection is there again.
    pub async fn changed(&self) {
        while self.0.listener.session().await.is_err() {
            sleep(RETRY).await;
        }
        self.0.told.notified().await;
    }

    /// Lets the database remove erased rows, so that no query finds them.
    async fn vacuum(&self) -> Result<(), Fault> {
        self.alone("VACUUM event, seat, token, sheet, class, link").await
    }

    /// Writes the tables into new files, in which there are no erased rows.
    pub async fn rewrite(&self) -> Result<(), Fault> {
        self.alone("VACUUM (FULL) event, seat, token, sheet, class, link").await
    }

    /// Does something that is no part of a transaction.
    async fn alone(&self, sql: &str) -> Result<(), Fault> {
        let session = self.reader().session().await?;
        session.client().batch_execute(sql).await.map_err(|error| fault(&error))
    }
}

/// A value of a row.
fn value<'a, T: FromSql<'a>>(row: &'a Row, column: usize) -> Result<T, Fault> {
    row.try_get(column).map_err(|error| fault(&error))
}

/// A number, which the tables hold as a signed one.
fn number<T: TryFrom<i64> + Default>(row: &Row, column: usize) -> Result<T, Fault> {
    Ok(T::try_from(value::<i64>(row, column)?).unwrap_or_default())
}

/// A hash.
fn hash(row: &Row, column: usize) -> Result<[u8; 32], Fault> {
    value::<&[u8]>(row, column)?.try_into().map_err(|_| Fault::NoStore(NAME.to_owned()))
}

//! The task that writes: group commit.

use super::super::fault::Fault;
use super::super::group::GROUP;
use super::line::{ANSWER, Line, Session, fault, is_own, late};
use super::schema::BEGIN;
use futures_util::future::try_join_all;
use tokio::sync::{mpsc, oneshot};
use tokio::time::timeout;
use tokio_postgres::types::ToSql;
use tokio_postgres::{Error, Row};

/// A value of a statement.
pub type Value = Box<dyn ToSql + Sync + Send>;

/// A change: one statement, made in one transaction with others.
pub struct Change {
    pub sql: &'static str,
    pub values: Vec<Value>,
    pub reply: oneshot::Sender<Result<Vec<Row>, Fault>>,
}

/// Ends a transaction and tells all servers of it when it is visible.
const COMMIT: &str = "SELECT pg_notify('meniscus', ''); COMMIT";

/// Works until the last sender is gone.
pub async fn write(line: Line, mut jobs: mpsc::Receiver<Change>) {
    let mut group = Vec::new();
    while jobs.recv_many(&mut group, GROUP).await > 0 {
        answer(&line, std::mem::take(&mut group)).await;
    }
}

async fn answer(line: &Line, group: Vec<Change>) {
    let results = match committed(line, &group).await {
        Err(Refused { is_own: true, .. }) if group.len() > 1 => {
            // One change has failed and took the others with it.
            let mut results = Vec::new();
            for change in &group {
                let alone = committed(line, std::slice::from_ref(change)).await;
                results.push(alone.map(|rows| rows.into_iter().flatten().collect()));
            }
            results
        }
        Err(refused) => group.iter().map(|_| Err(refused.clone())).collect(),
        Ok(rows) => rows.into_iter().map(Ok).collect(),
    };
    for (change, result) in group.into_iter().zip(results) {
        // Who asked may have gone; the change is stored nevertheless.
        let _ = change.reply.send(result.map_err(|refused| refused.fault));
    }
}

#[derive(Clone)]
struct Refused {
    fault: Fault,
    is_own: bool,
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self { fault: fault(&error), is_own: is_own(&error) }
    }
}

impl From<Fault> for Refused {
    fn from(fault: Fault) -> Self {
        Self { fault, is_own: false }
    }
}

/// Makes all changes in one transaction. Returns the rows of each.
async fn committed(line: &Line, group: &[Change]) -> Result<Vec<Vec<Row>>, Refused> {
    let session = line.session().await?;
    match timeout(ANSWER, transaction(&session, group)).await {
        Ok(Ok(rows)) => Ok(rows),
        Ok(Err(error)) => {
            let ended = timeout(ANSWER, session.client().batch_execute("ROLLBACK")).await;
            if !matches!(ended, Ok(Ok(()))) {
                line.give_up().await;
            }
            Err(error.into())
        }
        Err(_) => {
            line.give_up().await;
            Err(late().into())
        }
    }
}

async fn transaction(session: &Session, group: &[Change]) -> Result<Vec<Vec<Row>>, Error> {
    session.client().batch_execute(BEGIN).await?;
    // All statements are sent before the first answer is waited for. Their order is free: who asked for one has not had an answer
    // to another yet.
    let rows = try_join_all(group.iter().map(|change| async {
        let values: Vec<&(dyn ToSql + Sync)> = change.values.iter().map(|value| &**value as _).collect();
        session.rows(change.sql, &values).await
    }));
    let rows = rows.await?;
    session.client().batch_execute(COMMIT).await?;
    Ok(rows)
}

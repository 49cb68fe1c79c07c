//! The thread that writes: group commit.

use super::super::fault::Fault;
use super::super::group::GROUP;
use rusqlite::Connection;
use tokio::sync::{mpsc, oneshot};

/// A piece of work for the writing thread.
pub enum Job {
    /// A change, made in one transaction with others.
    Change(Box<dyn Pending>),
    /// Work outside of a transaction.
    Alone(Box<dyn Pending>),
}

/// Work whose answer waits for the commit.
pub trait Pending: Send {
    /// Does the work. Returns false if it failed.
    fn run(&mut self, connection: &Connection) -> bool;
    /// Answers, with this fault instead of the result if the transaction failed.
    fn answer(self: Box<Self>, fault: Option<Fault>);
}

/// Work with its result, and the place for its answer.
pub struct Task<T, W> {
    work: Option<W>,
    result: Option<Result<T, Fault>>,
    reply: oneshot::Sender<Result<T, Fault>>,
}

impl<T: Send + 'static, W: FnOnce(&Connection) -> Result<T, Fault> + Send + 'static> Task<T, W> {
    pub fn boxed(work: W, reply: oneshot::Sender<Result<T, Fault>>) -> Box<dyn Pending> {
        Box::new(Self { work: Some(work), result: None, reply })
    }
}

impl<T: Send + 'static, W: FnOnce(&Connection) -> Result<T, Fault> + Send + 'static> Pending for Task<T, W> {
    fn run(&mut self, connection: &Connection) -> bool {
        self.result = self.work.take().map(|work| work(connection));
        matches!(self.result, Some(Ok(_)))
    }

    fn answer(self: Box<Self>, fault: Option<Fault>) {
        let result = match (self.result, fault) {
            // The reason of the work itself says more than that of the transaction.
            (Some(Err(own)), _) => Err(own),
            (_, Some(fault)) => Err(fault),
            (Some(result), None) => result,
            (None, None) => Err(Fault::Ending),
        };
        // Who asked may have gone; the change is stored nevertheless.
        let _ = self.reply.send(result);
    }
}

/// Works until the last sender is gone.
pub fn write(connection: Connection, mut jobs: mpsc::Receiver<Job>) {
    let mut next = None;
    loop {
        let Some(job) = next.take().or_else(|| jobs.blocking_recv()) else { return };
        match job {
            Job::Alone(mut task) => {
                task.run(&connection);
                task.answer(None);
            }
            Job::Change(first) => {
                let mut group = vec![first];
                while group.len() < GROUP {
                    match jobs.try_recv() {
                        Ok(Job::Change(task)) => group.push(task),
                        Ok(alone) => {
                            next = Some(alone);
                            break;
                        }
                        Err(_) => break,
                    }
                }
                let fault = commit(&connection, &mut group).err().map(|error| error.to_string());
                for task in group {
                    task.answer(fault.clone().map(Fault::Unwritable));
                }
            }
        }
    }
}

/// Makes all changes in one transaction; one that fails is taken back alone.
fn commit(connection: &Connection, group: &mut [Box<dyn Pending>]) -> Result<(), rusqlite::Error> {
    connection.execute_batch("BEGIN IMMEDIATE")?;
    let result = group.iter_mut().try_for_each(|task| {
        connection.prepare_cached("SAVEPOINT one")?.execute([])?;
        if !task.run(connection) {
            // A full disk may have ended the whole transaction; then this fails.
            connection.prepare_cached("ROLLBACK TO one")?.execute([])?;
        }
        connection.prepare_cached("RELEASE one")?.execute([])?;
        Ok(())
    });
    match result.and_then(|()| connection.execute_batch("COMMIT")) {
        Ok(()) => Ok(()),
        Err(error) => {
            if !connection.is_autocommit() {
                let _ = connection.execute_batch("ROLLBACK");
            }
            Err(error)
        }
    }
}

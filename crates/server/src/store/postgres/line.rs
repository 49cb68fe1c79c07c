//! Connections that are made again when they are lost.

use super::super::fault::Fault;
use super::tls::encryption;
use futures_util::future::poll_fn;
use std::collections::HashMap;
use std::error::Error as _;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::runtime::Handle;
use tokio::sync::Notify;
use tokio::time::timeout;
use tokio_postgres::types::ToSql;
use tokio_postgres::{
    AsyncMessage, Client, Config, Connection, Error, NoTls, Row, SimpleQueryMessage, Socket, Statement,
};

/// Name of the schema, and of the channel on which servers tell each other of changes.
pub const NAME: &str = "meniscus";

/// Maximum time for an answer of the database.
pub const ANSWER: Duration = Duration::from_secs(30);

/// Time after a failure for which no further connection is tried.
const PAUSE: Duration = Duration::from_millis(300);

/// Settings of each connection. An answer is given when its bytes are on disk. A server that is lost within a transaction does
/// not keep the others waiting. Plans must not depend on the size that the tables had when a statement was prepared: each
/// statement finds its rows by an index.
const SETTINGS: &str = "-c search_path=meniscus -c synchronous_commit=on -c default_transaction_isolation=read\\ committed \
    -c idle_in_transaction_session_timeout=10s -c enable_seqscan=off -c enable_hashjoin=off -c enable_mergejoin=off -c jit=off";

/// The settings of all connections of a store.
pub fn configured(config: &Config) -> Config {
    let mut config = config.clone();
    let options = format!("{} {SETTINGS}", config.get_options().unwrap_or_default());
    config.options(options.trim()).application_name(NAME).connect_timeout(Duration::from_secs(5));
    // The loss of the database's computer is noticed soon.
    config.keepalives_idle(Duration::from_secs(10)).keepalives_interval(Duration::from_secs(5)).keepalives_retries(3);
    config
}

/// A connection with its prepared statements.
pub struct Session {
    client: Client,
    statements: Mutex<HashMap<&'static str, Statement>>,
}

impl Session {
    pub fn client(&self) -> &Client {
        &self.client
    }

    /// Prepares a statement unless it is prepared already.
    pub async fn statement(&self, sql: &'static str) -> Result<Statement, Error> {
        let known = self.statements.lock().unwrap_or_else(PoisonError::into_inner).get(sql).cloned();
        if let Some(statement) = known {
            return Ok(statement);
        }
        let statement = self.client.prepare(sql).await?;
        self.statements.lock().unwrap_or_else(PoisonError::into_inner).insert(sql, statement.clone());
        Ok(statement)
    }

    pub async fn rows(&self, sql: &'static str, values: &[&(dyn ToSql + Sync)]) -> Result<Vec<Row>, Error> {
        self.client.query(&self.statement(sql).await?, values).await
    }

    /// The first column of the first row, of a statement without parameters.
    pub async fn text(&self, sql: &str) -> Result<Option<String>, Fault> {
        let messages = self.client.simple_query(sql).await.map_err(|error| fault(&error))?;
        let row = messages.iter().find_map(|message| match message {
            SimpleQueryMessage::Row(row) => row.get(0).map(str::to_owned),
            _ => None,
        });
        Ok(row)
    }
}

/// One connection at a time, made when it is needed.
pub struct Line {
    config: Config,
    /// Where connections live: a request may come from another runtime, which ends before the server.
    runtime: Handle,
    /// Told of changes by other servers, and of the loss of the connection.
    told: Option<Arc<Notify>>,
    state: tokio::sync::Mutex<State>,
}

#[derive(Default)]
struct State {
    session: Option<Arc<Session>>,
    failed: Option<(Instant, Fault)>,
}

impl fmt::Debug for Line {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Line").finish_non_exhaustive()
    }
}

impl Line {
    /// A line that is not connected yet. `told`: listens for changes.
    pub fn new(config: &Config, told: Option<Arc<Notify>>) -> Self {
        Self { config: config.clone(), runtime: Handle::current(), told, state: tokio::sync::Mutex::default() }
    }

    /// The connection.
    pub async fn session(&self) -> Result<Arc<Session>, Fault> {
        let mut state = self.state.lock().await;
        if let Some(session) = state.session.as_ref().filter(|session| !session.client.is_closed()) {
            return Ok(session.clone());
        }
        if let Some((_, fault)) = state.failed.as_ref().filter(|(at, _)| at.elapsed() < PAUSE) {
            return Err(fault.clone());
        }
        let connecting = connect(self.config.clone(), self.told.clone());
        let made = timeout(ANSWER, self.runtime.spawn(connecting)).await;
        let made = match made {
            Ok(Ok(made)) => made,
            Ok(Err(_)) => Err(Fault::Ending),
            Err(_) => Err(late()),
        };
        let made = made.map(Arc::new);
        state.failed = made.as_ref().err().map(|fault| (Instant::now(), fault.clone()));
        state.session = made.as_ref().ok().cloned();
        made
    }

    /// Gives up a connection that does not answer.
    pub async fn give_up(&self) {
        self.state.lock().await.session = None;
    }

    /// Rows of a query.
    pub async fn rows(&self, sql: &'static str, values: &[&(dyn ToSql + Sync)]) -> Result<Vec<Row>, Fault> {
        let session = self.session().await?;
        match timeout(ANSWER, session.rows(sql, values)).await {
            Ok(rows) => rows.map_err(|error| fault(&error)),
            Err(_) => {
                self.give_up().await;
                Err(late())
            }
        }
    }
}

/// The database has not answered in time.
pub fn late() -> Fault {
    Fault::Away(std::io::Error::from(std::io::ErrorKind::TimedOut).to_string())
}

async fn connect(config: Config, told: Option<Arc<Notify>>) -> Result<Session, Fault> {
    let fails = |error: Error| fault(&error);
    let encryption = encryption(&config).map_err(|error| Fault::Away(error.to_string()))?;
    let client = match encryption {
        None => {
            let (client, connection) = config.connect(NoTls).await.map_err(fails)?;
            tokio::spawn(drive(connection, told.clone()));
            client
        }
        Some(encryption) => {
            let (client, connection) = config.connect(encryption).await.map_err(fails)?;
            tokio::spawn(drive(connection, told.clone()));
            client
        }
    };
    if let Some(told) = told {
        client.batch_execute("LISTEN meniscus").await.map_err(fails)?;
        // What was said before is not heard.
        told.notify_one();
    }
    Ok(Session { client, statements: Mutex::default() })
}

/// Works on a connection until it is lost.
async fn drive<S>(mut connection: Connection<Socket, S>, told: Option<Arc<Notify>>)
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    while let Some(Ok(message)) = poll_fn(|context| connection.poll_message(context)).await {
        if let (AsyncMessage::Notification(_), Some(told)) = (message, &told) {
            told.notify_one();
        }
    }
    drop(connection);
    if let Some(told) = told {
        told.notify_one();
    }
}

/// Reason of an error. Texts of the database never contain a password.
pub fn fault(error: &Error) -> Fault {
    let Some(reason) = error.as_db_error() else {
        let source = error.source().map(|source| format!(": {source}")).unwrap_or_default();
        return Fault::Away(format!("{error}{source}"));
    };
    let text = reason.message().to_owned();
    match reason.code().code() {
        // Connection, authorisation, no such database, too many connections, lost transactions, shutdown and start.
        code if ["08", "28", "3D", "25", "53300", "57"].iter().any(|class| code.starts_with(class)) => {
            Fault::Away(text)
        }
        "3F000" | "42P01" => Fault::NoStore(text),
        _ => Fault::Unwritable(text),
    }
}

/// True if another statement or other values would not fail: this one is to blame, and not the database.
pub fn is_own(error: &Error) -> bool {
    error.code().is_some_and(|code| ["22", "23"].iter().any(|class| code.code().starts_with(class)))
}

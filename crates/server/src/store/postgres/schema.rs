//! Tables of the store, in a schema of their own.

use super::super::fault::Fault;
use super::line::{NAME, Session, fault};

/// Version of the tables, in `store`.
const VERSION: i64 = 1;

/// The tables of a SQLite file (`sqlite/schema.rs`) with the same columns, and three more: `store` has the version, `link` the
/// hashes of the teachers' one-time links, and `change` names each class (seat 0) or seat of which something other than events has
/// changed, so that other servers read it again.
const TABLES: &str = "
CREATE SCHEMA meniscus;
CREATE TABLE store(version BIGINT NOT NULL);
CREATE TABLE class(class TEXT PRIMARY KEY, code TEXT NOT NULL, title TEXT NOT NULL, survey TEXT NOT NULL,
  created BIGINT NOT NULL, expires BIGINT NOT NULL);
CREATE TABLE seat(class TEXT NOT NULL, seat BIGINT NOT NULL, pseudonym TEXT NOT NULL, key BYTEA NOT NULL,
  approved BIGINT NOT NULL, PRIMARY KEY(class, seat));
CREATE TABLE token(hash BYTEA PRIMARY KEY, class TEXT NOT NULL, seat BIGINT NOT NULL);
CREATE INDEX token_seat ON token(class, seat);
CREATE TABLE event(number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY, class TEXT NOT NULL, seat BIGINT NOT NULL,
  seq BIGINT NOT NULL, at BIGINT NOT NULL, kind TEXT NOT NULL, body TEXT NOT NULL, UNIQUE(class, seat, seq));
CREATE TABLE sheet(class TEXT NOT NULL, id BYTEA NOT NULL, body TEXT NOT NULL, PRIMARY KEY(class, id));
CREATE TABLE erased(class TEXT NOT NULL, seat BIGINT NOT NULL, PRIMARY KEY(class, seat));
CREATE TABLE link(hash BYTEA PRIMARY KEY, class TEXT NOT NULL, made TIMESTAMPTZ NOT NULL DEFAULT now());
CREATE TABLE change(number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY, class TEXT NOT NULL, seat BIGINT NOT NULL);
";

/// Begins a transaction that changes the store. One transaction at a time does, of all servers: numbers are in the order in which
/// transactions become visible, so that nobody who has read up to a number misses a lower one. The key is \"Mcls\".
pub const BEGIN: &str = "BEGIN; SELECT pg_advisory_xact_lock(1298361459)";

/// Makes the tables if there are none and `makes`, and checks them otherwise.
pub async fn prepare(session: &Session, makes: bool) -> Result<(), Fault> {
    let encoding = session.text("SHOW server_encoding").await?;
    if encoding.as_deref() != Some("UTF8") {
        return Err(Fault::NoStore(format!("server_encoding {}", encoding.unwrap_or_default())));
    }
    // The lock is held for two servers that start at the same time.
    session.client().batch_execute(BEGIN).await.map_err(|error| fault(&error))?;
    let result = within(session, makes).await;
    let end = if result.is_ok() { "COMMIT" } else { "ROLLBACK" };
    session.client().batch_execute(end).await.map_err(|error| fault(&error))?;
    result
}

async fn within(session: &Session, makes: bool) -> Result<(), Fault> {
    let is_there = session.text("SELECT to_regclass('meniscus.store')::text").await?.is_some();
    if !is_there && !makes {
        return Err(Fault::NoStore(format!("schema {NAME}")));
    }
    if !is_there {
        let tables = format!("{TABLES}INSERT INTO store VALUES({VERSION})");
        session.client().batch_execute(&tables).await.map_err(|error| fault(&error))?;
    }
    match session.text("SELECT version::text FROM store").await? {
        Some(version) if version == VERSION.to_string() => Ok(()),
        version => Err(Fault::NoStore(format!("version {}", version.unwrap_or_default()))),
    }
}

//! Backups of a database as SQLite files, and restoring from them.

use super::super::fault::Fault;
use super::super::rows::signed;
use super::super::sqlite;
use super::super::taking::{over, taking, taking_erased};
use super::line::{Line, NAME, configured, fault};
use super::schema::{self, BEGIN};
use super::write::ERASE_CLASS;
use futures_util::TryStreamExt;
use futures_util::pin_mut;
use rusqlite::types::{Value, ValueRef};
use std::path::Path;
use tokio_postgres::binary_copy::BinaryCopyInWriter;
use tokio_postgres::types::{ToSql, Type};
use tokio_postgres::{Client, Config};

/// Tables of a backup with the types of their columns, which are the same in both databases.
const TABLES: [(&str, &[Type]); 6] = [
    ("class", &[Type::TEXT, Type::TEXT, Type::TEXT, Type::TEXT, Type::INT8, Type::INT8]),
    ("seat", &[Type::TEXT, Type::INT8, Type::TEXT, Type::BYTEA, Type::INT8]),
    ("token", &[Type::BYTEA, Type::TEXT, Type::INT8]),
    ("event", &[Type::INT8, Type::TEXT, Type::INT8, Type::INT8, Type::INT8, Type::TEXT, Type::TEXT]),
    ("sheet", &[Type::TEXT, Type::BYTEA, Type::TEXT]),
    ("erased", &[Type::TEXT, Type::INT8]),
];

/// Copies all rows, as of one moment, into a new file. Nothing stays of a file that did not become whole.
pub async fn back_up(config: &Config, to: &Path) -> Result<(), Fault> {
    let result = copy_out(config, to).await;
    if result.is_err() {
        let _ = std::fs::remove_file(to);
    }
    result
}

async fn copy_out(config: &Config, to: &Path) -> Result<(), Fault> {
    let session = Line::new(&configured(config), None).session().await?;
    schema::prepare(&session, false).await?;
    let client = session.client();
    let fails = |error: tokio_postgres::Error| fault(&error);
    client.batch_execute("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY").await.map_err(fails)?;
    let file = sqlite::backup::new(to)?;
    let transaction = file.unchecked_transaction()?;
    for (table, types) in TABLES {
        let places = vec!["?"; types.len()].join(",");
        let mut insert = transaction.prepare(&format!("INSERT INTO {table} VALUES({places})"))?;
        let rows = client.query_raw(&format!("SELECT * FROM {table}"), std::iter::empty::<&str>()).await;
        let rows = rows.map_err(fails)?;
        pin_mut!(rows);
        while let Some(row) = rows.try_next().await.map_err(fails)? {
            let values: Result<Vec<Value>, _> = types
                .iter()
                .enumerate()
                .map(|(column, kind)| match *kind {
                    Type::INT8 => row.try_get(column).map(Value::Integer),
                    Type::BYTEA => row.try_get(column).map(Value::Blob),
                    _ => row.try_get(column).map(Value::Text),
                })
                .collect();
            insert.execute(rusqlite::params_from_iter(values.map_err(fails)?))?;
        }
    }
    transaction.commit()?;
    Ok(())
}

/// Takes classes from a backup into the database. Returns the number of events that came back.
pub async fn restore(from: &Path, config: &Config, now: u64) -> Result<u64, Fault> {
    let backup = sqlite::backup::existing(from)?;
    let session = Line::new(&configured(config), None).session().await?;
    schema::prepare(&session, true).await?;
    let client = session.client();
    let fails = |error: tokio_postgres::Error| fault(&error);
    client.batch_execute("SET idle_in_transaction_session_timeout = 0").await.map_err(fails)?;
    client.batch_execute(BEGIN).await.map_err(fails)?;
    for (table, types) in TABLES {
        copy(&backup, client, table, types).await?;
    }
    client.batch_execute(&taking_erased("pg_temp", NAME)).await.map_err(fails)?;
    let mut events = 0;
    for statement in taking("pg_temp", NAME) {
        events = client.execute(&statement, &[&signed(now)]).await.map_err(fails)?;
    }
    // Servers that run read all of it.
    let changed = "INSERT INTO meniscus.change(class, seat)
        SELECT class, 0 FROM pg_temp.class UNION SELECT class, seat FROM pg_temp.seat UNION SELECT class, seat FROM pg_temp.erased";
    client.batch_execute(changed).await.map_err(fails)?;
    client
        .batch_execute(
            "DROP TABLE pg_temp.class, pg_temp.seat, pg_temp.token, pg_temp.event, pg_temp.sheet, pg_temp.erased",
        )
        .await
        .map_err(fails)?;
    for class in client.query(&over(NAME), &[&signed(now)]).await.map_err(fails)? {
        let class: String = class.try_get(0).map_err(fails)?;
        client.execute(ERASE_CLASS, &[&class]).await.map_err(fails)?;
    }
    client.batch_execute("SELECT pg_notify('meniscus', ''); COMMIT").await.map_err(fails)?;
    Ok(events)
}

/// Copies a table of a backup into a temporary one.
async fn copy(backup: &rusqlite::Connection, client: &Client, table: &str, types: &[Type]) -> Result<(), Fault> {
    let fails = |error: tokio_postgres::Error| fault(&error);
    let make = format!("CREATE TEMPORARY TABLE {table} AS SELECT * FROM meniscus.{table} WHERE false");
    client.batch_execute(&make).await.map_err(fails)?;
    let sink = client.copy_in(&format!("COPY pg_temp.{table} FROM STDIN BINARY")).await.map_err(fails)?;
    let writer = BinaryCopyInWriter::new(sink, types);
    pin_mut!(writer);
    let mut query = backup.prepare(&format!("SELECT * FROM {table}"))?;
    let mut rows = query.query([])?;
    while let Some(row) = rows.next()? {
        let values: Result<Vec<Box<dyn ToSql + Sync + Send>>, rusqlite::Error> = (0..types.len())
            .map(|column| -> Result<Box<dyn ToSql + Sync + Send>, rusqlite::Error> {
                Ok(match row.get_ref(column)? {
                    ValueRef::Integer(number) => Box::new(number),
                    ValueRef::Blob(bytes) => Box::new(bytes.to_vec()),
                    _ => Box::new(row.get::<_, String>(column)?),
                })
            })
            .collect();
        let values = values?;
        let values: Vec<&(dyn ToSql + Sync)> = values.iter().map(|value| &**value as _).collect();
        writer.as_mut().write(&values).await.map_err(fails)?;
    }
    writer.finish().await.map_err(fails)?;
    Ok(())
}

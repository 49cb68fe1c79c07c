//! Reading and writing of rows.

use super::super::fault::Fault;
use super::super::rows::{
    ClassRow, Cursor, EventRow, MOST_SHEETS, NewEvent, NewSeat, News, Outcome, SIZES, SeatRow, signed,
};
use super::Sqlite;
use crate::codes::Hash;
use rusqlite::{Connection, OptionalExtension, Row, params};

impl EventRow {
    fn of(row: &Row<'_>) -> rusqlite::Result<Self> {
        Ok(Self {
            number: unsigned(row, 0)?,
            seat: row.get(1)?,
            seq: unsigned(row, 2)?,
            at: unsigned(row, 3)?,
            kind: row.get(4)?,
            body: row.get(5)?,
        })
    }
}

/// A number that the tables hold as a signed one.
fn unsigned(row: &Row<'_>, column: usize) -> rusqlite::Result<u64> {
    Ok(u64::try_from(row.get::<_, i64>(column)?).unwrap_or(0))
}

impl Sqlite {
    pub async fn add_class(&self, class: ClassRow, is_first: bool) -> Result<(), Fault> {
        self.change(move |connection| {
            connection.execute(
                "INSERT INTO class SELECT ?1,?2,?3,?4,?5,?6 WHERE NOT (?7 AND EXISTS (SELECT 1 FROM class))",
                params![
                    class.class,
                    class.code,
                    class.title,
                    class.survey,
                    signed(class.created),
                    signed(class.expires),
                    is_first
                ],
            )?;
            Ok(())
        })
        .await
    }

    pub async fn add_seat(&self, class: String, seat: NewSeat, token: Hash, most: u32) -> Result<SeatRow, Fault> {
        self.change(move |connection| {
            exists(connection, &class, 0)?;
            let number = last_seat(connection, &class)? + 1;
            if number > most {
                return Err(Fault::SeatFull);
            }
            let NewSeat { pseudonym, key, approved } = seat;
            let pseudonym = pseudonym.replace(NewSeat::NUMBER, &number.to_string());
            let mut insert = connection.prepare_cached("INSERT INTO seat VALUES(?,?,?,?,?)")?;
            insert.execute(params![class, number, pseudonym, key, approved])?;
            add_token(connection, &class, number, &token)?;
            Ok(SeatRow { seat: number, pseudonym, key, approved })
        })
        .await
    }

    pub async fn add_token(&self, class: String, seat: u32, token: Hash) -> Result<(), Fault> {
        self.change(move |connection| add_token(connection, &class, seat, &token)).await
    }

    pub async fn add_link(&self, class: String, link: Hash) -> Result<(), Fault> {
        self.links.lock().map_err(|_| Fault::Ending)?.insert(link, class);
        Ok(())
    }

    pub async fn exchange(&self, link: Hash, token: Hash) -> Result<Option<String>, Fault> {
        let Some(class) = self.links.lock().map_err(|_| Fault::Ending)?.remove(&link) else { return Ok(None) };
        match self.add_token(class.clone(), 0, token).await {
            Ok(()) => Ok(Some(class)),
            // The class was erased meanwhile.
            Err(Fault::Missing) => Ok(None),
            Err(fault) => {
                self.add_link(class, link).await?;
                Err(fault)
            }
        }
    }

    pub async fn set_code(&self, class: String, code: String) -> Result<(), Fault> {
        self.change(move |connection| {
            connection.execute("UPDATE class SET code=? WHERE class=?", params![code, class])?;
            Ok(())
        })
        .await
    }

    pub async fn revoke_teachers(&self, class: String, but: Hash) -> Result<(), Fault> {
        self.links.lock().map_err(|_| Fault::Ending)?.retain(|_, of| *of != class);
        self.change(move |connection| {
            connection
                .execute("DELETE FROM token WHERE class=? AND seat=0 AND hash<>?", params![class, but.as_slice()])?;
            Ok(())
        })
        .await
    }

    /// Erased seats of all classes; seat 0 is the class itself.
    pub async fn erased(&self) -> Result<Vec<(String, u32)>, Fault> {
        self.read(|connection| {
            let mut query = connection.prepare("SELECT class, seat FROM erased")?;
            let rows = query.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    /// Place in what any process has erased: the number of erased seats and classes, which only grows.
    pub async fn cursor(&self) -> Result<Cursor, Fault> {
        self.read(|connection| {
            let mut query = connection.prepare_cached("SELECT count(*) FROM erased")?;
            Ok(Cursor { change: query.query_row([], |row| unsigned(row, 0))?, ..Cursor::default() })
        })
        .await
    }

    /// Everything that was ever erased, if anything was after this place. One server writes the file: nothing else is news.
    pub async fn news(&self, since: Cursor) -> Result<News, Fault> {
        let cursor = self.cursor().await?;
        let erased = if cursor == since { Vec::new() } else { self.erased().await? };
        Ok(News { cursor, erased, ..News::default() })
    }

    pub async fn approve(&self, class: String, seat: u32) -> Result<(), Fault> {
        self.change(move |connection| {
            connection.execute("UPDATE seat SET approved=1 WHERE class=? AND seat=?", params![class, seat])?;
            Ok(())
        })
        .await
    }

    pub async fn append(&self, class: String, seat: u32, at: u64, events: Vec<NewEvent>) -> Result<Outcome, Fault> {
        self.change(move |connection| append(connection, &class, seat, at, &events)).await
    }

    pub async fn append_of_teacher(
        &self,
        class: String,
        at: u64,
        kind: &'static str,
        body: String,
    ) -> Result<u64, Fault> {
        self.change(move |connection| {
            let event = NewEvent { seq: highest(connection, &class, 0)? + 1, kind, body };
            Ok(append(connection, &class, 0, at, &[event])?.number)
        })
        .await
    }

    pub async fn add_sheet(&self, class: String, id: [u8; 16], body: String) -> Result<bool, Fault> {
        self.change(move |connection| {
            exists(connection, &class, 0)?;
            let full = "SELECT count(*) >= ?3 AND NOT EXISTS(SELECT 1 FROM sheet WHERE class=?1 AND id=?2) FROM sheet WHERE class=?1";
            if connection.query_row(full, params![class, id, MOST_SHEETS], |row| row.get(0))? {
                return Err(Fault::SheetsFull);
            }
            Ok(connection.execute("INSERT OR IGNORE INTO sheet VALUES(?,?,?)", params![class, id, body])? > 0)
        })
        .await
    }

    pub async fn classes(&self) -> Result<Vec<ClassRow>, Fault> {
        self.read(|connection| {
            let mut query = connection.prepare("SELECT * FROM class ORDER BY created DESC, class")?;
            let rows = query.query_map([], |row| {
                Ok(ClassRow {
                    class: row.get(0)?,
                    code: row.get(1)?,
                    title: row.get(2)?,
                    survey: row.get(3)?,
                    created: unsigned(row, 4)?,
                    expires: unsigned(row, 5)?,
                })
            })?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn seats(&self, class: String) -> Result<Vec<SeatRow>, Fault> {
        self.read(move |connection| {
            let mut query =
                connection.prepare("SELECT seat, pseudonym, key, approved FROM seat WHERE class=? ORDER BY seat")?;
            let rows = query.query_map([class], |row| {
                Ok(SeatRow { seat: row.get(0)?, pseudonym: row.get(1)?, key: row.get(2)?, approved: row.get(3)? })
            })?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn sizes(&self, class: String) -> Result<Vec<(u32, u64)>, Fault> {
        self.read(move |connection| {
            let mut query = connection.prepare(SIZES)?;
            let rows = query.query_map([class], |row| Ok((row.get(0)?, unsigned(row, 1)?)))?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn tokens(&self, class: String) -> Result<Vec<(Hash, u32)>, Fault> {
        self.read(move |connection| {
            let mut query = connection.prepare("SELECT hash, seat FROM token WHERE class=?")?;
            let rows = query.query_map([class], |row| Ok((row.get(0)?, row.get(1)?)))?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn events(&self, class: String, since: u64, most: u32) -> Result<Vec<EventRow>, Fault> {
        self.read(move |connection| {
            let mut query = connection.prepare_cached(
                "SELECT number, seat, seq, at, kind, body FROM event WHERE number>? AND class=? ORDER BY number LIMIT ?",
            )?;
            let rows = query.query_map(params![signed(since), class, most], EventRow::of)?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn events_of_seat(&self, class: String, seat: u32) -> Result<Vec<EventRow>, Fault> {
        self.read(move |connection| {
            let mut query = connection.prepare_cached(
                "SELECT number, seat, seq, at, kind, body FROM event WHERE class=? AND seat=? ORDER BY seq",
            )?;
            let rows = query.query_map(params![class, seat], EventRow::of)?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }

    pub async fn last_number(&self) -> Result<u64, Fault> {
        self.read(last_number).await
    }

    pub async fn latest_of_teacher(&self, class: String, kind: &'static str) -> Result<Option<EventRow>, Fault> {
        self.read(move |connection| {
            let query = "SELECT number, seat, seq, at, kind, body FROM event WHERE class=? AND seat=0 AND kind=? ORDER BY seq DESC LIMIT 1";
            Ok(connection.query_row(query, params![class, kind], EventRow::of).optional()?)
        })
        .await
    }

    pub async fn sheets(&self, class: String) -> Result<Vec<String>, Fault> {
        self.read(move |connection| {
            let mut query = connection.prepare("SELECT body FROM sheet WHERE class=? ORDER BY id")?;
            let rows = query.query_map([class], |row| row.get(0))?;
            Ok(rows.collect::<Result<_, _>>()?)
        })
        .await
    }
}

/// Highest number of a seat that the class has ever had, erased ones included.
fn last_seat(connection: &Connection, class: &str) -> Result<u32, Fault> {
    let query = "SELECT max((SELECT coalesce(max(seat), 0) FROM seat WHERE class=?1), (SELECT coalesce(max(seat), 0) FROM erased WHERE class=?1))";
    Ok(connection.prepare_cached(query)?.query_row([class], |row| row.get(0))?)
}

/// Fails with [`Fault::Missing`] if there is no such seat, or for seat 0 no such class: another process may have erased it.
fn exists(connection: &Connection, class: &str, seat: u32) -> Result<(), Fault> {
    let query =
        "SELECT 1 FROM class WHERE class=?1 AND (?2=0 OR EXISTS(SELECT 1 FROM seat WHERE class=?1 AND seat=?2))";
    Ok(connection.prepare_cached(query)?.query_row(params![class, seat], |_| Ok(()))?)
}

fn add_token(connection: &Connection, class: &str, seat: u32, token: &Hash) -> Result<(), Fault> {
    exists(connection, class, seat)?;
    connection.prepare_cached("INSERT INTO token VALUES(?,?,?)")?.execute(params![token, class, seat])?;
    Ok(())
}

fn highest(connection: &Connection, class: &str, seat: u32) -> Result<u64, Fault> {
    let mut query = connection.prepare_cached("SELECT max(seq) FROM event WHERE class=? AND seat=?")?;
    let highest: Option<i64> = query.query_row(params![class, seat], |row| row.get(0))?;
    Ok(highest.and_then(|highest| u64::try_from(highest).ok()).unwrap_or(0))
}

fn last_number(connection: &Connection) -> Result<u64, Fault> {
    let mut query = connection.prepare_cached("SELECT max(number) FROM event")?;
    let last: Option<i64> = query.query_row([], |row| row.get(0))?;
    Ok(last.and_then(|last| u64::try_from(last).ok()).unwrap_or(0))
}

fn append(connection: &Connection, class: &str, seat: u32, at: u64, events: &[NewEvent]) -> Result<Outcome, Fault> {
    exists(connection, class, seat)?;
    let mut insert = connection
        .prepare_cached("INSERT OR IGNORE INTO event(class, seat, seq, at, kind, body) VALUES(?,?,?,?,?,?)")?;
    let mut same =
        connection.prepare_cached("SELECT kind=? AND body=? FROM event WHERE class=? AND seat=? AND seq=?")?;
    let mut added = 0;
    for event in events {
        let seq = signed(event.seq);
        if insert.execute(params![class, seat, seq, signed(at), event.kind, event.body])? == 1 {
            added += 1;
        } else if !same.query_row(params![event.kind, event.body, class, seat, seq], |row| row.get::<_, bool>(0))? {
            return Err(Fault::Taken(highest(connection, class, seat)?));
        }
    }
    Ok(Outcome { added, highest: highest(connection, class, seat)?, number: last_number(connection)? })
}

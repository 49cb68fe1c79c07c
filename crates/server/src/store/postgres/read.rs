//! Reading of rows.

use super::super::fault::Fault;
use super::super::rows::{ClassRow, EventRow, SIZES, SeatRow, signed};
use super::{Postgres, hash, number, value};
use crate::codes::Hash;
use tokio_postgres::Row;

fn event(row: &Row) -> Result<EventRow, Fault> {
    Ok(EventRow {
        number: number(row, 0)?,
        seat: number(row, 1)?,
        seq: number(row, 2)?,
        at: number(row, 3)?,
        kind: value(row, 4)?,
        body: value(row, 5)?,
    })
}

/// Of `class, code, title, survey, created, expires`.
pub(super) fn class(row: &Row) -> Result<ClassRow, Fault> {
    Ok(ClassRow {
        class: value(row, 0)?,
        code: value(row, 1)?,
        title: value(row, 2)?,
        survey: value(row, 3)?,
        created: number(row, 4)?,
        expires: number(row, 5)?,
    })
}

/// Of `seat, pseudonym, key, approved`.
pub(super) fn seat(row: &Row) -> Result<SeatRow, Fault> {
    let approved: i64 = value(row, 3)?;
    Ok(SeatRow { seat: number(row, 0)?, pseudonym: value(row, 1)?, key: hash(row, 2)?, approved: approved != 0 })
}

impl Postgres {
    pub async fn classes(&self) -> Result<Vec<ClassRow>, Fault> {
        let rows = self.rows("SELECT * FROM class ORDER BY created DESC, class", &[]).await?;
        rows.iter().map(class).collect()
    }

    pub async fn seats(&self, class: String) -> Result<Vec<SeatRow>, Fault> {
        let query = "SELECT seat, pseudonym, key, approved FROM seat WHERE class = $1 ORDER BY seat";
        self.rows(query, &[&class]).await?.iter().map(seat).collect()
    }

    pub async fn sizes(&self, class: String) -> Result<Vec<(u32, u64)>, Fault> {
        let rows = self.rows(SIZES, &[&class]).await?;
        rows.iter().map(|row| Ok((number(row, 0)?, number(row, 1)?))).collect()
    }

    pub async fn erased(&self) -> Result<Vec<(String, u32)>, Fault> {
        let rows = self.rows("SELECT class, seat FROM erased", &[]).await?;
        rows.iter().map(|row| Ok((value(row, 0)?, number(row, 1)?))).collect()
    }

    pub async fn tokens(&self, class: String) -> Result<Vec<(Hash, u32)>, Fault> {
        let rows = self.rows("SELECT hash, seat FROM token WHERE class = $1", &[&class]).await?;
        rows.iter().map(|row| Ok((hash(row, 0)?, number(row, 1)?))).collect()
    }

    pub async fn events(&self, class: String, since: u64, most: u32) -> Result<Vec<EventRow>, Fault> {
        let query = "SELECT number, seat, seq, at, kind, body FROM event WHERE number > $1 AND class = $2 ORDER BY number LIMIT $3";
        self.rows(query, &[&signed(since), &class, &i64::from(most)]).await?.iter().map(event).collect()
    }

    pub async fn events_of_seat(&self, class: String, seat: u32) -> Result<Vec<EventRow>, Fault> {
        let query = "SELECT number, seat, seq, at, kind, body FROM event WHERE class = $1 AND seat = $2 ORDER BY seq";
        self.rows(query, &[&class, &i64::from(seat)]).await?.iter().map(event).collect()
    }

    pub async fn last_number(&self) -> Result<u64, Fault> {
        Ok(self.cursor().await?.event)
    }

    pub async fn latest_of_teacher(&self, class: String, kind: &'static str) -> Result<Option<EventRow>, Fault> {
        let query = "SELECT number, seat, seq, at, kind, body FROM event WHERE class = $1 AND seat = 0 AND kind = $2 ORDER BY seq DESC LIMIT 1";
        self.rows(query, &[&class, &kind]).await?.first().map(event).transpose()
    }

    pub async fn sheets(&self, class: String) -> Result<Vec<String>, Fault> {
        let rows = self.rows("SELECT body FROM sheet WHERE class = $1 ORDER BY id", &[&class]).await?;
        rows.iter().map(|row| value(row, 0)).collect()
    }
}

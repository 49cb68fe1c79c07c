//! Changes of rows, each one statement that cannot fail for its own reasons: it says in its rows what it has found.

use super::super::fault::Fault;
use super::super::rows::{ClassRow, MOST_SHEETS, NewEvent, NewSeat, Outcome, SeatRow, signed};
use super::writer::Value;
use super::{Postgres, number, value};
use crate::codes::Hash;
use std::collections::BTreeMap;
use tokio_postgres::Row;
use tokio_postgres::types::ToSql;

/// A value of a statement.
fn given(value: impl ToSql + Sync + Send + 'static) -> Value {
    Box::new(value)
}

fn only(rows: Vec<Row>) -> Result<Row, Fault> {
    rows.into_iter().next().ok_or(Fault::Missing)
}

const ADD_CLASS: &str = "
WITH new AS (INSERT INTO class
    SELECT $1::text, $2::text, $3::text, $4::text, $5::bigint, $6::bigint WHERE NOT ($7 AND EXISTS (SELECT FROM class)) RETURNING class)
INSERT INTO change(class, seat) SELECT class, 0 FROM new";

const ADD_SEAT: &str = "
WITH next AS (SELECT 1 + greatest(0, (SELECT max(seat) FROM seat WHERE class = $1),
    (SELECT max(seat) FROM erased WHERE class = $1)) AS seat),
  new AS (INSERT INTO seat SELECT $1::text, seat, replace($2::text, '#', seat::text), $3::bytea, $4::bigint FROM next
    WHERE seat <= $6::bigint AND EXISTS (SELECT FROM class WHERE class = $1) RETURNING seat, pseudonym),
  added AS (INSERT INTO token SELECT $5::bytea, $1, seat FROM new),
  changed AS (INSERT INTO change(class, seat) SELECT $1, seat FROM new)
SELECT seat, pseudonym FROM new";

const ADD_TOKEN: &str = "
WITH own AS (SELECT seat FROM seat WHERE class = $2 AND seat = $3),
  added AS (INSERT INTO token SELECT $1::bytea, $2::text, seat FROM own)
INSERT INTO change(class, seat) SELECT $2, seat FROM own RETURNING seat";

const ADD_LINK: &str = "
WITH old AS (DELETE FROM link WHERE made < now() - interval '1 day')
INSERT INTO link(hash, class) VALUES($1, $2)";

const EXCHANGE: &str = "
WITH used AS (DELETE FROM link WHERE hash = $1 AND made >= now() - interval '1 day' RETURNING class),
  added AS (INSERT INTO token SELECT $2::bytea, class, 0 FROM used)
INSERT INTO change(class, seat) SELECT class, 0 FROM used RETURNING class";

const SET_CODE: &str = "
WITH own AS (UPDATE class SET code = $2 WHERE class = $1 RETURNING class)
INSERT INTO change(class, seat) SELECT class, 0 FROM own";

const REVOKE_TEACHERS: &str = "
WITH gone AS (DELETE FROM token WHERE class = $1 AND seat = 0 AND hash <> $2::bytea),
  links AS (DELETE FROM link WHERE class = $1)
INSERT INTO change(class, seat) SELECT class, 0 FROM class WHERE class = $1";

const APPROVE: &str = "
WITH own AS (UPDATE seat SET approved = 1 WHERE class = $1 AND seat = $2 RETURNING seat)
INSERT INTO change(class, seat) SELECT $1, seat FROM own";

const APPEND: &str = "
WITH new AS (SELECT * FROM unnest($4::bigint[], $5::text[], $6::text[]) WITH ORDINALITY AS new(seq, kind, body, place)),
  clash AS (SELECT FROM new JOIN event old ON old.class = $1 AND old.seat = $2 AND old.seq = new.seq
    WHERE old.kind <> new.kind OR old.body <> new.body),
  own AS (SELECT FROM seat WHERE class = $1 AND seat = $2),
  added AS (INSERT INTO event(class, seat, seq, at, kind, body)
    SELECT $1::text, $2::bigint, seq, $3::bigint, kind, body FROM new
    WHERE NOT EXISTS (SELECT FROM clash) AND EXISTS (SELECT FROM own) ORDER BY place
    ON CONFLICT DO NOTHING RETURNING number, seq)
SELECT EXISTS (SELECT FROM own), EXISTS (SELECT FROM clash), (SELECT count(*) FROM added),
  greatest(0, (SELECT max(seq) FROM event WHERE class = $1 AND seat = $2), (SELECT max(seq) FROM added)),
  greatest(0, (SELECT max(number) FROM event), (SELECT max(number) FROM added))";

const APPEND_OF_TEACHER: &str = "
INSERT INTO event(class, seat, seq, at, kind, body)
SELECT $1::text, 0, 1 + coalesce((SELECT max(seq) FROM event WHERE class = $1 AND seat = 0), 0), $2::bigint, $3::text, $4::text
WHERE EXISTS (SELECT FROM class WHERE class = $1) RETURNING number";

const ADD_SHEET: &str = "
WITH room AS (
  SELECT count(*) < $4 OR EXISTS (SELECT FROM sheet WHERE class = $1 AND id = $2) AS has FROM sheet WHERE class = $1),
  added AS (
    INSERT INTO sheet SELECT $1::text, $2::bytea, $3::text WHERE EXISTS (SELECT FROM class WHERE class = $1)
      AND (SELECT has FROM room)
    ON CONFLICT DO NOTHING RETURNING id)
SELECT has, EXISTS (SELECT FROM added) FROM room";

const ERASE_SEAT: &str = "
WITH gone AS (DELETE FROM seat WHERE class = $1 AND seat = $2 RETURNING seat),
  known AS (SELECT seat FROM gone UNION SELECT seat FROM erased WHERE class = $1 AND seat = $2 AND seat > 0),
  events AS (DELETE FROM event WHERE class = $1 AND seat IN (SELECT seat FROM known)),
  tokens AS (DELETE FROM token WHERE class = $1 AND seat IN (SELECT seat FROM known)),
  noted AS (INSERT INTO erased SELECT $1::text, seat FROM gone ON CONFLICT DO NOTHING)
INSERT INTO change(class, seat) SELECT $1, seat FROM known RETURNING seat";

/// Erases a class. Seat 0 stands for it.
pub(super) const ERASE_CLASS: &str = "
WITH noted AS (INSERT INTO erased VALUES($1, 0) ON CONFLICT DO NOTHING), events AS (DELETE FROM event WHERE class = $1), tokens AS (DELETE FROM token WHERE class = $1),
  seats AS (DELETE FROM seat WHERE class = $1), sheets AS (DELETE FROM sheet WHERE class = $1),
  links AS (DELETE FROM link WHERE class = $1), classes AS (DELETE FROM class WHERE class = $1)
INSERT INTO change(class, seat) VALUES($1, 0)";

impl Postgres {
    pub async fn add_class(&self, class: ClassRow, is_first: bool) -> Result<(), Fault> {
        let ClassRow { class, code, title, survey, created, expires } = class;
        let texts = [class, code, title, survey].into_iter().map(given);
        let times = [created, expires].into_iter().map(|time| given(signed(time)));
        let values = texts.chain(times).chain([given(is_first)]).collect();
        self.change(ADD_CLASS, values).await?;
        Ok(())
    }

    pub async fn add_seat(&self, class: String, seat: NewSeat, token: Hash, most: u32) -> Result<SeatRow, Fault> {
        let NewSeat { pseudonym, key, approved } = seat;
        let approved_number = i64::from(approved);
        let values = vec![
            given(class),
            given(pseudonym),
            given(key.to_vec()),
            given(approved_number),
            given(token.to_vec()),
            given(i64::from(most)),
        ];
        let row = self.change(ADD_SEAT, values).await?.into_iter().next().ok_or(Fault::SeatFull)?;
        Ok(SeatRow { seat: number(&row, 0)?, pseudonym: value(&row, 1)?, key, approved })
    }

    pub async fn add_token(&self, class: String, seat: u32, token: Hash) -> Result<(), Fault> {
        let values = vec![given(token.to_vec()), given(class), given(i64::from(seat))];
        only(self.change(ADD_TOKEN, values).await?).map(drop)
    }

    pub async fn add_link(&self, class: String, link: Hash) -> Result<(), Fault> {
        self.change(ADD_LINK, vec![given(link.to_vec()), given(class)]).await.map(drop)
    }

    pub async fn exchange(&self, link: Hash, token: Hash) -> Result<Option<String>, Fault> {
        let rows = self.change(EXCHANGE, vec![given(link.to_vec()), given(token.to_vec())]).await?;
        rows.first().map(|row| value(row, 0)).transpose()
    }

    pub async fn set_code(&self, class: String, code: String) -> Result<(), Fault> {
        self.change(SET_CODE, vec![given(class), given(code)]).await.map(drop)
    }

    pub async fn revoke_teachers(&self, class: String, but: Hash) -> Result<(), Fault> {
        self.change(REVOKE_TEACHERS, vec![given(class), given(but.to_vec())]).await.map(drop)
    }

    pub async fn approve(&self, class: String, seat: u32) -> Result<(), Fault> {
        self.change(APPROVE, vec![given(class), given(i64::from(seat))]).await.map(drop)
    }

    pub async fn append(&self, class: String, seat: u32, at: u64, events: Vec<NewEvent>) -> Result<Outcome, Fault> {
        // An event may be in one request twice, too.
        let mut different: BTreeMap<u64, usize> = BTreeMap::new();
        let (mut seqs, mut kinds, mut bodies) = (Vec::new(), Vec::new(), Vec::new());
        for NewEvent { seq, kind, body } in events {
            match different.get(&seq) {
                None => {
                    different.insert(seq, bodies.len());
                    seqs.push(signed(seq));
                    kinds.push(kind);
                    bodies.push(body);
                }
                Some(&place) if kinds[place] == kind && bodies[place] == body => {}
                Some(_) => return Err(Fault::Taken(seq)),
            }
        }
        let values =
            vec![given(class), given(i64::from(seat)), given(signed(at)), given(seqs), given(kinds), given(bodies)];
        let row = only(self.change(APPEND, values).await?)?;
        let highest = number(&row, 3)?;
        match (value(&row, 0)?, value(&row, 1)?) {
            (false, _) => Err(Fault::Missing),
            (true, true) => Err(Fault::Taken(highest)),
            (true, false) => Ok(Outcome { added: number(&row, 2)?, highest, number: number(&row, 4)? }),
        }
    }

    pub async fn append_of_teacher(
        &self,
        class: String,
        at: u64,
        kind: &'static str,
        body: String,
    ) -> Result<u64, Fault> {
        let values = vec![given(class), given(signed(at)), given(kind), given(body)];
        number(&only(self.change(APPEND_OF_TEACHER, values).await?)?, 0)
    }

    pub async fn add_sheet(&self, class: String, id: [u8; 16], body: String) -> Result<bool, Fault> {
        let values = vec![given(class), given(id.to_vec()), given(body), given(MOST_SHEETS)];
        let row = only(self.change(ADD_SHEET, values).await?)?;
        if value(&row, 0)? { value(&row, 1) } else { Err(Fault::SheetsFull) }
    }

    pub async fn erase_seats(&self, class: String, seats: Vec<u32>) -> Result<(), Fault> {
        for seat in seats {
            only(self.change(ERASE_SEAT, vec![given(class.clone()), given(i64::from(seat))]).await?)?;
        }
        self.vacuum().await
    }

    pub async fn erase_class(&self, class: String) -> Result<(), Fault> {
        self.change(ERASE_CLASS, vec![given(class)]).await?;
        self.vacuum().await
    }
}

//! Changes by other servers.

use super::super::fault::Fault;
use super::super::rows::{Cursor, News, signed};
use super::{Postgres, hash, number, read, value};
use std::collections::BTreeSet;

/// Latest numbers.
const CURSOR: &str =
    "SELECT coalesce((SELECT max(number) FROM event), 0), coalesce((SELECT max(number) FROM change), 0)";

/// Classes with events after a number, then what was changed after another number, as of one moment.
const HEADS: &str = "
SELECT true, class, max(number), min(seat) FROM event WHERE number > $1 GROUP BY class
UNION ALL SELECT false, class, max(number), seat FROM change WHERE number > $2 GROUP BY class, seat";

const CLASSES: &str = "SELECT * FROM class WHERE class = ANY($1)";

/// Seats and tokens of what was changed.
const SEATS: &str = "
SELECT seat, pseudonym, key, approved, class FROM seat
WHERE (class, seat) IN (SELECT * FROM unnest($1::text[], $2::bigint[]))";
const TOKENS: &str = "
SELECT hash, class, seat FROM token WHERE (class, seat) IN (SELECT * FROM unnest($1::text[], $2::bigint[]))";

impl Postgres {
    pub async fn cursor(&self) -> Result<Cursor, Fault> {
        let rows = self.rows(CURSOR, &[]).await?;
        let row = rows.first().ok_or(Fault::Missing)?;
        Ok(Cursor { event: number(row, 0)?, change: number(row, 1)? })
    }

    /// Everything that any server has changed after this place, until the call.
    pub async fn news(&self, since: Cursor) -> Result<News, Fault> {
        let line = &self.0.listener;
        let heads = line.rows(HEADS, &[&signed(since.event), &signed(since.change)]).await?;
        let mut news = News { cursor: since, ..News::default() };
        let mut changed: BTreeSet<(String, u32)> = BTreeSet::new();
        for row in &heads {
            let (class, latest, seat): (String, u64, u32) = (value(row, 1)?, number(row, 2)?, number(row, 3)?);
            if value(row, 0)? {
                news.cursor.event = news.cursor.event.max(latest);
                if seat == 0 {
                    news.settings.push(class.clone());
                }
                news.latest.push((class, latest));
            } else {
                news.cursor.change = news.cursor.change.max(latest);
                changed.insert((class, seat));
            }
        }
        if changed.is_empty() {
            return Ok(news);
        }
        news.teachers = changed.iter().filter(|(_, seat)| *seat == 0).map(|(class, _)| class.clone()).collect();
        let names: Vec<&str> = changed.iter().map(|(class, _)| class.as_str()).collect();
        let seats: Vec<i64> = changed.iter().map(|(_, seat)| i64::from(*seat)).collect();
        for row in line.rows(SEATS, &[&names, &seats]).await? {
            news.seats.push((value(&row, 4)?, read::seat(&row)?));
        }
        for row in line.rows(TOKENS, &[&names, &seats]).await? {
            news.tokens.push((hash(&row, 0)?, value(&row, 1)?, number(&row, 2)?));
        }
        for row in line.rows(CLASSES, &[&names]).await? {
            news.classes.push(read::class(&row)?);
        }
        let seats = news.seats.iter().map(|(class, row)| (class.clone(), row.seat));
        let classes = news.classes.iter().map(|row| (row.class.clone(), 0));
        let present: BTreeSet<(String, u32)> = seats.chain(classes).collect();
        news.erased = changed.difference(&present).cloned().collect();
        Ok(news)
    }
}

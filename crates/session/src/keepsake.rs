//! Records as a text, for the next visit.

use crate::Session;
use crate::recognise::Meaning;
use crate::record::Use;
use std::fmt::Write as _;
use units::Unit;

/// What the text begins with.
const VERSION: &str = "meniscus records 1\n";

/// The longest text: browsers keep a few megabytes for a site.
const LONGEST: usize = 1 << 20;

impl Session {
    /// The records as a text that [`Session::restore_records`] reads, and how many did not fit.
    pub fn saved_records(&self) -> (String, usize) {
        let (mut saved, mut missing) = (String::new(), 0);
        for record in &self.data.records {
            if !self.is_lasting(record.id) {
                missing += 1;
                continue;
            }
            let truth = record.truth.iter().flatten().map(|(name, value)| format!("{name}={value:e}"));
            let truth: Vec<String> = truth.collect();
            let chosen = record.uses.iter().enumerate().filter(|(_, used)| used.chosen);
            let chosen = chosen.map(|(column, Use { meaning, fitted, .. })| {
                format!("{column},{},{},{}", u8::from(*fitted), meaning.quantity, meaning.unit.text)
            });
            let chosen: Vec<String> = chosen.collect();
            let kind = if record.truth.is_some() { "virtual" } else { "measured" };
            let shown = if record.shown { "shown" } else { "hidden" };
            let _ = writeln!(
                saved,
                "{}\n{kind} {shown} {} {}\n{}\n{}\n{}",
                record.name.replace(['\n', '\r'], " "),
                record.text.len(),
                record.saved_made(),
                truth.join(";"),
                chosen.join(";"),
                record.text
            );
        }
        if !saved.is_empty() {
            saved.insert_str(0, VERSION);
        }
        (saved, missing)
    }

    /// Whether a record will be there at the next visit: it, and those before it, leave it room.
    pub(crate) fn is_lasting(&self, id: u32) -> bool {
        let mut sum = 0;
        for record in &self.data.records {
            let fits = sum + record.text.len() <= LONGEST;
            if record.id == id {
                return fits;
            }
            sum += if fits { record.text.len() } else { 0 };
        }
        false
    }

    /// Brings back records. What cannot be read is left out.
    pub fn restore_records(&mut self, saved: &str) {
        let Some(mut rest) = saved.strip_prefix(VERSION) else { return };
        while let Some(after) = self.restore_record(rest) {
            rest = after;
        }
        self.announcements.clear();
    }

    /// Brings back the first record of a text; what follows it.
    fn restore_record<'a>(&mut self, rest: &'a str) -> Option<&'a str> {
        let mut lines = rest.splitn(5, '\n');
        let (name, kind, truth, chosen, rest) =
            (lines.next()?, lines.next()?, lines.next()?, lines.next()?, lines.next()?);
        let mut kind = kind.split(' ');
        let (kind, shown, length, made) =
            (kind.next()?, kind.next()?, kind.next()?.parse::<usize>().ok()?, kind.next().unwrap_or_default());
        let (text, rest) = (rest.get(..length)?, rest.get(length + 1..)?);
        let truth = truth.split(';').filter_map(|entry| {
            let (name, value) = entry.split_once('=')?;
            Some((name.to_owned(), value.parse().ok()?))
        });
        let truth: Vec<(String, f64)> = truth.collect();
        let id = self.insert_record(name, text.as_bytes(), (kind == "virtual").then_some(truth)).ok();
        if let Some(record) = self.data.records.iter_mut().find(|record| Some(record.id) == id) {
            record.shown = shown == "shown";
            record.restore_made(made, &self.document);
            for entry in chosen.split(';') {
                let mut parts = entry.splitn(4, ',');
                let column = parts.next().and_then(|column| record.uses.get_mut(column.parse::<usize>().ok()?));
                let (Some(used), Some(fitted), Some(quantity), Some(unit)) =
                    (column, parts.next(), parts.next(), parts.next().and_then(|unit| Unit::parse(unit).ok()))
                else {
                    continue;
                };
                let meaning = Meaning { quantity: quantity.to_owned(), unit };
                *used = Use { meaning, fitted: fitted == "1", offset: 0.0, chosen: true };
            }
        }
        self.records_changed();
        Some(rest)
    }
}

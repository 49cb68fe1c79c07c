//! Records as texts, for the next visit.

use crate::Desk;
use crate::records::recognise::Meaning;
use crate::records::record::{Origin, Record, Use};
use play::name_of;
use units::Unit;

/// What the text begins with.
const VERSION: &str = "meniscus records 1\n";

/// The longest text: browsers keep a few megabytes for a site.
pub(crate) const LONGEST: usize = 1 << 20;

impl Desk {
    /// The records for the next visit: for each a name, which is the same at every visit and in every page, and a text that
    /// [`Desk::restore_records`] reads. Those that are too long are left out.
    pub fn saved_records(&self) -> Vec<(String, String)> {
        let document = self.document_name();
        let named = self.record_names().into_iter();
        named.filter_map(|(id, name)| Some((name, saved(self.record(id)?, &document)))).collect()
    }

    /// What a fit has found of a record holds beside this document alone.
    fn document_name(&self) -> String {
        name_of(&[&self.document.source])
    }

    /// The names of the records that will be there at the next visit, by their ids: by their content, and by their order where
    /// two are the same.
    pub(crate) fn record_names(&self) -> Vec<(u32, String)> {
        let mut names: Vec<(u32, String)> = Vec::new();
        for record in self.data.records.iter().filter(|record| self.is_lasting(record.id)) {
            let truth = write_values(record.truth.iter().flatten().map(|(name, value)| (name.as_str(), *value)));
            let own = line(&record.name);
            let mut again = 0;
            let mut name = name_of(&[&own, &truth, &record.text]);
            while names.iter().any(|(_, other)| *other == name) {
                again += 1;
                name = name_of(&[&own, &truth, &record.text, &again.to_string()]);
            }
            names.push((record.id, name));
        }
        names
    }

    /// Whether a record will be there at the next visit: it, and those before it, leave it room.
    pub(crate) fn is_lasting(&self, id: u32) -> bool {
        let mut sum = 0;
        for record in &self.data.records {
            let fits = !record.text.is_empty() && sum + record.text.len() <= LONGEST;
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
        self.forget_announcements();
    }

    /// Brings back the first record of a text; what follows it.
    fn restore_record<'a>(&mut self, rest: &'a str) -> Option<&'a str> {
        let mut lines = rest.splitn(5, '\n');
        let (name, kind, truth, chosen, rest) =
            (lines.next()?, lines.next()?, lines.next()?, lines.next()?, lines.next()?);
        let mut kind = kind.split(' ');
        let (what, shown, length) = (kind.next()?, kind.next()?, kind.next()?.parse::<usize>().ok()?);
        let mut further = || kind.next().unwrap_or_default();
        let (made, known, document, origin, offsets) = (further(), further(), further(), further(), further());
        let (origin, offsets) = if document == self.document_name() { (origin, offsets) } else { ("", "") };
        let (text, rest) = (rest.get(..length)?, rest.get(length + 1..)?);
        let truth: Vec<(String, f64)> = read_values(truth).map(|(name, value)| (name.to_owned(), value)).collect();
        let id = self.insert_record(name, text.as_bytes(), (what == "virtual").then_some(truth)).ok();
        if let Some(record) = self.data.records.iter_mut().find(|record| Some(record.id) == id) {
            record.shown = shown == "shown";
            record.restore_made(made, &self.document);
            record.known = read_values(known).map(|(name, value)| (name.to_owned(), value)).collect();
            for (column, used) in read_uses(chosen) {
                if let Some(place) = record.uses.get_mut(column) {
                    *place = used;
                }
            }
            record.origin = read_origin(origin);
            for (column, offset) in read_values(offsets) {
                if let Some(used) = column.parse().ok().and_then(|column: usize| record.uses.get_mut(column)) {
                    used.offset = offset;
                }
            }
        }
        self.records_changed();
        Some(rest)
    }
}

/// A record as [`Desk::restore_records`] reads it, beside the document of this name.
fn saved(record: &Record, document: &str) -> String {
    let truth = record.truth.iter().flatten().map(|(name, value)| (name.as_str(), *value));
    let known = record.known.iter().map(|(name, value)| (name.as_str(), *value));
    let chosen = record.uses.iter().enumerate().filter(|(_, used)| used.chosen);
    let kind = if record.truth.is_some() { "virtual" } else { "measured" };
    let shown = if record.shown { "shown" } else { "hidden" };
    let moved: Vec<(String, f64)> = (record.uses.iter().enumerate())
        .filter(|(_, used)| used.offset != 0.0)
        .map(|(column, used)| (column.to_string(), used.offset))
        .collect();
    format!(
        "{VERSION}{}\n{kind} {shown} {} {} {} {document} {} {}\n{}\n{}\n{}\n",
        line(&record.name),
        record.text.len(),
        record.saved_made(),
        write_values(known),
        record.origin.map(write_origin).unwrap_or_default(),
        write_values(moved.iter().map(|(column, offset)| (column.as_str(), *offset))),
        write_values(truth),
        write_uses(chosen),
        record.text
    )
}

/// `found=1.3e0`, or `part=1.3e0` where the fitted part began.
fn write_origin(origin: Origin) -> String {
    write_values([(if origin.found { "found" } else { "part" }, origin.reading)].into_iter())
}

/// What [`write_origin`] has written.
fn read_origin(text: &str) -> Option<Origin> {
    let (kind, reading) = read_values(text).next()?;
    reading.is_finite().then_some(Origin { reading, found: kind == "found" })
}

/// A name without what would end its line.
pub(crate) fn line(name: &str) -> String {
    name.replace(['\n', '\r'], " ")
}

/// `L=2e-1;gamma=4e-1`
pub(crate) fn write_values<'a>(values: impl Iterator<Item = (&'a str, f64)>) -> String {
    values.map(|(name, value)| format!("{name}={value:e}")).collect::<Vec<_>>().join(";")
}

/// What [`write_values`] has written; what cannot be read is left out.
pub(crate) fn read_values(text: &str) -> impl Iterator<Item = (&str, f64)> {
    text.split(';').filter_map(|entry| {
        let (name, value) = entry.split_once('=')?;
        Some((name, value.parse().ok()?))
    })
}

/// What columns are taken for: `1,1,y,cm;2,0,y',~cm/s`; the tilde is before a unit that no person has stated.
pub(crate) fn write_uses<'a>(uses: impl Iterator<Item = (usize, &'a Use)>) -> String {
    let entry = |(column, Use { meaning, fitted, stated, .. }): (usize, &Use)| {
        let sign = if *stated { "" } else { "~" };
        format!("{column},{},{},{sign}{}", u8::from(*fitted), meaning.quantity, meaning.unit.text)
    };
    uses.map(entry).collect::<Vec<_>>().join(";")
}

/// What [`write_uses`] has written, with the numbers of the columns; what cannot be read is left out.
pub(crate) fn read_uses(text: &str) -> impl Iterator<Item = (usize, Use)> {
    text.split(';').filter_map(|entry| {
        let mut parts = entry.splitn(4, ',');
        let (column, fitted) = (parts.next()?.parse().ok()?, parts.next()?);
        let (quantity, unit) = (parts.next()?.to_owned(), parts.next()?);
        let (unit, stated) = unit.strip_prefix('~').map_or((unit, true), |unit| (unit, false));
        let meaning = Meaning { quantity, unit: Unit::parse(unit).ok()? };
        Some((column, Use { meaning, fitted: fitted == "1", offset: 0.0, chosen: true, stated }))
    })
}

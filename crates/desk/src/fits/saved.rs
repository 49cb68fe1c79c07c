//! Fits as texts, for the next visit: what each was asked for and the numbers that it found. From those it is made again
//! in a few trials, so that nothing of its outcome has to be kept.

use crate::Desk;
use crate::fits::fit::{Definition, Found, Part, Waiting, texts};
use crate::records::record::Record;
use crate::records::saved::{line, read_uses, write_uses};
use analysis::fit::{Loss, Rival, Target, Varied};
use play::name_of;
use std::fmt::Write as _;

/// What the text begins with.
const VERSION: &str = "meniscus fits 2\n";
/// What it began with when initial values held at the first row of a record, whatever part of it was fitted.
const EARLIER: &str = "meniscus fits 1\n";

/// The longest texts together: the records need their room too.
const LONGEST: usize = 1 << 20;

impl Found {
    /// `17`, or with another minimum `17 2e-1 1.7e-1 4e-1`: how much worse it is, and its numbers.
    fn write_searches(&self) -> String {
        let rival = self.rival.iter().map(|rival| format!(" {:e} {}", rival.growth, write_numbers(&rival.values)));
        std::iter::once(self.starts.to_string()).chain(rival).collect()
    }

    /// What [`Found::write_searches`] has written, with the numbers that were found.
    fn read(searches: &str, values: Vec<f64>) -> Option<Self> {
        let (starts, rival) = searches.split_once(' ').unwrap_or((searches, ""));
        let rival = read_numbers(rival)?;
        let rival = rival.split_first().map(|(&growth, others)| Rival { growth, values: others.to_vec() });
        Some(Self { values, starts: starts.parse().ok()?, rival })
    }
}

impl Desk {
    /// The fits for the next visit: for each a name, which is the same at every visit and in every page, and a text that
    /// [`Desk::restore_fits`] reads. Those whose records will not be there are left out, and those for which there is no
    /// room.
    pub fn saved_fits(&self) -> Vec<(String, String)> {
        let mut saved = SavedFits { records: self.record_names(), fits: Vec::new(), length: 0 };
        for fit in &self.fits.finished {
            saved.write(&fit.definition, &texts(&fit.document), &Found::of(&fit.outcome));
        }
        if let Some(job) = self.being_remade()
            && let Some(found) = &job.found
        {
            saved.write(&job.definition, &texts(&job.document), found);
        }
        for Waiting { definition, texts, found } in &self.fits.waiting {
            saved.write(definition, texts, found);
        }
        saved.fits
    }

    /// Brings back fits of the records that are there, to be made again by [`Desk::advance_fit`]. What cannot be read is
    /// left out. Fits of an earlier version are searched from the beginning: their initial values held elsewhere.
    pub fn restore_fits(&mut self, saved: &str) {
        let earlier = saved.strip_prefix(EARLIER);
        let Some(text) = saved.strip_prefix(VERSION).or(earlier) else { return };
        let mut pages = Pages { rest: text, documents: Vec::new(), names: self.record_names() };
        while let Some(waiting) = pages.next(&self.data.records) {
            let begun = |waiting: Waiting| if earlier.is_some() { waiting.begun_anew() } else { waiting };
            self.fits.waiting.extend(waiting.map(begun));
        }
        // Those that were fitted together last probably will be again.
        if let Some(last) = self.fits.waiting.back() {
            self.fits.setup.others = last.definition.parts.iter().map(|part| part.record).collect();
            self.fits.setup.chosen = last.definition.parts.last().map(|part| part.record);
        }
    }

    /// Whether fits are waiting to be made again.
    pub fn has_fits_waiting(&self) -> bool {
        !self.fits.waiting.is_empty()
    }
}

/// What is being written.
struct SavedFits {
    /// The records that will be there: their ids and names.
    records: Vec<(u32, String)>,
    /// Names and texts.
    fits: Vec<(String, String)>,
    length: usize,
}

impl SavedFits {
    /// Writes a fit, unless there is no room for it.
    fn write(&mut self, definition: &Definition, texts: &[String], found: &Found) {
        let Some(fit) = self.fit(definition) else { return };
        let mut parts: Vec<&str> = texts.iter().map(String::as_str).collect();
        parts.push(&fit);
        // What it has found is no part of the name: made again, its last digits may differ.
        let name = name_of(&parts);
        let lengths: Vec<String> = texts.iter().map(|text| text.len().to_string()).collect();
        let document = format!("document {}\n{}\n", lengths.join(" "), texts.concat());
        let (values, starts) = (write_numbers(&found.values), found.write_searches());
        let text = format!("{VERSION}{document}{fit}found {values}\nstarts {starts}\nend\n");
        if self.length + text.len() <= LONGEST && self.fits.iter().all(|(other, _)| *other != name) {
            self.length += text.len();
            self.fits.push((name, text));
        }
    }

    /// A fit without what it has found; `None` if one of its records will not be there.
    fn fit(&self, definition: &Definition) -> Option<String> {
        let mut text = format!("fit 0 {}\n", line(&definition.file));
        let window = definition.window.map(|end| end.map_or_else(|| "-".to_owned(), |end| format!("{end:e}")));
        let varied: Vec<String> = definition.varied.iter().map(write_varied).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "window {}", window.join(" "));
        let _ = writeln!(text, "values {}", write_numbers(&definition.parameters));
        let _ = writeln!(text, "varied {}", varied.join(" "));
        if definition.loss != Loss::Squares {
            let _ = writeln!(text, "loss {}", definition.loss.code());
        }
        for part in &definition.parts {
            let (_, record) = self.records.iter().find(|(id, _)| *id == part.record)?;
            let uses = write_uses(part.uses.iter().enumerate());
            let fixed: Vec<String> = part.fixed.iter().map(|(index, value)| format!("{index}={value:e}")).collect();
            let origin = part.origin.map_or_else(|| "-".to_owned(), |origin| format!("{origin:e}"));
            let _ = writeln!(text, "record #{record} {origin} {} {}", fixed.join(";"), line(&part.name));
            let _ = writeln!(text, "uses {uses}");
        }
        Some(text)
    }
}

/// What is being read.
struct Pages<'a> {
    rest: &'a str,
    documents: Vec<Vec<String>>,
    /// The ids and names of the records that are there.
    names: Vec<(u32, String)>,
}

impl<'a> Pages<'a> {
    /// The next fit, or nothing where it cannot be read; `None` at the end.
    fn next(&mut self, records: &[Record]) -> Option<Option<Waiting>> {
        loop {
            let line = self.line()?;
            if let Some(lengths) = line.strip_prefix("document ") {
                self.document(lengths)?;
            } else if let Some(head) = line.strip_prefix("fit ") {
                let mut lines = Vec::new();
                loop {
                    match self.line()? {
                        "end" => return Some(self.fit(head, &lines, records)),
                        line => lines.push(line),
                    }
                }
            } else {
                return None;
            }
        }
    }

    fn line(&mut self) -> Option<&'a str> {
        let (line, rest) = self.rest.split_once('\n')?;
        self.rest = rest;
        Some(line)
    }

    fn document(&mut self, lengths: &str) -> Option<()> {
        let mut texts = Vec::new();
        for length in lengths.split(' ') {
            let length: usize = length.parse().ok()?;
            texts.push(self.rest.get(..length)?.to_owned());
            self.rest = self.rest.get(length..)?;
        }
        self.documents.push(texts);
        self.line().map(|_| ())
    }

    fn fit(&self, head: &str, lines: &[&str], records: &[Record]) -> Option<Waiting> {
        let (document, file) = head.split_once(' ')?;
        let texts = self.documents.get(document.parse::<usize>().ok()?)?.clone();
        let value = |key: &str| lines.iter().find_map(|line| line.strip_prefix(key)?.strip_prefix(' '));
        let (from, until) = value("window")?.split_once(' ')?;
        let mut parts = Vec::new();
        for (place, line) in lines.iter().enumerate() {
            if let Some(head) = line.strip_prefix("record ") {
                let uses = lines.get(place + 1)?.strip_prefix("uses ")?;
                parts.push(part(head, uses, records, &self.names)?);
            }
        }
        let definition = Definition {
            file: file.to_owned(),
            parts,
            varied: value("varied")?.split(' ').map(read_varied).collect::<Option<_>>()?,
            parameters: read_numbers(value("values")?)?,
            window: [time(from)?, time(until)?],
            // Earlier versions knew least squares only.
            loss: value("loss").map_or(Some(Loss::Squares), Loss::from_code)?,
        };
        let found = Found::read(value("starts").unwrap_or("1"), read_numbers(value("found")?)?)?;
        Some(Waiting { definition, texts, found })
    }
}

/// A time, or `-` for none.
fn time(text: &str) -> Option<Option<f64>> {
    if text == "-" { Some(None) } else { text.parse().ok().map(Some) }
}

/// A part of a fit, if its record is there: by its name in the storage, in texts of earlier versions by its place.
fn part(head: &str, uses: &str, records: &[Record], names: &[(u32, String)]) -> Option<Part> {
    let mut fields = head.splitn(4, ' ');
    let (place, origin) = (fields.next()?, time(fields.next()?)?);
    let (fixed, name) = (fields.next()?, fields.next()?);
    let record = match place.strip_prefix('#') {
        Some(place) => {
            let (id, _) = names.iter().find(|(_, name)| name == place)?;
            records.iter().find(|record| record.id == *id)?
        }
        None => records.get(place.parse::<usize>().ok()?)?,
    };
    let record = Some(record).filter(|record| line(&record.name) == name)?;
    let fixed = fixed.split(';').filter_map(|entry| {
        let (index, value) = entry.split_once('=')?;
        Some((index.parse().ok()?, value.parse().ok()?))
    });
    let mut taken = record.uses.clone();
    for (column, used) in read_uses(uses) {
        *taken.get_mut(column)? = used;
    }
    Some(Part { record: record.id, name: record.name.clone(), uses: taken, origin, fixed: fixed.collect() })
}

/// `3` for the parameter of this number, `clock`, `scale0`; with a star where it is one number for all records.
fn write_varied(varied: &Varied) -> String {
    let star = if varied.shared { "*" } else { "" };
    match varied.target {
        Target::Parameter(index) => format!("{index}{star}"),
        Target::Origin => format!("clock{star}"),
        Target::Offset(place) => format!("scale{place}{star}"),
    }
}

fn read_varied(text: &str) -> Option<Varied> {
    let name = text.trim_end_matches('*');
    let target = match (name, name.strip_prefix("scale")) {
        ("clock", _) => Target::Origin,
        (_, Some(place)) => Target::Offset(place.parse().ok()?),
        (index, None) => Target::Parameter(index.parse().ok()?),
    };
    Some(Varied { target, shared: name.len() < text.len(), ..Varied::parameter(0) })
}

fn write_numbers(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!("{number:e}")).collect::<Vec<_>>().join(" ")
}

fn read_numbers(text: &str) -> Option<Vec<f64>> {
    text.split(' ').filter(|number| !number.is_empty()).map(|number| number.parse().ok()).collect()
}

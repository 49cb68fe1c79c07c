//! Reader for the storage formats of earlier versions: one text for all records, one for fits and one for answers, each
//! made of lines. The next save writes the data as [`super::Item`].

use super::format::{
    Answer, Column, Content, Derivative, Fit, Found, FoundOfRecord, Part, Record, Rival, Target, Task, Varied,
};
use super::number::Number;

const RECORDS: &str = "meniscus records 1\n";
const FITS: &str = "meniscus fits 2\n";
/// Head of the first format of fits, in which initial values held at the first row of a record, regardless of the
/// fitted window.
const FIRST_FITS: &str = "meniscus fits 1\n";

/// The time at which the text was first stored, in milliseconds, and its items. The first versions stored no time; it
/// is then 0. Unreadable parts are left out. `None` for an unknown format.
pub(super) fn read(text: &str) -> Option<(u64, Vec<Content>)> {
    let timed = text.split_once('\n').and_then(|(since, text)| Some((since.parse().ok()?, text)));
    let (since, text) = timed.unwrap_or((0, text));
    if let Some(text) = text.strip_prefix(RECORDS) {
        return Some((since, records(text)));
    }
    if let Some(text) = text.strip_prefix(FITS) {
        return Some((since, fits(text)));
    }
    if let Some(text) = text.strip_prefix(FIRST_FITS) {
        return Some((since, fits(text).into_iter().map(begun_anew).collect()));
    }
    timed.and_then(|_| answer(text)).map(|answer| (since, vec![answer]))
}

/// An answer of three lines: the typed text, the grade, and whether the solution was shown.
fn answer(text: &str) -> Option<Content> {
    let play::Answer { typed, grade, revealed } = play::Answer::of_lines(text)?;
    Some(Content::Answer(Answer { typed, grade: grade.map(|grade| grade.code().to_owned()), revealed }))
}

fn records(mut rest: &str) -> Vec<Content> {
    let mut found = Vec::new();
    while let Some((record, after)) = record(rest) {
        found.push(Content::Record(record));
        rest = after;
    }
    found
}

/// The first record of a text, and the rest of the text. A record has a line for its name, one for its properties, one
/// for true values, one for the uses of columns chosen by the user, and then its text.
fn record(rest: &str) -> Option<(Record, &str)> {
    let mut lines = rest.splitn(5, '\n');
    let (name, about, truth, chosen, rest) =
        (lines.next()?, lines.next()?, lines.next()?, lines.next()?, lines.next()?);
    let mut about = about.split(' ');
    let (kind, shown, length) = (about.next()?, about.next()?, about.next()?.parse::<usize>().ok()?);
    let mut further = || about.next().unwrap_or_default();
    let (made, known, document, origin, offsets) = (further(), further(), further(), further(), further());
    let (text, rest) = (rest.get(..length)?, rest.get(length + 1..)?);
    let origin = values(origin).into_iter().next();
    let offsets = values(offsets).into_iter().filter_map(|(column, offset)| Some((column.parse().ok()?, offset)));
    let record = Record {
        name: name.to_owned(),
        text: text.to_owned(),
        hidden: shown != "shown",
        truth: (kind == "virtual").then(|| values(truth)),
        known: values(known),
        against: Vec::new(),
        columns: columns(chosen),
        derivatives: derivatives(made),
        found: Some(FoundOfRecord {
            document: document.to_owned(),
            origin_fitted: origin.as_ref().is_some_and(|(kind, _)| kind == "found"),
            origin: origin.map(|(_, reading)| reading),
            offsets: offsets.collect(),
        }),
    };
    Some((record, rest))
}

/// Values by name: `L=2e-1;gamma=4e-1`.
fn values(text: &str) -> Vec<(String, Number)> {
    let entry = |entry: &str| {
        let (name, value) = entry.split_once('=')?;
        Some((name.to_owned(), Number(value.parse().ok()?)))
    };
    text.split(';').filter_map(entry).collect()
}

/// Derivatives by column: `1:central,3:smooth-5-2`.
fn derivatives(text: &str) -> Vec<Derivative> {
    let entry = |entry: &str| {
        let (column, method) = entry.split_once(':')?;
        Some(Derivative { column: column.parse().ok()?, method: method.to_owned() })
    };
    text.split(',').filter_map(entry).collect()
}

/// Uses of columns, `1,1,y,cm;2,0,y',~cm/s`: column, 1 if fitted, quantity, unit. A tilde marks a unit that the user
/// has not stated.
fn columns(text: &str) -> Vec<Column> {
    let entry = |entry: &str| {
        let mut parts = entry.splitn(4, ',');
        let (column, fitted) = (parts.next()?.parse().ok()?, parts.next()?);
        let (quantity, unit) = (parts.next()?.to_owned(), parts.next()?);
        let (unit, stated) = unit.strip_prefix('~').map_or((unit, true), |unit| (unit, false));
        Some(Column { column, quantity, unit: unit.to_owned(), stated, fitted: fitted == "1" })
    };
    text.split(';').filter_map(entry).collect()
}

/// Documents, each preceded by the lengths of its texts, and fits that refer to them by number.
fn fits(mut rest: &str) -> Vec<Content> {
    let mut documents: Vec<Vec<String>> = Vec::new();
    let mut found = Vec::new();
    while let Some((line, after)) = rest.split_once('\n') {
        if let Some(lengths) = line.strip_prefix("document ") {
            let Some((texts, after)) = document(lengths, after) else { break };
            documents.push(texts);
            rest = after;
        } else if let Some(head) = line.strip_prefix("fit ") {
            let Some((lines, after)) = after.split_once("\nend\n") else { break };
            found.extend(fit(head, &lines.split('\n').collect::<Vec<_>>(), &documents).map(Content::Fit));
            rest = after;
        } else {
            break;
        }
    }
    found
}

/// The texts of a document and its translations, and the rest of the text.
fn document<'a>(lengths: &str, mut rest: &'a str) -> Option<(Vec<String>, &'a str)> {
    let mut texts = Vec::new();
    for length in lengths.split(' ') {
        let length: usize = length.parse().ok()?;
        texts.push(rest.get(..length)?.to_owned());
        rest = rest.get(length..)?;
    }
    Some((texts, rest.strip_prefix('\n')?))
}

fn fit(head: &str, lines: &[&str], documents: &[Vec<String>]) -> Option<Fit> {
    let (document, file) = head.split_once(' ')?;
    let value = |key: &str| lines.iter().find_map(|line| line.strip_prefix(key)?.strip_prefix(' '));
    let (from, until) = value("window")?.split_once(' ')?;
    let mut records = Vec::new();
    for (place, line) in lines.iter().enumerate() {
        if let Some(head) = line.strip_prefix("record ") {
            records.push(part(head, lines.get(place + 1)?.strip_prefix("uses ")?)?);
        }
    }
    let task = Task {
        file: file.to_owned(),
        window: [time(from)?, time(until)?],
        parameters: numbers(value("values")?)?,
        varied: value("varied")?.split(' ').map(varied).collect::<Option<_>>()?,
        loss: value("loss").map(str::to_owned),
        records,
    };
    // `17`: number of starts. `17 2e-1 1.7e-1 4e-1`: also another minimum, its growth followed by its values.
    let searches = value("starts").unwrap_or("1");
    let (starts, rival) = searches.split_once(' ').unwrap_or((searches, ""));
    let rival = numbers(rival)?;
    let rival = rival.split_first().map(|(&growth, values)| Rival { growth, values: values.to_vec() });
    let found = Found { values: numbers(value("found")?)?, starts: starts.parse().ok()?, rival };
    Some(Fit { documents: documents.get(document.parse::<usize>().ok()?)?.clone(), task, found })
}

/// A record of a fit: reference (`#` and its name, or its index), origin, fixed values, and its display name.
fn part(head: &str, uses: &str) -> Option<Part> {
    let mut fields = head.splitn(4, ' ');
    let (record, origin) = (fields.next()?, time(fields.next()?)?);
    let (fixed, name) = (fields.next()?, fields.next()?);
    let fixed = values(fixed).into_iter().filter_map(|(index, value)| Some((index.parse().ok()?, value)));
    Some(Part {
        record: record.trim_start_matches('#').to_owned(),
        name: name.to_owned(),
        origin,
        fixed: fixed.collect(),
        columns: columns(uses),
    })
}

/// A time; `-` is an open end.
fn time(text: &str) -> Option<Option<Number>> {
    if text == "-" { Some(None) } else { text.parse().ok().map(|time| Some(Number(time))) }
}

/// A varied number: `3` for the parameter of this index, `clock`, or `scale0`. A star marks one value for all records.
fn varied(text: &str) -> Option<Varied> {
    let name = text.trim_end_matches('*');
    let target = match (name, name.strip_prefix("scale")) {
        ("clock", _) => Target::Origin,
        (_, Some(place)) => Target::Offset(place.parse().ok()?),
        (index, None) => Target::Parameter(index.parse().ok()?),
    };
    Some(Varied { target, shared: name.len() < text.len() })
}

fn numbers(text: &str) -> Option<Vec<Number>> {
    text.split(' ').filter(|number| !number.is_empty()).map(|number| number.parse().ok().map(Number)).collect()
}

/// Removes the result of a fit from the first format, because its initial values held at another time. The fit is then
/// repeated in full.
fn begun_anew(mut content: Content) -> Content {
    if let Content::Fit(fit) = &mut content {
        fit.found.values.clear();
        fit.task.records.iter_mut().for_each(|part| part.origin = None);
    }
    content
}

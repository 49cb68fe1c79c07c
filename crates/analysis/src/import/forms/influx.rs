//! Annotated CSV of InfluxDB (docs.influxdata.com, "Annotated CSV"): each row holds one value of one series. The series
//! become columns over common times.

use crate::import::cells::{COLUMNS, Cells, Delimiter};
use std::collections::BTreeMap;

/// Upper bound of the cells of the table beyond the rows of the file. Series without common times need many empty cells.
const SPARE: usize = 4_000_000;

/// Places of the columns in the present header.
#[derive(Clone, Copy, Debug)]
struct Places {
    time: usize,
    value: usize,
    field: usize,
    table: Option<usize>,
}

/// Times and values of all series.
#[derive(Debug, Default)]
struct Series<'a> {
    /// Field and table of each series.
    keys: Vec<(&'a str, &'a str)>,
    places: BTreeMap<(&'a str, &'a str), usize>,
    times: Vec<&'a str>,
    rows: BTreeMap<&'a str, usize>,
    /// Row, series and value, in the order of the file.
    values: Vec<(usize, usize, &'a str)>,
}

/// Cells with tabs: times and one column for each series; `None` for any other file.
pub(super) fn read(text: &str) -> Option<String> {
    let first = text.trim_start_matches('\u{feff}').trim_start();
    let annotated = ["#group,", "#datatype,", "#default,"].iter().any(|start| first.starts_with(start));
    if !annotated && !first.lines().next()?.contains("_field") {
        return None;
    }
    let mut series = Series::default();
    let mut header: Option<Places> = None;
    for line in first.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let cells: Vec<&str> = Cells::of(line, Delimiter::Comma).take(COLUMNS).collect();
        if let Some(places) = places(&cells) {
            header = Some(places);
            continue;
        }
        let Places { time, value, field, table } = header?;
        let of = |place: usize| cells.get(place).copied().unwrap_or_default();
        series.push((of(field), table.map_or("", of)), of(time), of(value));
    }
    (series.keys.len().checked_mul(series.times.len())? <= series.values.len() + SPARE)
        .then(|| series.cells())
        .filter(|cells| !cells.is_empty())
}

/// Places in a header; `None` for any other line.
fn places(cells: &[&str]) -> Option<Places> {
    let place = |name: &str| cells.iter().position(|cell| *cell == name);
    Some(Places { time: place("_time")?, value: place("_value")?, field: place("_field")?, table: place("table") })
}

impl<'a> Series<'a> {
    fn push(&mut self, key: (&'a str, &'a str), time: &'a str, value: &'a str) {
        let column = *self.places.entry(key).or_insert_with(|| {
            self.keys.push(key);
            self.keys.len() - 1
        });
        let row = *self.rows.entry(time).or_insert_with(|| {
            self.times.push(time);
            self.times.len() - 1
        });
        self.values.push((row, column, value));
    }

    /// Table in the order of the times of the file. Fields of several tables are distinguished by these.
    fn cells(mut self) -> String {
        if self.keys.is_empty() || self.keys.len() >= COLUMNS {
            return String::new();
        }
        let mut text = "time".to_owned();
        for (field, table) in &self.keys {
            let alone = self.keys.iter().filter(|(other, _)| other == field).take(2).count() < 2;
            text.push('\t');
            text.push_str(field);
            if !alone {
                text.push(' ');
                text.push_str(table);
            }
        }
        text.push('\n');
        // Stable, so that the first value of a series at one time is kept.
        self.values.sort_by_key(|(row, column, _)| (*row, *column));
        let mut values = self.values.iter().peekable();
        for (row, time) in self.times.iter().enumerate() {
            text.push_str(time);
            for column in 0..self.keys.len() {
                text.push('\t');
                if let Some((_, _, value)) = values.next_if(|value| (value.0, value.1) == (row, column)) {
                    text.push_str(value);
                }
                while values.next_if(|value| (value.0, value.1) == (row, column)).is_some() {}
            }
            text.push('\n');
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_become_columns() {
        let text = "#group,false,false,true,false,true\n#datatype,string,long,dateTime:RFC3339,double,string\n#default,mean,,,,\n,result,table,_time,_value,_field\n,,0,t0,1,x\n,,0,t1,2,x\n\n,result,table,_time,_value,_field\n,,1,t1,3,y\n,,1,t2,4,y\n,,1,t2,5,y\n";
        assert_eq!(read(text).as_deref(), Some("time\tx\ty\nt0\t1\t\nt1\t2\t3\nt2\t\t4\n"));
        let text = "_time,_value,_field,table\nt0,1,x,0\nt0,2,x,1\n";
        assert_eq!(read(text).as_deref(), Some("time\tx 0\tx 1\nt0\t1\t2\n"));
        for text in ["t,x\n0,1\n", "#group,false\n", "", "_field\n1\n"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}

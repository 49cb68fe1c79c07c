//! Which columns are independent variables, and whose.

use crate::origin::UnitOrigin;
use crate::table::Column;
use units::Dimension;

/// Names of times, in the languages of the laboratory and some neighbours.
const TIMES: [&str; 17] = [
    "t",
    "time",
    "tiempo",
    "temps",
    "tempo",
    "zeit",
    "elapsed time",
    "elapsed",
    "tiempo transcurrido",
    "seconds",
    "timestamp",
    "time stamp",
    "zeitstempel",
    "hora",
    "uhrzeit",
    "millis",
    "micros",
];
/// Names of counters.
const COUNTERS: [&str; 12] =
    ["n", "frame", "frames", "step", "index", "i", "#", "no", "nr", "fotograma", "cuadro", "paso"];

/// Whether a column of this name holds times, as far as its name says: `t`, `Time`, `t (camera)`. A capital `T` may be a
/// temperature or a period.
pub(super) fn is_time(name: &str) -> bool {
    let stem = name.split(['(', '[']).next().unwrap_or(name).trim();
    stem != "T" && TIMES.contains(&stem.to_lowercase().as_str())
}

/// Sets [`Column::independent`] of all columns, and bodies where each has its own time but no name.
pub(super) fn assign(columns: &mut [Column]) {
    let independent = independent(columns);
    let counter = |column: &Column| is_in(&COUNTERS, &column.name) || column.name.is_empty();
    let counts = |column: &Column| column.values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
    let has_names = columns.iter().any(|column| !column.name.is_empty());
    let first = independent.first().copied().unwrap_or(0);
    let several = independent.len() > 1 && columns.iter().all(|column| column.body.is_none());
    let bodies: Vec<Option<String>> = columns.iter().map(|column| column.body.clone()).collect();
    for (index, column) in columns.iter_mut().enumerate() {
        // A counter beside a time is no measurement.
        let own = independent.contains(&index) || (index < first && has_names && counter(column) && counts(column));
        let before = independent.iter().rposition(|start| *start <= index);
        // Runs may stand beside each other in any order: each has its own clock.
        let same_body = |start: &&usize| column.body.is_some() && bodies.get(**start) == Some(&column.body);
        let clock = independent.iter().rev().filter(|start| **start <= index).find(same_body);
        let clock = clock.or_else(|| independent.iter().find(same_body)).copied();
        column.independent =
            if own { index } else { clock.unwrap_or_else(|| before.map_or(first, |group| independent[group])) };
        if several {
            column.body = before.map(|group| (group + 1).to_string());
        }
    }
}

/// The independent variables, ascending.
fn independent(columns: &[Column]) -> Vec<usize> {
    let all = |wanted: &dyn Fn(&Column) -> bool| -> Vec<usize> {
        (0..columns.len()).filter(|index| wanted(&columns[*index])).collect()
    };
    let may_be_time = |column: &Column| column.unit.as_ref().is_none_or(|unit| unit.dimension == Dimension::TIME);
    // Where one is called just that, `t_half` is a quantity; else `t_A` and `t_B` are times.
    let exact = all(&|column| is_time(&column.name) && may_be_time(column));
    if !exact.is_empty() {
        return one_clock(columns, exact);
    }
    let numbered = all(&|column| is_in(&TIMES, &column.name) && may_be_time(column));
    if !numbered.is_empty() {
        return numbered;
    }
    let Some(first) = columns.first() else { return Vec::new() };
    // A `T` that comes first can be a time; behind another quantity it is a period.
    let is_time = |column: &Column| {
        column.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME) && column.name != "T"
    };
    let time = if is_in(&COUNTERS, &first.name) || (first.name == "T" && may_be_time(first)) {
        None
    } else {
        columns.iter().position(is_time)
    };
    let one = time.unwrap_or(0);
    let name = &columns[one].name;
    if name.is_empty() { vec![one] } else { all(&|column| column.name == *name) }
}

/// Of several times with different names (`Time`, `t`) the one that all are measured against: one with a number rather than a
/// time of day, else the first. Those of other bodies are called as it is, or stand alone in their body.
fn one_clock(columns: &[Column], times: Vec<usize>) -> Vec<usize> {
    let is_number = |index: &&usize| columns[**index].origin.unit != UnitOrigin::Clock;
    let Some(&chosen) = times.iter().find(is_number).or(times.first()) else { return times };
    let alone = |index: usize| {
        let body = &columns[index].body;
        body.is_some() && times.iter().filter(|other| columns[**other].body == *body).count() == 1
    };
    times.iter().copied().filter(|&index| columns[index].name == columns[chosen].name || alone(index)).collect()
}

/// Whether a name is in the list, but for capitals and for what tells bodies apart: `t_A`, `t2`, `t.1`. A single letter counts
/// only as it is: `T` is no time, and `I` no counter.
fn is_in(list: &[&str], name: &str) -> bool {
    let stem = name
        .split(['_', '.'])
        .next()
        .unwrap_or_default()
        .trim_end_matches(|character: char| character.is_ascii_digit())
        .trim();
    [name, stem]
        .iter()
        .any(|name| list.contains(name) || (name.chars().count() > 1 && list.contains(&name.to_lowercase().as_str())))
}

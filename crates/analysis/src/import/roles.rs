//! Which columns are independent variables, and whose.

use crate::table::Column;
use units::Dimension;

/// Names of times, in the languages of the laboratory and some neighbours.
const TIMES: [&str; 10] =
    ["t", "time", "tiempo", "temps", "tempo", "zeit", "elapsed time", "elapsed", "tiempo transcurrido", "seconds"];
/// Names of counters.
const COUNTERS: [&str; 12] =
    ["n", "frame", "frames", "step", "index", "i", "#", "no", "nr", "fotograma", "cuadro", "paso"];

/// Sets [`Column::independent`] of all columns, and bodies where each has its own time but no name.
pub(super) fn assign(columns: &mut [Column]) {
    let independent = independent(columns);
    let counter = |column: &Column| is_in(&COUNTERS, &column.name) || column.name.is_empty();
    let counts = |column: &Column| column.values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
    let has_names = columns.iter().any(|column| !column.name.is_empty());
    let first = independent.first().copied().unwrap_or(0);
    let several = independent.len() > 1 && columns.iter().all(|column| column.body.is_none());
    for (index, column) in columns.iter_mut().enumerate() {
        // A counter beside a time is no measurement.
        let own = independent.contains(&index) || (index < first && has_names && counter(column) && counts(column));
        let group = independent.iter().rposition(|start| *start <= index);
        column.independent = if own { index } else { group.map_or(first, |group| independent[group]) };
        if several {
            column.body = group.map(|group| (group + 1).to_string());
        }
    }
}

/// The independent variables, ascending.
fn independent(columns: &[Column]) -> Vec<usize> {
    let all = |wanted: &dyn Fn(&Column) -> bool| -> Vec<usize> {
        (0..columns.len()).filter(|index| wanted(&columns[*index])).collect()
    };
    // Where one is called just that, `t_half` is a quantity; else `t_A` and `t_B` are times.
    let exact = all(&|column| TIMES.contains(&column.name.to_lowercase().as_str()));
    let times = if exact.is_empty() { all(&|column| is_in(&TIMES, &column.name)) } else { exact };
    if !times.is_empty() {
        return times;
    }
    let Some(first) = columns.first() else { return Vec::new() };
    let is_time = |column: &Column| column.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME);
    let time = if is_in(&COUNTERS, &first.name) { None } else { columns.iter().position(is_time) };
    let one = time.unwrap_or(0);
    let name = &columns[one].name;
    if name.is_empty() { vec![one] } else { all(&|column| column.name == *name) }
}

/// Whether a name is in the list, but for capitals and for what tells bodies apart: `t_A`, `t2`, `t.1`.
fn is_in(list: &[&str], name: &str) -> bool {
    let name = name.to_lowercase();
    let stem = name
        .split(['_', '.'])
        .next()
        .unwrap_or_default()
        .trim_end_matches(|character: char| character.is_ascii_digit());
    list.contains(&name.as_str()) || list.contains(&stem.trim())
}

//! Recognition of the lines of names, units and comments before the first row.

use super::below::Below;
use super::cells_of::{bare_unit, split};
use super::label::looks_like_unit;
use super::{label, meant};
use crate::import::cells::{Cells, Delimiter};
use crate::roles::is_time;
use crate::run_name;

/// Greatest number of lines above the rows that can be names, units and comments.
const LINES: usize = 6;

/// Roles of the lines of a header, by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    pub names: usize,
    pub units: Option<usize>,
    /// Full lines that hold neither names nor units.
    pub comments: Vec<usize>,
}

/// Recognises the roles of the lines from their cells over columns with numbers; `None` without lines.
pub(super) fn tell(lines: &[&str], delimiter: Delimiter, below: &Below) -> Option<Block> {
    let last = lines.len().checked_sub(1)?;
    let from = lines.len().saturating_sub(LINES);
    let rows: Vec<Row> = (from..lines.len()).map(|line| Row::new(line, lines[line], delimiter, below)).collect();
    let full = |row: &&Row| row.filled() >= 2.min(below.numeric().max(1)) && row.fits;
    let mut best: Option<(f64, usize, usize)> = None;
    for names in rows.iter().filter(full) {
        for units in rows.iter().filter(|units| units.line != names.line) {
            let Some(of_units) = units.as_units_of(names) else { continue };
            let near = match (units.line > names.line, units.line.abs_diff(names.line)) {
                (true, 1) => 1.0,
                (_, 1) => 0.5,
                _ => 0.0,
            };
            let score = of_units + names.as_names() + near + if units.line == last { 1.0 } else { 0.0 };
            if best.is_none_or(|(least, _, _)| score > least) {
                best = Some((score, names.line, units.line));
            }
        }
    }
    let (names, units) = match best {
        Some((_, names, units)) => (names, Some(units)),
        None => {
            // The last line has the names, unless another line has a much higher score.
            let own = rows.last().map_or(0.0, Row::as_names);
            let better = rows.iter().filter(full).max_by(|one, other| one.as_names().total_cmp(&other.as_names()));
            (better.filter(|row| row.as_names() >= own + 3.0).map_or(last, |row| row.line), None)
        }
    };
    // Symbols below the names of the same quantities, `Time, Potential` over `t, U`: the names are longer.
    let names = rows
        .iter()
        .find(|row| row.line + 1 == names)
        .filter(|row| row.spells(&rows, names))
        .map_or(names, |row| row.line);
    // With cells merged downwards, the line below completes the names.
    let completes = |row: &&Row| row.line > names && Some(row.line) != units && row.completes(&rows, names);
    let names = rows.iter().find(completes).map_or(names, |row| row.line);
    let comment = |row: &&Row| row.own && row.line != names && Some(row.line) != units;
    let comments = rows.iter().filter(full).filter(comment).map(|row| row.line).collect();
    Some(Block { names, units, comments })
}

/// Line of a header, with its cells over the columns with numbers.
struct Row<'a> {
    line: usize,
    cells: Vec<&'a str>,
    /// True if it has no more cells than the table has columns.
    fits: bool,
    /// True if the delimiter of the rows divides it.
    own: bool,
}

impl<'a> Row<'a> {
    fn new(line: usize, text: &'a str, delimiter: Delimiter, below: &Below) -> Self {
        let cells = split(text, delimiter, below.wide());
        let fits = cells.len() <= below.wide();
        // If there is one name less than columns, the names belong to the last columns.
        let shift = usize::from(cells.len() + 1 == below.wide() && below.names_rows());
        let over = cells.into_iter().enumerate().filter(|(place, _)| below.is_numeric(place + shift));
        let own = Cells::of(text, delimiter).filter(|cell| !cell.is_empty()).count() > 1;
        Self { line, own, cells: over.map(|(_, cell)| cell).collect(), fits }
    }

    fn filled(&self) -> usize {
        self.cells.iter().filter(|cell| !cell.is_empty()).count()
    }

    /// True if this line has a long name for each symbol of the line of names just below it.
    fn spells(&self, rows: &[Self], names: usize) -> bool {
        let Some(symbols) = rows.iter().find(|row| row.line == names) else { return false };
        let is_short = |cell: &str| cell.chars().count() <= 3;
        let timed = |row: &Self| row.cells.iter().any(|cell| is_time(cell));
        self.own
            && self.fits
            && self.cells.len() == symbols.cells.len()
            && self.cells.iter().all(|cell| cell.chars().count() > 3)
            && symbols.cells.iter().all(|cell| !cell.is_empty() && is_short(cell))
            && timed(self)
            && timed(symbols)
    }

    /// True if this line, just below the line of names, has names exactly where that has none.
    fn completes(&self, rows: &[Self], names: usize) -> bool {
        let Some(above) = rows.iter().find(|row| row.line == names && row.line + 1 == self.line) else { return false };
        let filled = |row: &Self, place: usize| row.cells.get(place).is_some_and(|cell| !cell.is_empty());
        let places = self.cells.len().max(above.cells.len());
        let missing = (0..places).any(|place| !filled(above, place));
        missing
            && (0..places).all(|place| filled(above, place) || filled(self, place))
            && !filled(self, 0)
            && filled(above, 0)
    }

    /// Score of this line as the units of `names`; `None` if it cannot be.
    fn as_units_of(&self, names: &Self) -> Option<f64> {
        let name = |place: usize| names.cells.get(place).copied().unwrap_or_default();
        let (mut known, mut like, mut bracketed, mut over_time) = (0, 0, 0, None);
        for (place, cell) in self.cells.iter().enumerate().filter(|(_, cell)| !cell.is_empty()) {
            let bare = bare_unit(cell);
            let is_known = meant::unit(bare, name(place)).is_some() && !bare.is_empty();
            known += usize::from(is_known);
            like += usize::from(is_known || looks_like_unit(bare) || cell.len() > bare.len());
            bracketed += usize::from(cell.len() > bare.len());
            if is_time(name(place)) {
                over_time = Some(over_time.unwrap_or(true) && (is_known || bracketed > 0 && cell.len() > bare.len()));
            }
        }
        let filled = self.filled();
        let all_in_brackets = bracketed == filled;
        // A single cell under several names is a unit only under a time or in brackets.
        if filled == 1 && names.filled() > 1 && over_time != Some(true) && !all_in_brackets {
            return None;
        }
        let believable =
            all_in_brackets || (over_time != Some(false) && (over_time == Some(true) || 2 * like > filled));
        // Above the names, only a line that consists of units alone.
        let strict = self.line > names.line || (like == filled && (filled >= 2 || all_in_brackets));
        if known == 0 || filled > names.filled() || !believable || !strict {
            return None;
        }
        let share = known as f64 / filled as f64;
        Some(4.0 * share + if over_time == Some(true) { 2.0 } else { 0.0 } + if all_in_brackets { 3.0 } else { 0.0 })
    }

    /// Score of this line as names.
    fn as_names(&self) -> f64 {
        let filled: Vec<&str> = self.cells.iter().copied().filter(|cell| !cell.is_empty()).collect();
        let labels: Vec<label::Label> = filled.iter().map(|cell| label::read(cell)).collect();
        let any = |holds: &dyn Fn(&label::Label) -> bool| labels.iter().any(holds);
        let different = |place: usize| filled.iter().take(place).all(|other| *other != filled[place]);
        let all_different = (0..filled.len()).all(different);
        let has_time = any(&|label| is_time(&label.name));
        let all_runs = filled.iter().all(|cell| run_name::name(cell).is_some());
        let sentence = filled.iter().any(|cell| cell.split_whitespace().count() > 4);
        let numbers = filled.iter().all(|cell| cell.starts_with(|first: char| first.is_ascii_digit()));
        let bracketed = filled.iter().any(|cell| bare_unit(cell).len() < cell.len());
        let score = |holds: bool, points: f64| if holds { points } else { 0.0 };
        score(has_time, 3.0)
            + score(any(&|label| label.unit.is_some()), 3.0)
            + score(all_different, 2.0)
            + score(filled.len() == self.cells.len(), 1.0)
            - score(!all_different && !has_time, 2.0)
            - score(all_runs, 3.0)
            - score(sentence, 2.0)
            - score(numbers, 3.0)
            - score(bracketed, 4.0)
    }
}

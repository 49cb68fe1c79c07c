//! Columns of words that name the sensor, board or run of each row: `1:`, `2:`, `3:`, `1:` …

/// Greatest number of different labels, and greatest length of one in bytes.
const LABELS: usize = 32;
const LONGEST: usize = 40;
/// Least number of rows of each label.
const LEAST: usize = 3;

/// Words of a column, one per row from the first; empty from the row on at which there are too many or none.
#[derive(Debug, Default)]
pub(super) struct Labels {
    names: Vec<String>,
    /// Index of the name of each row.
    rows: Vec<u8>,
    /// True if a row has no word, or there are too many.
    broken: bool,
}

impl Labels {
    /// Adds the word of a row.
    pub fn add(&mut self, row: usize, text: &str) {
        if self.broken {
            return;
        }
        let known = self.names.iter().position(|name| name == text);
        let is_next = row == self.rows.len() && text.len() <= LONGEST;
        let Some(label) = known.or_else(|| (self.names.len() < LABELS).then_some(self.names.len())).filter(|_| is_next)
        else {
            *self = Self { broken: true, ..Self::default() };
            return;
        };
        if known.is_none() {
            self.names.push(text.to_owned());
        }
        self.rows.push(label as u8);
    }

    /// Name and rows of each label, if each of the `times` has one and the labels name runs; else empty.
    ///
    /// They do if the times of all rows do not increase but those of each label do, or if the labels take turns. Two that
    /// take turns must differ in one letter or digit, because states such as *up* and *down* take turns, too.
    pub fn runs(&self, times: &[f64], heading: &str) -> Vec<(String, Vec<usize>)> {
        let count = self.names.len();
        if count < 2 || self.rows.len() != times.len() || times.iter().any(|time| !time.is_finite()) {
            return Vec::new();
        }
        let of_label = |label: usize| (0..times.len()).filter(|row| usize::from(self.rows[*row]) == label).collect();
        let parts: Vec<Vec<usize>> = (0..count).map(of_label).collect();
        let increase = |rows: &[usize]| rows.windows(2).all(|pair| times[pair[1]] > times[pair[0]]);
        let all: Vec<usize> = (0..times.len()).collect();
        let take_turns = || {
            let turn = self.rows.iter().enumerate().all(|(row, label)| usize::from(*label) == row % count);
            turn && (count > 2 || are_alike(&self.names[0], &self.names[1]))
        };
        let divide = if increase(&all) { take_turns() } else { parts.iter().all(|rows| increase(rows)) };
        if !divide || parts.iter().any(|rows| rows.len() < LEAST) {
            return Vec::new();
        }
        self.names.iter().map(|name| run(name, heading)).zip(parts).collect()
    }
}

/// True if two texts differ in one letter or digit.
fn are_alike(one: &str, other: &str) -> bool {
    let differences = one.chars().zip(other.chars()).filter(|(one, other)| one != other).count();
    one.chars().count() == other.chars().count() && differences == 1
}

/// Name of a run from its label and the heading of the column: `kitchen`, `sensor 1`, `Run 1`.
fn run(label: &str, heading: &str) -> String {
    let name = label.trim_end_matches([':', ';', '.', ' ']);
    let is_number = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_digit());
    match (is_number, heading.is_empty()) {
        (true, true) => format!("Run {name}"),
        (true, false) => format!("{heading} {name}"),
        _ if name.is_empty() => label.to_owned(),
        _ => name.to_owned(),
    }
}

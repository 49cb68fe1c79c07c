//! Data that two hand-ins share: equal, shifted, scaled or resampled.
//!
//! Two measurements of the same motion differ by their noise. A copy through a transformation without noise differs by
//! far less. So the residual of one series after the best shift and scale of the other is compared with the noise, which
//! is estimated from differences of high order. Rows can have been left out, and times shifted or scaled.

use super::difference::shortened;
use super::stretched::{Series, TimeMap, maps};
use analysis::reading::read;
use desk::LONGEST_RECORD;
use saved::Item;
use saved::format::Content;
use saved::hand_in::HandIn;
use units::Language;

/// Number of rows from which on two series are compared.
const FEWEST: usize = 8;
/// Number of rows of a series that are compared; the rest is left out.
const MOST_ROWS: usize = 2000;
/// Number of columns of a hand-in that are compared; the rest is left out.
const MOST_CURVES: usize = 40;
/// Largest residual of a copy, as a part of the standard deviation of the noise. Independent measurements have at least 1.
const COPY: f64 = 0.3;
/// Largest step in rows for which a part of the rows is looked for.
const LARGEST_STRIDE: usize = 10;

/// Origin of a measured column.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Source {
    /// A file of data.
    Data,
    /// A simulated measurement, such as a sample of the laboratory.
    Simulated,
    /// A film with this hash.
    Film(String),
}

/// A measured column of a hand-in.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Index of the hand-in in the list.
    pub hand_in: usize,
    /// Name of the record.
    pub record: String,
    /// Name of the column.
    pub column: String,
    source: Source,
    /// Times in seconds or in the unit of the file, and values.
    times: Vec<f64>,
    values: Vec<f64>,
    /// Standard deviation of the noise of the values.
    noise: f64,
}

/// Relation between two copied columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The values are equal.
    Equal,
    /// The values are shifted or scaled.
    Scaled,
    /// One has a part of the rows of the other, possibly shifted or scaled.
    Part,
    /// One is interpolated from the other, possibly shifted or scaled.
    Resampled,
}

/// Two columns with the same data.
#[derive(Clone, Debug)]
pub struct Copied {
    /// Index of the first hand-in, and names of its record and column.
    pub one: (usize, String, String),
    /// Index of the second hand-in, and names of its record and column.
    pub other: (usize, String, String),
    /// Relation between the columns.
    pub relation: Relation,
    /// True if both are simulated, or taken from the same film: a common source and no alarm.
    pub is_common_source: bool,
}

impl Copied {
    /// A sentence with the relation and both places. `name`: name of the hand-in of this index.
    pub fn text(&self, language: Language, name: impl Fn(usize) -> String) -> String {
        let place = |(index, record, column): &(usize, String, String)| {
            format!("{}, {}, {}", name(*index), shortened(record), shortened(column))
        };
        let relation = match self.relation {
            Relation::Equal => language.say("equal data"),
            Relation::Scaled => language.say("the same data, shifted or scaled"),
            Relation::Part => language.say("a part of the same data"),
            Relation::Resampled => language.say("the same data, resampled"),
        };
        let source = match self.is_common_source {
            true => language.say(" (a common source, no alarm)"),
            false => "",
        };
        format!("{relation}{source}: {} = {}", place(&self.one), place(&self.other))
    }
}

impl Curve {
    /// Measured columns of a hand-in, at most 40 with at most 2,000 rows each. `index`: index of the
    /// hand-in in the list.
    pub fn of(index: usize, hand_in: &HandIn) -> Vec<Self> {
        let items: Vec<(&str, Item)> =
            (hand_in.work.items.iter()).filter_map(|(name, text)| Some((name.as_str(), Item::read(text)?.1))).collect();
        let film_of = |name: &str| {
            items.iter().find_map(|(_, item)| match &item.0 {
                Content::Film(film) if film.record.as_deref() == Some(name) => Some(film.hash.clone()),
                _ => None,
            })
        };
        let mut curves = Vec::new();
        for (name, item) in &items {
            let Content::Record(record) = &item.0 else { continue };
            let Ok(contents) = read(record.text.clone().into_bytes(), LONGEST_RECORD) else { continue };
            let source = match film_of(name) {
                Some(hash) => Source::Film(hash),
                None if record.truth.is_some() => Source::Simulated,
                None => Source::Data,
            };
            let table = contents.import.table;
            for column in table.observed_columns() {
                let Some(own) = table.columns.get(column) else { continue };
                let rows = table.times_of(column).iter().zip(&own.values);
                let rows = rows.filter(|(time, value)| time.is_finite() && value.is_finite()).take(MOST_ROWS);
                let (times, values): (Vec<f64>, Vec<f64>) = rows.unzip();
                if values.len() >= FEWEST && curves.len() < MOST_CURVES {
                    let (record, column) = (record.name.clone(), table.label(column));
                    let noise = noise(&values);
                    curves.push(Self { hand_in: index, record, column, source: source.clone(), times, values, noise });
                }
            }
        }
        curves
    }

    fn series(&self) -> Series<'_> {
        Series { times: &self.times, values: &self.values }
    }

    fn place(&self) -> (usize, String, String) {
        (self.hand_in, self.record.clone(), self.column.clone())
    }
}

/// Pairs of columns of different hand-ins that have the same data.
pub fn copies(curves: &[Curve]) -> Vec<Copied> {
    let mut found = Vec::new();
    for (place, one) in curves.iter().enumerate() {
        for other in curves.iter().skip(place + 1).filter(|other| other.hand_in != one.hand_in) {
            found.extend(copied(one, other));
        }
    }
    found
}

/// The two columns if they have the same data.
pub fn copied(one: &Curve, other: &Curve) -> Option<Copied> {
    let relation = relation(one, other)?;
    let is_common_source = one.source == other.source && one.source != Source::Data;
    Some(Copied { one: one.place(), other: other.place(), relation, is_common_source })
}

fn relation(one: &Curve, other: &Curve) -> Option<Relation> {
    if one.values == other.values {
        return Some(Relation::Equal);
    }
    let (longer, shorter) = if one.values.len() >= other.values.len() { (one, other) } else { (other, one) };
    if longer.values.len() == shorter.values.len() && is_copy(&longer.values, &shorter.values, shorter.noise) {
        return Some(Relation::Scaled);
    }
    if has_part(longer, shorter) {
        return Some(Relation::Part);
    }
    (is_resampled(longer, shorter) || is_resampled(shorter, longer)).then_some(Relation::Resampled)
}

/// True if `values` follow from `of`, row by row, by a shift and a scale, much more exactly than the noise allows.
fn is_copy(of: &[f64], values: &[f64], noise: f64) -> bool {
    residual(of, values).is_some_and(|residual| residual <= COPY * noise)
}

/// Root mean square of the residuals of the least-squares line of `values` over `of`; `None` if `of` is constant or too
/// short.
fn residual(of: &[f64], values: &[f64]) -> Option<f64> {
    let n = values.len().min(of.len());
    if n < FEWEST {
        return None;
    }
    let mean = |values: &[f64]| values.iter().take(n).sum::<f64>() / n as f64;
    let (p, q) = (mean(of), mean(values));
    let (mut pp, mut pq, mut qq) = (0.0, 0.0, 0.0);
    for (a, b) in of.iter().zip(values) {
        pp += (a - p) * (a - p);
        pq += (a - p) * (b - q);
        qq += (b - q) * (b - q);
    }
    (pp > 0.0 && qq > 0.0).then(|| ((qq - pq * pq / pp).max(0.0) / n as f64).sqrt())
}

/// True if the shorter column has a part of the rows of the longer one: neighbouring rows, or every second, third ..
fn has_part(longer: &Curve, shorter: &Curve) -> bool {
    let (n, m) = (longer.values.len(), shorter.values.len());
    let strides = 1..=LARGEST_STRIDE.min((n - 1) / (m - 1).max(1));
    strides.into_iter().any(|stride| {
        let first = 0..n - stride * (m - 1);
        first.into_iter().any(|first| {
            let rows = |most: usize| -> Vec<f64> {
                longer.values.iter().skip(first).step_by(stride).take(most).copied().collect()
            };
            is_copy(&rows(FEWEST), shorter.values.get(..FEWEST).unwrap_or_default(), shorter.noise)
                && is_copy(&rows(m), &shorter.values, shorter.noise)
        })
    })
}

/// True if `values` are interpolated from `of`: with equal times, with times that begin together, or with another scale and
/// zero of the times.
fn is_resampled(of: &Curve, values: &Curve) -> bool {
    let begin = |curve: &Curve| curve.times.first().copied().unwrap_or(0.0);
    let shifts = [0.0, begin(of) - begin(values)];
    let shifted = shifts.into_iter().map(|shift| TimeMap { scale: 1.0, shift });
    let (series, own) = (of.series(), values.series());
    let follows = |map: TimeMap| {
        let (mut at, mut read) = (Vec::new(), Vec::new());
        for (time, value) in values.times.iter().zip(&values.values) {
            if let Some((interpolated, _)) = series.interpolated(map.apply(*time)) {
                at.push(interpolated);
                read.push(*value);
            }
        }
        2 * at.len() > values.values.len() && is_copy(&at, &read, values.noise)
    };
    shifted.into_iter().any(follows) || maps(series, own).into_iter().any(follows)
}

/// Standard deviation of the noise of equally spaced values: the smallest estimate from differences of the orders 2 to 8.
/// Differences of order k have the variance of the noise times the binomial coefficient (2k, k). A smooth motion that is sampled
/// coarsely gives too much at low orders.
fn noise(values: &[f64]) -> f64 {
    let mut differences: Vec<f64> = values.to_vec();
    let (mut factor, mut least) = (1.0, f64::INFINITY);
    for order in 1..=8 {
        differences = differences.windows(2).map(|pair| pair[1] - pair[0]).collect();
        if differences.is_empty() {
            break;
        }
        let k = f64::from(order);
        factor *= (2.0 * k) * (2.0 * k - 1.0) / (k * k);
        if order >= 2 {
            let variance = differences.iter().map(|one| one * one).sum::<f64>() / differences.len() as f64;
            least = least.min((variance / factor).sqrt());
        }
    }
    if least.is_finite() { least } else { 0.0 }
}

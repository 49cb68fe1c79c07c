//! A map of times under which one series is interpolated from another: `time of the other = scale * time + shift`.
//!
//! First maps come from the crossings of the mean level, or from both ends of the series. Each is refined by the method of Gauss
//! and Newton, with an unknown scale and zero of the values.

/// Number of rows that take part in the refinement.
const MOST_ROWS: usize = 64;
/// Number of steps of the refinement, and the change of the shift, as a part of the duration, from which on it is finished.
const STEPS: usize = 8;
const SETTLED: f64 = 1e-6;
/// Number of crossings of the other series that the first crossing can belong to.
const MOST_STARTS: usize = 6;
/// Distance from the mean level that a series reaches between two crossings, in standard deviations.
const SWING: f64 = 0.3;

/// Times and values of a series, in the order of time.
#[derive(Clone, Copy)]
pub struct Series<'a> {
    pub times: &'a [f64],
    pub values: &'a [f64],
}

/// A linear map of times.
#[derive(Clone, Copy, Debug)]
pub struct TimeMap {
    pub scale: f64,
    pub shift: f64,
}

impl TimeMap {
    pub fn apply(self, time: f64) -> f64 {
        self.scale * time + self.shift
    }
}

impl Series<'_> {
    /// Linear interpolation of the values, and its slope; `None` outside of the times.
    pub fn interpolated(self, time: f64) -> Option<(f64, f64)> {
        let after = self.times.partition_point(|own| *own < time).max(1);
        let ([p, q], [y, z]) = (
            [*self.times.get(after - 1)?, *self.times.get(after)?],
            [*self.values.get(after - 1)?, *self.values.get(after)?],
        );
        let slope = (z - y) / (q - p);
        // A value at the end of an interval is that of the row, to the bit.
        let value = if time == q { z } else { y + slope * (time - p) };
        (time >= p && slope.is_finite()).then_some((value, slope))
    }

    /// Times at which the values cross their mean upwards or downwards, with the direction.
    fn crossings(self) -> Vec<(f64, bool)> {
        let n = self.values.len() as f64;
        let mean = self.values.iter().sum::<f64>() / n;
        let swing = SWING * (self.values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n).sqrt();
        let (mut side, mut crossed, mut found) = (None, None, Vec::new());
        for (pair, times) in self.values.windows(2).zip(self.times.windows(2)) {
            let [before, after] = [pair[0] - mean, pair[1] - mean];
            if before * after <= 0.0 && before != after {
                crossed = Some(times[0] + (times[1] - times[0]) * before / (before - after));
            }
            if after.abs() > swing {
                let is_above = after > 0.0;
                if side.is_some_and(|side| side != is_above)
                    && let Some(time) = crossed
                {
                    found.push((time, is_above));
                }
                side = Some(is_above);
            }
        }
        found
    }

    fn ends(self) -> Option<[f64; 2]> {
        Some([*self.times.first()?, *self.times.last()?])
    }
}

/// Refined maps from the times of `values` to those of `of`.
pub fn maps(of: Series<'_>, values: Series<'_>) -> Vec<TimeMap> {
    firsts(of, values).into_iter().filter_map(|map| refined(of, values, map)).collect()
}

/// First maps: both ends together, and the crossings from each of the first ones of the other series on.
fn firsts(of: Series<'_>, values: Series<'_>) -> Vec<TimeMap> {
    let mut maps = Vec::new();
    if let (Some([a, b]), Some([c, d])) = (of.ends(), values.ends())
        && d > c
    {
        let scale = (b - a) / (d - c);
        maps.push(TimeMap { scale, shift: a - scale * c });
    }
    let (theirs, own) = (of.crossings(), values.crossings());
    // The values may be upside down, so each crossing can belong to each.
    for start in 0..theirs.len().min(MOST_STARTS) {
        let pairs: Vec<(f64, f64)> = own.iter().zip(&theirs[start..]).map(|(one, other)| (one.0, other.0)).collect();
        maps.extend(line(&pairs));
    }
    maps.retain(|map| map.scale > 0.0 && map.scale.is_finite() && map.shift.is_finite());
    maps
}

/// Line of least squares through points; `None` for fewer than three.
fn line(points: &[(f64, f64)]) -> Option<TimeMap> {
    let n = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0 / n, y + point.1 / n));
    let (xx, xy) = points
        .iter()
        .fold((0.0, 0.0), |(xx, xy), point| (xx + (point.0 - x) * (point.0 - x), xy + (point.0 - x) * (point.1 - y)));
    let scale = xy / xx;
    (points.len() >= 3).then_some(TimeMap { scale, shift: y - scale * x })
}

fn refined(of: Series<'_>, values: Series<'_>, mut map: TimeMap) -> Option<TimeMap> {
    let every = values.times.len().div_ceil(MOST_ROWS).max(1);
    let [begin, end] = values.ends()?;
    let (middle, half) = (0.5 * (begin + end), (0.5 * (end - begin)).max(f64::MIN_POSITIVE));
    for _ in 0..STEPS {
        // Columns: 1, the interpolated value, its derivative by the shift, and by the scale. Then the value.
        let mut sums = [[0.0; 5]; 4];
        for (time, value) in values.times.iter().zip(values.values).step_by(every) {
            let Some((level, slope)) = of.interpolated(map.apply(*time)) else { continue };
            let row = [1.0, level, slope, slope * (time - middle) / half, *value];
            for (sums, one) in sums.iter_mut().zip(row) {
                for (sum, other) in sums.iter_mut().zip(row) {
                    *sum += one * other;
                }
            }
        }
        let [_, factor, shift, stretch] = solved(sums)?;
        let (shift, stretch) = (shift / factor, stretch / factor / half);
        map.scale += stretch;
        map.shift += shift - stretch * middle;
        if shift.abs() + stretch.abs() * half < SETTLED * half {
            break;
        }
    }
    (map.scale > 0.0 && map.scale.is_finite() && map.shift.is_finite()).then_some(map)
}

/// Solution of four linear equations by elimination with pivots; `None` if they are singular.
fn solved(mut rows: [[f64; 5]; 4]) -> Option<[f64; 4]> {
    // Columns of unit length, since values and times have any size.
    let mut sizes = [0.0; 4];
    for (place, size) in sizes.iter_mut().enumerate() {
        *size = rows[place][place].sqrt();
        if !(*size > 0.0 && size.is_finite()) {
            return None;
        }
    }
    for (row, size) in rows.iter_mut().zip(sizes) {
        for (value, other) in row.iter_mut().zip(sizes.into_iter().chain([1.0])) {
            *value /= size * other;
        }
    }
    for place in 0..4 {
        let pivot = (place..4).max_by(|one, other| rows[*one][place].abs().total_cmp(&rows[*other][place].abs()))?;
        rows.swap(place, pivot);
        let own = rows[place];
        if own[place].abs() < 1e-12 {
            return None;
        }
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != place) {
            let factor = row[place] / own[place];
            row.iter_mut().zip(own).for_each(|(value, own)| *value -= factor * own);
        }
    }
    let mut solution = [0.0; 4];
    for (place, value) in solution.iter_mut().enumerate() {
        *value = rows[place][4] / rows[place][place] / sizes[place];
    }
    Some(solution)
}

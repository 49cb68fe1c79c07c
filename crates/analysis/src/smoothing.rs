//! Smoothing polynomials: values and derivatives from a local least-squares fit.

/// Smoothed values, or their derivative, by the method of A. Savitzky and M. J. E. Golay, Anal. Chem. 36, 1627 (1964): in
/// a window of `window` rows about each row a polynomial of this degree is fitted and read at the row. Steps may be uneven
/// (then the fit is made anew for each row, as by P. A. Gorry, Anal. Chem. 63, 534 (1991)). At the ends of the record, and
/// of its parts between long gaps, the window is shifted inwards.
///
/// `derivative` is 0 for the values themselves; the unit is that of the values over that of the times to its power. NaN
/// where the value itself is missing, or where a part has no more rows than the degree asks for. All NaN if `derivative`
/// is greater than `degree`, `degree` greater than 7 or not less than `window`, or the times do not ascend.
pub fn savitzky_golay(times: &[f64], values: &[f64], window: usize, degree: usize, derivative: usize) -> Vec<f64> {
    let mut smooth = vec![f64::NAN; values.len()];
    let rows: Vec<usize> =
        (0..times.len().min(values.len())).filter(|row| times[*row].is_finite() && values[*row].is_finite()).collect();
    let t: Vec<f64> = rows.iter().map(|row| times[*row]).collect();
    let y: Vec<f64> = rows.iter().map(|row| values[*row]).collect();
    let ascends = t.is_sorted_by(|one, other| one < other);
    if derivative > degree || degree > MOST || degree >= window || !ascends || t.len() <= degree {
        return smooth;
    }
    for part in parts(&t) {
        let (start, end) = (part.start, part.end);
        let width = window.min(part.len());
        for place in part {
            // Half a window to each side, shifted at the ends.
            let from = place.saturating_sub(width / 2).clamp(start, end - width);
            let local = from..from + width;
            if let Some(value) = local_fit(&t[local.clone()], &y[local], t[place], degree, derivative) {
                smooth[rows[place]] = value;
            }
        }
    }
    smooth
}

/// The highest degree. Higher ones follow the noise.
const MOST: usize = 7;

/// The rows between gaps; a gap is longer than two and a half usual steps, which a window does not bridge.
fn parts(times: &[f64]) -> Vec<core::ops::Range<usize>> {
    let usual = crate::cycles::median(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
    let mut parts = Vec::new();
    let mut start = 0;
    for (index, pair) in times.windows(2).enumerate() {
        if pair[1] - pair[0] > 2.5 * usual {
            parts.push(start..index + 1);
            start = index + 1;
        }
    }
    parts.push(start..times.len());
    parts
}

/// The derivative at `time` of the polynomial through these points. The monomials are made orthogonal (Gram and Schmidt,
/// twice for the last digits) so that even a high degree is well determined.
fn local_fit(times: &[f64], values: &[f64], time: f64, degree: usize, derivative: usize) -> Option<f64> {
    let (first, last) = (times.first()?, times.last()?);
    let scale = (last - first) / 2.0;
    let x: Vec<f64> = times.iter().map(|t| (t - time) / scale).collect();
    let mut result = 0.0;
    // Each orthogonal polynomial: its values at the points, and its coefficients in powers of x.
    let mut basis: Vec<(Vec<f64>, [f64; MOST + 1])> = Vec::with_capacity(degree + 1);
    if times.len() <= degree {
        return None;
    }
    for power in 0..=degree {
        let mut column: Vec<f64> = match basis.last() {
            Some((before, _)) => before.iter().zip(&x).map(|(value, x)| value * x).collect(),
            None => vec![1.0; x.len()],
        };
        let mut coefficients = [0.0; MOST + 1];
        match basis.last() {
            Some((_, before)) => coefficients[1..=power].copy_from_slice(&before[..power]),
            None => coefficients[0] = 1.0,
        }
        for _ in 0..2 {
            for (other, its) in &basis {
                let product: f64 = column.iter().zip(other).map(|(one, other)| one * other).sum();
                column.iter_mut().zip(other).for_each(|(one, other)| *one -= product * other);
                coefficients.iter_mut().zip(its).for_each(|(one, other)| *one -= product * other);
            }
        }
        let norm = column.iter().map(|value| value * value).sum::<f64>().sqrt();
        if norm < 1e-12 {
            return None;
        }
        column.iter_mut().for_each(|value| *value /= norm);
        coefficients.iter_mut().for_each(|value| *value /= norm);
        let share: f64 = column.iter().zip(values).map(|(one, value)| one * value).sum();
        result += share * coefficients[derivative];
        basis.push((column, coefficients));
    }
    // The derivative of x^k at 0 is k!; x counts in half windows.
    for factor in 1..=derivative {
        result *= factor as f64 / scale;
    }
    Some(result)
}

//! Smoothing by local least-squares polynomials: values and derivatives.

/// Greatest number of rows of a window. A wider one flattens the signal, and is slow if steps are uneven.
pub const WIDEST: usize = 501;

/// Smoothed values, or their derivative, by the method of A. Savitzky and M. J. E. Golay, Anal. Chem. 36, 1627 (1964): a
/// polynomial of this degree is fitted to `window` rows about each row and evaluated at the row. For uneven steps, each row
/// has its own fit (P. A. Gorry, Anal. Chem. 63, 534 (1991)); for even steps, all rows at the same place of their window
/// share the weights. At the ends of the record, and of its parts between long gaps, the window is shifted inwards.
///
/// `derivative` is 0 for the values themselves; the unit is that of the values over that of the times to this power. NaN
/// where the value itself is missing, or where a part has no more rows than the degree. All NaN if `derivative` is greater
/// than `degree`, `degree` greater than 7 or not less than `window`, `window` greater than [`WIDEST`], or the times do not
/// ascend.
pub fn savitzky_golay(times: &[f64], values: &[f64], window: usize, degree: usize, derivative: usize) -> Vec<f64> {
    let mut smooth = vec![f64::NAN; values.len()];
    let rows: Vec<usize> =
        (0..times.len().min(values.len())).filter(|row| times[*row].is_finite() && values[*row].is_finite()).collect();
    let t: Vec<f64> = rows.iter().map(|row| times[*row]).collect();
    let y: Vec<f64> = rows.iter().map(|row| values[*row]).collect();
    let ascends = t.is_sorted_by(|one, other| one < other);
    if derivative > degree || degree > MOST || degree >= window || window > WIDEST || !ascends || t.len() <= degree {
        return smooth;
    }
    for part in parts(&t) {
        let (start, end) = (part.start, part.end);
        let width = window.min(part.len());
        let even = is_even(&t[part.clone()]);
        // Weights of the last window, with the index in it at which they are evaluated.
        let mut known: Option<(usize, Vec<f64>)> = None;
        for place in part {
            // Half a window on each side, shifted at the ends.
            let from = place.saturating_sub(width / 2).clamp(start, end - width);
            if !even || known.as_ref().is_none_or(|(offset, _)| *offset != place - from) {
                let weights = weights(&t[from..from + width], t[place], degree, derivative);
                known = weights.map(|weights| (place - from, weights));
            }
            if let Some((_, weights)) = &known {
                smooth[rows[place]] = weights.iter().zip(&y[from..]).map(|(weight, value)| weight * value).sum();
            }
        }
    }
    smooth
}

/// Greatest degree; higher ones follow the noise.
const MOST: usize = 7;

/// True if all times are even to 1e-6 of a step.
fn is_even(times: &[f64]) -> bool {
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return true };
    let step = (last - first) / (times.len() - 1).max(1) as f64;
    times.iter().zip(0_u32..).all(|(time, row)| (time - first - f64::from(row) * step).abs() <= 1e-6 * step)
}

/// Ranges of rows between gaps; a gap is a step longer than 2.5 median steps.
fn parts(times: &[f64]) -> Vec<core::ops::Range<usize>> {
    let usual = units::order::median(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
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

/// Weights of the values at these times for the derivative at `time` of the polynomial through them. The monomials are made
/// orthogonal (Gram-Schmidt, repeated once for accuracy), so that even a high degree is well conditioned.
pub(crate) fn weights(times: &[f64], time: f64, degree: usize, derivative: usize) -> Option<Vec<f64>> {
    let (first, last) = (times.first()?, times.last()?);
    let scale = (last - first) / 2.0;
    let x: Vec<f64> = times.iter().map(|t| (t - time) / scale).collect();
    let mut weights = vec![0.0; x.len()];
    // For each orthogonal polynomial, its values at the points and its coefficients in powers of x.
    let mut basis: Vec<(Vec<f64>, [f64; MOST + 1])> = Vec::with_capacity(degree + 1);
    if times.len() <= degree {
        return None;
    }
    // The derivative of order k of x^k at 0 is k!; x is in units of half a window.
    let factor = (1..=derivative).fold(1.0, |product, factor| product * factor as f64 / scale);
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
        let part = factor * coefficients[derivative];
        weights.iter_mut().zip(&column).for_each(|(weight, value)| *weight += part * value);
        basis.push((column, coefficients));
    }
    Some(weights)
}

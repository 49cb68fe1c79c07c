//! Rows that repeat the value before: a film that was converted to a higher frame rate, or a sensor slower than its logger.

/// Least number of repeats for a pattern.
const LEAST: usize = 5;
/// Least median of the steps around repeats, in the smallest step. Below it the values are rounded.
const ROUNDED: f64 = 4.0;

/// Indices of the rows that repeat the value of the row before, ascending; empty unless they follow a pattern.
///
/// A film of rate `a` written at rate `b` repeats rows at distances that differ by at most one. Rounded values and turning
/// points repeat values, too: there the steps around are small, or change their sign.
pub(crate) fn repeats(values: &[f64]) -> Vec<usize> {
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let repeats: Vec<usize> = (0..steps.len()).filter(|at| steps[*at] == 0.0).map(|at| at + 1).collect();
    let gaps: Vec<usize> = repeats.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (Some(least), Some(most)) = (gaps.iter().min(), gaps.iter().max()) else { return Vec::new() };
    let covers = repeats[0] <= *most && values.len() - repeats[repeats.len() - 1] <= *most;
    if repeats.len() < LEAST || !covers || most - least > 1 || *most == 1 {
        return Vec::new();
    }
    let moving = |step: &&f64| step.is_finite() && **step != 0.0;
    let smallest = steps.iter().filter(moving).fold(f64::INFINITY, |least, step| least.min(step.abs()));
    let mut around = Vec::with_capacity(repeats.len());
    let mut onward = 0;
    for repeat in &repeats {
        let before = steps[..repeat - 1].iter().rev().find(moving);
        let after = steps[*repeat..].iter().find(moving);
        let (Some(before), Some(after)) = (before, after) else { continue };
        around.push(before.abs().max(after.abs()));
        onward += usize::from(before * after > 0.0);
    }
    let usual = units::order::median(around);
    if 2 * onward > repeats.len() && usual >= ROUNDED * smallest { repeats } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::repeats;

    /// Row `frame` of a swing filmed at `rate` and written at `written` frames per second, rounded to `digits`.
    fn film(rate: usize, written: usize, digits: i32) -> Vec<f64> {
        let scale = libm::pow(10.0, f64::from(digits));
        let swing = |picture: usize| (30.0 * libm::cos(4.1 * picture as f64 / rate as f64) * scale).round() / scale;
        (0..150).map(|frame| swing(frame * rate / written)).collect()
    }

    #[test]
    fn resampled_films_are_noticed() {
        for (rate, written) in [(27, 30), (24, 30), (25, 30), (25, 50), (24, 60), (15, 30), (29, 30)] {
            for digits in [2, 4, 12] {
                let found = repeats(&film(rate, written, digits));
                let expected: Vec<usize> =
                    (1..150).filter(|row| row * rate / written == (row - 1) * rate / written).collect();
                let expected = if expected.len() < 5 { Vec::new() } else { expected };
                assert_eq!(found, expected, "{rate} at {written}, {digits} digits");
            }
        }
    }

    #[test]
    fn other_equal_values_are_none() {
        let series = |value: &dyn Fn(f64) -> f64| -> Vec<f64> { (0..150).map(|row| value(f64::from(row))).collect() };
        for (name, values) in [
            ("rest", series(&|_| 3.0)),
            ("ramp in whole numbers", series(&|row| (row / 2.0).floor())),
            ("slow ramp", series(&|row| (row * 0.9).round())),
            ("cooling to a tenth", series(&|row| (600.0 * libm::exp(-row / 80.0)).round() / 10.0)),
            (
                "rows on both sides of a turning point",
                series(&|row| (100.0 * libm::cos((row + 0.5) * std::f64::consts::PI / 10.0)).round()),
            ),
            ("square", series(&|row| if (row / 10.0) as i32 % 2 == 0 { 1.0 } else { -1.0 })),
            ("swing", film(30, 30, 3)),
        ] {
            assert!(repeats(&values).is_empty(), "{name}");
        }
    }
}

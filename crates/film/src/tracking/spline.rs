//! Cubic B-splines on whole numbers.

/// Values of the four nonzero cubic B-splines at the fraction `f` between two knots, the leftmost first.
///
/// Unser, *IEEE Signal Process. Mag.* 16 (1999) 22.
pub(crate) fn values(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    let inner = |f: f64, g: f64| (4.0 - 3.0 * f * f * (1.0 + g)) / 6.0;
    [g * g * g / 6.0, inner(f, g), inner(g, f), f * f * f / 6.0]
}

/// Derivatives of [`values`].
pub(crate) fn slopes(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    [-g * g / 2.0, f * (3.0 * f - 4.0) / 2.0, -g * (3.0 * g - 4.0) / 2.0, f * f / 2.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_splines_add_up_to_one_and_their_slopes_to_zero() {
        for k in 0..=10 {
            let f = f64::from(k) / 10.0;
            assert!((values(f).iter().sum::<f64>() - 1.0).abs() < 1e-15, "{f}");
            assert!(slopes(f).iter().sum::<f64>().abs() < 1e-15, "{f}");
        }
    }

    #[test]
    fn the_slopes_are_those_of_the_values() {
        let (f, h) = (0.3, 1e-6);
        for k in 0..4 {
            let difference = (values(f + h)[k] - values(f - h)[k]) / (2.0 * h);
            assert!((slopes(f)[k] - difference).abs() < 1e-9, "{k}");
        }
    }
}

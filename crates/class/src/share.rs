//! Shares of persons or groups, with their intervals.

use units::say;

/// Quantile of the normal distribution for an interval of 95 %.
const QUANTILE: f64 = 1.959_963_984_540_054;

/// A number of persons or groups out of all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// Number that it is about.
    pub count: usize,
    /// Number of all.
    pub of: usize,
}

impl Share {
    /// The share, 0 to 1; NaN of none.
    pub fn value(self) -> f64 {
        self.count as f64 / self.of as f64
    }

    /// Interval of the share that holds with a probability of 95 % (E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209); 0 to 1
    /// of none.
    pub fn interval(self) -> (f64, f64) {
        if self.of == 0 {
            return (0.0, 1.0);
        }
        let (n, share, squared) = (self.of as f64, self.value(), QUANTILE * QUANTILE);
        let middle = (share + squared / (2.0 * n)) / (1.0 + squared / n);
        let reach = QUANTILE / (1.0 + squared / n) * (share * (1.0 - share) / n + squared / (4.0 * n * n)).sqrt();
        ((middle - reach).max(0.0), (middle + reach).min(1.0))
    }

    /// The share with its interval and number: `90 % (60 to 98 %, n = 10)`.
    pub fn text(self, language: units::Language) -> String {
        if self.of == 0 {
            return "n = 0".to_owned();
        }
        let percent = |part: f64| libm::round(100.0 * part);
        let ((low, high), n) = (self.interval(), self.of);
        let (low, high, share) = (percent(low), percent(high), percent(self.value()));
        say!(language, "{share} % ({low} to {high} %, n = {n})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Wilson's interval of 90 % of 10, 20 and 40: 60-98, 70-97 and 77-96 %.
    #[test]
    fn intervals_are_those_of_wilson() {
        for (count, of, expected) in [
            (9, 10, "90 % (60 to 98 %, n = 10)"),
            (18, 20, "90 % (70 to 97 %, n = 20)"),
            (36, 40, "90 % (77 to 96 %, n = 40)"),
            (0, 5, "0 % (0 to 43 %, n = 5)"),
            (5, 5, "100 % (57 to 100 %, n = 5)"),
            (0, 0, "n = 0"),
        ] {
            assert_eq!(Share { count, of }.text(units::Language::English), expected);
        }
    }
}

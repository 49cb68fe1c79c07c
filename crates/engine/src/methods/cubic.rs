//! Cubic Hermite polynomial on the interval from 0 to 1: values, range and zeros.

/// Value at `part` of an interval, 0 to 1, of the cubic with these values and slopes (per interval) at its ends: the interpolant of a
/// state within a step of a fixed-step method.
#[inline(always)]
pub fn cubic_value(values: [f64; 2], slopes: [f64; 2], part: f64) -> f64 {
    Cubic::new(values, slopes).at(part)
}

/// A cubic polynomial on the interval from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cubic {
    start: f64,
    change: f64,
    leaving: f64,
    arriving: f64,
}

impl Cubic {
    /// Cubic with these values and slopes at 0 and 1, in the units of one state or condition. A slope that is not finite is replaced by that of the straight
    /// line.
    #[inline(always)]
    pub fn new(values: [f64; 2], slopes: [f64; 2]) -> Self {
        let change = values[1] - values[0];
        let [leaving, arriving] = slopes.map(|slope| if slope.is_finite() { slope } else { change });
        Self { start: values[0], change, leaving, arriving }
    }

    /// Value at `part` of the interval, 0 to 1.
    #[inline(always)]
    pub fn at(&self, part: f64) -> f64 {
        let rest = 1.0 - part;
        let bend = rest * (self.leaving - self.change) - part * (self.arriving - self.change);
        self.start + part * (self.change + rest * bend)
    }

    /// The ends and the extrema between them, ascending, with their number.
    fn knots(&self) -> ([f64; 4], usize) {
        // Derivative: slope + 2 second p + 3 third p^2
        let slope = self.leaving;
        let second = 3.0 * self.change - 2.0 * self.leaving - self.arriving;
        let third = 3.0 * (self.leaving + self.arriving - 2.0 * self.change);
        let (mut knots, mut count) = ([0.0; 4], 1);
        let root = (second * second - third * slope).sqrt();
        if root >= 0.0 {
            let product = -(second + if second < 0.0 { -root } else { root });
            let (one, other) = (slope / product, product / third);
            for turn in [one.min(other), one.max(other)] {
                if turn > 0.0 && turn < 1.0 {
                    knots[count] = turn;
                    count += 1;
                }
            }
        }
        knots[count] = 1.0;
        (knots, count + 1)
    }

    /// Minimum and maximum on the interval, in the unit of the values.
    pub fn range(&self) -> (f64, f64) {
        let (knots, count) = self.knots();
        let values = knots.iter().take(count).map(|&knot| self.at(knot));
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    }

    /// Calls `found` with each change of sign, ascending; zero counts as positive.
    pub fn zeros(&self, mut found: impl FnMut(f64)) {
        let (knots, count) = self.knots();
        for pair in knots[..count].windows(2) {
            let &[mut low, mut high] = pair else { continue };
            let negative = self.at(low) < 0.0;
            if (self.at(high) < 0.0) == negative {
                continue;
            }
            for _ in 0..Self::HALVINGS {
                let middle = 0.5 * (low + high);
                if (self.at(middle) < 0.0) == negative { low = middle } else { high = middle }
            }
            found(high);
        }
    }

    /// Number of changes of sign; zero counts as positive.
    pub fn sign_changes(&self) -> usize {
        let (knots, count) = self.knots();
        let negative = |knot: f64| self.at(knot) < 0.0;
        knots[..count].windows(2).filter(|pair| negative(pair[0]) != negative(pair[1])).count()
    }

    /// Number of bisections: accuracy 1e-9 of the interval.
    const HALVINGS: usize = 30;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (p - 0.25) (p - 0.5) (p - 0.75), and a parabola that touches zero or does not.
    #[test]
    fn zeros_and_range() {
        let cubic = |p: f64| (p - 0.25) * (p - 0.5) * (p - 0.75);
        let slope = |p: f64| (p - 0.5) * (p - 0.75) + (p - 0.25) * (p - 0.75) + (p - 0.25) * (p - 0.5);
        let found = Cubic::new([cubic(0.0), cubic(1.0)], [slope(0.0), slope(1.0)]);
        let mut zeros = Vec::new();
        found.zeros(|zero| zeros.push(zero));
        assert_eq!(zeros.len(), 3);
        for (zero, expected) in zeros.iter().zip([0.25, 0.5, 0.75]) {
            assert!((zero - expected).abs() < 1e-8, "{zero}");
        }
        // 4 (p - 0.3)^2 + low
        for (low, count) in [(-0.01, 2), (0.01, 0)] {
            let parabola = Cubic::new([0.36 + low, 1.96 + low], [-2.4, 5.6]);
            let mut zeros = 0;
            parabola.zeros(|_| zeros += 1);
            assert_eq!(zeros, count);
            let (least, greatest) = parabola.range();
            assert!((least - low).abs() < 1e-15 && (greatest - 1.96 - low).abs() < 1e-15);
        }
        assert_eq!(Cubic::new([1.0, 3.0], [f64::NAN, f64::INFINITY]).at(0.5), 2.0);
    }
}

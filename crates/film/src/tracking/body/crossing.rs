//! The motion through a meeting of two bodies: one smooth curve through the positions before and after.

use crate::tracking::linear::solve;

/// Time in s and position in px.
pub(super) type Place = (f64, [f64; 2]);

/// Number of coefficients with many positions, and with few.
const MANY: usize = 6;
const FEW: usize = 4;

/// Polynomial by least squares through positions before and after a meeting: a quintic, or a cubic through few.
pub(super) struct Curve {
    /// Middle of the times and half their range, s.
    time: [f64; 2],
    /// Coefficients of both coordinates, for times relative to the middle in units of half the range.
    coefficients: [[f64; MANY]; 2],
    /// Scatter of the positions about the curve along a coordinate, px.
    pub scatter: f64,
}

impl Curve {
    /// `None` if there are fewer than three positions on a side, or their times coincide.
    pub(super) fn through(before: &[Place], after: &[Place]) -> Option<Curve> {
        match before.len().min(after.len()) {
            ..3 => None,
            3 | 4 => Curve::of::<FEW>(before, after),
            _ => Curve::of::<MANY>(before, after),
        }
    }

    fn of<const TERMS: usize>(before: &[Place], after: &[Place]) -> Option<Curve> {
        let (first, last) = (before.first()?.0, after.last()?.0);
        let time = [(first + last) / 2.0, (last - first).abs() / 2.0];
        let mut curve = Curve { time, coefficients: [[0.0; MANY]; 2], scatter: 0.0 };
        let all = || before.iter().chain(after);
        let mut matrix = [[0.0; TERMS]; TERMS];
        let mut sides = [[0.0; TERMS]; 2];
        for (time, position) in all() {
            let terms = curve.terms(*time);
            for (row, term) in terms.iter().enumerate().take(TERMS) {
                matrix[row].iter_mut().zip(terms).for_each(|(sum, other)| *sum += term * other);
                sides.iter_mut().zip(position).for_each(|(side, part)| side[row] += term * part);
            }
        }
        for (coefficients, side) in curve.coefficients.iter_mut().zip(sides) {
            coefficients.iter_mut().zip(solve(matrix, side)?.0).for_each(|(to, from)| *to = from);
        }
        let squares: f64 = all().map(|(time, position)| curve.off(*time, *position)).map(|off| off * off).sum();
        let freedom = 2 * (before.len() + after.len()).saturating_sub(TERMS);
        curve.scatter = (squares / freedom.max(1) as f64).sqrt();
        Some(curve)
    }

    /// Powers of a time.
    fn terms(&self, time: f64) -> [f64; MANY] {
        let t = (time - self.time[0]) / self.time[1];
        let mut terms = [1.0; MANY];
        (1..MANY).for_each(|k| terms[k] = terms[k - 1] * t);
        terms
    }

    /// Position at a time, px.
    pub(super) fn at(&self, time: f64) -> [f64; 2] {
        let terms = self.terms(time);
        self.coefficients.map(|line| line.iter().zip(terms).map(|(coefficient, term)| coefficient * term).sum())
    }

    /// Distance of a position from the curve, px.
    pub(super) fn off(&self, time: f64, [x, y]: [f64; 2]) -> f64 {
        let [u, v] = self.at(time);
        libm::hypot(x - u, y - v)
    }
}

//! The motion through a meeting of two bodies: one smooth curve through the positions before and after.

use crate::tracking::linear::solve;

/// Time in s and position in px.
pub(crate) type Place = (f64, [f64; 2]);

/// Number of coefficients with many positions, and with few.
const MANY: usize = 10;
const SOME: usize = 8;
const FEW: usize = 6;
const FEWEST: usize = 4;
/// Number of positions on each side of a curve that follows them closely.
pub(crate) const CLOSE: usize = 4;

/// Polynomial by least squares through positions before and after a meeting, of the degree that their number allows.
pub(crate) struct Curve {
    /// Middle of the times and half their range, s.
    time: [f64; 2],
    /// Coefficients of both coordinates, for times relative to the middle in units of half the range.
    coefficients: [[f64; MANY]; 2],
    /// Number of coordinates less that of coefficients.
    pub freedom: f64,
    /// Scatter of the positions about the curve along a coordinate, px.
    pub scatter: f64,
}

impl Curve {
    /// `None` if there are fewer than three positions on a side, or their times coincide.
    pub(crate) fn through(before: &[Place], after: &[Place]) -> Option<Curve> {
        let sides = [before, after].concat();
        match before.len().min(after.len()) {
            ..3 => None,
            3 | 4 => Curve::of::<FEWEST>(&sides),
            5..8 => Curve::of::<FEW>(&sides),
            8..12 => Curve::of::<SOME>(&sides),
            _ => Curve::of::<MANY>(&sides),
        }
    }

    /// Curve through four positions or more on each side that follows them closely, for a motion that turns between them. `None` with fewer.
    pub(crate) fn close(before: &[Place], after: &[Place]) -> Option<Curve> {
        if before.len().min(after.len()) < CLOSE { None } else { Curve::of::<FEW>(&[before, after].concat()) }
    }

    fn of<const TERMS: usize>(sides: &[Place]) -> Option<Curve> {
        let (first, last) = (sides.first()?.0, sides.last()?.0);
        let time = [(first + last) / 2.0, (last - first).abs() / 2.0];
        let mut curve = Curve { time, coefficients: [[0.0; MANY]; 2], freedom: 0.0, scatter: 0.0 };
        let mut matrix = [[0.0; TERMS]; TERMS];
        let mut products = [[0.0; TERMS]; 2];
        for (time, position) in sides {
            let terms = curve.terms(*time);
            for (row, term) in terms.iter().enumerate().take(TERMS) {
                matrix[row].iter_mut().zip(terms).for_each(|(sum, other)| *sum += term * other);
                products.iter_mut().zip(position).for_each(|(side, part)| side[row] += term * part);
            }
        }
        for (coefficients, side) in curve.coefficients.iter_mut().zip(products) {
            coefficients.iter_mut().zip(solve(matrix, side)?.0).for_each(|(to, from)| *to = from);
        }
        let squares: f64 = sides.iter().map(|(time, position)| curve.off(*time, *position)).map(|off| off * off).sum();
        curve.freedom = 2.0 * sides.len().saturating_sub(TERMS).max(1) as f64;
        curve.scatter = (squares / curve.freedom).sqrt();
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
    pub(crate) fn at(&self, time: f64) -> [f64; 2] {
        let terms = self.terms(time);
        self.coefficients.map(|line| line.iter().zip(terms).map(|(coefficient, term)| coefficient * term).sum())
    }

    /// Distance of a position from the curve, px.
    pub(crate) fn off(&self, time: f64, [x, y]: [f64; 2]) -> f64 {
        let [u, v] = self.at(time);
        libm::hypot(x - u, y - v)
    }
}

//! Functions given by a table: piecewise polynomials.
//!
//! An [`Interpolation`] is a polynomial between each two points. It is computed in two nodes: `Node::Piece`, the number of
//! the piece in which the argument lies, which changes at the points as a `floor` does, so that steps end there; and
//! `Node::Interpolated`, the value of that piece, which is smooth.

use serde::{Deserialize, Serialize};

/// Kind of interpolation between the points of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Course {
    /// `table`: linear.
    Linear,
    /// `smooth table`: cubics without overshoot.
    Smooth,
    /// `steps table`: the value of each point up to the next.
    Steps,
}

/// Relation of an interpolation to a curve drawn by the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct OfDrawing {
    /// Index in [`crate::Model::tables`].
    pub table: u32,
    /// Order of the derivative of the curve; 0 for the curve itself.
    pub derivative: u32,
}

/// A piecewise polynomial of one number x. There is a polynomial between each two neighbouring knots, before the first knot
/// and after the last; those of a table are constant outside its points.
///
/// It is evaluated in two steps, so that steps of integration can end at the knots: first the index of the piece in which x
/// lies, which changes at the knots only, then the value of that piece at x, which is smooth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interpolation {
    /// Ends of the pieces, strictly ascending.
    knots: Vec<f64>,
    /// Coefficients of the pieces, from power 0 to power 3 of the distance from the knot at which the piece begins. The
    /// first piece, before the first knot, uses the distance from the first knot.
    pieces: Vec<[f64; 4]>,
    /// Lowest order of derivative that is discontinuous at the knots: 0 if the value jumps, 1 if the slope does.
    smoothness: u32,
    /// Relation to a curve drawn by the reader, if there is one: the points are then not known in advance.
    drawing: Option<OfDrawing>,
}

impl Interpolation {
    /// Interpolation through points of a table. `None` if x does not strictly increase or a number is not finite.
    pub fn through_points(course: Course, points: &[[f64; 2]]) -> Option<Self> {
        match course {
            Course::Linear => Self::linear(points),
            Course::Smooth => Self::smooth(points),
            Course::Steps => Self::steps(points),
        }
    }

    /// This function, marked as the curve drawn by the reader for this table.
    pub fn drawn(self, table: u32) -> Self {
        Self { drawing: Some(OfDrawing { table, derivative: 0 }), ..self }
    }

    /// Relation to a curve drawn by the reader, if there is one.
    pub fn drawing(&self) -> Option<OfDrawing> {
        self.drawing
    }

    /// Piecewise constant: the value of each point up to the next. `None` if x does not strictly increase or a number is
    /// not finite.
    pub fn steps(points: &[[f64; 2]]) -> Option<Self> {
        Self::through(points, 0, |piece| [piece.from, 0.0, 0.0, 0.0])
    }

    /// Piecewise linear through the points (argument and value, SI). `None` as for [`Self::steps`].
    pub fn linear(points: &[[f64; 2]]) -> Option<Self> {
        Self::through(points, 1, |piece| [piece.from, (piece.to - piece.from) / piece.size, 0.0, 0.0])
    }

    /// Monotone cubic interpolation with a continuous slope, without overshoot: F. N. Fritsch & J. Butland, A method for
    /// constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984) 300; at the ends the
    /// parabola through three points (C. Moler, Numerical Computing with MATLAB, section 3.6). `None` as for
    /// [`Self::steps`].
    pub fn smooth(points: &[[f64; 2]]) -> Option<Self> {
        let slopes = slopes(points);
        Self::through(points, 2, |piece| {
            let secant = (piece.to - piece.from) / piece.size;
            let [start, end] =
                [piece.number, piece.number + 1].map(|point| slopes.get(point).copied().unwrap_or(secant));
            let square = (3.0 * secant - 2.0 * start - end) / piece.size;
            [piece.from, start, square, (start + end - 2.0 * secant) / (piece.size * piece.size)]
        })
    }

    fn through(points: &[[f64; 2]], smoothness: u32, between: impl Fn(&Piece) -> [f64; 4]) -> Option<Self> {
        let [first, last] = [points.first()?, points.last()?].map(|point| [point[1], 0.0, 0.0, 0.0]);
        let inner = points.windows(2).enumerate().map(|(number, pair)| {
            let size = pair[1][0] - pair[0][0];
            between(&Piece { number, size, from: pair[0][1], to: pair[1][1] })
        });
        let pieces = std::iter::once(first).chain(inner).chain([last]).collect();
        let knots = points.iter().map(|point| point[0]).collect();
        Some(Self { knots, pieces, smoothness, drawing: None }).filter(Self::is_sound)
    }

    /// True if knots and coefficients are finite and consistent.
    pub(super) fn is_sound(&self) -> bool {
        let finite = self.knots.iter().chain(self.pieces.iter().flatten()).all(|number| number.is_finite());
        let increase = self.knots.windows(2).all(|pair| pair[0] < pair[1]);
        finite && increase && !self.knots.is_empty() && self.pieces.len() == self.knots.len() + 1
    }

    /// Ends of the pieces, strictly ascending.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Coefficients of the pieces, one more than knots: from power 0 to power 3 of the distance from the knot at which the
    /// piece begins, and from the first knot for the first piece.
    pub fn pieces(&self) -> &[[f64; 4]] {
        &self.pieces
    }

    /// Index of the piece in which `x` lies: 0 before the first knot, one more from each knot on. NaN for NaN.
    #[inline]
    pub fn piece(&self, x: f64) -> f64 {
        if x.is_nan() { x } else { self.knots.partition_point(|&knot| knot <= x) as f64 }
    }

    /// Value at `x` of the polynomial of a piece, even if `x` lies in another piece.
    #[inline]
    pub fn value(&self, x: f64, piece: f64) -> f64 {
        if piece.is_nan() {
            return piece;
        }
        let piece = (piece.max(0.0) as usize).min(self.knots.len());
        let (begin, [a, b, c, d]) = (self.knots[piece.saturating_sub(1)], self.pieces[piece]);
        let distance = x - begin;
        // Avoids infinity times 0, which is NaN.
        if b == 0.0 && c == 0.0 && d == 0.0 { a } else { a + distance * (b + distance * (c + distance * d)) }
    }

    /// Domain: from the first knot to the last. For steps, whose last value holds for ever, it ends at infinity.
    pub fn range(&self) -> [f64; 2] {
        let [first, last] = [self.knots.first(), self.knots.last()].map(|knot| knot.copied().unwrap_or(f64::NAN));
        if self.smoothness == 0 { [first, f64::INFINITY] } else { [first, last] }
    }

    /// Lowest order of derivative that is discontinuous at the knots: 0 if the value jumps, 1 if the slope does.
    pub fn smoothness(&self) -> u32 {
        self.smoothness
    }

    /// The derivative of each piece, with the same knots.
    pub fn derivative(&self) -> Self {
        let pieces = self.pieces.iter().map(|[_, b, c, d]| [*b, 2.0 * c, 3.0 * d, 0.0]).collect();
        let drawing = self.drawing.map(|own| OfDrawing { derivative: own.derivative.saturating_add(1), ..own });
        Self { knots: self.knots.clone(), pieces, smoothness: self.smoothness.saturating_sub(1), drawing }
    }

    /// A function with the same pieces and its zeros at the knots. It changes its sign at each knot, with a continuous
    /// slope of magnitude 1.
    pub fn zeros(&self) -> Self {
        let sizes = self.knots.windows(2).map(|pair| pair[1] - pair[0]);
        let mut sign = -1.0;
        let mut pieces = vec![[0.0, 1.0, 0.0, 0.0]];
        for size in sizes {
            sign = -sign;
            pieces.push([0.0, sign, -sign / size, 0.0]);
        }
        pieces.push([0.0, -sign, 0.0, 0.0]);
        Self { knots: self.knots.clone(), pieces, smoothness: 2, drawing: None }
    }
}

/// Interval between two points of a table.
struct Piece {
    /// Index of the first point.
    number: usize,
    /// Distance of the points in x.
    size: f64,
    /// Value at the first point.
    from: f64,
    /// Value at the second point.
    to: f64,
}

/// Slopes at the points, one per point.
fn slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let pieces: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| (pair[1][0] - pair[0][0], (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0])))
        .collect();
    let (Some(&first), Some(&last)) = (pieces.first(), pieces.last()) else { return vec![0.0; points.len()] };
    let inner = pieces.windows(2).map(|pair| {
        let [(before, falling), (after, rising)] = [pair[0], pair[1]];
        if falling * rising <= 0.0 {
            return 0.0;
        }
        let (w, v) = (2.0 * after + before, after + 2.0 * before);
        (w + v) / (w / falling + v / rising)
    });
    let second = pieces.get(1).copied().unwrap_or(first);
    let before_last = pieces.len().checked_sub(2).and_then(|place| pieces.get(place)).copied().unwrap_or(last);
    std::iter::once(slope_at_end(first, second)).chain(inner).chain([slope_at_end(last, before_last)]).collect()
}

/// Slope at an end, from size and slope of the piece there and of the next one.
fn slope_at_end((size, slope): (f64, f64), (next_size, next_slope): (f64, f64)) -> f64 {
    let parabola = ((2.0 * size + next_size) * slope - size * next_slope) / (size + next_size);
    if parabola * slope <= 0.0 {
        0.0
    } else if slope * next_slope <= 0.0 && parabola.abs() > 3.0 * slope.abs() {
        3.0 * slope
    } else {
        parabola
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 1.0], [2.0, 4.0], [4.0, 3.0], [5.0, 3.0]];

    fn at(table: &Interpolation, x: f64) -> f64 {
        table.value(x, table.piece(x))
    }

    #[test]
    fn each_kind_goes_through_its_points_and_keeps_the_last_values() {
        for kind in [Interpolation::steps, Interpolation::linear, Interpolation::smooth] {
            let table = kind(&POINTS).expect("the points increase");
            for [x, y] in POINTS {
                assert_eq!(at(&table, x), y);
            }
            assert_eq!([at(&table, -1e300), at(&table, f64::NEG_INFINITY), at(&table, 9.0)], [0.0, 0.0, 3.0]);
            assert!(at(&table, f64::NAN).is_nan());
        }
        let linear = Interpolation::linear(&POINTS).expect("the points increase");
        assert_eq!([at(&linear, 1.5), at(&linear, 3.0), at(&linear, 4.5)], [2.5, 3.5, 3.0]);
        let steps = Interpolation::steps(&POINTS).expect("the points increase");
        assert_eq!([at(&steps, 0.999), at(&steps, 1.0), at(&steps, 3.9)], [0.0, 1.0, 4.0]);
    }

    /// The harmonic mean of the secants 1 and 3, equally far, is 3/2; at a maximum the slope is 0. With these, the cubic in
    /// the middle between (1, 1) and (2, 4) is (1 + 4)/2 + (3/2 - 0)/8.
    #[test]
    fn cubics_have_the_slopes_of_fritsch_and_butland() {
        let table = Interpolation::smooth(&POINTS).expect("the points increase");
        let slope = table.derivative();
        assert_eq!([1.0, 2.0, 4.0, 5.0].map(|x| at(&slope, x)), [1.5, 0.0, 0.0, 0.0]);
        assert!((at(&table, 1.5) - 2.6875).abs() < 1e-15);
        // No overshoot beyond the points.
        for number in 0..=500 {
            let y = at(&table, f64::from(number) / 100.0);
            assert!((0.0..=4.0).contains(&y), "{y}");
        }
    }

    #[test]
    fn the_zeros_are_the_knots_and_nothing_else() {
        let zeros = Interpolation::linear(&POINTS).expect("the points increase").zeros();
        let signs = [-0.5, 0.5, 1.5, 3.0, 4.5, 5.5].map(|x| at(&zeros, x).signum());
        assert_eq!(signs, [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]);
        let slope = zeros.derivative();
        assert_eq!(POINTS.map(|[x, _]| (at(&zeros, x), at(&slope, x).abs())), [(0.0, 1.0); 5]);
    }

    #[test]
    fn points_that_do_not_increase_are_none() {
        for points in [&[][..], &[[1.0, 0.0], [1.0, 2.0]], &[[2.0, 0.0], [1.0, 2.0]], &[[f64::NAN, 1.0]]] {
            assert_eq!(Interpolation::linear(points), None);
        }
    }
}

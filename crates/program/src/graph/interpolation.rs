//! Functions that are given by a table: a polynomial between each two of its points.

use serde::{Deserialize, Serialize};

/// How a table goes from point to point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Course {
    /// `table`: straight lines.
    Linear,
    /// `smooth table`: cubics that do not overshoot.
    Smooth,
    /// `steps table`: the value of each point until the next.
    Steps,
}

/// What an interpolation has to do with a curve that the reader draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct OfDrawing {
    /// Which of [`crate::Model::tables`].
    pub table: u32,
    /// Which derivative of the curve; 0 for the curve itself.
    pub derivative: u32,
}

/// A function of one number x: a polynomial between each two neighbouring knots. Before the first knot and behind the last it
/// is a polynomial, too; a table keeps its value there.
///
/// To say where a step of integration has to end, it is computed in two steps: the number of the piece in which x lies, which
/// changes at the knots only, and the value of that piece at x, which is smooth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interpolation {
    /// Where the pieces meet, each greater than the one before.
    knots: Vec<f64>,
    /// The piece before the first knot, those between the knots, and the one behind the last: the coefficients of the powers,
    /// from the zeroth on, of the distance from the knot at which the piece begins; that of the first counts from its end.
    pieces: Vec<[f64; 4]>,
    /// How many times it can be differentiated at the knots until it jumps: 0 if it jumps itself, 1 if it bends.
    smoothness: u32,
    /// Whether the reader draws it: then its points are not known before.
    drawing: Option<OfDrawing>,
}

impl Interpolation {
    /// Through points by a course. `None` unless the x of the points are finite and increase, and their values are finite.
    pub fn through_points(course: Course, points: &[[f64; 2]]) -> Option<Self> {
        match course {
            Course::Linear => Self::linear(points),
            Course::Smooth => Self::smooth(points),
            Course::Steps => Self::steps(points),
        }
    }

    /// The same as the curve of a table that the reader draws.
    pub fn drawn(self, table: u32) -> Self {
        Self { drawing: Some(OfDrawing { table, derivative: 0 }), ..self }
    }

    /// What it has to do with a curve that the reader draws.
    pub fn drawing(&self) -> Option<OfDrawing> {
        self.drawing
    }

    /// From each point on its value, until the next. `None` unless the x of the points are finite and increase, and their
    /// values are finite.
    pub fn steps(points: &[[f64; 2]]) -> Option<Self> {
        Self::through(points, 0, |piece| [piece.from, 0.0, 0.0, 0.0])
    }

    /// Straight lines between the points. `None` as for [`Self::steps`].
    pub fn linear(points: &[[f64; 2]]) -> Option<Self> {
        Self::through(points, 1, |piece| [piece.from, (piece.to - piece.from) / piece.size, 0.0, 0.0])
    }

    /// Cubics with a common slope at each point, which rise where the points rise, fall where they fall, and nowhere overshoot
    /// them: F. N. Fritsch & J. Butland, A method for constructing local monotone piecewise cubic interpolants, SIAM J. Sci.
    /// Stat. Comput. 5 (1984) 300; at the ends the parabola through three points (C. Moler, Numerical Computing with MATLAB,
    /// section 3.6). `None` as for [`Self::steps`].
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

    /// Whether its parts fit together.
    pub(super) fn is_sound(&self) -> bool {
        let finite = self.knots.iter().chain(self.pieces.iter().flatten()).all(|number| number.is_finite());
        let increase = self.knots.windows(2).all(|pair| pair[0] < pair[1]);
        finite && increase && !self.knots.is_empty() && self.pieces.len() == self.knots.len() + 1
    }

    /// The number of the piece in which `x` lies: 0 before the first knot, and from each knot on one more. NaN for NaN.
    #[inline]
    pub fn piece(&self, x: f64) -> f64 {
        if x.is_nan() { x } else { self.knots.partition_point(|&knot| knot <= x) as f64 }
    }

    /// The value at `x` of the polynomial of a piece, also where `x` lies in another.
    #[inline]
    pub fn value(&self, x: f64, piece: f64) -> f64 {
        if piece.is_nan() {
            return piece;
        }
        let piece = (piece.max(0.0) as usize).min(self.knots.len());
        let (begin, [a, b, c, d]) = (self.knots[piece.saturating_sub(1)], self.pieces[piece]);
        let distance = x - begin;
        // An infinite distance times 0 would be no number.
        if b == 0.0 && c == 0.0 && d == 0.0 { a } else { a + distance * (b + distance * (c + distance * d)) }
    }

    /// Where it is given: from the first knot to the last, and of steps, whose last value has no end, from the first on.
    pub fn range(&self) -> [f64; 2] {
        let [first, last] = [self.knots.first(), self.knots.last()].map(|knot| knot.copied().unwrap_or(f64::NAN));
        if self.smoothness == 0 { [first, f64::INFINITY] } else { [first, last] }
    }

    /// How many times it can be differentiated at the knots until it jumps: 0 if it jumps itself, 1 if it bends.
    pub fn smoothness(&self) -> u32 {
        self.smoothness
    }

    /// The derivative, piece by piece.
    pub fn derivative(&self) -> Self {
        let pieces = self.pieces.iter().map(|[_, b, c, d]| [*b, 2.0 * c, 3.0 * d, 0.0]).collect();
        let drawing = self.drawing.map(|own| OfDrawing { derivative: own.derivative.saturating_add(1), ..own });
        Self { knots: self.knots.clone(), pieces, smoothness: self.smoothness.saturating_sub(1), drawing }
    }

    /// A function with the same pieces whose zeros are the knots. It changes its sign at each and has a continuous slope of
    /// magnitude 1 there.
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

/// What lies between two points of a table.
struct Piece {
    /// That of its first point.
    number: usize,
    /// The distance of the points.
    size: f64,
    /// The value at the first.
    from: f64,
    /// The value at the second.
    to: f64,
}

/// The slopes at the points.
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

/// The slope at an end from the size and slope of the piece there and of the next.
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

    /// The harmonic mean of the secants 1 and 3, equally far, is 3/2; at a greatest value the slope is 0; and from these the
    /// cubic in the middle between (1, 1) and (2, 4) is (1 + 4)/2 + (3/2 - 0)/8.
    #[test]
    fn cubics_have_the_slopes_of_fritsch_and_butland() {
        let table = Interpolation::smooth(&POINTS).expect("the points increase");
        let slope = table.derivative();
        assert_eq!([1.0, 2.0, 4.0, 5.0].map(|x| at(&slope, x)), [1.5, 0.0, 0.0, 0.0]);
        assert!((at(&table, 1.5) - 2.6875).abs() < 1e-15);
        // Nowhere beyond the points.
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

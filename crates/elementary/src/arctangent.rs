//! Arctangents: `atan(x) = atan(q/p) + atan((p x - q)/(p + q x))` with the fraction `q/p` that leaves at most 7/16 (the
//! fractions 1/2, 1, 3/2 and infinity of FreeBSD's `s_atan.c`, 1993, by Sun Microsystems).

use crate::pair::{Pair, SIGN, is_between, signed};

/// Coefficients of `(atan(t)/t - 1)/t^2` in powers of `t^2`.
const SERIES: [f64; 11] = [
    -0.333_333_333_333_329_3,
    0.199_999_999_998_764_47,
    -0.142_857_142_724_982_1,
    0.111_111_104_051_639_74,
    -0.090_908_871_244_662_64,
    0.076_918_760_431_500_24,
    -0.066_610_712_938_981_16,
    0.058_335_568_032_998_77,
    -0.049_768_172_838_144_685,
    0.036_529_934_352_195_495,
    -0.016_283_788_734_528_494,
];

/// pi.
const PI: Pair = Pair { high: core::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

/// Smallest quotient from which a fraction is subtracted.
const FIRST: f64 = 0.4375;

/// Larger arguments have the arctangent pi/2.
const MOST: f64 = 1e18;

/// A fraction `q/p` and its arctangent.
struct Fraction {
    p: f64,
    q: f64,
    arctangent: Pair,
}

/// The fraction for `y/x`; both are positive.
#[inline(always)]
fn fraction(y: f64, x: f64) -> Fraction {
    let mut chosen = Fraction { p: 1.0, q: 0.0, arctangent: Pair { high: 0.0, low: 0.0 } };
    if y >= FIRST * x {
        chosen = Fraction {
            p: 2.0,
            q: 1.0,
            arctangent: Pair { high: 0.463_647_609_000_806_1, low: 2.269_877_745_296_168_7e-17 },
        };
    }
    if y >= 0.6875 * x {
        chosen = Fraction { p: 1.0, q: 1.0, arctangent: Pair { high: PI.high / 4.0, low: PI.low / 4.0 } };
    }
    if y >= 1.1875 * x {
        chosen = Fraction {
            p: 2.0,
            q: 3.0,
            arctangent: Pair { high: 0.982_793_723_247_329, low: 1.390_331_103_123_099_8e-17 },
        };
    }
    if y >= 2.4375 * x {
        chosen = Fraction { p: 0.0, q: 1.0, arctangent: Pair { high: PI.high / 2.0, low: PI.low / 2.0 } };
    }
    chosen
}

/// `atan(t) - t` for `|t|` up to 7/16.
#[inline(always)]
fn beyond(t: f64) -> f64 {
    let square = t * t;
    let [a, b, c, d, e, f, g, h, i, j, k] = SERIES;
    let late = f + square * (g + square * (h + square * (i + square * (j + square * k))));
    t * square * (a + square * (b + square * (c + square * (d + square * (e + square * late)))))
}

/// Arctangent of `x`, rad. Every argument is plain.
#[inline(always)]
pub(crate) fn plain_atan(x: f64) -> f64 {
    let magnitude = x.abs();
    let Fraction { p, q, arctangent } = fraction(magnitude, 1.0);
    let magnitude = if magnitude > MOST { MOST } else { magnitude };
    let t = (p * magnitude - q) / (p + q * magnitude);
    signed(Pair::sum(arctangent.high, t).corrected(beyond(t) + arctangent.low).value(), x)
}

/// Arctangent of `x`, rad, between -pi/2 and pi/2.
pub fn atan(x: f64) -> f64 {
    // The first fraction is 0: nothing is divided.
    if x.abs() < FIRST { signed(x.abs() + beyond(x.abs()), x) } else { plain_atan(x) }
}

/// True if the lanes compute this angle: no products overflow or lose bits.
#[inline(always)]
pub(crate) fn is_plain(y: f64, x: f64) -> bool {
    const LEAST: f64 = 1e-100;
    const MOST: f64 = 1e100;
    let (y, x) = (y.abs(), x.abs());
    is_between(y, LEAST, MOST) & is_between(x, LEAST, MOST)
}

/// `q x` with its error, for `q` = 0, 1 or 3.
#[inline(always)]
fn times(x: f64, q: f64) -> Pair {
    let high = q * x;
    Pair { high, low: ((q - 1.0) * x - high) + x }
}

/// Angle of a plain point.
#[inline(always)]
pub(crate) fn plain_atan2(y: f64, x: f64) -> f64 {
    let (height, width) = (y.abs(), x.abs());
    let Fraction { p, q, arctangent } = fraction(height, width);
    // Of the products only that with q = 3 is rounded. The difference of the leading parts is exact.
    let (below, beside) = (times(width, q), times(height, q));
    let numerator = Pair { high: p * height - below.high, low: -below.low };
    let one = p * width;
    let high = one + beside.high;
    let part = high - one;
    let denominator = Pair { high, low: (one - (high - part)) + (beside.high - part) + beside.low };
    let t = numerator.over(denominator);
    let sum = Pair::sum(arctangent.high, t.high).corrected(t.low + (beyond(t.value()) + arctangent.low));
    let opposite = Pair::difference(PI.high, sum.high).corrected(PI.low - sum.low);
    let angle = if x.to_bits() & SIGN == 0 { sum } else { opposite };
    signed(angle.value(), y)
}

/// Angle of the point (`x`, `y`), rad, between -pi and pi.
pub fn atan2(y: f64, x: f64) -> f64 {
    if is_plain(y, x) { plain_atan2(y, x) } else { libm::atan2(y, x) }
}

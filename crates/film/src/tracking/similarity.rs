//! Similarity transformations: shift, rotation and scale.

/// Similarity (x, y) -> (a x - b y + c, b x + a y + d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Similarity {
    /// Scale times the cosine of the angle.
    pub a: f64,
    /// Scale times the sine of the angle.
    pub b: f64,
    /// Shift to the right, px.
    pub c: f64,
    /// Shift downwards, px.
    pub d: f64,
}

impl Similarity {
    /// Identity.
    pub const IDENTITY: Similarity = Similarity { a: 1.0, b: 0.0, c: 0.0, d: 0.0 };

    /// Least-squares similarity from the first points of the pairs to the second ones; a pure shift for one pair.
    /// `None` without pairs, or if all first points coincide.
    pub fn between(pairs: &[([f64; 2], [f64; 2])]) -> Option<Similarity> {
        let count = pairs.len() as f64;
        let mean = |pick: fn(&([f64; 2], [f64; 2])) -> f64| pairs.iter().map(pick).sum::<f64>() / count;
        let from = [mean(|pair| pair.0[0]), mean(|pair| pair.0[1])];
        let to = [mean(|pair| pair.1[0]), mean(|pair| pair.1[1])];
        let (mut along, mut across, mut size) = (0.0, 0.0, 0.0);
        for (first, second) in pairs {
            let (u, v) = (first[0] - from[0], first[1] - from[1]);
            let (p, q) = (second[0] - to[0], second[1] - to[1]);
            along += u * p + v * q;
            across += u * q - v * p;
            size += u * u + v * v;
        }
        let (a, b) = match pairs.len() {
            0 => return None,
            1 => (1.0, 0.0),
            _ if size > 0.0 => (along / size, across / size),
            _ => return None,
        };
        Some(Similarity { a, b, c: to[0] - a * from[0] + b * from[1], d: to[1] - b * from[0] - a * from[1] })
    }

    /// Image of a point.
    pub fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x - self.b * y + self.c, self.b * x + self.a * y + self.d]
    }

    /// Image of a direction, with the scale.
    pub fn turn(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x - self.b * y, self.b * x + self.a * y]
    }

    /// Inverse image of a point.
    pub fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let size = self.a * self.a + self.b * self.b;
        let (u, v) = (x - self.c, y - self.d);
        [(self.a * u + self.b * v) / size, (self.a * v - self.b * u) / size]
    }
}

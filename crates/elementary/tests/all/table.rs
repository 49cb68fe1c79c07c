//! The functions by name, with their tables of exact values.

/// A function of one or two numbers, for one argument and for many.
#[derive(Clone, Copy)]
pub enum Function {
    /// A function of one number.
    One(fn(f64) -> f64, fn(&mut [f64])),
    /// A function of two numbers.
    Two(fn(f64, f64) -> f64, fn(&mut [f64], &[f64])),
}

use Function::{One, Two};

/// Name, function and table of each.
pub const FUNCTIONS: [(&str, Function, &str); 11] = [
    ("sin", One(elementary::sin, elementary::sin_all), include_str!("../exact/sin.txt")),
    ("cos", One(elementary::cos, elementary::cos_all), include_str!("../exact/cos.txt")),
    ("tan", One(elementary::tan, elementary::tan_all), include_str!("../exact/tan.txt")),
    ("exp", One(elementary::exp, elementary::exp_all), include_str!("../exact/exp.txt")),
    ("ln", One(elementary::ln, elementary::ln_all), include_str!("../exact/ln.txt")),
    ("sinh", One(elementary::sinh, elementary::sinh_all), include_str!("../exact/sinh.txt")),
    ("cosh", One(elementary::cosh, elementary::cosh_all), include_str!("../exact/cosh.txt")),
    ("tanh", One(elementary::tanh, elementary::tanh_all), include_str!("../exact/tanh.txt")),
    ("atan", One(elementary::atan, elementary::atan_all), include_str!("../exact/atan.txt")),
    ("atan2", Two(elementary::atan2, elementary::atan2_all), include_str!("../exact/atan2.txt")),
    ("pow", Two(elementary::pow, elementary::pow_all), include_str!("../exact/pow.txt")),
];

/// A line of a table.
pub struct Exact {
    /// One argument or two; the second is 0 otherwise.
    pub arguments: [f64; 2],
    /// The number nearest to the exact value.
    pub nearest: f64,
    /// The exact value minus that number, in units of its last place.
    pub beyond: f64,
}

impl Function {
    /// Value at the arguments.
    pub fn value(self, [a, b]: [f64; 2]) -> f64 {
        match self {
            One(function, _) => function(a),
            Two(function, _) => function(a, b),
        }
    }

    /// Values at many arguments, in lanes.
    pub fn values(self, arguments: &[[f64; 2]]) -> Vec<f64> {
        let mut values: Vec<f64> = arguments.iter().map(|[a, _]| *a).collect();
        match self {
            One(_, all) => all(&mut values),
            Two(_, all) => all(&mut values, &arguments.iter().map(|[_, b]| *b).collect::<Vec<_>>()),
        }
        values
    }

    /// The lines of a table.
    pub fn lines(self, table: &str) -> Vec<Exact> {
        let number = |bits: &str| f64::from_bits(u64::from_str_radix(bits, 16).expect("bits"));
        let lines = table.lines().map(|line| {
            let columns: Vec<&str> = line.split(' ').collect();
            match (self, columns.as_slice()) {
                (One(..), [a, nearest, beyond]) => ([number(a), 0.0], *nearest, *beyond),
                (Two(..), [a, b, nearest, beyond]) => ([number(a), number(b)], *nearest, *beyond),
                _ => panic!("{line}"),
            }
        });
        lines
            .map(|(arguments, nearest, beyond)| Exact {
                arguments,
                nearest: number(nearest),
                beyond: beyond.parse().expect("a difference"),
            })
            .collect()
    }
}

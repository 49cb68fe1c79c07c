//! Functions of the language: arguments, dimensions and graph nodes.

use crate::{Binary, Graph, Node, NodeId, Unary};
use units::{Words, words};

/// A function of the language.
#[derive(Debug)]
pub struct Function {
    /// Name as written before the parenthesis.
    pub name: &'static str,
    /// Minimum number of arguments.
    pub least: usize,
    /// Maximum number of arguments.
    pub most: usize,
    /// Rule for the dimensions of arguments and result.
    pub dimensions: Rule,
    build: Build,
}

/// Rule for the dimensions of arguments and result of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Argument and result are pure numbers.
    Pure,
    /// Argument and result are pure numbers: rounding would depend on the unit.
    Whole,
    /// Root of this degree.
    Root(i8),
    /// All arguments have the same dimension, as has the result.
    Same,
    /// All arguments have the same dimension; the result is a pure number.
    Ratio,
    /// All arguments but the first have the same dimension, as has the result.
    Rest,
}

#[derive(Clone, Copy, Debug)]
enum Build {
    Unary(Unary),
    /// Two arguments; more are combined from left to right.
    Binary(Binary),
    Hypotenuse,
    /// Sum of any number of arguments.
    Sum,
    /// `a - b*floor(a/b)`: has the sign of the divisor.
    Remainder,
    /// Dry friction, kept as [`Node::Friction`] until the model is solved.
    Friction,
    /// A random draw. The first argument is its stream, which authors cannot write.
    Draw(Draw),
    /// Stream of draws, a hash of two numbers.
    Stream,
}

/// Distribution of a draw.
#[derive(Clone, Copy, Debug)]
enum Draw {
    /// Uniform between two values.
    Uniform,
    /// Normal with mean and standard deviation.
    Normal,
    /// Exponential with a mean.
    Exponential,
    /// Poisson with a mean.
    Poisson,
    /// Binomial with number of trials and probability.
    Binomial,
}

/// No limit other than the size of a model.
const MANY: usize = u32::MAX as usize;

const fn one(name: &'static str, dimensions: Rule, function: Unary) -> Function {
    Function { name, least: 1, most: 1, dimensions, build: Build::Unary(function) }
}

const fn two(name: &'static str, most: usize, dimensions: Rule, function: Binary) -> Function {
    Function { name, least: 2, most, dimensions, build: Build::Binary(function) }
}

/// A draw with `arguments` arguments besides its stream.
const fn draw(name: &'static str, arguments: usize, dimensions: Rule, draw: Draw) -> Function {
    Function { name, least: 1 + arguments, most: 1 + arguments, dimensions, build: Build::Draw(draw) }
}

/// All functions, in the order of the language reference.
pub const FUNCTIONS: &[Function] = &[
    one("sqrt", Rule::Root(2), Unary::SquareRoot),
    one("cbrt", Rule::Root(3), Unary::CubeRoot),
    one("abs", Rule::Same, Unary::Absolute),
    one("sign", Rule::Ratio, Unary::Sign),
    one("exp", Rule::Pure, Unary::Exp),
    one("ln", Rule::Pure, Unary::Ln),
    one("log10", Rule::Pure, Unary::Log10),
    one("sin", Rule::Pure, Unary::Sin),
    one("cos", Rule::Pure, Unary::Cos),
    one("tan", Rule::Pure, Unary::Tan),
    one("asin", Rule::Pure, Unary::Asin),
    one("acos", Rule::Pure, Unary::Acos),
    one("atan", Rule::Pure, Unary::Atan),
    two("atan2", 2, Rule::Ratio, Binary::Atan2),
    one("sinh", Rule::Pure, Unary::Sinh),
    one("cosh", Rule::Pure, Unary::Cosh),
    one("tanh", Rule::Pure, Unary::Tanh),
    one("asinh", Rule::Pure, Unary::Asinh),
    one("acosh", Rule::Pure, Unary::Acosh),
    one("atanh", Rule::Pure, Unary::Atanh),
    one("floor", Rule::Whole, Unary::Floor),
    one("ceil", Rule::Whole, Unary::Ceil),
    one("round", Rule::Whole, Unary::Round),
    Function { name: "sum", least: 1, most: MANY, dimensions: Rule::Same, build: Build::Sum },
    two("min", MANY, Rule::Same, Binary::Minimum),
    two("max", MANY, Rule::Same, Binary::Maximum),
    Function { name: "mod", least: 2, most: 2, dimensions: Rule::Same, build: Build::Remainder },
    Function { name: "hypot", least: 2, most: 2, dimensions: Rule::Same, build: Build::Hypotenuse },
    Function { name: "coulomb", least: 2, most: 3, dimensions: Rule::Rest, build: Build::Friction },
    draw("uniform", 2, Rule::Rest, Draw::Uniform),
    draw("normal", 2, Rule::Rest, Draw::Normal),
    draw("exponential", 1, Rule::Rest, Draw::Exponential),
    draw("poisson", 1, Rule::Pure, Draw::Poisson),
    draw("binomial", 2, Rule::Pure, Draw::Binomial),
    Function { name: Function::STREAM, least: 2, most: 2, dimensions: Rule::Pure, build: Build::Stream },
];

impl Function {
    /// Name of the function that makes streams of draws; it cannot be written in a text.
    pub const STREAM: &str = "stream of draws";

    /// True if the function draws at random.
    pub fn draws(&self) -> bool {
        matches!(self.build, Build::Draw(_))
    }

    /// The function of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        FUNCTIONS.iter().find(|function| function.name == name)
    }

    /// The function of this name if the name is reserved. Names of functions added after the first edition of the language
    /// can be used otherwise.
    pub fn reserving(name: &str) -> Option<&'static Self> {
        Self::named(name)
            .filter(|function| !matches!(function.build, Build::Friction | Build::Sum | Build::Draw(_) | Build::Stream))
    }

    /// True if the function accepts this number of arguments.
    pub fn takes(&self, arguments: usize) -> bool {
        (self.least..=self.most).contains(&arguments)
    }

    /// Accepted number of arguments as text: `1 argument`, `2 arguments`, `2 or more arguments`.
    pub fn arity(&self) -> Words {
        match (self.least, self.most) {
            (1, 1) => words("1 argument"),
            (least, most) if least == most => words!("{least} arguments"),
            (least, most) if least + 1 == most => {
                words!("{least} or {most} arguments")
            }
            (least, _) => words!("{least} or more arguments"),
        }
    }

    /// Builds the node of a call; a constant 0 without arguments, which an earlier check excludes.
    pub fn build(&self, graph: &mut Graph, arguments: &[NodeId]) -> NodeId {
        let Some((&first, rest)) = arguments.split_first() else {
            return graph.constant(0.0);
        };
        match self.build {
            Build::Stream => rest.first().map_or(first, |&number| graph.binary(Binary::Stream, first, number)),
            Build::Draw(draw) => self::draws(graph, draw, first, rest),
            Build::Unary(function) => graph.unary(function, first),
            Build::Binary(function) => rest.iter().fold(first, |value, &next| graph.binary(function, value, next)),
            Build::Sum => pairwise_sum(graph, arguments),
            Build::Hypotenuse => {
                let squares = arguments.iter().map(|&side| graph.multiply(side, side)).collect::<Vec<_>>();
                let sum = squares.into_iter().reduce(|sum, square| graph.add(sum, square)).unwrap_or(first);
                graph.unary(Unary::SquareRoot, sum)
            }
            Build::Friction => match *rest {
                [adhesion, ref sliding @ ..] => {
                    let sliding = sliding.first().copied().unwrap_or(adhesion);
                    graph.insert(Node::Friction(first, adhesion, sliding))
                }
                [] => first,
            },
            Build::Remainder => rest.iter().fold(first, |value, &divisor| {
                let quotient = graph.divide(value, divisor);
                let whole = graph.unary(Unary::Floor, quotient);
                let multiple = graph.multiply(divisor, whole);
                graph.subtract(value, multiple)
            }),
        }
    }
}

/// Node of a draw from a stream.
fn draws(graph: &mut Graph, draw: Draw, stream: NodeId, arguments: &[NodeId]) -> NodeId {
    match (draw, arguments) {
        (Draw::Uniform, &[low, high]) => {
            let (part, range) = (graph.unary(Unary::Uniform, stream), graph.subtract(high, low));
            let above = graph.multiply(range, part);
            graph.add(low, above)
        }
        (Draw::Normal, &[mean, deviation]) => {
            let number = graph.unary(Unary::Normal, stream);
            let off = graph.multiply(deviation, number);
            graph.add(mean, off)
        }
        (Draw::Exponential, &[mean]) => {
            let number = graph.unary(Unary::Exponential, stream);
            graph.multiply(mean, number)
        }
        (Draw::Poisson, &[mean]) => graph.binary(Binary::Poisson, mean, stream),
        (Draw::Binomial, &[trials, probability]) => graph.insert(Node::Binomial(trials, probability, stream)),
        _ => graph.constant(f64::NAN),
    }
}

/// Pairwise summation: the rounding error of n terms grows with log n only (N. J. Higham, SIAM J. Sci. Comput. 14 (1993)
/// 783), and the sums of one level are independent.
fn pairwise_sum(graph: &mut Graph, terms: &[NodeId]) -> NodeId {
    let mut level = terms.to_vec();
    while level.len() > 1 {
        level = level
            .chunks(2)
            .map(|pair| match *pair {
                [a, b] => graph.add(a, b),
                _ => pair[0],
            })
            .collect();
    }
    level.first().copied().unwrap_or_else(|| graph.constant(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_remainder_has_the_sign_of_the_divisor() {
        let remainder = Function::named("mod").expect("it is in the table");
        for (a, b, expected) in [(7.0, 3.0, 1.0), (-7.0, 3.0, 2.0), (7.0, -3.0, -2.0)] {
            let mut graph = Graph::default();
            let arguments = [graph.constant(a), graph.constant(b)];
            let value = remainder.build(&mut graph, &arguments);
            assert_eq!(graph.as_constant(value), Some(expected), "mod({a}, {b})");
        }
    }
}

//! Dimensions with unknowns, and their unification. Dimensions are products of powers, so every condition is one linear
//! equation with rational exponents. After A. J. Kennedy, "Programming Languages and Dimensions", 1996, without
//! polymorphism, which models do not need.

use crate::Span;
use std::collections::BTreeMap;
use units::{Dimension, Exponent};

/// Index of an unknown dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Variable(pub usize);

/// A known dimension times powers of unknown ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Form {
    pub known: Dimension,
    /// Sorted by variable, each variable once, no exponent 0.
    pub unknown: Vec<(Variable, Exponent)>,
}

/// An exponent is out of bounds. No physical quantity comes near the bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooLarge;

impl From<Dimension> for Form {
    fn from(known: Dimension) -> Self {
        Self { known, unknown: Vec::new() }
    }
}

impl Form {
    /// A pure number.
    pub fn pure() -> Self {
        Self::from(Dimension::NONE)
    }

    /// The dimension, if nothing in it is unknown.
    pub fn dimension(&self) -> Option<Dimension> {
        self.unknown.is_empty().then_some(self.known)
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Result<Self, TooLarge> {
        let known = self.known.times(other.known).ok_or(TooLarge)?;
        if other.unknown.is_empty() {
            return Ok(Self { known, unknown: self.unknown.clone() });
        }
        let mut unknown = self.unknown.clone();
        for &(variable, exponent) in &other.unknown {
            match unknown.binary_search_by_key(&variable, |&(variable, _)| variable) {
                Ok(index) => unknown[index].1 = unknown[index].1.plus(exponent).ok_or(TooLarge)?,
                Err(index) => unknown.insert(index, (variable, exponent)),
            }
        }
        unknown.retain(|(_, exponent)| !exponent.is_zero());
        Ok(Self { known, unknown })
    }

    /// The quotient.
    pub fn per(&self, other: &Self) -> Result<Self, TooLarge> {
        if other.unknown.is_empty() {
            let known = self.known.per(other.known).ok_or(TooLarge)?;
            return Ok(Self { known, unknown: self.unknown.clone() });
        }
        self.times(&other.power(Exponent::from(-1))?)
    }

    /// The power.
    pub fn power(&self, power: Exponent) -> Result<Self, TooLarge> {
        if power.is_zero() {
            return Ok(Self::pure());
        }
        let known = self.known.power(power).ok_or(TooLarge)?;
        let raised = |&(variable, exponent): &(Variable, Exponent)| {
            exponent.times(power).map(|exponent| (variable, exponent)).ok_or(TooLarge)
        };
        let unknown = self.unknown.iter().map(raised).collect::<Result<_, _>>()?;
        Ok(Self { known, unknown })
    }
}

/// Reason why two dimensions cannot be made equal.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Conflict {
    /// They differ by a known factor.
    Different,
    /// An exponent is out of bounds.
    TooLarge,
}

impl From<TooLarge> for Conflict {
    fn from(_: TooLarge) -> Self {
        Self::TooLarge
    }
}

/// State of the inference: the solutions found so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solver {
    variables: Vec<Option<Solution>>,
    solved: usize,
}

/// Solution for an unknown dimension.
#[derive(Clone, Debug)]
struct Solution {
    /// In terms of variables that were unsolved at that time: those solved later, and those still free.
    form: Form,
    /// Number of solutions found before it.
    rank: usize,
    /// Place in the source that determines it.
    origin: Span,
}

impl Solver {
    /// Returns a new free dimension.
    pub fn fresh(&mut self) -> Form {
        let variable = Variable(self.variables.len());
        self.variables.push(None);
        Form { known: Dimension::NONE, unknown: vec![(variable, Exponent::ONE)] }
    }

    /// Substitutes all known solutions.
    pub fn resolve(&self, form: &Form) -> Result<Form, TooLarge> {
        if form.unknown.is_empty() {
            return Ok(form.clone());
        }
        let mut known = form.known;
        let mut open: BTreeMap<Variable, Exponent> = BTreeMap::new();
        // In the order of their ranks, each variable is substituted only once.
        let mut found: BTreeMap<usize, (&Solution, Exponent)> = BTreeMap::new();
        let mut factors = form.unknown.clone();
        loop {
            for (variable, exponent) in factors.drain(..) {
                match &self.variables[variable.0] {
                    Some(solution) => {
                        let (_, sum) = found.entry(solution.rank).or_insert((solution, Exponent::ZERO));
                        *sum = sum.plus(exponent).ok_or(TooLarge)?;
                    }
                    None => {
                        let sum = open.entry(variable).or_insert(Exponent::ZERO);
                        *sum = sum.plus(exponent).ok_or(TooLarge)?;
                    }
                }
            }
            let Some((_, (solution, exponent))) = found.pop_first() else { break };
            let value = solution.form.power(exponent)?;
            known = known.times(value.known).ok_or(TooLarge)?;
            factors = value.unknown;
        }
        let unknown = open.into_iter().filter(|(_, exponent)| !exponent.is_zero()).collect();
        Ok(Form { known, unknown })
    }

    /// Makes two dimensions equal. `origin` is the place that requires it.
    pub fn unify(&mut self, a: &Form, b: &Form, origin: Span) -> Result<(), Conflict> {
        if a == b {
            return Ok(());
        }
        let mut ratio = self.resolve(&a.per(b)?)?;
        let Some((variable, exponent)) = ratio.unknown.pop() else {
            return if ratio.known.is_none() { Ok(()) } else { Err(Conflict::Different) };
        };
        let reciprocal = Exponent::new(-i64::from(exponent.denominator()), i64::from(exponent.numerator()));
        let form = ratio.power(reciprocal.ok_or(TooLarge)?)?;
        self.variables[variable.0] = Some(Solution { form, rank: self.solved, origin });
        self.solved += 1;
        Ok(())
    }

    /// Place that determined the dimension of the first variable of the form.
    pub fn origin(&self, form: &Form) -> Option<Span> {
        let (variable, _) = form.unknown.first()?;
        self.variables[variable.0].as_ref().map(|solution| solution.origin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_dimensions_from_products_and_roots() {
        let mut solver = Solver::default();
        let (x, y) = (solver.fresh(), solver.fresh());
        let length = Form::from(Dimension::LENGTH);
        let time = Form::from(Dimension::TIME);
        // x^2 y = length, y = time/x
        let product = x.power(Exponent::from(2)).unwrap().times(&y).unwrap();
        solver.unify(&product, &length, Span::default()).unwrap();
        solver.unify(&y, &time.per(&x).unwrap(), Span::default()).unwrap();
        assert_eq!(solver.resolve(&x).unwrap().dimension().unwrap().to_string(), "m s^-1");
        assert_eq!(solver.resolve(&y).unwrap().dimension().unwrap().to_string(), "m^-1 s^2");
        let root = x.power(Exponent::new(1, 2).unwrap()).unwrap();
        assert_eq!(solver.unify(&root, &length, Span::default()), Err(Conflict::Different));
    }

    #[test]
    fn what_is_free_stays_free_and_conflicts_change_nothing() {
        let mut solver = Solver::default();
        let (x, y) = (solver.fresh(), solver.fresh());
        solver.unify(&x, &y, Span::default()).unwrap();
        assert_eq!(solver.resolve(&x).unwrap().dimension(), None);
        let length = Form::from(Dimension::LENGTH);
        assert_eq!(solver.unify(&length, &Form::pure(), Span::default()), Err(Conflict::Different));
        solver.unify(&x, &length, Span::default()).unwrap();
        assert_eq!(solver.resolve(&y).unwrap().dimension(), Some(Dimension::LENGTH));
    }
}

//! Numbers and combinations that the data cannot determine.

use super::covariance::Covariance;
use crate::fit::autoregression::{orthonormal, subtract_projection};
use crate::fit::linear::norm;
use crate::fit::search::Search;
use serde::{Deserialize, Serialize};
use units::order::sort;
use units::{Language, say};

/// Reason why numbers are not determined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Lack {
    /// The curve does not change along a combination of them.
    Flat,
    /// Each is uncertain by more than half of its value, while a combination of them is well determined.
    Weak,
    /// The curve is the same if two of them exchange their values.
    Exchange,
}

/// Numbers that the data do not determine individually.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Undetermined {
    /// Reason.
    pub lack: Lack,
    /// Names of the numbers.
    pub names: Vec<String>,
    /// Combinations that are determined, such as `b/rho`, if they are simple; empty for a single number without effect.
    pub combinations: Vec<String>,
}

/// Groups the flat directions of the curve; `names` and values `x` have one entry per column.
pub(crate) fn undetermined(flat: &[Vec<f64>], names: &[String], x: &[f64]) -> Vec<Undetermined> {
    let mut groups: Vec<(Vec<usize>, Vec<Vec<f64>>)> = Vec::new();
    for direction in flat {
        // Relative changes, except where the value is zero.
        let relative: Vec<f64> =
            direction.iter().zip(x).map(|(change, x)| if *x == 0.0 { *change } else { change / x }).collect();
        let greatest = relative.iter().fold(0.0, |greatest: f64, value| greatest.max(value.abs()));
        let mut members: Vec<usize> =
            (0..relative.len()).filter(|&column| relative[column].abs() > 1e-4 * greatest).collect();
        let mut directions = vec![relative];
        // Directions that share a number are merged into one group.
        let mut place = 0;
        while place < groups.len() {
            if groups[place].0.iter().any(|column| members.contains(column)) {
                let (columns, others) = groups.remove(place);
                members.extend(columns);
                directions.extend(others);
            } else {
                place += 1;
            }
        }
        sort(&mut members);
        members.dedup();
        groups.push((members, directions));
    }
    let named = |(members, directions): (Vec<usize>, Vec<Vec<f64>>)| Undetermined {
        lack: Lack::Flat,
        combinations: combinations(&directions, &members, names, x).unwrap_or_default(),
        names: members.into_iter().map(|column| names[column].clone()).collect(),
    };
    groups.into_iter().map(named).collect()
}

/// Pairs of numbers of which only a product or quotient of powers is well determined, from the textbook covariance at the
/// end of a search.
pub(in crate::fit) fn weak(best: &Search, covariance: &Covariance, names: &[String]) -> Vec<Undetermined> {
    let size = best.x.len();
    let variance = |a: usize, b: usize| covariance.textbook[a * size + b];
    let relative = |column: usize| variance(column, column).sqrt() / best.x[column].abs();
    let uncertain = |column: &usize| covariance.dof > 0.0 && (VAGUE..f64::INFINITY).contains(&relative(*column));
    let columns: Vec<usize> = (0..size).filter(uncertain).collect();
    let mut found = Vec::new();
    for (place, &a) in columns.iter().enumerate() {
        for &b in &columns[place + 1..] {
            let together = variance(a, b) / (best.x[a] * best.x[b]);
            let (of_a, of_b, sign) = (relative(a), relative(b), together.signum());
            // Standard error of a^p/b^q or a^p*b^q relative to that of the more certain factor.
            let gain = |(p, q): (f64, f64)| {
                let square = p * p * of_a * of_a + q * q * of_b * of_b - 2.0 * p * q * together.abs();
                square.max(0.0).sqrt() / (p * of_a).min(q * of_b)
            };
            let powers = POWERS.into_iter().min_by(|one, other| gain(*one).total_cmp(&gain(*other)));
            let tight = powers.filter(|powers| gain(*powers) <= WELL);
            let named = |(p, q): (f64, f64)| product(&[(a, p), (b, -sign * q)], names);
            if let Some(combination) = tight.and_then(named) {
                let names = [a, b].map(|column| names[column].clone()).to_vec();
                found.push(Undetermined { lack: Lack::Weak, names, combinations: vec![combination] });
            }
        }
    }
    found
}

/// Relative standard error from which on a number counts as poorly determined.
const VAGUE: f64 = 0.5;
/// Greatest relative error of a well determined combination, as a part of that of its more certain factor.
const WELL: f64 = 0.2;
/// Exponents that are tried.
const POWERS: [(f64, f64); 3] = [(1.0, 1.0), (2.0, 1.0), (1.0, 2.0)];
/// Relative tolerance for whole exponents of a flat direction, and for equal changes in a sum.
const EXACTLY: f64 = 1e-6;

/// Combinations that are constant along all `directions`, given as relative changes by column. Their number is that of the
/// `members` minus that of the directions. `None` if they are not simple.
fn combinations(directions: &[Vec<f64>], members: &[usize], names: &[String], x: &[f64]) -> Option<Vec<String>> {
    let [first, others @ ..] = members else { return None };
    if let [direction] = directions {
        // With one direction, each of the others forms a combination with the first.
        let pair = |&other: &usize| {
            let powers = [(*first, direction[other]), (other, -direction[*first])];
            let product = if x[*first] == 0.0 || x[other] == 0.0 { None } else { product(&powers, names) };
            product.or_else(|| sum(direction, (*first, other), names, x))
        };
        return others.iter().map(pair).collect();
    }
    if directions.len() + 1 != members.len() || members.iter().any(|&column| x[column] == 0.0) {
        return None;
    }
    // The only combination of powers has exponents orthogonal to all directions. A unit vector minus its projection on the
    // directions is a multiple of them.
    let own = |direction: &Vec<f64>| members.iter().map(|&column| direction[column]).collect();
    let basis = orthonormal(directions.iter().map(own).collect());
    if basis.len() < directions.len() {
        return None;
    }
    let axis = |place: usize| {
        let mut axis = vec![0.0; members.len()];
        axis[place] = 1.0;
        subtract_projection(&basis, &mut axis);
        axis
    };
    let exponents = (0..members.len()).map(axis).max_by(|one, other| norm(one).total_cmp(&norm(other)))?;
    let powers: Vec<(usize, f64)> = members.iter().copied().zip(exponents).collect();
    Some(vec![product(&powers, names)?])
}

/// Product of powers whose exponents are in the ratio of small whole numbers; the first exponent is positive.
fn product(powers: &[(usize, f64)], names: &[String]) -> Option<String> {
    let least = powers.iter().map(|(_, exponent)| exponent.abs()).fold(f64::INFINITY, f64::min);
    let sign = powers.first()?.1.signum();
    let whole = |scale: f64| {
        let rounded = |&(column, exponent): &(usize, f64)| {
            let exponent = sign * exponent / least * scale;
            let whole = exponent.round();
            let near = whole != 0.0 && whole.abs() <= 4.0 && (exponent - whole).abs() <= EXACTLY * whole.abs();
            near.then_some((column, whole as i32))
        };
        powers.iter().map(rounded).collect::<Option<Vec<(usize, i32)>>>()
    };
    let powers = (1..=4).find_map(|scale| whole(f64::from(scale)))?;
    let mut text = String::new();
    for (column, exponent) in powers {
        let sign = if exponent > 0 { "*" } else { "/" };
        text.push_str(if text.is_empty() { "" } else { sign });
        text.push_str(&names[column]);
        if exponent.abs() > 1 {
            text.push_str(&format!("^{}", exponent.abs()));
        }
    }
    Some(text)
}

/// Sum or difference of two numbers that is constant along a direction of relative changes.
fn sum(direction: &[f64], (a, b): (usize, usize), names: &[String], x: &[f64]) -> Option<String> {
    let change = |column: usize| direction[column] * if x[column] == 0.0 { 1.0 } else { x[column] };
    let equal = |one: f64, other: f64| (one - other).abs() <= EXACTLY * one.abs();
    let sign = if equal(change(a), -change(b)) {
        "+"
    } else if equal(change(a), change(b)) {
        "-"
    } else {
        return None;
    };
    Some(format!("{} {sign} {}", names[a], names[b]))
}

impl Undetermined {
    /// Sentence about what cannot be determined.
    pub fn text(&self, language: Language) -> String {
        let names = language.join(&self.names);
        let combinations = language.join(&self.combinations);
        let known = !combinations.is_empty();
        match (self.lack, self.names.len()) {
            (Lack::Exchange, _) => say!(
                language,
                "The curve is the same if {names} exchange their values and the others follow: the data cannot tell which is which."
            ),
            (Lack::Weak, _) => say!(
                language,
                "The data determine {combinations} well, but hardly {names} each by itself; fix one of them."
            ),
            (Lack::Flat, 1) => say!(language, "The data do not determine {names}: the curve does not change with it."),
            (Lack::Flat, _) if known => {
                say!(language, "The data determine only {combinations}, not {names} each by itself; fix one of them.")
            }
            (Lack::Flat, _) => {
                say!(language, "The data determine only combinations of {names}, not each by itself; fix some of them.")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_are_named() {
        let names: Vec<String> = ["b", "rho", "c"].map(str::to_owned).to_vec();
        let named = |flat: &[Vec<f64>], x: &[f64]| undetermined(flat, &names, x);
        let one = |combinations: &[&str], members: &[&str]| Undetermined {
            names: members.iter().map(|name| (*name).to_owned()).collect(),
            combinations: combinations.iter().map(|one| (*one).to_owned()).collect(),
            lack: Lack::Flat,
        };
        // b and rho grow together: b/rho stays.
        assert_eq!(named(&[vec![0.5, 10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(&["b/rho"], &["b", "rho"])]);
        assert_eq!(named(&[vec![0.5, -10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(&["b*rho"], &["b", "rho"])]);
        // db/b = 2 drho/rho: b/rho^2 stays.
        assert_eq!(named(&[vec![1.0, 10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(&["b/rho^2"], &["b", "rho"])]);
        assert_eq!(named(&[vec![1.0, 0.0, -1.0]], &[0.3, 1.0, 3.0]), [one(&["b + c"], &["b", "c"])]);
        assert_eq!(named(&[vec![0.0, 0.0, 1.0]], &[1.0; 3]), [one(&[], &["c"])]);
        // One direction among three numbers.
        let three = [one(&["b/rho", "b*c"], &["b", "rho", "c"])];
        assert_eq!(named(&[vec![0.5, 10.0, -0.03]], &[50.0, 1000.0, 3.0]), three);
        // Two directions among three numbers: b*rho/c^2 stays.
        let two = [vec![1.0, -2.0, 0.0], vec![0.0, 2.0 * 2.0, 3.0]];
        assert_eq!(named(&two, &[1.0, 2.0, 3.0]), [one(&["b*rho/c^2"], &["b", "rho", "c"])]);
        let two = [vec![1.0, 1.1, 0.0], vec![0.0, 1.0, 1.0]];
        assert_eq!(named(&two, &[1.0, 2.0, 3.0]), [one(&[], &["b", "rho", "c"])]);
    }
}

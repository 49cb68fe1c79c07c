//! What the data cannot determine, named.

/// Numbers of which the data determine only a combination, or nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Undetermined {
    /// Their names.
    pub names: Vec<String>,
    /// The combination that is determined, `b/rho`, where it is a simple one; empty where a single number changes nothing.
    pub combination: Option<String>,
}

/// Groups the flat directions of the curve: `names` and values `x` by column.
pub(crate) fn undetermined(flat: &[Vec<f64>], names: &[String], x: &[f64]) -> Vec<Undetermined> {
    let mut groups: Vec<(Vec<usize>, Vec<&Vec<f64>>)> = Vec::new();
    for direction in flat {
        // Each column in its own size: relative changes, where the value is not zero.
        let relative: Vec<f64> =
            direction.iter().zip(x).map(|(change, x)| if *x == 0.0 { *change } else { change / x }).collect();
        let greatest = relative.iter().fold(0.0, |greatest: f64, value| greatest.max(value.abs()));
        let mut members: Vec<usize> =
            (0..relative.len()).filter(|&column| relative[column].abs() > 1e-4 * greatest).collect();
        let mut directions = vec![direction];
        // Directions that share a number are one puzzle.
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
        members.sort_unstable();
        members.dedup();
        groups.push((members, directions));
    }
    groups
        .into_iter()
        .map(|(members, directions)| Undetermined {
            combination: match (directions.as_slice(), members.as_slice()) {
                ([direction], &[a, b]) => combination(direction, (a, b), names, x),
                _ => None,
            },
            names: members.into_iter().map(|column| names[column].clone()).collect(),
        })
        .collect()
}

/// What stays the same along a direction in which two numbers change: a quotient or product of powers, a sum or difference.
fn combination(direction: &[f64], (a, b): (usize, usize), names: &[String], x: &[f64]) -> Option<String> {
    let (name_a, name_b) = (&names[a], &names[b]);
    if x[a] != 0.0 && x[b] != 0.0 {
        // a^p b^q stays the same if p da/a + q db/b = 0.
        if let Some((p, q)) = small_ratio(-(direction[a] / x[a]) / (direction[b] / x[b])) {
            let power = |name: &str, exponent: u32| {
                if exponent == 1 { name.to_owned() } else { format!("{name}^{exponent}") }
            };
            let (first, second) = (power(name_a, q.unsigned_abs()), power(name_b, p.unsigned_abs()));
            return Some(if p > 0 { format!("{first}*{second}") } else { format!("{first}/{second}") });
        }
    }
    if (direction[a] + direction[b]).abs() <= 1e-6 * direction[a].abs() {
        return Some(format!("{name_a} + {name_b}"));
    }
    ((direction[a] - direction[b]).abs() <= 1e-6 * direction[a].abs()).then(|| format!("{name_a} - {name_b}"))
}

/// A ratio as whole numbers up to 4, the second positive.
fn small_ratio(ratio: f64) -> Option<(i32, i32)> {
    (1..=4).flat_map(|q| (1..=4).map(move |p| (p, q))).find_map(|(p, q)| {
        let size = f64::from(p) / f64::from(q);
        ((ratio.abs() - size).abs() <= 1e-6 * size).then_some((if ratio > 0.0 { p } else { -p }, q))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_are_named() {
        let names: Vec<String> = ["b", "rho", "c"].map(str::to_owned).to_vec();
        let named = |flat: &[Vec<f64>], x: &[f64]| undetermined(flat, &names, x);
        let one = |combination: Option<&str>, members: &[&str]| Undetermined {
            names: members.iter().map(|name| (*name).to_owned()).collect(),
            combination: combination.map(str::to_owned),
        };
        // b and rho grow together: b/rho stays.
        assert_eq!(named(&[vec![0.5, 10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(Some("b/rho"), &["b", "rho"])]);
        assert_eq!(named(&[vec![0.5, -10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(Some("b*rho"), &["b", "rho"])]);
        // db/b = 2 drho/rho: b/rho^2 stays.
        assert_eq!(named(&[vec![1.0, 10.0, 0.0]], &[50.0, 1000.0, 3.0]), [one(Some("b/rho^2"), &["b", "rho"])]);
        assert_eq!(named(&[vec![1.0, 0.0, -1.0]], &[0.3, 1.0, 3.0]), [one(Some("b + c"), &["b", "c"])]);
        assert_eq!(named(&[vec![0.0, 0.0, 1.0]], &[1.0; 3]), [one(None, &["c"])]);
        // Two directions among three numbers.
        let two = [vec![1.0, 1.0, 0.0], vec![0.0, 1.0, 1.0]];
        assert_eq!(named(&two, &[1.0, 2.0, 3.0]), [one(None, &["b", "rho", "c"])]);
    }
}

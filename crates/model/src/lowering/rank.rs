//! Test for singular systems of equations. The dependence of equations such as x'' + y'' = a and 2*x'' + 2*y'' = b cannot
//! be seen from the unknowns that they contain. It is detected from the values of the coefficients at a few points.

use program::{Graph, LinearSystem, Node, NodeId};

/// Number of points; the matrix must be singular at all of them.
const POINTS: u32 = 3;

/// A pivot smaller than this, relative to the largest entry of its row, is taken as 0.
const NEGLIGIBLE: f64 = 1e-12;

/// True if the matrix of a system is singular at all test points.
pub(crate) fn is_singular(graph: &Graph, system: &LinearSystem) -> bool {
    let (entries, size) = (&system.entries, system.right.len());
    let nodes: Vec<NodeId> = entries.iter().map(|entry| entry.node).collect();
    let order = graph.reachable(&nodes);
    (0..POINTS).all(|point| {
        let values = evaluate(graph, &order, point);
        let mut matrix = vec![0.0; size * size];
        for entry in entries {
            matrix[entry.row as usize * size + entry.column as usize] = value(&order, &values, entry.node);
        }
        matrix.iter().all(|entry| entry.is_finite()) && has_no_pivot(matrix, size)
    })
}

/// A pseudo-random number between 0.5 and 1.5.
fn arbitrary(input: u32, point: u32) -> f64 {
    let mut bits = (u64::from(input) << 8) + u64::from(point) + 1;
    // The finishing steps of SplitMix64 (Steele, Lea and Flood, 2014).
    bits = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    0.5 + (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// Value of one of the nodes in `order`, which is sorted.
fn value(order: &[NodeId], values: &[f64], node: NodeId) -> f64 {
    let place = order.binary_search(&node).ok();
    place.and_then(|place| values.get(place)).copied().unwrap_or(f64::NAN)
}

/// Values of the nodes in `order` at a pseudo-random, reproducible point.
fn evaluate(graph: &Graph, order: &[NodeId], point: u32) -> Vec<f64> {
    let mut values = Vec::with_capacity(order.len());
    for &id in order {
        let of = |id: NodeId| value(order, &values, id);
        let value = match graph.node(id) {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Parameter(_)
            | Node::Initial(_)
            | Node::Independent
            | Node::State(_)
            | Node::Friction(..)
            | Node::Binomial(..)
            | Node::Solution { .. } => arbitrary(id.0, point),
            Node::Piece(number, x) => graph.interpolations()[number as usize].piece(of(x)),
            Node::Interpolated(number, x, piece) => graph.interpolations()[number as usize].value(of(x), of(piece)),
            Node::Unary(function, x) => function.evaluate(of(x)),
            Node::Binary(function, a, b) => function.evaluate(of(a), of(b)),
            Node::Select(condition, chosen, other) => {
                if of(condition) != 0.0 {
                    of(chosen)
                } else {
                    of(other)
                }
            }
        };
        values.push(value);
    }
    values
}

/// True if Gaussian elimination with pivoting finds a column without a pivot.
fn has_no_pivot(mut matrix: Vec<f64>, size: usize) -> bool {
    let mut rows: Vec<&mut [f64]> = matrix.chunks_mut(size).collect();
    for row in &mut rows {
        let greatest = row.iter().fold(0.0_f64, |greatest, entry| greatest.max(entry.abs()));
        if greatest > 0.0 {
            row.iter_mut().for_each(|entry| *entry /= greatest);
        }
    }
    for column in 0..size {
        let magnitude = |row: &usize| rows[*row][column].abs();
        let Some(pivot) = (column..size).max_by(|a, b| magnitude(a).total_cmp(&magnitude(b))) else {
            return false;
        };
        if rows[pivot][column].abs() < NEGLIGIBLE {
            return true;
        }
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let upper = &above[column];
        for row in below {
            let factor = row[column] / upper[column];
            // Most rows of a large system have a zero here.
            if factor == 0.0 {
                continue;
            }
            for (entry, &other) in row.iter_mut().zip(upper.iter()) {
                *entry -= factor * other;
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_dependent_rows_and_no_others() {
        assert!(has_no_pivot(vec![1.0, 2.0, 2.0, 4.0], 2));
        assert!(has_no_pivot(vec![0.0], 1));
        assert!(has_no_pivot(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0], 3));
        assert!(!has_no_pivot(vec![0.0, 1.0, 1.0, 0.0], 2));
        assert!(!has_no_pivot(vec![1e-20, 0.0, 0.0, 1e20], 2), "rows may have any scale");
    }

    fn alone(coefficient: NodeId) -> LinearSystem {
        LinearSystem::new([((0, 0), coefficient)], vec![coefficient])
    }

    #[test]
    fn looks_at_more_than_one_point() {
        let mut graph = Graph::default();
        let x = graph.insert(Node::State(0));
        let difference = graph.subtract(x, x);
        assert!(is_singular(&graph, &alone(difference)));
        assert!(!is_singular(&graph, &alone(x)));
    }
}

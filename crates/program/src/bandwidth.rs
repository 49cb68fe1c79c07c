//! Bandwidth reduction: an order of the unknowns of a sparse system with its entries close to the diagonal (reverse
//! Cuthill-McKee: Cuthill & McKee, Proc. 24th ACM Nat. Conf. (1969) 157; first node by George & Liu, ACM Trans. Math.
//! Softw. 5 (1979) 284).

use std::collections::VecDeque;
use units::order::{sort, sort_by_key};

/// Minimum size of a banded system: dense elimination is faster for smaller ones.
const LEAST_BANDED: usize = 32;

/// Order of the unknowns for a banded elimination of a matrix with entries at these (row, column); `None` if a dense
/// elimination takes less work.
pub fn banded_order(size: usize, pattern: &[(usize, usize)]) -> Option<Vec<usize>> {
    if size < LEAST_BANDED {
        return None;
    }
    let width = |order: &[usize]| {
        let (lower, upper) = bandwidth(pattern, &places(order));
        band_width(lower, upper)
    };
    let natural: Vec<usize> = (0..size).collect();
    let narrow = narrow_order(size, pattern);
    let order = if width(&natural) <= width(&narrow) { natural } else { narrow };
    (2 * width(&order) < size).then_some(order)
}

/// Stored numbers per row for a banded elimination with `lower` diagonals below and `upper` above the main one; row
/// exchanges fill `lower` further ones.
pub fn band_width(lower: usize, upper: usize) -> usize {
    2 * lower + upper + 1
}

/// Inverse permutation: the place of each number in `order`.
pub fn places(order: &[usize]) -> Vec<usize> {
    let mut places = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &number)| places[number] = place);
    places
}

/// Indices of the unknowns in an order of small bandwidth; `pattern` has row and column of every entry.
fn narrow_order(size: usize, pattern: &[(usize, usize)]) -> Vec<usize> {
    let mut neighbours = vec![Vec::new(); size];
    for &(row, column) in pattern.iter().filter(|(row, column)| row != column) {
        neighbours[row].push(column);
        neighbours[column].push(row);
    }
    for list in &mut neighbours {
        sort(list);
        list.dedup();
    }
    let degrees: Vec<usize> = neighbours.iter().map(Vec::len).collect();
    let sort = |nodes: &mut [usize]| sort_by_key(nodes, |&node| degrees[node]);
    neighbours.iter_mut().for_each(|list| sort(list));
    let mut order = Vec::with_capacity(size);
    let mut reached = vec![false; size];
    let mut by_degree: Vec<usize> = (0..size).collect();
    sort(&mut by_degree);
    for node in by_degree {
        if !reached[node] {
            let first = end_of(&neighbours, node);
            breadth_first(&neighbours, first, &mut reached, &mut order);
        }
    }
    order.reverse();
    order
}

/// Appends all nodes connected with `first` to `order`, by distance. Returns the greatest distance.
fn breadth_first(neighbours: &[Vec<usize>], first: usize, reached: &mut [bool], order: &mut Vec<usize>) -> usize {
    let mut waiting = VecDeque::from([(first, 0)]);
    let mut farthest = 0;
    reached[first] = true;
    while let Some((node, distance)) = waiting.pop_front() {
        order.push(node);
        farthest = distance;
        for &next in &neighbours[node] {
            if !std::mem::replace(&mut reached[next], true) {
                waiting.push_back((next, distance + 1));
            }
        }
    }
    farthest
}

/// Pseudo-peripheral node: a node far away from others in the component of `node`.
fn end_of(neighbours: &[Vec<usize>], node: usize) -> usize {
    /// Maximum number of attempts; further ones gain little.
    const ATTEMPTS: usize = 4;
    let (mut best, mut greatest) = (node, 0);
    for _ in 0..ATTEMPTS {
        let mut order = Vec::new();
        let farthest = breadth_first(neighbours, best, &mut vec![false; neighbours.len()], &mut order);
        let Some(&last) = order.last().filter(|_| farthest > greatest) else { break };
        (best, greatest) = (last, farthest);
    }
    best
}

/// Number of diagonals with entries below and above the main one; `place` has the place of each unknown.
pub fn bandwidth(pattern: &[(usize, usize)], place: &[usize]) -> (usize, usize) {
    pattern.iter().fold((0, 0), |(lower, upper), &(row, column)| {
        let (row, column) = (place[row], place[column]);
        (lower.max(row.saturating_sub(column)), upper.max(column.saturating_sub(row)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn narrowest(size: usize, pattern: &[(usize, usize)]) -> (usize, usize) {
        let order = narrow_order(size, pattern);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..size), "every unknown has a place");
        bandwidth(pattern, &places(&order))
    }

    #[test]
    fn a_chain_in_any_order_has_one_diagonal_on_each_side() {
        // 0, 7, 14, ... modulo 100 are neighbours.
        let pattern: Vec<(usize, usize)> = (0..99).map(|k| (7 * k % 100, 7 * (k + 1) % 100)).collect();
        assert_eq!(narrowest(100, &pattern).0.max(narrowest(100, &pattern).1), 1);
    }

    #[test]
    fn a_ring_has_two_and_a_square_lattice_one_for_each_row() {
        let ring: Vec<(usize, usize)> = (0..60).map(|k| (k, (k + 1) % 60)).collect();
        let (lower, upper) = narrowest(60, &ring);
        assert!(lower.max(upper) <= 2, "{lower} {upper}");
        let lattice: Vec<(usize, usize)> = (0..12)
            .flat_map(|i| {
                (0..30).flat_map(move |j| [(i * 30 + j, (i + 1) % 12 * 30 + j), (i * 30 + j, i * 30 + (j + 1) % 30)])
            })
            .filter(|&(from, to)| to > from)
            .collect();
        let (lower, upper) = narrowest(360, &lattice);
        assert!(lower.max(upper) <= 26, "{lower} {upper}");
    }

    #[test]
    fn parts_without_connection_stand_one_behind_the_other() {
        assert_eq!(narrowest(5, &[]), (0, 0));
        assert_eq!(narrowest(4, &[(0, 2), (1, 3)]).0.max(narrowest(4, &[(0, 2), (1, 3)]).1), 1);
    }
}

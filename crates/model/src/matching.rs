//! Pairing of equations with unknowns, and the order in which the pairs are solved.

use units::order::sort;

/// Pairs as many equations as possible with unknowns that they contain. `contains[equation]` lists unknowns.
///
/// Returns the equation of each unknown. Kuhn's augmenting paths, without recursion.
pub(crate) fn match_equations(contains: &[Vec<usize>], unknowns: usize) -> Vec<Option<usize>> {
    let mut equation_of: Vec<Option<usize>> = vec![None; unknowns];
    let mut unknown_of: Vec<Option<usize>> = vec![None; contains.len()];
    let mut from: Vec<Option<usize>> = vec![None; unknowns];
    let mut reached: Vec<usize> = Vec::new();
    for start in 0..contains.len() {
        // Breadth-first search: `from[unknown]` is the equation from which the unknown was reached.
        reached.drain(..).for_each(|unknown| from[unknown] = None);
        let mut waiting = vec![start];
        let mut next = 0;
        let mut free = None;
        'search: while let Some(&equation) = waiting.get(next) {
            next += 1;
            for &unknown in &contains[equation] {
                if from[unknown].is_some() {
                    continue;
                }
                from[unknown] = Some(equation);
                reached.push(unknown);
                match equation_of[unknown] {
                    Some(other) => waiting.push(other),
                    None => {
                        free = Some(unknown);
                        break 'search;
                    }
                }
            }
        }
        // Exchange the pairs along the augmenting path.
        while let Some(unknown) = free {
            let Some(equation) = from[unknown] else { break };
            free = unknown_of[equation].replace(unknown);
            equation_of[unknown] = Some(equation);
            if equation == start {
                break;
            }
        }
    }
    equation_of
}

/// Groups of unknowns that must be solved together, each group after the groups that it depends on. `needs[unknown]` lists
/// the other unknowns in its equation. Tarjan's strongly connected components, without recursion.
pub(crate) fn blocks(needs: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let mut number = vec![UNSEEN; needs.len()];
    let mut lowest = vec![UNSEEN; needs.len()];
    let mut open: Vec<usize> = Vec::new();
    let mut is_open = vec![false; needs.len()];
    let mut counter = 0;
    let mut blocks = Vec::new();
    for start in 0..needs.len() {
        if number[start] != UNSEEN {
            continue;
        }
        let mut path: Vec<(usize, usize)> = vec![(start, 0)];
        while let Some((at, edge)) = path.pop() {
            if edge == 0 {
                number[at] = counter;
                lowest[at] = counter;
                counter += 1;
                open.push(at);
                is_open[at] = true;
            }
            if let Some(&needed) = needs[at].get(edge) {
                path.push((at, edge + 1));
                if number[needed] == UNSEEN {
                    path.push((needed, 0));
                } else if is_open[needed] {
                    lowest[at] = lowest[at].min(number[needed]);
                }
                continue;
            }
            if let Some(&(parent, _)) = path.last() {
                lowest[parent] = lowest[parent].min(lowest[at]);
            }
            if lowest[at] == number[at] {
                let mut block = Vec::new();
                while let Some(member) = open.pop() {
                    is_open[member] = false;
                    block.push(member);
                    if member == at {
                        break;
                    }
                }
                sort(&mut block);
                blocks.push(block);
            }
        }
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exchanges_pairs_to_find_a_complete_matching() {
        let contains = [vec![0, 1], vec![0], vec![1, 2]];
        assert_eq!(match_equations(&contains, 3), [Some(1), Some(0), Some(2)]);
    }

    #[test]
    fn leaves_what_has_no_equation() {
        assert_eq!(match_equations(&[vec![0], vec![0]], 2), [Some(0), None]);
        assert_eq!(match_equations(&[], 1), [None]);
    }

    #[test]
    fn solves_in_order_and_together_only_what_is_coupled() {
        // 0 needs 1; 1 and 2 need each other; 3 needs 0.
        let needs = [vec![1], vec![2], vec![1], vec![0]];
        assert_eq!(blocks(&needs), [vec![1, 2], vec![0], vec![3]]);
    }

    #[test]
    fn a_long_chain_does_not_exhaust_the_stack() {
        let needs: Vec<Vec<usize>> =
            (0..100_000).map(|index| if index == 0 { vec![] } else { vec![index - 1] }).collect();
        assert_eq!(blocks(&needs).len(), 100_000);
    }
}

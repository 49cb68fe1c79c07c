//! Compares columns with single instructions.

use super::*;
use crate::Routine;
use crate::code::run;

/// A generator of arbitrary numbers below a bound (Knuth's MMIX).
struct Arbitrary(u64);

impl Arbitrary {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }
}

const STATES: usize = 50;

/// A graph with and without repetition: layers of one operation on neighbours, on one common value or on arbitrary nodes.
fn graph(arbitrary: &mut Arbitrary) -> (Graph, Vec<NodeId>) {
    const UNARY: [Unary; 4] = [Unary::Negate, Unary::Sin, Unary::Absolute, Unary::Exp];
    const BINARY: [Binary; 6] =
        [Binary::Add, Binary::Subtract, Binary::Multiply, Binary::Divide, Binary::Maximum, Binary::Less];
    let mut graph = Graph::default();
    let mut nodes: Vec<NodeId> = (0..STATES as u32).map(|state| graph.insert(Node::State(state))).collect();
    nodes.extend([Node::Independent, Node::Parameter(0), Node::Parameter(1)].map(|node| graph.insert(node)));
    nodes.extend([0.5, -3.0].map(|value| graph.constant(value)));
    for _ in 0..12 {
        let (start, other, common) =
            (nodes.len() - STATES.min(nodes.len()), arbitrary.below(nodes.len()), arbitrary.below(3));
        let (one, two) = (BINARY[arbitrary.below(BINARY.len())], BINARY[arbitrary.below(BINARY.len())]);
        let function = UNARY[arbitrary.below(UNARY.len())];
        let layer: Vec<NodeId> = (start..nodes.len() - 1)
            .map(|index| {
                let right = match common {
                    0 => nodes[other],
                    1 => nodes[index + 1],
                    _ => nodes[arbitrary.below(nodes.len())],
                };
                let first = graph.binary(one, nodes[index], right);
                let second = graph.unary(function, nodes[index + 1]);
                let sum = graph.binary(two, first, second);
                graph.select(right, sum, first)
            })
            .collect();
        nodes.extend(layer);
    }
    let size = 3;
    let matrix = nodes.iter().rev().take(size * size).enumerate();
    let entry = |(place, &node): (usize, &NodeId)| ((place / size, place % size), node);
    let system = graph.insert_system(program::LinearSystem::new(matrix.map(entry), nodes[..size].to_vec()));
    nodes.extend((0..size as u32).map(|row| graph.insert(Node::Solution { system, row })));
    (graph, nodes)
}

fn values<const ROWS: usize>(code: &mut Code, order: &[u32]) -> Vec<u64> {
    let mut registers: Vec<[f64; ROWS]> = code.registers.iter().map(|&value| [value; ROWS]).collect();
    registers[0] = std::array::from_fn(|row| 0.25 + row as f64);
    for (place, &state) in order.iter().enumerate() {
        registers[place + 1] = [libm::sin(f64::from(state)); ROWS];
    }
    for &(index, register) in &code.parameters {
        registers[register as usize] = [[2.5, -0.75][index]; ROWS];
    }
    run(&code.prologue, &mut registers, &code.columns, &code.interpolations, &mut code.systems);
    run(&code.body, &mut registers, &code.columns, &code.interpolations, &mut code.systems);
    code.registers = registers.iter().map(|values| values[ROWS - 1]).collect();
    let mut out = vec![0.0; code.roots.len()];
    code.copy_roots(&mut out);
    // Sign and payload of NaN are not specified.
    out.iter().map(|value| if value.is_nan() { 1 } else { value.to_bits() }).collect()
}

#[test]
fn columns_have_the_bits_of_single_instructions() {
    let mut arbitrary = Arbitrary(1);
    for _ in 0..40 {
        let (graph, roots) = graph(&mut arbitrary);
        let natural: Vec<u32> = (0..STATES as u32).collect();
        let reversed: Vec<u32> = natural.iter().rev().copied().collect();
        let mut single = compile_with(usize::MAX, &graph, natural.clone(), &roots);
        assert!(single.columns.is_empty());
        for order in [&natural, &reversed] {
            let places = order.clone();
            let mut columns = compile_with(0, &graph, places, &roots);
            assert!(columns.columns.len() > 10);
            assert_eq!(columns.operations(), single.operations());
            assert_eq!(values::<1>(&mut columns, order), values::<1>(&mut single, &natural));
            assert_eq!(values::<4>(&mut columns, order), values::<4>(&mut single, &natural));
        }
    }
}

#[test]
fn a_chain_is_a_few_columns() {
    let mut graph = Graph::default();
    let stiffness = graph.insert(Node::Parameter(0));
    let two = graph.constant(2.0);
    let x: Vec<NodeId> = (0..1000).map(|state| graph.insert(Node::State(state))).collect();
    let forces: Vec<NodeId> = x
        .windows(3)
        .map(|window| {
            let twice = graph.multiply(two, window[1]);
            let sum = graph.subtract(window[0], twice);
            let sum = graph.add(sum, window[2]);
            graph.multiply(stiffness, sum)
        })
        .collect();
    let code = compile(&graph, (0..1000).collect(), &forces);
    let columns: Vec<(Operation, u32)> = code.columns.iter().map(|column| (column.operation, column.count)).collect();
    let expected = [(Operation::SubtractProduct, 998), (Operation::Add, 998), (Operation::Multiply, 998)];
    assert_eq!(columns, expected);
    assert_eq!((code.body.len(), code.rows.len()), (3, 1));
}

/// Rows are computed with wider registers, many at once.
#[test]
fn rows_have_the_bits_of_single_evaluations() {
    let mut arbitrary = Arbitrary(3);
    let (graph, roots) = graph(&mut arbitrary);
    let mut routine = Routine::from_graph(&graph, STATES, &roots);
    let state: Vec<f64> = (0..STATES).map(|place| 0.1 * place as f64 - 2.0).collect();
    routine.prepare(&[0.7, -1.3], &state);
    let times: Vec<f64> = (0..37).map(|row| 0.21 * f64::from(row)).collect();
    let mut rows = vec![0.0; roots.len() * times.len()];
    routine.evaluate_rows(&times, &state, &mut rows);
    let mut values = vec![0.0; roots.len()];
    for (row, &time) in times.iter().enumerate() {
        routine.evaluate(time, &state, &mut values);
        for (root, value) in values.iter().enumerate() {
            let found = rows[root * times.len() + row];
            let same = found.to_bits() == value.to_bits() || found.is_nan() && value.is_nan();
            assert!(same, "root {root} at {time}: {found} and {value}");
        }
    }
}

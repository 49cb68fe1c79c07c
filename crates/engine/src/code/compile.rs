//! Compiler from expressions to register code.

use super::columns::{Entry, columns};
use super::instruction::{Elimination, Instruction, Operation, Register};
use crate::code::Code;
use crate::methods::sparse::Sparse;
use program::{Binary, Graph, Node, NodeId, Unary};

/// Minimum number of operations for a search for columns.
const LEAST_OPERATIONS: usize = 64;

/// Compiles code that computes `roots`; `places` has the position of each state in the state vector given at evaluation.
pub(crate) fn compile(graph: &Graph, places: Vec<u32>, roots: &[NodeId]) -> Code {
    compile_with(LEAST_OPERATIONS, graph, places, roots)
}

/// [`compile`] with a search for columns from `least` operations on.
fn compile_with(least: usize, graph: &Graph, places: Vec<u32>, roots: &[NodeId]) -> Code {
    let mut compiler = Compiler::new(graph, places, roots);
    compiler.compile(least);
    compiler.code.find_rows();
    compiler.code
}

/// The part of the code that computes a node.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    Unused,
    Prologue,
    Body,
}

struct Compiler<'a> {
    graph: &'a Graph,
    /// Position in the given state vector, one value per state.
    places: Vec<u32>,
    /// One value per node.
    stage: Vec<Stage>,
    /// Number of uses as an operand or a root, one value per node.
    uses: Vec<u32>,
    /// True for a product that is computed by the instruction of its sum, one value per node.
    absorbed: Vec<bool>,
    register: Vec<Register>,
    /// Index of each linear system of the graph in the code, `None` until it is emitted.
    system: Vec<Option<u32>>,
    code: Code,
}

impl<'a> Compiler<'a> {
    fn new(graph: &'a Graph, places: Vec<u32>, roots: &[NodeId]) -> Self {
        let nodes = graph.len();
        let interpolations = graph.interpolations().to_vec();
        let code = Code { registers: vec![0.0; places.len() + 1], interpolations, ..Code::default() };
        let mut compiler = Self {
            graph,
            places,
            stage: vec![Stage::Unused; nodes],
            uses: vec![0; nodes],
            absorbed: vec![false; nodes],
            register: vec![0; nodes],
            system: vec![None; graph.systems().len()],
            code,
        };
        compiler.mark(roots);
        compiler
    }

    /// Counts the uses of each node and determines its stage.
    fn mark(&mut self, roots: &[NodeId]) {
        for root in roots {
            self.uses[root.0 as usize] += 1;
        }
        // Operands have smaller indices, so a descending loop meets every user before its operands.
        let mut read = vec![false; self.graph.systems().len()];
        for index in (0..self.graph.len()).rev() {
            let node = self.graph.node(NodeId(index as u32));
            if self.uses[index] > 0 && first_of_system(node, &mut read) {
                for operand in operands(self.graph, node) {
                    self.uses[operand.0 as usize] += 1;
                }
            }
        }
        let mut stages = vec![Stage::Unused; self.graph.systems().len()];
        for index in 0..self.graph.len() {
            if self.uses[index] == 0 {
                continue;
            }
            let node = self.graph.node(NodeId(index as u32));
            self.stage[index] = match node {
                Node::Independent | Node::State(_) => Stage::Body,
                Node::Solution { system, .. } => {
                    if stages[system as usize] == Stage::Unused {
                        stages[system as usize] = self.latest(node);
                    }
                    stages[system as usize]
                }
                _ => self.latest(node),
            };
            if let Some((product, _)) = self.product(node, self.stage[index]) {
                self.absorbed[product.0 as usize] = true;
            }
        }
        self.code.roots = roots.iter().map(|root| root.0).collect();
    }

    /// The latest stage of the operands of a node.
    fn latest(&self, node: Node) -> Stage {
        let mut operands = operands(self.graph, node).into_iter();
        let in_body = operands.any(|operand| self.stage[operand.0 as usize] == Stage::Body);
        if in_body { Stage::Body } else { Stage::Prologue }
    }

    /// For a sum or difference: the operand that is a product without other users, and the other operand.
    fn product(&self, node: Node, stage: Stage) -> Option<(NodeId, NodeId)> {
        let (Node::Binary(Binary::Add, a, b) | Node::Binary(Binary::Subtract, a, b)) = node else {
            return None;
        };
        let lone = |id: NodeId| {
            let index = id.0 as usize;
            self.uses[index] == 1
                && self.stage[index] == stage
                && matches!(self.graph.node(id), Node::Binary(Binary::Multiply, ..))
        };
        if lone(a) {
            Some((a, b))
        } else if lone(b) {
            Some((b, a))
        } else {
            None
        }
    }

    fn compile(&mut self, least: usize) {
        let own = |&index: &usize| self.stage[index] != Stage::Unused && !self.absorbed[index];
        let mut nodes: Vec<usize> = (0..self.graph.len()).filter(own).collect();
        if nodes.len() >= least {
            nodes.retain(|&index| !self.input(index));
            self.compile_levels(&nodes);
        } else {
            for index in nodes {
                if !self.input(index) {
                    self.emit(index);
                }
            }
        }
        for root in &mut self.code.roots {
            *root = self.register[*root as usize];
        }
    }

    /// Compiles level by level: the operations of one level are independent and can form columns.
    fn compile_levels(&mut self, nodes: &[usize]) {
        for (stage, levels) in [Stage::Prologue, Stage::Body].map(|stage| (stage, self.levels(nodes, stage))) {
            for level in levels {
                let mut entries = Vec::new();
                for index in level {
                    match self.graph.node(NodeId(index as u32)) {
                        Node::Solution { .. } => self.emit(index),
                        node => {
                            let (operation, operands) = self.operation(node, stage);
                            entries.push(Entry { operation, operands, node: index });
                        }
                    }
                }
                self.emit_level(stage, entries);
            }
        }
    }

    /// Operations of a stage by level. The level is one more than the highest level of the operands in the same stage.
    fn levels(&self, nodes: &[usize], stage: Stage) -> Vec<Vec<usize>> {
        let mut level = vec![0_usize; self.graph.len()];
        let mut system = vec![None; self.graph.systems().len()];
        let mut levels: Vec<Vec<usize>> = Vec::new();
        for &index in nodes.iter().filter(|&&index| self.stage[index] == stage) {
            let node = self.graph.node(NodeId(index as u32));
            let of = |node: Node, of_absorbed: &dyn Fn(usize) -> usize| {
                let operands = operands(self.graph, node).into_iter();
                operands.map(|operand| of_absorbed(operand.0 as usize)).max().unwrap_or_default()
            };
            // The operands of an absorbed product are operands of the sum.
            let direct = |operand: usize| level[operand];
            let through = |operand: usize| match self.absorbed[operand] {
                true => of(self.graph.node(NodeId(operand as u32)), &direct),
                false => level[operand],
            };
            let own = match node {
                Node::Solution { system: number, .. } => {
                    *system[number as usize].get_or_insert_with(|| 1 + of(node, &direct))
                }
                _ => 1 + of(node, &through),
            };
            level[index] = own;
            if levels.len() < own {
                levels.resize_with(own, Vec::new);
            }
            levels[own - 1].push(index);
        }
        levels
    }

    /// Emits independent operations.
    fn emit_level(&mut self, stage: Stage, entries: Vec<Entry>) {
        let first = self.code.registers.len() as Register;
        let found = columns(entries, first);
        self.code.registers.resize(first as usize + found.order.len(), 0.0);
        for (to, entry) in (first..).zip(&found.order) {
            self.register[entry.node] = to;
        }
        for column in found.columns {
            let number = self.code.columns.len() as u32;
            self.code.columns.push(column);
            self.push(stage, Instruction::Column(number));
        }
        for place in found.alone {
            let entry = &found.order[place];
            self.push(stage, entry.operation.instruction(first + place as Register, entry.operands));
        }
    }

    /// True if a node has no operands; its register is then allocated.
    fn input(&mut self, index: usize) -> bool {
        let node = self.graph.node(NodeId(index as u32));
        self.register[index] = match node {
            Node::Independent => 0,
            Node::State(state) => self.places[state as usize] + 1,
            Node::Constant(bits) => self.allocate(f64::from_bits(bits)),
            // A finished model does not evaluate this node.
            Node::Friction(..) => self.allocate(f64::NAN),
            Node::Parameter(_) | Node::Initial(_) => self.allocate(0.0),
            _ => return false,
        };
        match node {
            Node::Parameter(parameter) => self.code.parameters.push((parameter as usize, self.register[index])),
            Node::Initial(state) => self.code.initial.push((state as usize, self.register[index])),
            _ => {}
        }
        true
    }

    /// Emits the code of a node that has operands.
    fn emit(&mut self, index: usize) {
        let node = self.graph.node(NodeId(index as u32));
        let stage = self.stage[index];
        if let Node::Solution { system, row } = node {
            let number = match self.system[system as usize] {
                Some(number) => number,
                None => self.emit_system(system, stage),
            };
            self.register[index] = self.code.systems[number as usize].target + row;
            return;
        }
        let (operation, operands) = self.operation(node, stage);
        let to = self.allocate(0.0);
        self.register[index] = to;
        self.push(stage, operation.instruction(to, operands));
    }

    /// Operation and operand registers of a node.
    fn operation(&self, node: Node, stage: Stage) -> (Operation, [Register; 3]) {
        if let Some((product, other)) = self.product(node, stage)
            && let Node::Binary(_, a, b) = self.graph.node(product)
        {
            let operation = match node {
                Node::Binary(Binary::Add, ..) => Operation::MultiplyAdd,
                Node::Binary(_, left, _) if left == product => Operation::MultiplySubtract,
                _ => Operation::SubtractProduct,
            };
            return (operation, [self.of(a), self.of(b), self.of(other)]);
        }
        match node {
            Node::Unary(function, a) => {
                let negates = function == Unary::Negate;
                (if negates { Operation::Negate } else { Operation::Unary(function) }, [self.of(a), 0, 0])
            }
            Node::Binary(function, a, b) => {
                let operation = match function {
                    Binary::Add => Operation::Add,
                    Binary::Subtract => Operation::Subtract,
                    Binary::Multiply => Operation::Multiply,
                    Binary::Divide => Operation::Divide,
                    _ => Operation::Binary(function),
                };
                (operation, [self.of(a), self.of(b), 0])
            }
            Node::Piece(interpolation, x) => (Operation::Piece(interpolation), [self.of(x), 0, 0]),
            Node::Interpolated(interpolation, x, piece) => {
                (Operation::Interpolated(interpolation), [self.of(x), self.of(piece), 0])
            }
            Node::Select(condition, a, b) => (Operation::Select, [condition, a, b].map(|operand| self.of(operand))),
            Node::Binomial(trials, probability, stream) => {
                (Operation::Binomial, [trials, probability, stream].map(|operand| self.of(operand)))
            }
            // Unreachable: `input` and `emit` handle inputs and solutions.
            _ => (Operation::Negate, [0; 3]),
        }
    }

    fn emit_system(&mut self, system: u32, stage: Stage) -> u32 {
        let linear = &self.graph.systems()[system as usize];
        let size = linear.right.len();
        let entries = linear.entries.iter().map(|entry| self.of(entry.node)).collect();
        let right = linear.right.iter().map(|&id| self.of(id)).collect();
        let target = self.code.registers.len() as Register;
        self.code.registers.resize(target as usize + size, 0.0);
        let number = self.code.systems.len() as u32;
        let matrix = Sparse::new(size, &linear.pattern());
        self.code.systems.push(Elimination { entries, right, target, matrix, solution: vec![0.0; size] });
        self.push(stage, Instruction::Solve(number));
        self.system[system as usize] = Some(number);
        number
    }

    fn push(&mut self, stage: Stage, instruction: Instruction) {
        match stage {
            Stage::Body => self.code.body.push(instruction),
            Stage::Prologue | Stage::Unused => self.code.prologue.push(instruction),
        }
    }

    fn allocate(&mut self, value: f64) -> Register {
        self.code.registers.push(value);
        (self.code.registers.len() - 1) as Register
    }

    fn of(&self, id: NodeId) -> Register {
        self.register[id.0 as usize]
    }
}

/// False for a further unknown of a linear system already met.
fn first_of_system(node: Node, read: &mut [bool]) -> bool {
    match node {
        Node::Solution { system, .. } => !std::mem::replace(&mut read[system as usize], true),
        _ => true,
    }
}

/// Operands of a node.
fn operands(graph: &Graph, node: Node) -> Vec<NodeId> {
    match node {
        Node::Constant(_) | Node::Parameter(_) | Node::Initial(_) | Node::Independent | Node::State(_) => Vec::new(),
        Node::Unary(_, a) | Node::Piece(_, a) => vec![a],
        Node::Binary(_, a, b) | Node::Interpolated(_, a, b) => vec![a, b],
        Node::Select(a, b, c) | Node::Friction(a, b, c) | Node::Binomial(a, b, c) => vec![a, b, c],
        Node::Solution { system, .. } => graph.systems()[system as usize].operands().collect(),
    }
}

#[cfg(test)]
mod tests;

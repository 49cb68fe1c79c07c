//! Compiles expressions of a model to register code and evaluates them.

use crate::instruction::{self, Elimination, Instruction, Register};
use crate::linear::Factors;
use program::{Binary, Graph, Model, Node, NodeId, Unary};

/// How many rows are computed at a time.
const ROWS: usize = 16;

/// Register code for a set of expressions, the roots. What depends on parameters and initial values only is computed once
/// by [`Routine::prepare`], the rest by each [`Routine::evaluate`], which allocates nothing.
#[derive(Clone, Debug)]
pub struct Routine {
    prologue: Vec<Instruction>,
    body: Vec<Instruction>,
    /// The independent variable, the states, then one for each node.
    registers: Vec<f64>,
    /// The same for many rows at a time, where these were asked for.
    rows: Vec<[f64; ROWS]>,
    states: usize,
    parameters: Vec<(usize, Register)>,
    initial: Vec<(usize, Register)>,
    roots: Vec<Register>,
    systems: Vec<Elimination>,
}

impl Routine {
    /// Compiles `roots`, nodes of the model's graph.
    pub fn compile(model: &Model, roots: &[NodeId]) -> Self {
        Self::from_graph(&model.graph, model.states.len(), roots)
    }

    /// Compiles `roots` of a graph with `states` states.
    pub fn from_graph(graph: &Graph, states: usize, roots: &[NodeId]) -> Self {
        let mut compiler = Compiler::new(graph, states, roots);
        compiler.compile();
        compiler.routine
    }

    /// Sets parameters and initial values, all in SI, in the model's order.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        for &(index, register) in &self.parameters {
            self.registers[register as usize] = parameters[index];
        }
        for &(index, register) in &self.initial {
            self.registers[register as usize] = initial[index];
        }
        instruction::run(&self.prologue, self.registers.as_chunks_mut::<1>().0, &mut self.systems);
    }

    /// Computes all roots at `time` and `state`; `out[i]` becomes the value of `roots[i]`.
    #[inline]
    pub fn evaluate(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.evaluate_at(time, out, |k| state[k]);
    }

    /// [`Routine::evaluate`] at the state whose number `k` is `state(k)`: what a method needs between two stages goes
    /// straight into the registers.
    #[inline]
    pub(crate) fn evaluate_at(&mut self, time: f64, out: &mut [f64], state: impl Fn(usize) -> f64) {
        if let Some((clock, registers)) = self.registers.split_first_mut() {
            *clock = time;
            for (k, register) in registers.iter_mut().take(self.states).enumerate() {
                *register = state(k);
            }
        }
        instruction::run(&self.body, self.registers.as_chunks_mut::<1>().0, &mut self.systems);
        for (value, &register) in out.iter_mut().zip(&self.roots) {
            *value = self.registers[register as usize];
        }
    }

    /// Computes all roots at many times and one state: those of root `i` stand in `out` from `i * times.len()` on. They have
    /// the bits of [`Routine::evaluate`].
    pub fn evaluate_rows(&mut self, times: &[f64], state: &[f64], out: &mut [f64]) {
        self.registers[1..=self.states].copy_from_slice(&state[..self.states]);
        self.rows.clear();
        self.rows.extend(self.registers.iter().map(|&value| [value; ROWS]));
        for (chunk, some) in times.chunks(ROWS).enumerate() {
            self.rows[0][..some.len()].copy_from_slice(some);
            instruction::run(&self.body, &mut self.rows, &mut self.systems);
            for (column, &register) in out.chunks_mut(times.len()).zip(&self.roots) {
                let values = &self.rows[register as usize][..some.len()];
                column[chunk * ROWS..][..some.len()].copy_from_slice(values);
            }
        }
    }

    /// How many roots there are.
    pub fn len(&self) -> usize {
        self.roots.len()
    }

    /// Whether there are no roots.
    pub fn is_empty(&self) -> bool {
        self.roots.is_empty()
    }

    /// How many instructions an evaluation takes.
    pub fn instructions(&self) -> usize {
        self.body.len()
    }

    /// About how many floating-point operations an evaluation takes, copying included.
    pub(crate) fn work(&self) -> u64 {
        let systems: usize = self.systems.iter().map(|system| system.work()).sum();
        (self.body.len() + self.roots.len() + self.states + systems) as u64
    }

    /// Whether the last evaluation met a linear system without a solution.
    pub(crate) fn singular(&self) -> bool {
        self.systems.iter().any(|system| system.factors.singular)
    }
}

/// When a node can be computed.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    Unused,
    Prologue,
    Body,
}

struct Compiler<'a> {
    graph: &'a Graph,
    /// By node.
    stage: Vec<Stage>,
    /// How often each node is read, as an operand or a root.
    uses: Vec<u32>,
    /// Products computed as part of the sum that reads them.
    absorbed: Vec<bool>,
    register: Vec<Register>,
    /// By system of the graph: its number in the routine.
    system: Vec<Option<u32>>,
    routine: Routine,
}

impl<'a> Compiler<'a> {
    fn new(graph: &'a Graph, states: usize, roots: &[NodeId]) -> Self {
        let routine = Routine {
            prologue: Vec::new(),
            body: Vec::new(),
            registers: vec![0.0; states + 1],
            rows: Vec::new(),
            states,
            parameters: Vec::new(),
            initial: Vec::new(),
            roots: Vec::new(),
            systems: Vec::new(),
        };
        let nodes = graph.len();
        let mut compiler = Self {
            graph,
            stage: vec![Stage::Unused; nodes],
            uses: vec![0; nodes],
            absorbed: vec![false; nodes],
            register: vec![0; nodes],
            system: vec![None; graph.systems().len()],
            routine,
        };
        compiler.mark(roots);
        compiler
    }

    /// Finds what is used, how often, and when it can be computed.
    fn mark(&mut self, roots: &[NodeId]) {
        for root in roots {
            self.uses[root.0 as usize] += 1;
        }
        // Operands have smaller numbers, so going down meets every reader before what it reads.
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
        self.routine.roots = roots.iter().map(|root| root.0).collect();
    }

    /// The latest stage of what a node reads.
    fn latest(&self, node: Node) -> Stage {
        let mut operands = operands(self.graph, node).into_iter();
        let in_body = operands.any(|operand| self.stage[operand.0 as usize] == Stage::Body);
        if in_body { Stage::Body } else { Stage::Prologue }
    }

    /// The operand of a sum or difference that is a product without other readers, and the other operand.
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

    fn compile(&mut self) {
        for index in 0..self.graph.len() {
            if self.stage[index] != Stage::Unused && !self.absorbed[index] {
                self.emit(index);
            }
        }
        for root in &mut self.routine.roots {
            *root = self.register[*root as usize];
        }
    }

    fn emit(&mut self, index: usize) {
        let node = self.graph.node(NodeId(index as u32));
        let stage = self.stage[index];
        match node {
            Node::Independent => self.register[index] = 0,
            Node::State(state) => self.register[index] = state + 1,
            Node::Constant(bits) => self.register[index] = self.allocate(f64::from_bits(bits)),
            // In a finished model nothing is computed from it.
            Node::Friction(..) => self.register[index] = self.allocate(f64::NAN),
            Node::Parameter(parameter) => {
                let register = self.allocate(0.0);
                self.register[index] = register;
                self.routine.parameters.push((parameter as usize, register));
            }
            Node::Initial(state) => {
                let register = self.allocate(0.0);
                self.register[index] = register;
                self.routine.initial.push((state as usize, register));
            }
            Node::Solution { system, row } => {
                let number = match self.system[system as usize] {
                    Some(number) => number,
                    None => self.emit_system(system, stage),
                };
                self.register[index] = self.routine.systems[number as usize].target + row;
            }
            Node::Unary(..) | Node::Binary(..) | Node::Select(..) => {
                let to = self.allocate(0.0);
                self.register[index] = to;
                let instruction = self.instruction(node, stage, to);
                self.push(stage, instruction);
            }
        }
    }

    fn instruction(&mut self, node: Node, stage: Stage, to: Register) -> Instruction {
        if let Some((product, other)) = self.product(node, stage)
            && let Node::Binary(_, a, b) = self.graph.node(product)
        {
            let (a, b, c) = (self.of(a), self.of(b), self.of(other));
            return match node {
                Node::Binary(Binary::Add, ..) => Instruction::MultiplyAdd(to, a, b, c),
                Node::Binary(_, left, _) if left == product => Instruction::MultiplySubtract(to, a, b, c),
                _ => Instruction::SubtractProduct(to, a, b, c),
            };
        }
        match node {
            Node::Unary(Unary::Negate, a) => Instruction::Negate(to, self.of(a)),
            Node::Unary(function, a) => Instruction::Unary(function, to, self.of(a)),
            Node::Binary(Binary::Add, a, b) => Instruction::Add(to, self.of(a), self.of(b)),
            Node::Binary(Binary::Subtract, a, b) => Instruction::Subtract(to, self.of(a), self.of(b)),
            Node::Binary(Binary::Multiply, a, b) => Instruction::Multiply(to, self.of(a), self.of(b)),
            Node::Binary(Binary::Divide, a, b) => Instruction::Divide(to, self.of(a), self.of(b)),
            Node::Binary(function, a, b) => Instruction::Binary(function, to, self.of(a), self.of(b)),
            Node::Select(condition, a, b) => Instruction::Select(to, self.of(condition), self.of(a), self.of(b)),
            // Inputs and solutions are not computed by instructions of their own; `emit` has dealt with them.
            _ => Instruction::Negate(to, to),
        }
    }

    fn emit_system(&mut self, system: u32, stage: Stage) -> u32 {
        let linear = &self.graph.systems()[system as usize];
        let size = linear.right.len();
        let matrix = linear.matrix.iter().map(|&id| self.of(id)).collect();
        let right = linear.right.iter().map(|&id| self.of(id)).collect();
        let target = self.routine.registers.len() as Register;
        self.routine.registers.resize(target as usize + size, 0.0);
        let number = self.routine.systems.len() as u32;
        let factors = Factors::new(size);
        self.routine.systems.push(Elimination { matrix, right, target, factors, solution: vec![0.0; size] });
        self.push(stage, Instruction::Solve(number));
        self.system[system as usize] = Some(number);
        number
    }

    fn push(&mut self, stage: Stage, instruction: Instruction) {
        match stage {
            Stage::Body => self.routine.body.push(instruction),
            Stage::Prologue | Stage::Unused => self.routine.prologue.push(instruction),
        }
    }

    fn allocate(&mut self, value: f64) -> Register {
        self.routine.registers.push(value);
        (self.routine.registers.len() - 1) as Register
    }

    fn of(&self, id: NodeId) -> Register {
        self.register[id.0 as usize]
    }
}

/// Whether this is not a further unknown of a system that has been read already.
fn first_of_system(node: Node, read: &mut [bool]) -> bool {
    match node {
        Node::Solution { system, .. } => !std::mem::replace(&mut read[system as usize], true),
        _ => true,
    }
}

/// What a node reads.
fn operands(graph: &Graph, node: Node) -> Vec<NodeId> {
    match node {
        Node::Constant(_) | Node::Parameter(_) | Node::Initial(_) | Node::Independent | Node::State(_) => Vec::new(),
        Node::Unary(_, a) => vec![a],
        Node::Binary(_, a, b) => vec![a, b],
        Node::Select(a, b, c) | Node::Friction(a, b, c) => vec![a, b, c],
        Node::Solution { system, .. } => {
            let system = &graph.systems()[system as usize];
            system.matrix.iter().chain(&system.right).copied().collect()
        }
    }
}

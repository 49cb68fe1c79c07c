//! WebAssembly for the steps of a model: whole steps of a method without dispatch.
//!
//! A module imports a memory, `block.memory`, with the block of numbers that [`engine::Layout`] or [`engine::WindowLayout`]
//! describes, and the functions of [`Module::functions`], `function.0` and so on. It exports `run`, which takes the address
//! of the block in bytes and the greatest number of steps or rows, and returns what [`engine::Compiled::run`] returns.
//!
//! | file | content |
//! |---|---|
//! | `methods.rs` | the loop over the steps of the fixed-step methods |
//! | `window.rs`, `step.rs`, `control.rs`, `checks.rs` | the same of the Dormand-Prince method |
//! | `lanes.rs` | rounds of the Dormand-Prince method over pairs of runs |
//! | `body.rs`, `operation.rs`, `interpolation.rs` | formulas, single operations, tables |
//! | `sink` | the function in the making, with its blocks and loops in `flow.rs` |
//! | `arithmetic.rs` | instructions for each kind of `Values` |
//! | `function.rs`, `calls.rs` | imported functions |
//! | `routine.rs`, `runs.rs`, `states.rs` | functions, loops and order of the states of code with many operations |
//!
//! Elementary functions, the powers of the step control and the judgement of an interpolant are imported, so that they exist
//! once. Values are numbers, or pairs of numbers of two runs in SIMD registers, so that runs side by side ([`side_by_side`])
//! are made by the same code; functions are called for each number of a pair. A browser without SIMD refuses such a module,
//! and its runs are made one by one. Rosenbrock's method, linear systems, counting variables and steps of too many operations
//! stay interpreted, with the reason in the `Result`; `cargo xtask bench` prints it, and `cargo xtask bench emitted` measures
//! emitted code alone.
//!
//! Steps of up to 6,000 operations are straight code with a local variable for each value. Those of more, as of a gas or a
//! string, are loops over lists in the block (`sink/lists.rs`): what a method does for each state is written once
//! (`Sink::each`), and the loop does two elements at a time in SIMD registers. The states are then in the order of their
//! registers (`states.rs`), in which positions are consecutive, and `sink/rows.rs` stores them in the order of the model. The
//! right-hand side is one or several functions that all stages call. The engine gives equal operations consecutive registers,
//! so that each run of them is a loop; results that a single run reads are computed in its loop and never stored.
//! [`module_of_lists`] makes such code of any listing, for tests. The tests and the fuzz target `emit` run modules in
//! `wasmi`, and so does `cargo run -p emit --example fuzz -- 10`, which compares programs of numbered seeds for ten minutes.
//!
//! - **Invariant:** emitted code does the operations of the interpreter in its order, and no multiply-add is fused: runs have
//!   the same bits.
//! - **Invariant:** this crate only encodes; it runs nothing.

mod arithmetic;
mod body;
mod calls;
mod checks;
mod control;
mod function;
mod interpolation;
mod lanes;
mod methods;
mod operation;
mod routine;
mod runs;
mod sink;
mod states;
mod step;
mod window;

pub use function::{Function, Plain};

use calls::Calls;
use engine::{LanesListing, Listing};
use program::Interpolation;
use sink::{Sink, Values};
use std::sync::Arc;
use wasm_encoder::{
    CodeSection, EntityType, ExportKind, ExportSection, FunctionSection, ImportSection, MemoryType, TypeSection,
    ValType,
};

/// A module in the binary format of WebAssembly.
#[derive(Clone, Debug)]
pub struct Module {
    /// The module.
    pub bytes: Vec<u8>,
    /// Functions that it imports, in the order of their numbers.
    pub functions: Vec<Function>,
}

/// Number of operations that are too many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyOperations(pub usize);

/// Maximum number of operations of a step that is straight code: the evaluations of the right-hand side and the sums of the method.
const MOST_OPERATIONS: usize = 6000;

/// Maximum number of operations and loops of a step with lists in memory, each evaluation of formulas counted once.
const MOST_LOOPS: usize = 40_000;

/// Emits the steps of a listing. Browsers need SIMD for those of many operations.
///
/// # Errors
/// The step has too many operations.
pub fn module(listing: &Listing) -> Result<Module, TooManyOperations> {
    if methods::operations(listing) > MOST_OPERATIONS {
        return module_of_lists(listing);
    }
    Ok(steps(listing, None))
}

/// Emits the steps of a listing as loops over lists in memory, as [`module`] does for many operations.
///
/// # Errors
/// The step has too many operations.
pub fn module_of_lists(listing: &Listing) -> Result<Module, TooManyOperations> {
    let loops = methods::loops(listing);
    if loops > MOST_LOOPS {
        return Err(TooManyOperations(loops));
    }
    let own = listing.window.as_ref().map_or(listing.layout.own(), |window| window.layout.own());
    Ok(steps(listing, Some(own)))
}

/// `lists`: first place of the block for lists, which are local variables otherwise.
fn steps(listing: &Listing, lists: Option<usize>) -> Module {
    let calls = Calls::of(listing, &[]);
    let mut sink = Sink::new(Values::Numbers, &calls, lists);
    methods::steps(listing, &mut sink);
    let routines = sink.take_routines();
    let run = sink.finish();
    with_functions(&run, &routines, calls, &listing.interpolations)
}

/// Emits the steps of runs side by side, for [`engine::SideBySide`]. Browsers need SIMD for it. `run` takes the address of the numbers
/// of the first pair and the number of steps or rounds, at least 1, and returns that of those made.
///
/// # Errors
/// The step has too many operations.
pub fn side_by_side(listing: &LanesListing) -> Result<Module, TooManyOperations> {
    let LanesListing { steps, readings, .. } = listing;
    let operations = methods::operations(steps) + readings.lines.len();
    if operations > MOST_OPERATIONS {
        return Err(TooManyOperations(operations));
    }
    let calls = Calls::of(steps, &readings.lines);
    let mut sink = Sink::new(Values::Pairs, &calls, None);
    methods::steps_side_by_side(listing, &mut sink);
    Ok(with_functions(&sink.finish(), &[], calls, &steps.interpolations))
}

/// The module of the function `run` with those that it calls.
fn with_functions(
    run: &wasm_encoder::Function,
    routines: &[wasm_encoder::Function],
    calls: Calls,
    interpolations: &[Arc<Interpolation>],
) -> Module {
    let (mut types, mut imports) = (TypeSection::new(), ImportSection::new());
    for operands in 1..=Function::MOST_OPERANDS {
        types.ty().function(std::iter::repeat_n(ValType::F64, operands), [ValType::F64]);
    }
    types.ty().function([ValType::I32, ValType::I32], [ValType::I32]);
    types.ty().function([ValType::I32], []);
    let memory = MemoryType { minimum: 0, maximum: None, memory64: false, shared: false, page_size_log2: None };
    imports.import("block", "memory", memory);
    for (number, function) in calls.imported.iter().enumerate() {
        imports.import("function", &number.to_string(), EntityType::Function(function.operands() as u32 - 1));
    }
    let (mut own, mut exports, mut code) = (FunctionSection::new(), ExportSection::new(), CodeSection::new());
    own.function(Function::MOST_OPERANDS as u32);
    exports.export("run", ExportKind::Func, calls.imported.len() as u32);
    code.function(run);
    for &function in &calls.own {
        let of = |number: u32| &interpolations[number as usize];
        let body = match function {
            Function::Interpolated(number) => interpolation::value(of(number)),
            Function::Piece(number) => interpolation::piece(of(number)),
            // All others are imported.
            _ => continue,
        };
        own.function(function.operands() as u32 - 1);
        code.function(&body);
    }
    for routine in routines {
        own.function(Function::MOST_OPERANDS as u32 + 1);
        code.function(routine);
    }
    let mut module = wasm_encoder::Module::new();
    module.section(&types).section(&imports).section(&own).section(&exports).section(&code);
    Module { bytes: module.finish(), functions: calls.imported }
}

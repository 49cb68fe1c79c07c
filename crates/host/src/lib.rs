//! Emitted code in a browser. An instance works on the memory of the module that this crate is part of. It finds the
//! elementary functions in that module's table by their address, so that no JavaScript stands between.
//!
//! [`Compiler`] keeps the code of the last listings. The laboratory gives it to the time line of each document that it opens
//! (`TimeLine::use_compiler`; `play` has the trait only, in `Motion`), and its workers make the steps of fits with it
//! (`FitComputation::compile`). The player interprets; a run that it began goes on in emitted code when the laboratory takes
//! it over.
//!
//! - **Invariant:** what is not compiled is interpreted, with the same bits; [`Fallback`] says why.

use emit::{Function, Plain};
use engine::{Compiled, Interpreted, LanesListing, Listing, Setup, SideBySide};
use js_sys::{Object, Reflect, Uint8Array, WebAssembly};
use program::{Interpolation, Model, NodeId};
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen::prelude::{Closure, JsCast, JsValue, wasm_bindgen};

#[wasm_bindgen]
extern "C" {
    /// Exports of an emitted module.
    type Exports;

    #[wasm_bindgen(method)]
    fn run(this: &Exports, block: u32, count: u32) -> u32;
}

/// Reason why steps are interpreted.
#[derive(Clone, Debug, PartialEq)]
pub enum Fallback {
    /// The engine has no listing of them.
    Interpreted(Interpreted),
    /// There are too many operations.
    TooManyOperations(usize),
    /// The browser refuses the module: its message.
    Refused(String),
}

/// Compiles the steps of a stepper or a run from its listing.
///
/// # Errors
/// The reason why they are interpreted.
pub fn compile(listing: Result<Listing, Interpreted>) -> Result<Rc<dyn Compiled>, Fallback> {
    let listing = listing.map_err(Fallback::Interpreted)?;
    let module = emit::module(&listing).map_err(|error| Fallback::TooManyOperations(error.0))?;
    instance(&module, &listing.interpolations)
}

/// Compiles the steps of runs side by side.
///
/// # Errors
/// The reason why there is no code for them.
pub fn compile_side_by_side(listing: &LanesListing) -> Result<Rc<dyn Compiled>, Fallback> {
    let module = emit::side_by_side(listing).map_err(|error| Fallback::TooManyOperations(error.0))?;
    instance(&module, &listing.steps.interpolations)
}

/// Compiles a module in the browser.
fn instance(module: &emit::Module, interpolations: &[Arc<Interpolation>]) -> Result<Rc<dyn Compiled>, Fallback> {
    let instance = Instance::new(module, interpolations);
    instance
        .map(|instance| Rc::new(instance) as Rc<dyn Compiled>)
        .map_err(|error| Fallback::Refused(format!("{error:?}")))
}

/// Compiles steps and keeps the code of the last listings: a run that begins again has the same.
#[derive(Debug, Default)]
pub struct Compiler {
    /// Last used first.
    known: RefCell<Vec<Known>>,
}

/// A listing with its code; `None` if its steps are interpreted.
type Known = (Listing, Option<Rc<dyn Compiled>>);

impl Compiler {
    /// Maximum number of listings kept.
    const KEPT: usize = 4;
}

impl engine::Compiler for Compiler {
    fn compile(&self, listing: Listing) -> Option<Rc<dyn Compiled>> {
        let mut known = self.known.borrow_mut();
        let entry = match known.iter().position(|(known, _)| *known == listing) {
            Some(place) => known.remove(place),
            None => {
                let code = compile(Ok(listing.clone())).ok();
                (listing, code)
            }
        };
        let code = entry.1.clone();
        known.insert(0, entry);
        known.truncate(Self::KEPT);
        code
    }

    fn side_by_side(&self, model: &Model, setup: &Setup, nodes: &[NodeId]) -> Option<Box<dyn SideBySide>> {
        let alone = |listing| self.compile(listing);
        engine::side_by_side(model, setup, nodes, |listing| compile_side_by_side(listing).ok(), alone)
    }
}

/// An instance of an emitted module.
struct Instance {
    exports: Exports,
    /// Functions with data of their own, which live as long as the instance.
    _interpolations: Vec<Closure<dyn Fn(f64, f64) -> f64>>,
}

impl Instance {
    fn new(module: &emit::Module, interpolations: &[Arc<Interpolation>]) -> Result<Self, JsValue> {
        let table: WebAssembly::Table = wasm_bindgen::function_table().unchecked_into();
        let functions = Object::new();
        let mut closures = Vec::new();
        for (number, &function) in module.functions.iter().enumerate() {
            let value = match function.plain() {
                // A function pointer is an index into the table of functions.
                Some(Plain::One(function)) => table.get(function as usize as u32)?.into(),
                Some(Plain::Two(function)) => table.get(function as usize as u32)?.into(),
                Some(Plain::Three(function)) => table.get(function as usize as u32)?.into(),
                Some(Plain::Six(function)) => table.get(function as usize as u32)?.into(),
                None => {
                    let closure = with_data(function, interpolations.to_vec());
                    let value = closure.as_ref().clone();
                    closures.push(closure);
                    value
                }
            };
            Reflect::set(&functions, &number.to_string().into(), &value)?;
        }
        let (block, imports) = (Object::new(), Object::new());
        Reflect::set(&block, &"memory".into(), &wasm_bindgen::memory())?;
        Reflect::set(&imports, &"block".into(), &block)?;
        Reflect::set(&imports, &"function".into(), &functions)?;
        let module = WebAssembly::Module::new(&Uint8Array::from(module.bytes.as_slice()))?;
        let exports = WebAssembly::Instance::new(&module, &imports)?.exports().unchecked_into();
        Ok(Self { exports, _interpolations: closures })
    }
}

/// A function of an interpolation.
fn with_data(function: Function, interpolations: Vec<Arc<Interpolation>>) -> Closure<dyn Fn(f64, f64) -> f64> {
    Closure::new(move |a, b| function.value([a, b, 0.0, 0.0, 0.0, 0.0], &interpolations))
}

impl fmt::Debug for Instance {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Instance")
    }
}

impl Compiled for Instance {
    fn run(&self, block: &mut [f64], count: u32) -> u32 {
        // The code changes the block in this memory; it has the place of every number from its layout.
        self.exports.run(block.as_mut_ptr() as usize as u32, count)
    }
}

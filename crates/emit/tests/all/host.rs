//! A host that runs emitted modules.

use emit::{Function, Module};
use engine::{Compiled, LanesListing, Listing};
use program::Interpolation;
use std::cell::RefCell;
use std::sync::Arc;
use wasmi::{Caller, Engine, Func, FuncType, Linker, Memory, MemoryType, Store, TypedFunc, Val, ValType};

/// An instance of an emitted module.
#[derive(Debug)]
pub struct Instance {
    store: RefCell<Store<()>>,
    memory: Memory,
    run: TypedFunc<(i32, i32), i32>,
    /// Length of the part of the block that a single attempt of a step uses.
    attempt: usize,
}

impl Instance {
    /// Compiles a module that was emitted for `listing`.
    pub fn new(module: &Module, listing: &Listing) -> Self {
        let attempt = listing.window.as_ref().map_or(0, |window| window.layout.record(2));
        Self::with_functions(module, &listing.interpolations, attempt)
    }

    /// Compiles a module that was emitted for runs side by side.
    pub fn side_by_side(module: &Module, listing: &LanesListing) -> Self {
        Self::with_functions(module, &listing.steps.interpolations, 0)
    }

    fn with_functions(module: &Module, interpolations: &[Arc<Interpolation>], attempt: usize) -> Self {
        let engine = Engine::default();
        let compiled = wasmi::Module::new(&engine, &module.bytes).expect("a valid module");
        let mut store = Store::new(&engine, ());
        let memory = Memory::new(&mut store, MemoryType::new(64, None)).expect("memory");
        let mut linker = Linker::new(&engine);
        linker.define("block", "memory", memory).expect("one memory");
        for (number, function) in module.functions.iter().copied().enumerate() {
            let interpolations = interpolations.to_vec();
            let call = move |_: Caller<'_, ()>, operands: &[Val], results: &mut [Val]| {
                let mut numbers = [0.0; Function::MOST_OPERANDS];
                for (number, operand) in numbers.iter_mut().zip(operands) {
                    *number = f64::from(operand.f64().expect("a number"));
                }
                results[0] = Val::F64(function.value(numbers, &interpolations).into());
                Ok(())
            };
            let of_type = FuncType::new(vec![ValType::F64; function.operands()], [ValType::F64]);
            let function = Func::new(&mut store, of_type, call);
            linker.define("function", &number.to_string(), function).expect("one function of this number");
        }
        let instance = linker.instantiate_and_start(&mut store, &compiled).expect("all imports");
        let run = instance.get_typed_func(&store, "run").expect("a function `run`");
        Self { store: RefCell::new(store), memory, run, attempt }
    }
}

impl Compiled for Instance {
    fn run(&self, block: &mut [f64], count: u32) -> u32 {
        let block = if count == 0 { &mut block[..self.attempt] } else { block };
        let store = &mut *self.store.borrow_mut();
        let places = self.memory.data_mut(&mut *store).as_chunks_mut().0;
        assert!(places.len() >= block.len(), "memory for the block");
        block.iter().zip(places).for_each(|(number, place)| *place = number.to_le_bytes());
        let made = self.run.call(&mut *store, (0, count as i32)).expect("no trap");
        for (number, bytes) in block.iter_mut().zip(self.memory.data(&*store).as_chunks().0) {
            *number = f64::from_le_bytes(*bytes);
        }
        made as u32
    }
}

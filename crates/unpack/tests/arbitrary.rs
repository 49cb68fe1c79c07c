//! Whatever the bytes are, they come back as they were, and what holds no module is told from what does.

use proptest::prelude::*;
use unpack::{join, split};
use wasm_encoder::{
    BlockType, CodeSection, DataCountSection, DataSection, Function, Instruction, MemArg, Module, ValType,
};

/// Instructions of each kind that the walk tells apart.
fn instruction() -> impl Strategy<Value = Instruction<'static>> {
    let place = |offset| MemArg { offset, align: 2, memory_index: 0 };
    prop_oneof![
        any::<u32>().prop_map(Instruction::LocalGet),
        any::<u32>().prop_map(Instruction::LocalTee),
        any::<u32>().prop_map(Instruction::GlobalSet),
        any::<u32>().prop_map(Instruction::Call),
        any::<u32>().prop_map(Instruction::BrIf),
        any::<u32>().prop_map(Instruction::MemoryFill),
        any::<i32>().prop_map(Instruction::I32Const),
        any::<i64>().prop_map(Instruction::I64Const),
        any::<f64>().prop_map(|value| Instruction::F64Const(value.into())),
        any::<u32>().prop_map(move |offset| Instruction::I32Load(place(offset.into()))),
        any::<u32>().prop_map(move |offset| Instruction::F64Store(place(offset.into()))),
        any::<u32>().prop_map(|type_index| Instruction::CallIndirect { type_index, table_index: 0 }),
        any::<u32>().prop_map(|label| Instruction::BrTable(vec![label; 5].into(), 3)),
        Just(Instruction::TypedSelect(ValType::F64)),
        Just(Instruction::Block(BlockType::Result(ValType::I32))),
        Just(Instruction::MemoryCopy { src_mem: 0, dst_mem: 0 }),
        Just(Instruction::I32TruncSatF64S),
        Just(Instruction::F64Add),
        Just(Instruction::End),
    ]
}

prop_compose! {
    fn module()(
        functions in prop::collection::vec(prop::collection::vec(instruction(), 0..30), 0..5),
        data in prop::collection::vec(any::<u8>(), 0..200),
    ) -> Vec<u8> {
        let mut code = CodeSection::new();
        for instructions in functions {
            let mut function = Function::new([(3, ValType::I32), (200, ValType::F64)]);
            for instruction in &instructions {
                function.instruction(instruction);
            }
            code.function(&function);
        }
        let mut section = DataSection::new();
        section.passive(data);
        let mut module = Module::new();
        module.section(&DataCountSection { count: 1 }).section(&code).section(&section);
        module.finish()
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_module_comes_back(module in module()) {
        prop_assert_eq!(join(&split(&module).unwrap()), Some(module));
    }

    #[test]
    fn a_damaged_module_comes_back(mut module in module(), places in prop::collection::vec(any::<(prop::sample::Index, u8)>(), 1..20)) {
        for (place, byte) in places {
            let place = place.index(module.len());
            module[place] = byte;
        }
        prop_assert_eq!(join(&split(&module).unwrap()), Some(module));
    }

    #[test]
    fn any_bytes_come_back(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert_eq!(join(&split(&bytes).unwrap()), Some(bytes));
    }

    #[test]
    fn joining_damaged_streams_is_safe(module in module(), place in any::<prop::sample::Index>(), byte: u8) {
        let mut parts = split(&module).unwrap();
        let place = place.index(parts.len());
        parts[place] = byte;
        // Of the same length if they are taken for a module at all.
        prop_assert!(join(&parts).is_none_or(|joined| joined.len() == module.len()));
        prop_assert_eq!(join(&parts[..place]), None);
    }
}

#[test]
fn each_kind_stands_in_a_stream_of_its_own() {
    let mut function = Function::new([]);
    for number in 0..50 {
        function.instruction(&Instruction::LocalGet(7)).instruction(&Instruction::I32Const(number));
    }
    let mut code = CodeSection::new();
    code.function(&function);
    let mut module = Module::new();
    let parts = split(&module.section(&code).clone().finish()).unwrap();
    for stream in [[7; 50].to_vec(), (0..50).collect(), [0x20, 0x41].repeat(50)] {
        assert!(parts.windows(stream.len()).any(|window| window == stream), "{stream:?}");
    }
}

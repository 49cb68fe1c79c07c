//! The functions of a WebAssembly module in an order in which they compress well: each near those that resemble it.
//!
//! A repetition costs less the nearer it is, and what a compressor has learnt about the bytes just before fits best what
//! resembles them; wasm-bindgen writes the functions by their size, which says little about what is in them. Packed, the
//! module becomes a fortieth smaller. In what order they stand changes nothing else.

use anyhow::{Context, Result};
use std::collections::HashMap;
use wasm_encoder::reencode::{self, Reencode};
use wasm_encoder::{CodeSection, FunctionSection, Module};
use wasmparser::{CodeSectionReader, FunctionSectionReader, Parser, Payload, TypeRef};

/// How many bytes are taken together where functions are compared.
const SHINGLE: usize = 4;

/// The module with its functions reordered.
pub fn by_likeness(module: &[u8]) -> Result<Vec<u8>> {
    let mut imported = 0;
    let mut bodies = Vec::new();
    for payload in Parser::new(0).parse_all(module) {
        match payload.context("the module cannot be read")? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import?.ty, TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(body.as_bytes()),
            _ => {}
        }
    }
    let order = order(&bodies);
    let mut places = vec![0; order.len()];
    for (place, &function) in (imported..).zip(&order) {
        places[function] = place;
    }
    let mut reordered = Module::new();
    Reorder { imported, order, places }.parse_core_module(&mut reordered, Parser::new(0), module)?;
    Ok(reordered.finish())
}

/// Writes a module again with its own functions in another order.
struct Reorder {
    /// How many functions are imported; those keep their numbers.
    imported: u32,
    /// The old positions in the new order.
    order: Vec<usize>,
    /// The new number of each position.
    places: Vec<u32>,
}

impl Reencode for Reorder {
    type Error = std::convert::Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, reencode::Error> {
        let own = function.checked_sub(self.imported);
        Ok(own.and_then(|own| self.places.get(own as usize)).copied().unwrap_or(function))
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        section: FunctionSectionReader<'_>,
    ) -> Result<(), reencode::Error> {
        let types = section.into_iter().collect::<wasmparser::Result<Vec<u32>>>()?;
        for &function in &self.order {
            functions.function(types[function]);
        }
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        section: CodeSectionReader<'_>,
    ) -> Result<(), reencode::Error> {
        let bodies = section.into_iter().collect::<wasmparser::Result<Vec<_>>>()?;
        for function in self.order.clone() {
            self.parse_function_body(code, bodies[function].clone())?;
        }
        Ok(())
    }
}

/// The positions of the functions in the new order: the largest first, then always the one of which most is found in the
/// one before. To compare with more than that one made the packed module larger.
fn order(bodies: &[&[u8]]) -> Vec<usize> {
    let shingles: Vec<Vec<u32>> = bodies.iter().map(|body| shingles(body)).collect();
    let mut holders: HashMap<u32, Vec<usize>> = HashMap::new();
    for (function, shingles) in shingles.iter().enumerate() {
        for &shingle in shingles {
            holders.entry(shingle).or_default().push(function);
        }
    }
    let mut left: Vec<usize> = (0..bodies.len()).collect();
    let mut order = Vec::with_capacity(bodies.len());
    let mut next = left.iter().copied().max_by_key(|&function| bodies[function].len());
    while let Some(function) = next {
        order.push(function);
        left.retain(|&other| other != function);
        let mut found = vec![0; bodies.len()];
        for &holder in shingles[function].iter().flat_map(|shingle| &holders[shingle]) {
            found[holder] += 1;
        }
        // Thousandths; a tiny function resembles anything and has to wait.
        let likeness = |function: usize| 1000 * found[function] / (shingles[function].len() + 4);
        next = left.iter().copied().max_by_key(|&function| (likeness(function), std::cmp::Reverse(function)));
    }
    order
}

/// Hashes of the sequences of bytes in a function, each once.
fn shingles(body: &[u8]) -> Vec<u32> {
    // FNV-1a.
    let hash = |bytes: &[u8]| {
        bytes.iter().fold(0x811c_9dc5, |hash: u32, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    };
    let mut shingles: Vec<u32> = body.windows(SHINGLE).map(hash).collect();
    shingles.sort_unstable();
    shingles.dedup();
    shingles
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_encoder::{
        ConstExpr, ElementSection, Elements, EntityType, ExportKind, ExportSection, Function, FunctionSection,
        ImportSection, RefType, TableSection, TableType, TypeSection,
    };
    use wasmparser::Operator;

    /// An imported function and four own ones; the first calls the last and the import, and all stand in a table.
    fn module() -> Vec<u8> {
        let mut types = TypeSection::new();
        types.ty().function([], []);
        let mut imports = ImportSection::new();
        imports.import("host", "tell", EntityType::Function(0));
        let mut functions = FunctionSection::new();
        let mut exports = ExportSection::new();
        let mut code = CodeSection::new();
        // Two pairs that resemble each other, each written apart.
        for (number, constants) in [(1, 1000..1010), (2, 5000..5010), (3, 1000..1011), (4, 5000..5012)] {
            functions.function(0);
            exports.export(&format!("f{number}"), ExportKind::Func, number);
            let mut body = Function::new([]);
            for constant in constants {
                body.instructions().i32_const(constant).drop();
            }
            if number == 1 {
                body.instructions().call(4).call(0);
            }
            body.instructions().end();
            code.function(&body);
        }
        let mut tables = TableSection::new();
        let element_type = RefType::FUNCREF;
        let table64 = false;
        tables.table(TableType { element_type, table64, minimum: 4, maximum: None, shared: false });
        let mut elements = ElementSection::new();
        elements.active(None, &ConstExpr::i32_const(0), Elements::Functions((&[1, 2, 3, 4]).into()));
        let mut module = Module::new();
        module.section(&types).section(&imports).section(&functions).section(&tables).section(&exports);
        module.section(&elements).section(&code);
        module.finish()
    }

    /// The constants and calls in each function, in the order in which they stand; where the exports and the table lead.
    type Contents = (Vec<(Vec<i32>, Vec<u32>)>, Vec<u32>, Vec<u32>);

    fn read(module: &[u8]) -> Contents {
        let (mut bodies, mut exported, mut table) = (Vec::new(), Vec::new(), Vec::new());
        for payload in Parser::new(0).parse_all(module) {
            match payload.unwrap() {
                Payload::CodeSectionEntry(body) => {
                    let (mut constants, mut calls) = (Vec::new(), Vec::new());
                    for operator in body.get_operators_reader().unwrap() {
                        match operator.unwrap() {
                            Operator::I32Const { value } => constants.push(value),
                            Operator::Call { function_index } => calls.push(function_index),
                            _ => {}
                        }
                    }
                    bodies.push((constants, calls));
                }
                Payload::ExportSection(exports) => exported.extend(exports.into_iter().map(|own| own.unwrap().index)),
                Payload::ElementSection(elements) => {
                    for element in elements {
                        if let wasmparser::ElementItems::Functions(functions) = element.unwrap().items {
                            table.extend(functions.into_iter().map(Result::unwrap));
                        }
                    }
                }
                _ => {}
            }
        }
        (bodies, exported, table)
    }

    #[test]
    fn like_stands_beside_like_and_every_reference_follows() {
        let before = read(&module());
        let after = read(&by_likeness(&module()).unwrap());
        let firsts: Vec<i32> = after.0.iter().map(|(constants, _)| constants[0]).collect();
        assert!(firsts == [1000, 1000, 5000, 5000] || firsts == [5000, 5000, 1000, 1000], "{firsts:?}");
        // Numbers begin behind the import.
        let body = |read: &Contents, number: u32| read.0[number as usize - 1].clone();
        for (one, other) in before.1.iter().zip(&after.1).chain(before.2.iter().zip(&after.2)) {
            assert_eq!(body(&before, *one).0, body(&after, *other).0);
        }
        let (_, calls) = body(&after, after.1[0]);
        assert_eq!(calls[1], 0, "the import");
        assert_eq!(body(&after, calls[0]).0, body(&before, 4).0);
        assert_eq!((after.1.len(), after.2.len()), (4, 4));
    }
}

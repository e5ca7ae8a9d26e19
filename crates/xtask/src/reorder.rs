//! A wasm module with its functions in the order in which `gzip` packs it smallest.

use crate::order::{Likeness, functions};
use anyhow::{Context, Result};
use miniz_oxide::deflate::compress_to_vec;
use std::convert::Infallible;
use std::thread;
use wasm_encoder::reencode::{Error, Reencode};
use wasm_encoder::{CodeSection, FunctionSection, Module};
use wasmparser::{CodeSectionReader, FunctionSectionReader, Parser};

/// Bytes of functions that the next one is compared with: about as many as `gzip` remembers.
const WINDOW_BYTES: usize = 32_000;

/// More and fewer of them. Which packs a module smallest is mostly chance, and makes four parts in a thousand.
const WINDOWS_BYTES: std::ops::Range<usize> = 22_000..42_000;
const STEP_BYTES: usize = 250;

/// After so many rounds the last ones gained a few bytes, if any.
const MOST_ROUNDS: usize = 8;

/// A module, behind how many bytes it is packed.
type Packed = (usize, Vec<u8>);

/// A module in an order that packs it small.
///
/// # Errors
/// For what is no wasm module.
pub(crate) fn small(module: &[u8]) -> Result<Vec<u8>> {
    let (imported, bodies) = functions(module)?;
    reordered(module, imported, &Likeness::new(&bodies).order(WINDOW_BYTES))
}

/// A module in the smallest order found, which takes some hundred times as long: what is in order already is put in another one,
/// which may be better, since of functions that are as alike the first is taken, and its calls are by other numbers.
///
/// # Errors
/// For what is no wasm module.
pub(crate) fn smallest(module: &[u8]) -> Result<Vec<u8>> {
    let mut smallest = packed(module.to_vec());
    for _ in 0..MOST_ROUNDS {
        let next = smallest_reordered(&smallest.1)?;
        if next.0 >= smallest.0 {
            break;
        }
        smallest = next;
    }
    Ok(smallest.1)
}

/// A module in the smallest of the orders that [`WINDOWS_BYTES`] give, which the processors find side by side.
fn smallest_reordered(module: &[u8]) -> Result<Packed> {
    let (imported, bodies) = functions(module)?;
    let likeness = Likeness::new(&bodies);
    let in_windows = |windows_bytes: &[usize]| -> Result<Vec<Packed>> {
        let orders = windows_bytes.iter().map(|&bytes| likeness.order(bytes));
        orders.map(|order| Ok(packed(reordered(module, imported, &order)?))).collect()
    };
    let windows_bytes: Vec<_> = WINDOWS_BYTES.step_by(STEP_BYTES).collect();
    let part = windows_bytes.len().div_ceil(thread::available_parallelism()?.get());
    let found = thread::scope(|scope| {
        let parts = windows_bytes.chunks(part).map(|windows_bytes| scope.spawn(|| in_windows(windows_bytes)));
        let parts: Vec<_> = parts.collect();
        parts.into_iter().map(|part| part.join().expect("an order")).collect::<Result<Vec<_>>>()
    })?;
    found.into_iter().flatten().min().context("no order of a module's functions")
}

fn packed(module: Vec<u8>) -> Packed {
    (packed_bytes(&module), module)
}

/// As many as `gzip` makes of it, but for a thousandth or three; what is smaller in one is mostly so in the other.
fn packed_bytes(module: &[u8]) -> usize {
    compress_to_vec(module, 9).len()
}

/// A module with its own functions in another order, given by their numbers after those of the imported ones.
fn reordered(module: &[u8], imported: u32, order: &[usize]) -> Result<Vec<u8>> {
    let mut places: Vec<_> = order.iter().zip(imported..).collect();
    places.sort_unstable();
    let numbers = (0..imported).chain(places.into_iter().map(|(_, place)| place)).collect();
    let mut written = Module::new();
    Reordering { order, numbers }
        .parse_core_module(&mut written, Parser::new(0), module)
        .context("a wasm module to reorder")?;
    Ok(written.finish())
}

/// An order, and by function, imported or not, its number in it.
struct Reordering<'a> {
    order: &'a [usize],
    numbers: Vec<u32>,
}

impl Reencode for Reordering<'_> {
    type Error = Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, Error> {
        Ok(self.numbers[function as usize])
    }

    fn parse_function_section(
        &mut self,
        written: &mut FunctionSection,
        section: FunctionSectionReader<'_>,
    ) -> Result<(), Error> {
        let types: Vec<_> = section.into_iter().collect::<Result<_, _>>()?;
        self.order.iter().for_each(|&i| {
            written.function(types[i]);
        });
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        written: &mut CodeSection,
        section: CodeSectionReader<'_>,
    ) -> Result<(), Error> {
        let bodies: Vec<_> = section.into_iter().collect::<Result<_, _>>()?;
        self.order.iter().try_for_each(|&i| self.parse_function_body(written, bodies[i].clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_encoder::{
        ConstExpr, ElementSection, Elements, EntityType, ExportKind, ExportSection, Function, ImportSection,
        RefType, StartSection, TableSection, TableType, TypeSection, ValType,
    };

    /// A module that imports a function, and has one of each type, of which each calls the next one: with the numbers that they
    /// have in an order.
    fn module(order: [u32; 3]) -> Vec<u8> {
        let number = |i: u32| 1 + order.iter().position(|&at| at == i % 3).expect("a function") as u32;
        let mut types = TypeSection::new();
        [ValType::I32, ValType::F32, ValType::F64]
            .iter()
            .for_each(|&result| types.ty().function([], [result]));
        types.ty().function([], []);
        let mut imports = ImportSection::new();
        imports.import("m", "f", EntityType::Function(3));
        let (mut functions, mut code) = (FunctionSection::new(), CodeSection::new());
        for i in order {
            functions.function(i);
            let mut body = Function::new([(i, ValType::F64)]);
            body.instructions().call(0).call(number(i + 1)).drop().unreachable().end();
            code.function(&body);
        }
        let mut tables = TableSection::new();
        let table_type = TableType {
            element_type: RefType::FUNCREF,
            table64: false,
            minimum: 3,
            maximum: None,
            shared: false,
        };
        tables.table(table_type);
        let mut exports = ExportSection::new();
        exports.export("e", ExportKind::Func, number(2));
        let mut elements = ElementSection::new();
        elements.active(
            None,
            &ConstExpr::i32_const(0),
            Elements::Functions([0, number(0), number(2)].as_slice().into()),
        );
        let mut module = Module::new();
        module.section(&types).section(&imports).section(&functions).section(&tables).section(&exports);
        module.section(&StartSection { function_index: 0 }).section(&elements).section(&code);
        module.finish()
    }

    #[test]
    fn functions_keep_who_calls_them() {
        let first = module([0, 1, 2]);
        for order in [[0, 1, 2], [2, 0, 1], [1, 0, 2]] {
            let reordered = reordered(&first, 1, &order.map(|i| i as usize)).expect("a module");
            assert_eq!(reordered, module(order), "{order:?}");
        }
    }

    #[test]
    fn those_that_are_alike_are_packed_together() {
        let module = of_pieces(&[&[(1, 300)], &[(2, 5000)], &[(1, 300)]]);
        for reorder in [small, smallest] {
            let reordered = reorder(&module).expect("a module");
            assert_eq!(reordered.len(), module.len());
            assert!(packed_bytes(&reordered) + 2000 < packed_bytes(&module));
            assert!(reorder(b"no module").is_err());
        }
    }

    #[test]
    fn what_no_order_packs_smaller_stays_as_it_is() {
        let of_two = [[2, 3], [3, 0], [4, 1], [1, 3], [1, 2]].map(|kinds| kinds.map(|kind| (kind, 1200)));
        let module = of_pieces(&of_two.each_ref().map(|pieces| &pieces[..]));
        assert!(packed_bytes(&small(&module).expect("a module")) > packed_bytes(&module));
        assert!(smallest(&module).expect("a module") == module);
    }

    /// A module of functions of pieces, each of numbers that follow from its kind, so many.
    fn of_pieces(bodies: &[&[(u64, usize)]]) -> Vec<u8> {
        let mut types = TypeSection::new();
        types.ty().function([], []);
        let (mut functions, mut code) = (FunctionSection::new(), CodeSection::new());
        for pieces in bodies {
            functions.function(0);
            let mut body = Function::new([]);
            let numbers = pieces.iter().flat_map(|&(kind, count)| without_repeats(kind).take(count));
            numbers.for_each(|number| {
                body.instructions().f64_const(f64::from_bits(number).into()).drop();
            });
            body.instructions().end();
            code.function(&body);
        }
        let mut module = Module::new();
        module.section(&types).section(&functions).section(&code);
        module.finish()
    }

    fn without_repeats(kind: u64) -> impl Iterator<Item = u64> {
        let next = |number: &u64| Some(number.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1));
        std::iter::successors(Some(kind), next)
    }
}

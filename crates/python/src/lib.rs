//! The compiled part of the Python package, `meniscus._core`: the requests of `crates/requests`, and Arrow's C interface.
//!
//! The classes, with their types and documentation, are Python sources, `crates/python/python/meniscus`. They write requests,
//! and leave everything else to `meniscus._core`, of which there are two: this crate (`pyo3`, built by `maturin` into one
//! wheel for all versions of Python) and `crates/pyodide`. Columns leave as bytes of Python, which arrays of numpy and
//! Arrow's C interface (`arrow-array`) share.
//!
//! `cargo xtask python` makes both wheels (`xtask/src/python.rs`, `xtask/src/pyodide.rs`), deflates them by zopfli
//! (`xtask/src/wheel.rs`), 3 % smaller than maturin does, and runs `tests`; it is a part of `cargo xtask test full`.
//! `everywhere.py` computes in this Python and in Pyodide (in Node, from `tests/pyodide`) and must give the same text
//! everywhere. The crates are not among the default members, because nothing but Python can load them.
//!
//! - **Invariant:** all work is done without the lock of the interpreter.

mod arrow;
mod surroundings;

use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use requests::{Buffer, Reply};
use surroundings::Surroundings;

/// The compiled part of the package `meniscus`.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::{Opened, arrow_stream, call, open_document};

    use super::*;

    #[pymodule_init]
    fn initialise(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", program::VERSION)?;
        module.add("BITS", program::BITS)
    }
}

/// An opened document.
#[pyclass(module = "meniscus._core", frozen)]
#[derive(Debug)]
struct Opened(requests::Opened);

/// The opened document, or `None`, and the reply.
#[pyfunction]
fn open_document(py: Python<'_>, request: &str) -> PyResult<(Option<Opened>, String)> {
    let surroundings = Surroundings::default();
    let (opened, reply) = py.detach(|| requests::open(&surroundings, request));
    surroundings.ended()?;
    Ok((opened.map(Opened), reply.json))
}

/// The reply to a request: JSON, and the bytes of its arrays. `numbers`: arrays of numbers of 8 bytes, in the order of the machine.
#[pyfunction]
fn call<'py>(
    py: Python<'py>,
    name: &str,
    documents: Vec<Py<Opened>>,
    request: &str,
    numbers: Vec<PyBackedBytes>,
) -> PyResult<(String, Vec<Bound<'py, PyBytes>>)> {
    let surroundings = Surroundings::default();
    let documents: Vec<&requests::Opened> = documents.iter().map(|document| &document.get().0).collect();
    let array = |bytes: &PyBackedBytes| bytes.as_chunks().0.iter().map(|number| f64::from_ne_bytes(*number)).collect();
    let numbers: Vec<Vec<f64>> = numbers.iter().map(array).collect();
    let Reply { json, buffers } = py.detach(|| requests::call(&surroundings, name, &documents, request, &numbers));
    surroundings.ended()?;
    let buffers = buffers.iter().map(|buffer| match buffer {
        Buffer::Numbers(numbers) => PyBytes::new(py, arrow::bytes(numbers)),
        Buffer::Truths(truths) => PyBytes::new(py, truths),
    });
    Ok((json, buffers.collect()))
}

/// Capsule with the columns of a table as a stream of Arrow. The columns are those of `Table`.
#[pyfunction]
fn arrow_stream<'py>(py: Python<'py>, columns: Vec<arrow::Column<'py>>, rows: usize) -> PyResult<Bound<'py, PyAny>> {
    Ok(arrow::stream(py, columns, rows)?.into_any())
}

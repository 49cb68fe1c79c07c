//! Columns of tables, and their arrays of numpy.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyBytes;

/// A column of a table.
#[derive(Debug)]
pub struct Column {
    /// Name, such as `y'`.
    pub name: String,
    /// Unit; empty for pure numbers, truths and texts.
    pub unit: String,
    /// Label of the author; empty without one.
    pub label: String,
    /// Values.
    pub values: Values,
}

/// Values of a column, which arrays of numpy and Arrow share.
#[derive(Debug)]
pub enum Values {
    /// Numbers of 8 bytes in the order of the machine.
    Numbers(Py<PyBytes>),
    /// 0 or 1, one byte each.
    Truths(Py<PyBytes>),
    /// Texts; `None` where there is no value.
    Texts(Vec<Option<Box<str>>>),
}

impl Column {
    /// Name and unit, `y' [m/s]`; only the name without a unit.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    /// The column as an array of numpy that cannot be written.
    pub fn array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        static FROM_BUFFER: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        static ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        match &self.values {
            Values::Numbers(bytes) => FROM_BUFFER.import(py, "numpy", "frombuffer")?.call1((bytes, "f8")),
            Values::Truths(bytes) => FROM_BUFFER.import(py, "numpy", "frombuffer")?.call1((bytes, "?")),
            Values::Texts(texts) => {
                let texts: Vec<Option<&str>> = texts.iter().map(Option::as_deref).collect();
                ARRAY.import(py, "numpy", "array")?.call1((texts, "O"))
            }
        }
    }
}

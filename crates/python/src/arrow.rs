//! Tables through Arrow's C interface.

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchIterator, RecordBatchOptions, StringArray,
};
use arrow_buffer::{Buffer, NullBuffer, ScalarBuffer, ToByteSlice};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use bytes::Bytes;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyCapsule;
use std::collections::HashMap;
use std::sync::Arc;

/// A column of a table: name, unit, label, kind of values, and values.
pub type Column<'py> = (String, String, String, String, Bound<'py, PyAny>);

/// Memory of numbers.
pub fn bytes(numbers: &[f64]) -> &[u8] {
    numbers.to_byte_slice()
}

/// A capsule with a stream of one batch. Numbers are not copied.
pub fn stream<'py>(py: Python<'py>, columns: Vec<Column<'py>>, rows: usize) -> PyResult<Bound<'py, PyCapsule>> {
    let refused = |error: ArrowError| PyValueError::new_err(error.to_string());
    let mut fields = Vec::with_capacity(columns.len());
    let mut arrays: Vec<ArrayRef> = Vec::with_capacity(columns.len());
    for (name, unit, label, kind, values) in columns {
        let (kind, array): (DataType, ArrayRef) = match kind.as_str() {
            "numbers" => {
                let shared: PyBackedBytes = values.extract()?;
                let numbers = ScalarBuffer::<f64>::from(Buffer::from(Bytes::from_owner(shared)));
                let missing = numbers.iter().any(|number| number.is_nan());
                let valid = missing.then(|| numbers.iter().map(|number| !number.is_nan()).collect::<NullBuffer>());
                (DataType::Float64, Arc::new(Float64Array::new(numbers, valid)))
            }
            "truths" => {
                let truths: PyBackedBytes = values.extract()?;
                let truths: Vec<bool> = truths.iter().map(|byte| *byte != 0).collect();
                (DataType::Boolean, Arc::new(BooleanArray::from(truths)))
            }
            _ => {
                let texts: Vec<Option<String>> = values.extract()?;
                (DataType::Utf8, Arc::new(texts.into_iter().collect::<StringArray>()))
            }
        };
        let described = [("unit", unit), ("label", label)].into_iter();
        let described = described.filter(|(_, text)| !text.is_empty());
        let metadata: HashMap<String, String> = described.map(|(key, text)| (key.to_owned(), text)).collect();
        fields.push(Field::new(name, kind, true).with_metadata(metadata));
        arrays.push(array);
    }
    let schema = Arc::new(Schema::new(fields));
    let options = RecordBatchOptions::new().with_row_count(Some(rows));
    let batch = RecordBatch::try_new_with_options(schema.clone(), arrays, &options).map_err(refused)?;
    let stream = FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new([Ok(batch)], schema)));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}

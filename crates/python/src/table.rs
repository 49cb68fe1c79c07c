//! Tables as Python objects: columns of numpy with units.

use crate::arrow;
use crate::column::{Column, Values};
use crate::diagnostic::Diagnostic;
use crate::errors::value_error;
use arrow_buffer::ToByteSlice;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyCapsule, PyDict, PyList, PyTuple};
use runner::ColumnValues;

/// A table: columns with names and units. `table["y"]` is a column as an array of numpy, in the unit `table.units["y"]`.
#[pyclass(module = "meniscus", frozen)]
#[derive(Debug)]
pub struct Table {
    columns: Vec<Column>,
    rows: usize,
    /// Warnings about the run, such as a step that is too long.
    #[pyo3(get)]
    notices: Vec<Diagnostic>,
    /// Message of the event that ended the run before its time; `None` if none did.
    #[pyo3(get)]
    ended: Option<String>,
}

/// A column as a tuple, for pickles: name, unit, label, kind, values.
type Pickled<'py> = (String, String, String, &'static str, Bound<'py, PyAny>);

impl Table {
    /// A table of `runner`.
    pub fn new(py: Python<'_>, table: runner::Table, notices: Vec<Diagnostic>, ended: Option<String>) -> Self {
        let mut rows = 0;
        let mut columns = Vec::with_capacity(table.columns.len());
        for column in table.columns {
            let values = match column.values {
                ColumnValues::Numbers(numbers) => {
                    rows = numbers.len();
                    Values::Numbers(PyBytes::new(py, numbers.as_slice().to_byte_slice()).unbind())
                }
                ColumnValues::Truths(truths) => {
                    rows = truths.len();
                    let bytes: Vec<u8> = truths.into_iter().map(u8::from).collect();
                    Values::Truths(PyBytes::new(py, &bytes).unbind())
                }
                ColumnValues::Texts(texts) => {
                    rows = texts.len();
                    Values::Texts(texts)
                }
            };
            columns.push(Column {
                name: column.head.name,
                unit: column.head.unit.text,
                label: column.head.label.unwrap_or_default(),
                values,
            });
        }
        Self { columns, rows, notices, ended }
    }

    fn column(&self, name: &str) -> PyResult<&Column> {
        self.columns.iter().find(|column| column.name == name).ok_or_else(|| {
            let known = units::nearest(name, self.columns.iter().map(|column| column.name.as_str()));
            PyKeyError::new_err(match known {
                Some(near) => format!("there is no column `{name}`; did you mean `{near}`?"),
                None => format!("there is no column `{name}`"),
            })
        })
    }

    /// Arrays of all columns by name, or by heading with unit.
    fn arrays<'py>(&self, py: Python<'py>, headings: bool) -> PyResult<Bound<'py, PyDict>> {
        let arrays = PyDict::new(py);
        for column in &self.columns {
            let name = if headings { column.heading() } else { column.name.clone() };
            arrays.set_item(name, column.array(py)?)?;
        }
        Ok(arrays)
    }
}

#[pymethods]
impl Table {
    /// Restores a table from a pickle.
    #[new]
    fn restore(columns: &Bound<'_, PyList>, notices: Vec<Diagnostic>, ended: Option<String>) -> PyResult<Self> {
        let mut restored = Vec::new();
        let mut rows = 0;
        for column in columns {
            let (name, unit, label, kind, values): (String, String, String, String, Bound<'_, PyAny>) =
                column.extract()?;
            let values = match kind.as_str() {
                "numbers" => Values::Numbers(values.cast_into::<PyBytes>()?.unbind()),
                "truths" => Values::Truths(values.cast_into::<PyBytes>()?.unbind()),
                "texts" => {
                    let texts: Vec<Option<String>> = values.extract()?;
                    Values::Texts(texts.into_iter().map(|text| text.map(String::into_boxed_str)).collect())
                }
                _ => return Err(value_error("this is no table")),
            };
            rows = match &values {
                Values::Numbers(bytes) => bytes.bind(columns.py()).len()? / 8,
                Values::Truths(bytes) => bytes.bind(columns.py()).len()?,
                Values::Texts(texts) => texts.len(),
            };
            restored.push(Column { name, unit, label, values });
        }
        Ok(Self { columns: restored, rows, notices, ended })
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Vec<Pickled<'py>>, Vec<Diagnostic>, Option<String>)> {
        let mut columns = Vec::new();
        for column in &self.columns {
            let (kind, values) = match &column.values {
                Values::Numbers(bytes) => ("numbers", bytes.bind(py).clone().into_any()),
                Values::Truths(bytes) => ("truths", bytes.bind(py).clone().into_any()),
                Values::Texts(texts) => {
                    let texts: Vec<Option<&str>> = texts.iter().map(Option::as_deref).collect();
                    ("texts", texts.into_pyobject(py)?)
                }
            };
            columns.push((column.name.clone(), column.unit.clone(), column.label.clone(), kind, values));
        }
        Ok((columns, self.notices.clone(), self.ended.clone()))
    }

    /// Names of the columns.
    #[getter]
    fn columns(&self) -> Vec<&str> {
        self.columns.iter().map(|column| column.name.as_str()).collect()
    }

    /// Names of the columns, so that `dict(table)` has all arrays.
    fn keys(&self) -> Vec<&str> {
        self.columns()
    }

    /// Unit of each column by name; empty for pure numbers.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        self.columns.iter().try_for_each(|column| units.set_item(&column.name, &column.unit))?;
        Ok(units)
    }

    /// Label of each column that the author has given one.
    #[getter]
    fn labels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let labels = PyDict::new(py);
        let labelled = self.columns.iter().filter(|column| !column.label.is_empty());
        labelled.into_iter().try_for_each(|column| labels.set_item(&column.name, &column.label))?;
        Ok(labels)
    }

    fn __len__(&self) -> usize {
        self.rows
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(PyTuple::new(py, self.columns())?.try_iter()?.into_any())
    }

    fn __contains__(&self, name: &str) -> bool {
        self.columns.iter().any(|column| column.name == name)
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.column(name)?.array(py)
    }

    fn __repr__(&self) -> String {
        let headings: Vec<String> = self.columns.iter().map(Column::heading).collect();
        format!("<Table of {} rows: {}>", self.rows, headings.join(", "))
    }

    /// The table as a DataFrame of pandas, with the units in `attrs["units"]`; with `headings` also in the names of the columns.
    #[pyo3(signature = (*, headings = false))]
    fn to_pandas<'py>(&self, py: Python<'py>, headings: bool) -> PyResult<Bound<'py, PyAny>> {
        let frame = py.import("pandas")?.call_method1("DataFrame", (self.arrays(py, headings)?,))?;
        frame.getattr("attrs")?.set_item("units", self.units(py)?)?;
        Ok(frame)
    }

    /// The table as a Dataset of xarray along its first column, with units in the attributes.
    fn to_xarray<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (data, coordinates) = (PyDict::new(py), PyDict::new(py));
        let Some(first) = self.columns.first() else { return Err(value_error("the table has no columns")) };
        for (place, column) in self.columns.iter().enumerate() {
            let attributes = PyDict::new(py);
            attributes.set_item("units", &column.unit)?;
            let described = (&first.name, column.array(py)?, attributes);
            let target = if place == 0 { &coordinates } else { &data };
            target.set_item(&column.name, described)?;
        }
        py.import("xarray")?.call_method1("Dataset", (data, coordinates))
    }

    /// The table as a Table of pyarrow, whose numbers share the memory of this one. Parquet is `pyarrow.parquet.write_table(..)`.
    fn to_arrow<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("pyarrow")?.call_method1("table", (slf,))
    }

    /// The table through Arrow's C interface for streams. A number without a value is null.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A consumer may ask for another schema; the protocol allows to answer with one's own.
        let _ = requested_schema;
        arrow::stream(py, &self.columns, self.rows)
    }
}

//! Results of fits as Python objects.

use crate::table::Table;
use engine::table::Column;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use runner::fitting::Fitted;
use runner::{ColumnValues, TableColumn};
use units::Unit;

/// A fitted number with its standard error, in its unit.
#[pyclass(module = "meniscus", frozen, get_all)]
#[derive(Clone, Debug)]
pub struct Estimate {
    /// Value; `None` if the data do not determine it.
    value: Option<f64>,
    /// Standard error; `None` if there is none. For residuals that are correlated in time if they are.
    stderr: Option<f64>,
    /// Unit; empty for a pure number.
    unit: String,
}

#[pymethods]
impl Estimate {
    #[new]
    fn restore(value: Option<f64>, stderr: Option<f64>, unit: String) -> Self {
        Self { value, stderr, unit }
    }

    fn __getnewargs__(&self) -> (Option<f64>, Option<f64>, String) {
        (self.value, self.stderr, self.unit.clone())
    }

    fn __float__(&self) -> f64 {
        self.value.unwrap_or(f64::NAN)
    }

    fn __repr__(&self) -> String {
        let number = |value: Option<f64>| value.map_or("not determined".to_owned(), |value| value.to_string());
        let error = self.stderr.map_or(String::new(), |error| format!(" ± {error}"));
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        format!("<Estimate {}{error}{unit}>", number(self.value))
    }
}

/// A fit: its estimates, its quality, and the residuals. `print(fit)` is what the command line prints.
#[pyclass(module = "meniscus", frozen)]
#[derive(Debug)]
pub struct Fit {
    summary: Py<PyDict>,
    text: String,
    curves: Py<PyList>,
}

impl Fit {
    /// A fit from its object in JSON and its text.
    pub fn new(py: Python<'_>, json: &str, text: String, fitted: &Fitted) -> PyResult<Self> {
        let summary = py.import("json")?.call_method1("loads", (json,))?.cast_into::<PyDict>()?.unbind();
        let curves = fitted.outcome.observations.iter().map(|observation| {
            let clock = &fitted.theory.document.program.model.independent;
            let numbers = |name: &str, unit: &Unit, values: &[f64]| TableColumn {
                head: Column { name: name.to_owned(), label: None, unit: unit.clone() },
                values: ColumnValues::Numbers(values.iter().map(|value| unit.from_si(*value)).collect()),
            };
            let residuals: Vec<f64> = observation
                .measured
                .iter()
                .zip(&observation.fitted)
                .map(|(measured, fitted)| measured - fitted)
                .collect();
            let inside = Column { name: "inside".to_owned(), label: None, unit: Unit::dimensionless() };
            let columns = vec![
                numbers(&clock.name, &clock.unit, &observation.times),
                numbers("measured", &observation.unit, &observation.measured),
                numbers("fitted", &observation.unit, &observation.fitted),
                numbers("residual", &observation.unit, &residuals),
                TableColumn { head: inside, values: ColumnValues::Truths(observation.inside.clone()) },
            ];
            Table::new(py, runner::Table { columns }, Vec::new(), None)
        });
        let curves = PyList::new(py, curves.map(|table| Py::new(py, table)).collect::<PyResult<Vec<_>>>()?)?;
        Ok(Self { summary, text, curves: curves.unbind() })
    }

    fn estimates<'py>(&self, py: Python<'py>, key: &str) -> PyResult<Bound<'py, PyDict>> {
        let estimates = PyDict::new(py);
        let Some(stated) = self.summary.bind(py).get_item(key)? else { return Ok(estimates) };
        for (name, entry) in stated.cast_into::<PyDict>()? {
            let get = |key: &str| entry.get_item(key);
            let robust: Option<f64> = get("stderr_hac")?.extract()?;
            let stderr = if robust.is_some() { robust } else { get("stderr")?.extract()? };
            estimates
                .set_item(name, Estimate { value: get("value")?.extract()?, stderr, unit: get("unit")?.extract()? })?;
        }
        Ok(estimates)
    }
}

#[pymethods]
impl Fit {
    #[new]
    fn restore(summary: Py<PyDict>, text: String, curves: Py<PyList>) -> Self {
        Self { summary, text, curves }
    }

    fn __getnewargs__(&self, py: Python<'_>) -> (Py<PyDict>, String, Py<PyList>) {
        (self.summary.clone_ref(py), self.text.clone(), self.curves.clone_ref(py))
    }

    /// Fitted parameters that hold for all records, by name.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.estimates(py, "parameters")
    }

    /// Quantities that follow from the parameters, by name.
    #[getter]
    fn derived<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.estimates(py, "derived")
    }

    /// All results, with the keys of `meniscus fit --format json`.
    #[getter]
    fn summary(&self, py: Python<'_>) -> Py<PyDict> {
        self.summary.clone_ref(py)
    }

    /// For each observed quantity of each record a table: time, measured, fitted, residual, and whether the row was fitted.
    #[getter]
    fn curves(&self, py: Python<'_>) -> Py<PyList> {
        self.curves.clone_ref(py)
    }

    /// An entry of the summary, such as `fit["rmse"]`.
    fn __getitem__<'py>(&self, py: Python<'py>, key: &str) -> PyResult<Bound<'py, PyAny>> {
        self.summary.bind(py).as_any().get_item(key)
    }

    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let title: String = self.__getitem__(py, "title")?.extract()?;
        Ok(format!("<Fit of {title}>"))
    }
}

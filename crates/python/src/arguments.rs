//! Python arguments as the texts that `runner` reads.

use crate::errors::value_error;
use pyo3::conversion::FromPyObjectOwned;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyString};
use runner::names::Assignment;
use std::path::PathBuf;
use units::Unit;

/// Keyword arguments of a call, from which each is taken once.
pub struct Options<'py>(Bound<'py, PyDict>);

impl<'py> Options<'py> {
    /// The keyword arguments of a call.
    pub fn new(py: Python<'py>, given: Option<&Bound<'py, PyDict>>) -> PyResult<Self> {
        given.map_or_else(|| Ok(PyDict::new(py)), PyDictMethods::copy).map(Self)
    }

    /// An argument; `None` if it is missing or `None`.
    pub fn take(&self, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(value) = self.0.get_item(name)? else { return Ok(None) };
        self.0.del_item(name)?;
        Ok(Some(value).filter(|value| !value.is_none()))
    }

    /// An argument of a simple type.
    pub fn get<T: FromPyObjectOwned<'py>>(&self, name: &str) -> PyResult<Option<T>> {
        self.take(name)?.map(|value| value.extract().map_err(Into::into)).transpose()
    }

    /// A value: a number in the declared unit, or a text with its own unit.
    pub fn value(&self, name: &str) -> PyResult<Option<String>> {
        self.take(name)?.map(|value| text(&value)).transpose()
    }

    /// Values by name: a dictionary.
    pub fn assignments(&self, name: &str) -> PyResult<Vec<Assignment>> {
        self.take(name)?.map_or_else(|| Ok(Vec::new()), |given| assignments(name, &given))
    }

    /// Names: one text or several.
    pub fn names(&self, name: &str) -> PyResult<Option<Vec<String>>> {
        self.take(name)?.map(|given| names(&given)).transpose()
    }

    /// Paths by name: a dictionary.
    pub fn paths(&self, name: &str) -> PyResult<Vec<(String, PathBuf)>> {
        let Some(given) = self.take(name)? else { return Ok(Vec::new()) };
        let mut paths = Vec::new();
        for (key, path) in dictionary(name, &given)? {
            paths.push((key.extract()?, path.extract()?));
        }
        Ok(paths)
    }

    /// The arguments that were not taken, as values of parameters.
    pub fn parameters(&self) -> PyResult<Vec<Assignment>> {
        let parameters = assignments("parameters", &self.0)?;
        self.0.clear();
        Ok(parameters)
    }

    /// Refuses arguments that were not taken.
    pub fn finish(&self) -> PyResult<()> {
        match self.0.keys().iter().next() {
            Some(name) => Err(PyTypeError::new_err(format!("unexpected argument {name}"))),
            None => Ok(()),
        }
    }
}

fn dictionary<'py>(
    name: &str,
    given: &Bound<'py, PyAny>,
) -> PyResult<impl Iterator<Item = (Bound<'py, PyAny>, Bound<'py, PyAny>)>> {
    let dictionary = given.cast::<PyDict>();
    let dictionary = dictionary.map_err(|_| PyTypeError::new_err(format!("{name} must be a dictionary")))?;
    Ok(dictionary.clone().into_iter())
}

/// Values by name. Several values for one name are joined by commas.
fn assignments(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<Assignment>> {
    let mut assignments = Vec::new();
    for (key, value) in dictionary(name, given)? {
        let value = match is_several(&value) {
            true => value.try_iter()?.map(|value| text(&value?)).collect::<PyResult<Vec<_>>>()?.join(", "),
            false => text(&value)?,
        };
        assignments.push(Assignment { name: key.extract()?, value });
    }
    Ok(assignments)
}

/// True for a sequence of values, false for a number, a text or a quantity.
pub fn is_several(value: &Bound<'_, PyAny>) -> bool {
    !value.is_instance_of::<PyString>() && !is_quantity(value) && value.len().is_ok()
}

/// One text or several.
pub fn names(given: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    if given.is_instance_of::<PyString>() { Ok(vec![given.extract()?]) } else { given.extract() }
}

/// Text of a value: a number, `True` and `False` as switches, a text such as `3 cm` or `3 [cm]`, or a quantity of Pint.
pub fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(switch) = value.cast::<PyBool>() {
        return Ok(if switch.is_true() { "on" } else { "off" }.to_owned());
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(with_brackets(text.to_str()?));
    }
    if is_quantity(value) {
        let number: f64 = value.getattr("magnitude")?.extract()?;
        let unit = value.getattr("units")?.call_method1("__format__", ("~C",))?.extract::<String>()?;
        return Ok(with_brackets(&format!("{number:?} {}", unit.replace("**", "^"))));
    }
    match value.extract::<f64>() {
        Ok(number) => Ok(format!("{number:?}")),
        Err(_) => Err(value_error(format!("{} is no number and no text", value.repr()?))),
    }
}

fn is_quantity(value: &Bound<'_, PyAny>) -> bool {
    value.hasattr("magnitude").unwrap_or(false) && value.hasattr("units").unwrap_or(false)
}

/// `3 cm` as `3 [cm]`, as documents write it; another text as it is.
fn with_brackets(text: &str) -> String {
    let text = text.trim();
    let end = text.find(|letter: char| !(letter.is_ascii_digit() || "+-.eE".contains(letter))).unwrap_or(text.len());
    let (number, unit) = (&text[..end], text[end..].trim());
    if number.parse::<f64>().is_ok() && !unit.is_empty() && Unit::parse(unit).is_ok() {
        format!("{number} [{unit}]")
    } else {
        text.to_owned()
    }
}

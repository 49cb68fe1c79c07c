//! Pages that play a document, and the widget that shows one in a notebook.

use crate::errors::{refused, value_error};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use runner::fitting::Theory;
use std::ffi::CStr;

/// The player without a simulation.
#[cfg(page_inside)]
const PLAYER: Option<&str> = Some(include_str!(env!("MENISCUS_PLAYER")));
#[cfg(not(page_inside))]
const PLAYER: Option<&str> = None;

/// Python code of the widget.
const WIDGET: &CStr = match CStr::from_bytes_with_nul(concat!(include_str!("widget.py"), "\0").as_bytes()) {
    Ok(code) => code,
    Err(_) => panic!("the code of the widget has a zero"),
};

/// The class of the widget.
static CLASS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// Page that plays a document and contains its source.
pub fn page(py: Python<'_>, document: &Theory) -> PyResult<String> {
    let player = PLAYER.ok_or_else(|| {
        value_error("this package was built without the player: run `cargo xtask page`, then build the wheel again")
    })?;
    let made = py.detach(|| runner::page::played(player, &document.sources.embedded(), &document.document.program));
    made.map_err(|refusal| refused(py, &refusal))
}

/// Widget that shows a document with these values of its parameters; `height` in CSS pixels.
pub fn widget<'py>(
    py: Python<'py>,
    document: &Theory,
    parameters: Bound<'py, PyDict>,
    height: u32,
) -> PyResult<Bound<'py, PyAny>> {
    let class = CLASS.get_or_try_init(py, || {
        let module = PyModule::from_code(py, WIDGET, c"widget.py", c"meniscus.widget")?;
        module.getattr("DocumentWidget").map(Bound::unbind)
    })?;
    let values = PyDict::new(py);
    values.set_item("_page", page(py, document)?)?;
    values.set_item("title", &document.document.program.title)?;
    values.set_item("parameters", parameters)?;
    values.set_item("height", height)?;
    class.bind(py).call((), Some(&values))
}

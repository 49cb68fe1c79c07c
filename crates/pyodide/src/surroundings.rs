//! The surroundings that Python gives the module: files, the player, and signals.

use js_sys::{Array, Uint8Array};
use runner::Files;
use std::cell::RefCell;
use std::io;
use std::path::Path;
use wasm_bindgen::prelude::{JsCast, JsValue, wasm_bindgen};

#[wasm_bindgen]
extern "C" {
    /// The class `Surroundings` of `core.py`.
    pub type Python;

    /// Bytes of a file, or the message of the system.
    #[wasm_bindgen(method, catch)]
    fn read(this: &Python, path: &str) -> Result<JsValue, JsValue>;

    #[wasm_bindgen(method, catch)]
    fn is_folder(this: &Python, path: &str) -> Result<bool, JsValue>;

    #[wasm_bindgen(method, catch)]
    fn names(this: &Python, folder: &str) -> Result<Array, JsValue>;

    #[wasm_bindgen(method, catch)]
    fn player(this: &Python) -> Result<Option<String>, JsValue>;

    /// Lets Python look at signals; it raises an exception if the work shall end.
    #[wasm_bindgen(method, catch)]
    fn go_on(this: &Python) -> Result<(), JsValue>;
}

/// The surroundings of one call.
pub struct Surroundings<'a> {
    python: &'a Python,
    compiler: host::Compiler,
    /// Exception with which Python has ended the work.
    ended: RefCell<Option<JsValue>>,
}

impl<'a> Surroundings<'a> {
    pub fn new(python: &'a Python) -> Self {
        Self { python, compiler: host::Compiler::default(), ended: RefCell::default() }
    }

    /// Throws the exception with which Python has ended the work.
    pub fn ended(&self) -> Result<(), JsValue> {
        self.ended.take().map_or(Ok(()), Err)
    }
}

impl Files for Surroundings<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let read = self.python.read(&path.to_string_lossy()).unwrap_or_else(|error| error);
        match read.dyn_into::<Uint8Array>() {
            Ok(bytes) => Ok(bytes.to_vec()),
            Err(message) => Err(io::Error::other(message.as_string().unwrap_or_default())),
        }
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.python.is_folder(&path.to_string_lossy()).unwrap_or_default()
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let names = self.python.names(&folder.to_string_lossy()).unwrap_or_default();
        names.iter().filter_map(|name| name.as_string()).collect()
    }
}

impl requests::Host for Surroundings<'_> {
    fn player(&self) -> Option<String> {
        self.python.player().unwrap_or_default()
    }

    fn seconds(&self) -> f64 {
        js_sys::Date::now() / 1000.0
    }

    fn goes_on(&self) -> bool {
        match self.python.go_on() {
            Ok(()) => true,
            Err(exception) => {
                self.ended.replace(Some(exception));
                false
            }
        }
    }

    fn compiler(&self) -> Option<&dyn engine::Compiler> {
        Some(&self.compiler)
    }
}

//! The simulation of the page, and its program.

use play::Play;
use program::bundle;
use std::cell::RefCell;
use view::Host;
use wasm_bindgen::{JsCast, JsValue};

/// The simulation, once it has been read.
#[derive(Default)]
pub struct Simulation(pub RefCell<Option<Play>>);

impl Host for Simulation {
    fn with_play(&self, work: &mut dyn FnMut(&mut Play)) {
        if let Ok(mut play) = self.0.try_borrow_mut()
            && let Some(play) = play.as_mut()
        {
            work(play);
        }
    }
}

/// The simulation whose bundle the page's script has inflated; `None` where there is none, or it is damaged.
pub fn of_page() -> Option<Play> {
    let bytes = js_sys::Reflect::get(&js_sys::global(), &JsValue::from_str("bundle")).ok()?;
    let bytes: js_sys::Uint8Array = bytes.dyn_into().ok()?;
    bundle::read(&bytes.to_vec()).ok().map(Play::open)
}

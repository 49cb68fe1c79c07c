//! Goes on with fits: gives the workers what they can do, and takes what they have found.

use super::travel;
use crate::app::{App, Lab};
use view::views::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Duration of a slice where the page itself computes, in milliseconds: half a frame.
const SLICE: f64 = 8.0;

/// Works on pending fits, including those restored from an earlier visit. The workers call it when they have news.
pub fn go_on(app: App) {
    app.fit_progress.set(app.read_desk(|desk| desk.fits().progress()));
    let begins = app.with(|lab| !std::mem::replace(&mut lab.fitting, true)).unwrap_or_default();
    if begins {
        work(app);
    }
}

/// Works on the fits once, or for one slice, then yields to the browser.
fn work(app: App) {
    let step = Closure::once_into_js(move || {
        let end = js_sys::Date::now() + SLICE;
        let before = travel::values(app);
        let (more, here) = app.with(|lab| advance(lab, end)).unwrap_or_default();
        app.fit_progress.set(app.read_desk(|desk| desk.fits().progress()));
        app.publish(false, false);
        travel::from(app, before);
        if more && here {
            return work(app);
        }
        app.with(|lab| lab.fitting = false);
        if !more {
            app.page.wake();
        }
    });
    let _ = window().set_timeout_with_callback(step.unchecked_ref());
}

/// Returns whether there is more work, and whether the page itself computes; then it works until the time `end`.
fn advance(lab: &mut Lab, end: f64) -> (bool, bool) {
    let Some(desk) = &mut lab.desk else { return (false, false) };
    loop {
        let (more, here) = (desk.advance_fits(&mut lab.workers), lab.workers.is_here());
        if !more || !here || js_sys::Date::now() >= end {
            return (more, here);
        }
    }
}

//! Computes fits in slices between frames.

use crate::app::App;
use view::browser;
use view::tabs;
use view::views::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Duration of a slice, in milliseconds: half a frame.
const SLICE: f64 = 8.0;

/// Works on pending fits, including those restored from an earlier visit.
pub fn go_on(app: App) {
    app.fit_progress.set(app.read_desk(|desk| desk.fit_progress()));
    let begins = app.with(|lab| !std::mem::replace(&mut lab.fitting, true)).unwrap_or_default();
    if begins {
        work(app);
    }
}

/// Works on the fits for one slice, then yields to the browser.
fn work(app: App) {
    let step = Closure::once_into_js(move || {
        let end = js_sys::Date::now() + SLICE;
        let more = app.read_desk(|desk| {
            let mut more = desk.advance_fit();
            while more && js_sys::Date::now() < end {
                more = desk.advance_fit();
            }
            more
        });
        let asked_for = app.fit_progress.with_untracked(Option::is_some);
        app.fit_progress.set(app.read_desk(|desk| desk.fit_progress()));
        app.publish(false, false);
        if more {
            work(app);
        } else {
            app.with(|lab| lab.fitting = false);
            // The result appears below the button.
            if asked_for && app.tab.get_untracked() == tabs::FIT {
                browser::bring_to_top("fit-step");
            }
            app.page.wake();
        }
    });
    let _ = window().set_timeout_with_callback(step.unchecked_ref());
}

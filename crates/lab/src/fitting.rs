//! Fits in the page: begun by a button, made in slices between frames.

use crate::app::App;
use crate::{browser, fit_results, fit_setup, library};
use leptos::prelude::*;
use session::{FitProgress, Session};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// A slice of work takes so many milliseconds: half a frame.
const SLICE: f64 = 8.0;

/// The part of the tab that fits; nothing while there is no record.
pub fn view(app: App) -> impl IntoView {
    let has_records = Memo::new(move |_| {
        app.changes.records.track();
        app.read(|session| !session.records().is_empty())
    });
    move || if has_records.get() { card(app) } else { ().into_any() }
}

fn card(app: App) -> AnyView {
    let words = app.words();
    let refusal = RwSignal::new(None::<String>);
    let chosen = RwSignal::new(None::<u32>);
    // What is shown of the results unless a person chooses: the best after a ranking, else the last.
    let ranked = RwSignal::new(true);
    let begin = move |rank: bool| {
        ranked.set(rank);
        chosen.set(None);
        let file = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
        refusal.set(app.attempt(|session| {
            if !rank {
                return session.begin_fit(&file);
            }
            let theories = library::theories();
            let theories = theories.into_iter().filter_map(|entry| Some((entry.file().to_owned(), entry.open()?)));
            session.begin_ranking(theories.collect())
        }));
        go_on(app);
    };
    let busy = move || app.fit_progress.with(Option::is_some);
    view! {
        <section class="fitting card" aria-labelledby="fitting-title">
            {fit_setup::view(app, refusal)}
            <div class="intake">
                <button type="button" class="primary" id="fit" aria-disabled=move || busy().to_string() on:click=move |_| begin(false)>{words.fit_begin}</button>
                <button type="button" class="quiet" id="rank" title=words.fit_rank_title aria-disabled=move || busy().to_string() on:click=move |_| begin(true)>{words.fit_rank}</button>
                {move || busy().then(|| running(app))}
            </div>
            <p class="refusal" role="alert">{move || refusal.get()}</p>
            {fit_results::view(app, chosen, ranked)}
        </section>
    }
    .into_any()
}

/// The bar and the way out, while a fit is being made.
fn running(app: App) -> AnyView {
    let words = app.words();
    let progress = app.fit_progress;
    let finished = move || progress.with(|now| now.as_ref().map_or((0, 1), |now| now.finished));
    let told = move || {
        progress.with(|now| {
            let FitProgress { theory, trials, finished, .. } = now.clone()?;
            let place = if finished.1 > 1 { format!("{}/{}: ", finished.0 + 1, finished.1) } else { String::new() };
            Some(format!("{place}{theory}, {trials} {}", words.fit_trials))
        })
    };
    view! {
        <progress aria-label=words.fit_title max=move || finished().1.to_string()
            value=move || { let (done, all) = finished(); (all > 1).then(|| done.to_string()) }></progress>
        <span class="note">{told}</span>
        <button type="button" class="quiet" id="cancel-fit" on:click=move |_| {
            app.act(Session::cancel_fit);
            progress.set(None);
            browser::focus("fit");
        }>{words.fit_cancel}</button>
    }
    .into_any()
}

/// Works on what is to be fitted, and on what an earlier visit has left to be made again.
pub fn go_on(app: App) {
    app.fit_progress.set(app.read(|session| session.fit_progress()));
    let begins = app.with(|lab| !std::mem::replace(&mut lab.fitting, true)).unwrap_or_default();
    if begins {
        work(app);
    }
}

/// Works on the fits for a slice, then lets the page breathe.
fn work(app: App) {
    let step = Closure::once_into_js(move || {
        let end = js_sys::Date::now() + SLICE;
        let more = app.read(|session| {
            let mut more = session.advance_fit();
            while more && js_sys::Date::now() < end {
                more = session.advance_fit();
            }
            more
        });
        app.fit_progress.set(app.read(|session| session.fit_progress()));
        app.publish(false, false);
        if more {
            work(app);
        } else {
            app.with(|lab| lab.fitting = false);
            crate::frame::wake(app);
        }
    });
    let _ = window().set_timeout_with_callback(step.unchecked_ref());
}

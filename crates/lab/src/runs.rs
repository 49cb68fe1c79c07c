//! Kept runs: drawn behind the present one, shown, hidden, removed.

use crate::app::App;
use crate::icons;
use leptos::prelude::*;
use session::Session;

/// Keeps the run as it is.
pub fn keep_button(app: App) -> impl IntoView {
    let words = app.words();
    view! {
        <button type="button" class="quiet with-icon" id="keep" title=words.keep_title
            on:click=move |_| if let Some(refusal) = app.attempt(Session::keep) { app.say(refusal) }>
            {icons::keep()}<span>{words.keep}</span>
        </button>
    }
}

/// The list of kept runs and the ghost; nothing while there are none.
pub fn list(app: App) -> impl IntoView {
    let words = app.words();
    move || {
        app.changes.runs.track();
        let (kept, ghost) = app.read(|session| (session.kept(), session.has_ghost()));
        if kept.is_empty() && !ghost {
            return ().into_any();
        }
        let rows = kept
            .into_iter()
            .map(|run| {
                let (id, shown, name) = (run.id, run.shown, run.name);
                let remove = format!("{}: {name}", words.remove_run);
                view! {
                    <li class="run">
                        <label class="switch">
                            <input type="checkbox" prop:checked=shown on:change=move |event| {
                                let shown = event_target_checked(&event);
                                app.act(|session| session.show_kept(id, shown));
                            } />
                            <span>{name}</span>
                        </label>
                        <button type="button" class="icon small" title=remove.clone() aria-label=remove on:click=move |_| {
                            app.act(|session| session.remove_kept(id));
                            // The button is gone; the focus goes where the next run is kept.
                            crate::browser::focus("keep");
                        }>{icons::cross()}</button>
                    </li>
                }
            })
            .collect_view();
        let ghost = ghost.then(|| {
            let remove = format!("{}: {}", words.remove_run, words.ghost);
            view! {
                <li class="run ghost">
                    <span>{words.ghost}</span>
                    <button type="button" class="icon small" title=remove.clone() aria-label=remove on:click=move |_| {
                        app.act(Session::clear_ghost);
                        crate::browser::focus("keep");
                    }>{icons::cross()}</button>
                </li>
            }
        });
        view! { <ul class="runs" aria-label=words.runs>{rows}{ghost}</ul> }.into_any()
    }
}

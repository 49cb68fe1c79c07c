//! The controls: presets, parameters, the state, method and step.

use crate::app::App;
use crate::parameters;
use leptos::prelude::*;
use session::Session;

/// A name typeset: `h_l` as MathML. Labels say the same in words, so readers of the screen need not hear it.
pub fn symbol(name: &str) -> impl IntoView {
    view! { <span class="symbol" aria-hidden="true" inner_html=model::typeset_name(name)></span> }
}

/// The controls.
pub fn view(app: App) -> impl IntoView {
    let words = app.words();
    view! {
        <section class="controls card" id="controls" aria-labelledby="controls-title">
            <h2 id="controls-title" class="visually-hidden">{words.controls}</h2>
            <div class="block">
                <div class="block-head">
                    <h3>{words.parameters}</h3>
                    <button type="button" class="quiet" id="reset-parameters" on:click=move |_| app.act(Session::reset_parameters)>{words.reset_parameters}</button>
                </div>
                {parameters::view(app)}
            </div>
            {presets(app)}
            {states(app)}
            {numerics(app)}
        </section>
    }
}

fn presets(app: App) -> impl IntoView {
    let words = app.words();
    let now = Memo::new(move |_| {
        app.changes.parameters.track();
        app.read(|session| session.presets())
    });
    let groups = now.get_untracked();
    if groups.is_empty() {
        return ().into_any();
    }
    let selected = move |index: usize| {
        now.with(|groups| {
            groups.iter().flat_map(|group| &group.presets).any(|preset| preset.index == index && preset.selected)
        })
    };
    let refusal = RwSignal::new(None::<String>);
    let groups = groups
        .into_iter()
        .enumerate()
        .map(|(number, group)| {
            let id = format!("presets-{number}");
            let buttons = group
                .presets
                .into_iter()
                .map(|preset| {
                    let index = preset.index;
                    view! {
                        <button type="button" class="chip" title=preset.description aria-pressed=move || selected(index).to_string()
                            on:click=move |_| refusal.set(app.attempt(|session| session.apply_preset(index)))>
                            {preset.name}
                        </button>
                    }
                })
                .collect_view();
            let name = if group.name.is_empty() { words.presets.to_owned() } else { group.name };
            view! {
                <div class="preset-group" role="group" aria-labelledby=id.clone()>
                    <h4 id=id.clone()>{name}</h4>
                    <div class="chips">{buttons}</div>
                </div>
            }
        })
        .collect_view();
    view! {
        <div class="block presets">
            <h3 class="visually-hidden">{words.presets}</h3>
            {groups}
            <p class="refusal" role="alert">{move || refusal.get()}</p>
        </div>
    }
    .into_any()
}

/// The state, to be edited while the run stands still.
fn states(app: App) -> impl IntoView {
    let words = app.words();
    let states = app.read(|session| session.states());
    if states.is_empty() {
        return ().into_any();
    }
    let fields = states
        .into_iter()
        .map(|state| {
            let (index, id) = (state.index, format!("state-{}", state.index));
            let view = move || {
                app.changes.values.track();
                app.changes.transport.track();
                app.read(|session| session.states().into_iter().nth(index))
            };
            let editable = move || view().is_some_and(|state| state.editable);
            let error = RwSignal::new(None::<String>);
            let field = parameters::Field {
                id: id.clone(),
                text: Signal::derive(move || view().map(|state| state.text).unwrap_or_default()),
                editable: Signal::derive(editable),
                signed: true,
                error,
                commit: move |text: String| app.attempt(|session| session.set_state_text(index, &text)),
                nudge: |_| (),
            };
            view! {
                <div class="parameter">
                    <label for=id.clone()><span>{state.label}</span>{symbol(&state.name)}</label>
                    <span class="quantity">{field.view()}<span class="unit">{state.unit}</span></span>
                    <p class="refusal" id=format!("{id}-error") role="alert">{move || error.get()}</p>
                </div>
            }
        })
        .collect_view();
    view! {
        <div class="block">
            <div class="block-head"><h3>{words.state}</h3></div>
            {fields}
            <p class="note">{words.state_hint}</p>
        </div>
    }
    .into_any()
}

/// Method and step.
fn numerics(app: App) -> impl IntoView {
    let words = app.words();
    let refusal = RwSignal::new(None::<String>);
    let error = RwSignal::new(None::<String>);
    let chosen = move |name: &'static str| {
        app.changes.parameters.track();
        app.read(|session| session.methods().iter().any(|method| method.name == name && method.selected))
    };
    let options = app
        .read(|session| session.methods())
        .into_iter()
        .map(|method| {
            view! {
                <option value=method.name disabled=!method.refused.is_empty() title=method.refused selected=move || chosen(method.name)>{method.label}</option>
            }
        })
        .collect_view();
    let step = move || {
        app.changes.parameters.track();
        app.read(|session| session.step_text())
    };
    let field = parameters::Field {
        id: "step-size".to_owned(),
        text: Signal::derive(move || step().0),
        editable: Signal::derive(|| true),
        signed: false,
        error,
        commit: move |text: String| app.attempt(|session| session.set_step_text(&text)),
        nudge: |_| (),
    };
    view! {
        <details class="block numerics">
            <summary><h3>{words.numerics}</h3></summary>
            <div class="parameter">
                <label for="method"><span>{words.method}</span></label>
                <select id="method" on:change=move |event| {
                    let name = event_target_value(&event);
                    refusal.set(app.attempt(|session| session.set_method(&name)));
                }>{options}</select>
                <p class="refusal" role="alert">{move || refusal.get()}</p>
            </div>
            <div class="parameter">
                <label for="step-size"><span>{words.step}</span></label>
                <span class="quantity">{field.view()}<span class="unit">{move || step().1}</span></span>
                <p class="refusal" id="step-size-error" role="alert">{move || error.get()}</p>
            </div>
        </details>
    }
}

//! Velocity and acceleration of a record's column, made anew: which column, by which method.

use crate::app::App;
use crate::browser;
use leptos::prelude::*;
use session::{Differentiation, RecordView};

/// What was chosen last: the same for all records, as long as the page is open.
#[derive(Clone, Copy)]
pub struct Choice {
    /// The records whose form is open.
    open: RwSignal<Vec<u32>>,
    smooth: RwSignal<bool>,
    window: RwSignal<String>,
    degree: RwSignal<String>,
}

impl Choice {
    /// What a person meets at first.
    pub fn new() -> Self {
        Self {
            open: RwSignal::new(Vec::new()),
            smooth: RwSignal::new(false),
            window: RwSignal::new("9".to_owned()),
            degree: RwSignal::new("3".to_owned()),
        }
    }

    fn method(self) -> Differentiation {
        let number = |text: RwSignal<String>| text.with_untracked(|text| text.trim().parse().unwrap_or_default());
        match self.smooth.get_untracked() {
            true => Differentiation::Smooth { window: number(self.window), degree: number(self.degree) },
            false => Differentiation::Central,
        }
    }
}

/// The form, closed at first; nothing where no column can be differentiated.
pub fn view(app: App, record: &RecordView, choice: Choice) -> AnyView {
    let words = app.words();
    let id = record.id;
    let columns: Vec<_> = record.columns.iter().filter(|column| column.differentiable).collect();
    let Some(first) = columns.first().map(|column| column.index) else { return ().into_any() };
    let any_made = record.columns.iter().any(|column| !column.made.is_empty());
    let of = columns.iter().find(|column| column.fitted).map_or(first, |column| column.index);
    let column = RwSignal::new(of);
    let options = columns
        .into_iter()
        .map(|column| {
            view! { <option value=column.index.to_string() selected=column.index == of>{column.head.clone()}</option> }
        })
        .collect_view();
    let button = format!("derive-{id}");
    let again = button.clone();
    let make = move |_| {
        let refusal = app.attempt(|session| session.make_derivatives(id, column.get_untracked(), choice.method()));
        app.record_refusal.set(refusal);
        browser::focus_later(again.clone());
    };
    let summary = format!("derivatives-{id}");
    let forget_focus = button.clone();
    view! {
        <details class="derivatives" open=choice.open.with_untracked(|open| open.contains(&id))
            on:toggle=move |event| {
                let now = event_target::<web_sys::Element>(&event).has_attribute("open");
                choice.open.update(|open| {
                    open.retain(|other| *other != id);
                    if now { open.push(id) }
                });
            }>
            <summary id=summary>{words.derivatives_title}</summary>
            <p class="note">{words.derivatives_intro}</p>
            <div class="looking">
                <span class="quantity"><label for=format!("derive-of-{id}")>{words.derivatives_of}</label>
                    <select id=format!("derive-of-{id}") on:change=move |event| column.set(event_target_value(&event).parse().unwrap_or(of))>{options}</select></span>
                <span class="quantity"><label for=format!("derive-how-{id}")>{words.derivatives_method}</label>
                    <select id=format!("derive-how-{id}") on:change=move |event| choice.smooth.set(event_target_value(&event) == "smooth")>
                        <option value="central" selected=!choice.smooth.get_untracked()>{words.derivatives_central}</option>
                        <option value="smooth" selected=choice.smooth.get_untracked()>{words.derivatives_smooth}</option>
                    </select></span>
                {move || choice.smooth.get().then(|| polynomial(app, id, choice))}
                <button type="button" class="quiet outlined" id=button on:click=make>{words.derivatives_make}</button>
                {any_made.then(|| view! {
                    <button type="button" class="quiet" on:click=move |_| {
                        app.act(|session| session.forget_derivatives(id));
                        browser::focus_later(forget_focus.clone());
                    }>{words.derivatives_forget}</button>
                })}
            </div>
        </details>
    }
    .into_any()
}

/// Rows and degree of the smoothing polynomials.
fn polynomial(app: App, id: u32, choice: Choice) -> AnyView {
    let words = app.words();
    let field = move |name: &str, label: &'static str, text: RwSignal<String>| {
        let id = format!("derive-{name}-{id}");
        view! {
            <span class="quantity"><label for=id.clone()>{label}</label>
                <input type="text" class="number" id=id inputmode="numeric" autocomplete="off" prop:value=text.get_untracked()
                    on:input=move |event| text.set(event_target_value(&event)) /></span>
        }
    };
    view! { {field("rows", words.derivatives_rows, choice.window)} {field("degree", words.derivatives_degree, choice.degree)} }
        .into_any()
}

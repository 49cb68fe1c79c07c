//! The values that can be read off, with their symbols.

use crate::app::App;
use leptos::prelude::*;
use session::{Readout, ReadoutKind};

/// The readouts: what changes with time, and what does not.
pub fn view(app: App) -> impl IntoView {
    let words = app.words();
    let first: Vec<Readout> = app.read(|session| session.readouts());
    let now = RwSignal::new(first.clone());
    Effect::new(move |_| {
        app.changes.values.track();
        app.changes.parameters.track();
        now.set(app.read(|session| session.readouts()));
    });
    // The clock shows the independent variable.
    let list = |varies: bool, title: &'static str| {
        let rows: Vec<_> = first
            .iter()
            .enumerate()
            .filter(|(_, readout)| readout.varies == varies && readout.kind != ReadoutKind::Independent)
            .map(|(index, readout)| row(now, index, readout))
            .collect();
        (!rows.is_empty()).then(|| view! { <div class="values"><h3>{title}</h3><dl>{rows}</dl></div> })
    };
    view! {
        <section class="readouts card" id="readouts" aria-labelledby="readouts-title">
            <h2 id="readouts-title" class="visually-hidden">{words.readouts}</h2>
            {list(true, words.changing)}
            {list(false, words.constants)}
        </section>
    }
}

fn row(now: RwSignal<Vec<Readout>>, index: usize, readout: &Readout) -> AnyView {
    let get =
        move |part: fn(&Readout) -> &String| now.with(|list| list.get(index).map(part).cloned().unwrap_or_default());
    // A name that is a word says what the label says.
    let symbol = (!readout.name.eq_ignore_ascii_case(&readout.label))
        .then(|| view! { <span class="symbol" inner_html=model::typeset_name(&readout.name)></span> });
    view! {
        <div>
            <dt>
                <span class="label">{readout.label.clone()}</span>
                {symbol}
            </dt>
            <dd>
                <span class="value">{move || get(|readout| &readout.value)}</span>
                <span class="unit">{move || get(|readout| &readout.unit)}</span>
            </dd>
        </div>
    }
    .into_any()
}

//! The form of the virtual measurement.

use crate::app::App;
use leptos::prelude::*;
use session::{MEASUREMENT_FIELDS, MeasurementForm};

/// The form, closed at first.
pub fn view(app: App) -> AnyView {
    let words = app.words();
    let form = RwSignal::new(app.read(|session| session.measurement_form()));
    let refusal = RwSignal::new(None::<(usize, String)>);
    let labels = [
        words.virtual_rate,
        words.virtual_duration,
        words.virtual_pixel,
        words.virtual_noise,
        words.virtual_jitter,
        words.virtual_scale,
        words.virtual_seed,
    ];
    let units = move || form.with(|form| app.read(|session| session.measurement_units(&form.quantity)));
    let fields: Vec<AnyView> =
        labels.into_iter().enumerate().map(|(index, label)| field(form, refusal, index, label, units)).collect();
    let measurable = app.read(|session| session.measurable());
    let options: Vec<AnyView> = measurable
        .into_iter()
        .skip(1)
        .map(|(value, label)| {
            let chosen = form.with_untracked(|form| form.quantity == value);
            view! { <option value=value selected=chosen>{label}</option> }.into_any()
        })
        .collect();
    let measure = move |_| {
        let asked: MeasurementForm = form.get_untracked();
        let answer = app.act(|session| {
            let number = session.records().iter().filter(|record| record.synthetic).count() + 1;
            let name = format!("{} {number}", words.virtual_name);
            session.measure(&name, &asked).err().map(|(field, refusal)| (field, session.refusal_text(&refusal)))
        });
        refusal.set(answer);
    };
    view! {
        <details class="virtual card" id="virtual">
            <summary><h3>{words.virtual_measurement}</h3></summary>
            <p class="note">{words.virtual_intro}</p>
            <div class="form">
                <div class="parameter">
                    <label for="virtual-quantity">{words.virtual_quantity}</label>
                    <select id="virtual-quantity" on:change=move |event| form.update(|form| form.quantity = event_target_value(&event))>{options}</select>
                </div>
                {fields}
            </div>
            <p class="note">{words.virtual_seed_hint}</p>
            <button type="button" class="primary" id="measure" on:click=measure>{words.virtual_measure}</button>
        </details>
    }
    .into_any()
}

fn field(
    form: RwSignal<MeasurementForm>,
    refusal: RwSignal<Option<(usize, String)>>,
    index: usize,
    label: &'static str,
    units: impl Fn() -> [String; MEASUREMENT_FIELDS] + Copy + Send + Sync + 'static,
) -> AnyView {
    let id = format!("virtual-{index}");
    let error = format!("{id}-error");
    let refused = move || {
        refusal.with(|refusal| refusal.as_ref().filter(|(field, _)| *field == index).map(|(_, why)| why.clone()))
    };
    let described = error.clone();
    view! {
        <div class="parameter">
            <label for=id.clone()>{label}</label>
            <span class="quantity">
                <input type="text" class="number" id=id autocomplete="off" spellcheck="false"
                    prop:value=form.with_untracked(|form| form.fields[index].clone())
                    aria-invalid=move || refused().map(|_| "true") aria-describedby=move || refused().map(|_| described.clone())
                    on:input=move |event| form.update(|form| form.fields[index] = event_target_value(&event)) />
                <span class="unit">{move || units()[index].clone()}</span>
            </span>
            <p class="refusal" id=error role="alert">{refused}</p>
        </div>
    }
    .into_any()
}

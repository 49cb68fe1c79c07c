//! Form of the virtual measurement.

use crate::app::App;
use crate::film;
use desk::{MEASUREMENT_FIELDS, MeasurementForm, measurement_units};
use view::views::*;

/// The form; its settings are folded.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let form = create_signal(app.read_desk(|desk| MeasurementForm::suited(desk.play())));
    let refusal = create_signal(None::<(usize, String)>);
    let labels = [
        words.virtual_rate,
        words.virtual_duration,
        words.virtual_pixel,
        words.virtual_noise,
        words.virtual_jitter,
        words.virtual_scale,
        words.virtual_seed,
    ];
    let units = memo(move || form.with(|form| app.read_desk(|desk| measurement_units(desk.play(), &form.quantity))));
    let measurable = app.read_desk(|desk| desk.records().measurable());
    let choose = |(value, label): (String, String)| {
        let chosen = form.with_untracked(|form| form.quantity == value);
        option().value(value).selected(chosen).child(label)
    };
    let measure = move |_| {
        let asked: MeasurementForm = form.get_clone_untracked();
        let answer = app.act_on_desk(|desk| {
            let number = desk.records().list().iter().filter(|record| record.synthetic).count() + 1;
            let name = format!("{} {number}", words.virtual_name);
            desk.change_records(|records, open| records.measure(open, &name, &asked))
                .err()
                .map(|(field, refusal)| (field, refusal.text(desk.play())))
        });
        refusal.set(answer);
    };
    let quantity = select()
        .id("virtual-quantity")
        .when(events::change, move |event| form.update(|form| form.quantity = value_of(&event)))
        .each(measurable.into_iter().skip(1), choose);
    let quantity =
        div().class("parameter").child(label().r#for("virtual-quantity").child(words.virtual_quantity)).child(quantity);
    let fields = div()
        .class("form")
        .child(quantity)
        .each(labels.into_iter().enumerate(), |(index, label)| field(form, refusal, index, label, units));
    let settings = details()
        .class("more")
        .child(summary().child(words.virtual_settings))
        .child(fields)
        .child(note(words.virtual_seed_hint));
    div()
        .class("virtual card")
        .id("virtual")
        .child(h3().child(words.virtual_measurement))
        .child(note(words.virtual_intro))
        .child(
            div()
                .class("intake")
                .child(
                    button().class("primary").id("measure").when(events::click, measure).child(words.virtual_measure),
                )
                .child(film::virtual_camera_button(app)),
        )
        .child(settings)
}

fn field(
    form: Signal<MeasurementForm>,
    refusal: Signal<Option<(usize, String)>>,
    index: usize,
    name: &'static str,
    units: ReadSignal<[String; MEASUREMENT_FIELDS]>,
) -> HtmlDiv {
    let id = format!("virtual-{index}");
    let error = format!("{id}-error");
    let refused = move || {
        refusal.with(|refusal| refusal.as_ref().filter(|(field, _)| *field == index).map(|(_, why)| why.clone()))
    };
    let described = error.clone();
    let input = short_field(id.clone())
        .prop("value", form.with_untracked(|form| form.fields[index].clone()))
        .attr("aria-invalid", move || refused().map(|_| "true"))
        .attr("aria-describedby", move || refused().map(|_| described.clone()))
        .when(events::input, move |event| form.update(|form| form.fields[index] = value_of(&event)));
    let unit = unit_of(text(move || units.with(|units| units[index].clone())));
    div()
        .class("parameter")
        .child(label().r#for(id).child(name))
        .child(span().class("quantity").child(input).child(unit))
        .child(p().class("refusal").id(error).role("alert").child(text(move || refused().unwrap_or_default())))
}

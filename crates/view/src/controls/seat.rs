//! Field of the seat, on which the assigned values of a class depend.

use crate::app::App;
use crate::controls::parameters::Field;
use crate::views::*;

/// Field with a note that says whose values are set; nothing if the document assigns no values.
pub fn view(app: App) -> View {
    let words = app.words();
    if app.read(|play| play.basis().seat()).is_none() {
        return View::new();
    }
    let number = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.basis().seat().and_then(|seat| seat.number))
    });
    let (locked, fixed) = (app.host().embedding().locked, app.host().has_fixed_seat());
    let error = create_signal(None::<String>);
    let field = Field {
        id: "seat".to_owned(),
        text: memo(move || number.get().map(|number| number.to_string()).unwrap_or_default()),
        // In a page with locked values, only a missing seat can be given.
        editable: memo(move || !fixed && (!locked || number.get().is_none())),
        signed: false,
        error,
        commit: Box::new(move |text| app.attempt(|play| play.set_seat(text))),
        nudge: Box::new(|_| ()),
    };
    let told = move || (if number.get().is_some() { words.seat_known } else { words.seat_unknown }).to_owned();
    div()
        .class("block")
        .child(
            div()
                .class("parameter")
                .child(label().r#for("seat").child(span().child(words.seat)))
                .child(with_unit(field.view(), ""))
                .child(refusal_of(error).id("seat-error")),
        )
        .child(note(text(told)).id("seat-note"))
        .into()
}

//! The buttons of the document.

use crate::app::App;
use crate::views::*;
use play::ButtonView;

/// A row with the document's buttons; empty if there are none.
pub fn view(app: App) -> View {
    let words = app.words();
    let buttons = app.read(|play| play.basis().buttons());
    if buttons.is_empty() {
        return View::new();
    }
    let refusal = create_signal(None::<String>);
    let usable = memo(move || {
        app.changes.transport.track();
        app.read(|play| play.time_line().can_press())
    });
    let one = move |view: ButtonView| {
        let index = view.index;
        button()
            .class("action")
            .id(format!("button-{index}"))
            .attr("aria-disabled", move || (!usable.get()).then_some("true"))
            .when(events::click, move |_| {
                refusal.set(app.attempt(|play| play.change_settings(|settings| settings.press(index))))
            })
            .child(view.title)
    };
    div()
        .class("block actions")
        .role("group")
        .attr("aria-label", words.buttons)
        .child(div().class("chips").each(buttons, one))
        .child(refusal_of(refusal))
        .into()
}

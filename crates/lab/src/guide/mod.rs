//! Guided start: four things to do with the opening document.

mod step;

pub use step::Step;

use crate::app::App;
use view::page::welcome::GUIDE;
use view::views::*;
use view::{browser, panel::tabs};

/// Id of the button that ends the guided start.
const END: &str = "guide-end";

/// Begins with the first step.
pub fn begin(app: App) {
    app.tab.set(tabs::EXPLORE);
    app.guide.set(Some(Step::Lift));
    // The button that was pressed is gone.
    browser::focus_later(END.to_owned());
}

/// The present step and a button that ends the guided start.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let step = move || {
        let step = app.guide.get().unwrap_or(Step::Done);
        let (number, task) = match step {
            Step::Lift => ("1/4", words.guide_lift),
            Step::LetGo => ("2/4", words.guide_let_go),
            Step::Damp(_) => ("3/4", words.guide_damp),
            Step::Read => ("4/4", words.guide_read),
            Step::Done => ("4/4", words.guide_done),
        };
        let keys = (step == Step::Lift).then(|| span().class("for-keys").child(words.guide_lift_keys));
        View::from((strong().child(number), span().child(task), keys.map_or_else(View::new, View::from)))
    };
    let end = move |_| {
        app.guide.set(None);
        browser::focus_later(GUIDE.to_owned());
    };
    let is_done = move || app.guide.get() == Some(Step::Done);
    let name = move || if is_done() { words.close } else { words.guide_skip };
    div()
        .class("guide")
        .role("region")
        .attr("aria-label", words.guide)
        .child(p().id("guide-step").attr("aria-live", "polite").child(changing(step)))
        .child(
            button()
                .class("quiet outlined")
                .id(END)
                .attr("aria-describedby", "guide-step")
                .when(events::click, end)
                .child(text(move || name().to_owned())),
        )
}

//! Line of the opening document in the header of the laboratory, with first things to do. The player shows it as the laboratory
//! does, so that nothing moves when the laboratory takes over.

use crate::app::App;
use crate::browser;
use crate::page::opening::Opening;
use crate::pieces::icons;
use crate::pieces::toolbar::Toolbar;
use crate::views::*;

/// File name of the document with which the laboratory opens.
pub const OPENING: &str = "tube.md";

/// Id of the button that begins with a film.
pub const FILM: &str = "film-own";

/// Id of the button that begins *See it measured*.
pub const SEE: &str = "see-measured";

/// Id of the button in the line that does the same where the door has no room.
pub const SEE_IN_LINE: &str = "see-measured-in-line";

/// Id of the button that begins the guided start.
pub const GUIDE: &str = "guide";

/// Storage key that is set once the guided start has been offered.
const OFFERED: &str = "guide";

/// True on the first visit, when the guided start is offered prominently.
pub fn is_first_visit() -> bool {
    browser::remembered(OFFERED).is_none()
}

/// True if the page opens with the opening document of the laboratory, and not with one that was put into it.
pub fn is_home(opening: &Opening) -> bool {
    opening.name() == OPENING && document().get_element_by_id("documents").is_none()
}

/// Makes this visit the first one.
pub fn end_first_visit() {
    browser::remember(OFFERED, "offered");
}

/// Door to the sample film, under the plot of the opening document.
pub fn door(app: App, press: impl Fn() + 'static) -> HtmlButton {
    let words = app.words();
    button()
        .class("door")
        .id(SEE)
        .when(events::click, move |_| press())
        .child(span().class("door-picture").attr("aria-hidden", "true").child(icons::play()))
        .child(
            span().child(strong().child(words.see_measured)).child(span().class("note").child(words.see_measured_note)),
        )
}

/// The line. `press` is called with the id of the pressed button.
pub fn line(app: App, is_first_visit: bool, press: impl Fn(&'static str) + Clone + 'static) -> HtmlDiv {
    let words = app.words();
    let guide = button().class(if is_first_visit { "action" } else { "quiet" }).child(words.guide);
    let film = button().class("quiet").child(words.film_own);
    let see = button().class("quiet for-small").child(words.see_measured);
    let buttons = [(GUIDE, guide), (SEE_IN_LINE, see), (FILM, film)].into_iter();
    let bar = Toolbar::new();
    let place = |(place, (id, button)): (usize, (&'static str, HtmlButton))| {
        let press = press.clone();
        button
            .id(id)
            .tabindex(move || bar.stop(place))
            .when(events::focus, move |_| bar.enter(place))
            .when(events::click, move |_| press(id))
    };
    div()
        .class("welcome")
        .role("toolbar")
        .attr("aria-label", words.first_steps)
        .when(events::keydown, Toolbar::turn)
        .each(buttons.enumerate(), place)
}

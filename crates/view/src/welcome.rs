//! Line of the opening document in the header of the laboratory, with first things to do. The player shows it as the laboratory
//! does, so that nothing moves when the laboratory takes over.

use crate::app::App;
use crate::toolbar::Toolbar;
use crate::views::*;

/// File name of the document with which the laboratory opens.
pub const OPENING: &str = "tube.md";

/// Id of the button that begins with a film.
pub const FILM: &str = "film-own";

/// Id of the button that opens the published simulation.
pub const PUBLISHED: &str = "published";

/// The line. `press` is called with the id of the pressed button.
pub fn line(app: App, press: impl Fn(&'static str) + Clone + 'static) -> HtmlDiv {
    let words = app.words();
    let film = button().child(words.film_own).child(span().class("film-steps").child(words.film_own_steps));
    let buttons = [(FILM, film), (PUBLISHED, button().child(words.published))];
    let bar = Toolbar::new();
    let place = |(place, (id, button)): (usize, (&'static str, HtmlButton))| {
        let press = press.clone();
        button
            .class("quiet")
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
        .each(buttons.into_iter().enumerate(), place)
}

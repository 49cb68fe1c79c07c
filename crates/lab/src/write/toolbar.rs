//! A toolbar with a single tab stop: arrow keys move between its buttons, following the WAI-ARIA pattern.

use view::browser;
use view::views::*;
use web_sys::KeyboardEvent;

/// Toolbar of buttons with their ids.
pub fn view<const N: usize>(name: &'static str, buttons: [(&'static str, HtmlButton); N]) -> HtmlDiv {
    let ids = buttons.each_ref().map(|(id, _)| *id);
    // Index of the tab stop: the first button, or the one that had the focus last.
    let stop = create_signal(0);
    let turn = move |event: KeyboardEvent| {
        let now = ids.iter().position(|id| *id == browser::focused()).unwrap_or(0);
        let next = match event.key().as_str() {
            "ArrowRight" => (now + 1) % N,
            "ArrowLeft" => (now + N - 1) % N,
            "Home" => 0,
            "End" => N - 1,
            _ => return,
        };
        event.prevent_default();
        if let Some(id) = ids.get(next) {
            browser::focus(id);
        }
    };
    let each = buttons.into_iter().enumerate();
    div().class("toolbar").role("toolbar").attr("aria-label", name).when(events::keydown, turn).each(
        each,
        move |(place, (_, button))| {
            button
                .tabindex(move || if stop.get() == place { "0" } else { "-1" })
                .when(events::focus, move |_| stop.set(place))
        },
    )
}

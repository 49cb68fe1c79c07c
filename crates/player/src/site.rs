//! Links of a page that belongs to a site: to the list of all simulations, and to the laboratory with the same
//! document. Their addresses are in the head of the page; a standalone page has none.

use play::Link;
use view::views::*;
use view::{App, browser, pieces::icons};
use web_sys::{HtmlAnchorElement, HtmlLinkElement};

/// The links; empty if the page belongs to no site.
pub fn links(app: App) -> View {
    let words = app.words();
    let list = address("simulations").map(|address| {
        link(icons::books(), words.all_simulations).id("all-simulations").title(words.all_simulations).href(address)
    });
    View::from((list.map_or_else(View::new, View::from), laboratory(app)))
}

/// Link to the laboratory. It contains the state at the moment it is followed.
fn laboratory(app: App) -> View {
    let Some(address) = address("laboratory") else { return View::new() };
    let words = app.words();
    let mut link = link(icons::flask(), words.open_in_laboratory)
        .id("open-in-laboratory")
        .title(words.laboratory_title)
        .href(address.clone());
    let node: HtmlAnchorElement = link.node();
    let renew = move || {
        let state = app.read(|play| play.share());
        if let Some((laboratory, fragment)) = address.split_once('#')
            && let Ok(document) = Link::read(fragment)
        {
            node.set_href(&format!("{laboratory}#{}", Link { state, ..document }.write()));
        }
    };
    // A key triggers only a click. A pointer that opens a menu or another window triggers none, only `pointerdown`.
    let pressed = renew.clone();
    link.when(events::pointerdown, move |_| pressed()).when(events::click, move |_| renew()).into()
}

fn link(icon: SvgSvg, words: &'static str) -> HtmlA {
    a().class("quiet with-icon").child(icon).child(span().child(words))
}

fn address(id: &str) -> Option<String> {
    browser::by_id::<HtmlLinkElement>(id).map(|link| link.href())
}

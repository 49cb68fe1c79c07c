//! List of the versions of a document, with buttons to restore them.

use super::times::time_text;
use super::unfolded::Unfolded;
use super::versions::{self, Version};
use super::{changes, draft};
use crate::app::App;
use desk::{LineChanges, line_changes};
use view::views::*;

/// Button that shows the list, and the list below the tools.
pub fn view(app: App, unfolded: Signal<Option<Unfolded>>) -> (HtmlButton, HtmlDiv) {
    let open = move || unfolded.get() == Some(Unfolded::Versions);
    let list = changing(move || {
        app.written.track();
        if open() { list(app) } else { View::new() }
    });
    let button = Unfolded::Versions
        .button(unfolded, "version-list", app.words().versions)
        .when(events::click, move |_| draft::flush(app));
    let place = div().class("templates").id("version-list").hidden(move || !open()).child(list);
    (button, place)
}

/// Versions, the latest first, each with its changes from the previous one.
fn list(app: App) -> View {
    let words = app.words();
    let all = versions::all(app);
    if all.is_empty() {
        return note(words.no_versions).into();
    }
    let mut before: Option<Vec<String>> = None;
    let mut rows = Vec::new();
    for version in all {
        let changes = before
            .as_ref()
            .map(|before| line_changes(before.iter().map(String::as_str), version.texts.iter().map(String::as_str)));
        before = Some(version.texts.clone());
        rows.push(row(app, version, changes));
    }
    rows.reverse();
    View::from((note(words.versions_intro), ul().class("versions").each(rows, |row| row)))
}

fn row(app: App, version: Version, changes: Option<LineChanges>) -> HtmlLi {
    let words = app.words();
    let changed = match changes {
        Some(LineChanges { added, removed }) => format!("+{added} −{removed} {}", words.version_lines),
        None => words.version_first.to_owned(),
    };
    let texts = version.texts;
    let open = move |_| {
        changes::go_back(app, &texts);
        app.notify(words.version_opened);
    };
    let time = span().class("version-time").child(time_text(app, version.time));
    li().child(button().class("quiet").when(events::click, open).child(time).child(span().class("note").child(changed)))
}

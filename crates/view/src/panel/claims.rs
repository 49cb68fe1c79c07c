//! Claims of the author about the simulation, and their results: a list below the theory, checked on demand.

use crate::app::App;
use crate::page::theme;
use crate::panel::question::supposed;
use crate::views::*;
use figure::Settings;
use play::{ClaimView, ClaimsView, deviation_svg};

/// List of claims; empty if the document contains none.
pub fn view(app: App) -> View {
    if !app.read(|play| !play.program().checks.is_empty()) {
        return View::new();
    }
    let words = app.words();
    // Claim whose deviation plot is shown.
    let drawn = create_signal(None::<(usize, usize)>);
    let listed = move || {
        app.changes.claims.track();
        each(app.read(|play| play.claims().list(play.basis())).into_iter().enumerate(), move |(check, claims)| {
            group(app, check, claims, drawn)
        })
    };
    let state = move || {
        app.changes.claims.track();
        summary_of(app)
    };
    let run = button()
        .class("quiet")
        .id("run-checks")
        .when(events::click, move |_| app.act(|play| play.change_claims(|claims, _| claims.begin())));
    details()
        .class("card fold checks")
        .id("checks")
        .child(summary().child(h3().child(words.checks)))
        .child(note(words.checks_intro))
        .child(
            p().class("setup")
                .child(run.child(words.run_checks))
                .child(" ")
                .child(span().role("status").child(text(state))),
        )
        .child(div().child(changing(listed)))
        .into()
}

/// Summary of the results.
fn summary_of(app: App) -> String {
    let words = app.words();
    let claims = app
        .read(|play| play.claims().list(play.basis()).into_iter().flat_map(|claims| claims.claims).collect::<Vec<_>>());
    let count = |holds: Option<bool>| claims.iter().filter(|claim| claim.holds == holds).count();
    if app.read(|play| play.claims().is_judging(play.basis())) {
        return words.checks_running.to_owned();
    }
    match (count(None), count(Some(false))) {
        (0, 0) => format!("{} ({})", words.checks_hold, claims.len()),
        (0, failed) => format!("{} {failed}/{}", words.checks_fail, claims.len()),
        _ => String::new(),
    }
}

fn group(app: App, check: usize, claims: ClaimsView, drawn: Signal<Option<(usize, usize)>>) -> View {
    let words = app.words();
    let head = (!claims.setup.is_empty())
        .then(|| p().class("setup").child(words.checks_with).child(" ").child(supposed(claims.setup)));
    div()
        .maybe(head)
        .child(
            ul().each(claims.claims.into_iter().enumerate(), |(number, claim)| {
                item(app, (check, number), claim, drawn)
            }),
        )
        .into()
}

fn item(app: App, place: (usize, usize), claim: ClaimView, drawn: Signal<Option<(usize, usize)>>) -> HtmlLi {
    let words = app.words();
    // Screen readers read a word instead of the mark.
    let (mark, spoken) = match claim.holds {
        None => ("·", words.check_open),
        Some(true) => ("✓", words.check_holds),
        Some(false) => ("✗", words.check_fails),
    };
    let state = match claim.holds {
        None => "open",
        Some(true) => "holds",
        Some(false) => "fails",
    };
    li().attr("data-state", state)
        .child(span().class("mark").attr("aria-hidden", "true").child(mark))
        .child(span().class("visually-hidden").child(spoken).child(": "))
        .child(span().class("claim").child(claim.name).child(" ").child(code().child(claim.written)))
        .maybe((!claim.outcome.is_empty()).then(|| span().class("outcome").child(claim.outcome)))
        .maybe(claim.is_drawn.then(|| deviation(app, place, drawn)))
}

/// Button that shows the deviation of the present run from a claim, and its plot.
fn deviation(app: App, place: (usize, usize), drawn: Signal<Option<(usize, usize)>>) -> HtmlDiv {
    let words = app.words();
    let id = format!("deviation-{}-{}", place.0, place.1);
    let is_shown = move || drawn.get() == Some(place);
    let plot = move || {
        if !is_shown() {
            return View::new();
        }
        app.changes.values.track();
        let settings = Settings { width: 320.0, height: 170.0, font_size: 11.0, ..Settings::default() };
        match app.read(|play| deviation_svg(play.basis(), play.course(), place, &settings, theme::palette())) {
            Some(svg) => div().class("deviation-plot").inner_html(svg).into(),
            None => note(words.check_plot_waits).into(),
        }
    };
    let toggle = move |_| drawn.set(if drawn.get_untracked() == Some(place) { None } else { Some(place) });
    let title = move || if is_shown() { words.check_plot_hide } else { words.check_plot_show }.to_owned();
    div()
        .class("deviation")
        .child(
            button()
                .class("quiet")
                .id(id.clone())
                .attr("aria-expanded", move || is_shown().to_string())
                .attr("aria-controls", format!("{id}-plot"))
                .when(events::click, toggle)
                .child(text(title)),
        )
        .child(div().id(format!("{id}-plot")).child(changing(plot)))
}

//! Comparison of the tracks with the truth of a filmed simulation, shown on demand.

use crate::app::App;
use crate::film::words;
use desk::TruthComparison;
use sycamore_web::SvgGlobalAttributes;
use units::number::plain;
use view::views::*;

/// Button, then numbers and differences over time; empty for other films.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let filmed = memo(move || app.films.now.with(|now| now.as_ref().is_some_and(|now| now.filmed)));
    let asked = memo(move || app.films.truth.with(|truth| !truth.is_empty()));
    let compare = move |_| {
        app.films.truth.set(app.read_desk(|desk| desk.films().compare_with_truth()));
        view::browser::focus_later("film-truth".to_owned());
    };
    changing(move || match (filmed.get(), asked.get()) {
        (false, _) => View::new(),
        (true, false) => {
            button().class("quiet").id("compare-truth").when(events::click, compare).child(words.compare_truth).into()
        }
        (true, true) => result(app),
    })
}

fn result(app: App) -> View {
    let all = app.films.truth.get_clone();
    let count = all.len();
    let one = |(number, one): (usize, TruthComparison)| {
        let plot = plot(app, &one);
        View::from((each(lines(app, &one, (count > 1).then_some(number + 1)), |line| p().child(line)), plot))
    };
    div().class("film-truth").id("film-truth").tabindex("-1").child(each(all.into_iter().enumerate(), one)).into()
}

fn lines(app: App, one: &TruthComparison, number: Option<usize>) -> Vec<String> {
    let words = words::of(app);
    let style = app.language.get_untracked().style();
    let metres = one.metres.map(|metres| {
        let (value, unit) = if metres < 1e-3 { (1e6 * metres, "µm") } else { (1e3 * metres, "mm") };
        let (value, unit) = if metres < 1.0 { (value, unit) } else { (metres, "m") };
        format!(" ({} {unit})", plain(value, 2, style))
    });
    let number = number.map(|number| format!(" {number}")).unwrap_or_default();
    let rms = plain(one.rms, 2, style);
    let mut lines = vec![format!("{}{number}: {} {rms} px{}", words.truth, words.rms, metres.unwrap_or_default())];
    lines.extend(one.scale_error.map(|error| {
        let sign = if error < 0.0 { "−" } else { "+" };
        format!("{}: {sign}{} %", words.truth_scale, plain(100.0 * error.abs(), 2, style))
    }));
    lines
}

/// Differences over time, px: to the right and down for a body, along the tube for a surface.
fn plot(app: App, one: &TruthComparison) -> View {
    let words = words::of(app);
    let style = app.language.get_untracked().style();
    let reach = one.differences.iter().flat_map(|(_, both)| both).fold(0.05_f64, |most, one| most.max(one.abs()));
    let ends = one.differences.first().zip(one.differences.last()).map(|((first, _), (last, _))| [*first, *last]);
    let Some([first, last]) = ends else { return View::new() };
    let across = |frame: usize| 300.0 * (frame - first) as f64 / (last - first).max(1) as f64;
    let curve = |k: usize| {
        let points = one.differences.iter().map(|(frame, both)| {
            format!("{:.2} {:.2}", across(*frame), 40.0 - 38.0 * both.get(k).copied().unwrap_or_default() / reach)
        });
        format!("M{}", points.collect::<Vec<_>>().join("L"))
    };
    let is_body = one.differences.iter().any(|(_, [_, second])| *second != 0.0);
    let second = is_body.then(|| path().class("second").d(curve(1)));
    let picture = svg()
        .viewBox("0 0 300 80")
        .attr("preserveAspectRatio", "none")
        .attr("aria-hidden", "true")
        .child(path().class("zero").d("M0 40H300"))
        .child(path().class("first").d(curve(0)))
        .maybe(second);
    let range = format!("± {} px", plain(reach, 2, style));
    let legend = if is_body { words.truth_legend_body } else { words.truth_legend };
    figure()
        .class("truth-plot")
        .child(div().child(picture))
        .child(figcaption().class("note").child(format!("{legend}, {range}")))
        .into()
}

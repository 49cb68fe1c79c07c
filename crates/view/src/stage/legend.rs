//! Legend in the title line of a plot.

use crate::app::App;
use crate::pieces::symbols::with_indices;
use crate::views::*;
use figure::{Dash, Style};
use play::{LegendEntry, PlotId};
use sycamore_web::SvgGlobalAttributes;

/// Legend of a plot; empty if there is only one series.
pub fn view(app: App, id: PlotId) -> View {
    let entries = memo(move || {
        app.changes.runs.track();
        app.changes.parameters.track();
        app.changes.plots.track();
        app.read(|play| play.plots().legend(id))
    });
    changing(move || {
        let entries = entries.get_clone();
        let is_run = |entry: &LegendEntry| matches!(entry.style, Style::Faded(_));
        if entries.is_empty() {
            return View::new();
        }
        let item = |entry: LegendEntry| {
            let class = is_run(&entry).then_some("of-run");
            li().class(class).title(entry.label.clone()).child(sample(entry.style, entry.colour)).child(name(&entry))
        };
        ul().class("legend").attr("aria-label", app.words().legend).each(entries, item).into()
    })
}

/// Label of an entry. The name of a run, and that of a record in parentheses, come from the user: an underscore in them
/// is not an index.
fn name(entry: &LegendEntry) -> HtmlSpan {
    let of_model = match entry.style {
        Style::Faded(_) => 0,
        Style::Points | Style::Unused => entry.label.find(" (").unwrap_or(entry.label.len()),
        _ => entry.label.len(),
    };
    let (of_model, own) = entry.label.split_at(of_model);
    with_indices(of_model).child(own.to_owned())
}

/// Sample of a line or a point in its colour and style.
pub fn sample(style: Style, colour: u8) -> SvgSvg {
    let ink = match style {
        Style::Faded(_) => format!("color:var(--faded-{})", usize::from(colour) % figure::SERIES_COLOURS),
        _ => format!("color:var(--series-{})", usize::from(colour) % figure::SERIES_COLOURS),
    };
    let drawing = svg()
        .class(if matches!(style, Style::Ghost | Style::Unused) { "sample faint" } else { "sample" })
        .viewBox("0 0 24 8")
        .width("24")
        .height("8")
        .attr("aria-hidden", "true")
        .style(ink);
    let dash = match style {
        Style::Kept(pattern) | Style::Faded(pattern) => Dash::Pattern(pattern),
        _ => Dash::Solid,
    };
    let dashes: Vec<String> = dash.lengths().iter().map(f32::to_string).collect();
    match style {
        Style::Points | Style::Unused | Style::Dots => drawing.child(tags::path().class("point").d("M12 4h0")),
        _ => drawing.child(tags::path().d("M0 4h24").attr("stroke-dasharray", dashes.join(" "))),
    }
}

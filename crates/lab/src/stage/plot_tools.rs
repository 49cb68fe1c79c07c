//! A plot's toolbar: zoom, and a menu with what is saved of it and the full screen.

use super::{canvas, full_screen};
use crate::app::App;
use crate::theme::Colours;
use crate::views::*;
use crate::{browser, icons};
use figure::Settings;
use wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, Element, FocusEvent, HtmlCanvasElement, KeyboardEvent, Node};

/// The size of a downloaded figure, in CSS pixels.
const SAVED: Settings = Settings { width: 960.0, height: 540.0, font_size: 16.0, decimal_comma: false };
/// How many pixels of a downloaded PNG make one of those.
const SAVED_SCALE: f64 = 2.0;

/// The toolbar of the plot that `figure` shows.
pub fn view(app: App, index: usize, figure: Element) -> HtmlDiv {
    let words = app.words();
    let automatic = move || super::plots::now(app, index).is_none_or(|plot| plot.automatic);
    let zoom = move |factor: f64| app.act(|session| session.zoom_plot(index, None, factor, figure::Direction::Both));
    let tool = |name: &'static str| button().class("icon").called(name);
    let open = create_signal(false);
    let id = format!("plot-menu-{index}");
    let more = tool(words.plot_menu)
        .id(format!("plot-more-{index}"))
        .attr("aria-expanded", move || open.get().to_string())
        .attr("aria-controls", id.clone())
        .when(events::click, move |_| open.update(|open| *open = !*open))
        .child(icons::more());
    let mut tools = div().class("tools");
    let node: Node = tools.node();
    // The menu closes when the focus leaves the toolbar.
    let left = move |event: FocusEvent| {
        let to = event.related_target().and_then(|to| to.dyn_into::<Node>().ok());
        if !node.contains(to.as_ref()) {
            open.set(false);
        }
    };
    let escape = move |event: KeyboardEvent| {
        if event.key() == "Escape" && open.get_untracked() {
            open.set(false);
            browser::focus(&format!("plot-more-{index}"));
        }
    };
    tools
        .when(events::focusout, left)
        .when(events::keydown, escape)
        .child(tool(words.zoom_out).when(events::click, move |_| zoom(0.5)).child(icons::minus()))
        .child(tool(words.zoom_in).when(events::click, move |_| zoom(2.0)).child(icons::plus()))
        .child(
            tool(words.fit)
                .attr("aria-disabled", move || automatic().to_string())
                .when(events::click, move |_| app.act(|session| session.reset_plot(index)))
                .child(icons::fit()),
        )
        .child(more)
        .child(menu(app, index, id, open, figure))
}

fn menu(app: App, index: usize, id: String, open: Signal<bool>, figure: Element) -> HtmlDiv {
    let words = app.words();
    let item = |name: &'static str, label: &'static str, save: fn(App, usize)| {
        let save = move |_| {
            save(app, index);
            open.set(false);
            browser::focus(&format!("plot-more-{index}"));
        };
        button().class("text").called(name).when(events::click, save).child(label)
    };
    let full = full_screen::is_offered().then(|| {
        let fill = move |_| {
            open.set(false);
            full_screen::toggle(&figure);
        };
        button().class("icon").called(words.full_screen).when(events::click, fill).child(icons::full_screen())
    });
    div()
        .class("menu")
        .id(id)
        .role("group")
        .attr("aria-label", words.plot_menu)
        .hidden(move || !open.get())
        .child(item(words.save_svg, "SVG", save_svg))
        .child(item(words.save_png, "PNG", save_png))
        .child(item(words.save_plot_csv, "CSV", save_csv))
        .maybe(full)
}

fn saved(app: App) -> Settings {
    Settings { decimal_comma: app.language.get_untracked().style().decimal_comma, ..SAVED }
}

/// `Phase portrait` as `phase-portrait`.
fn file_name(app: App, index: usize, ending: &str) -> String {
    let title = super::plots::now(app, index).map(|plot| plot.title).unwrap_or_default();
    let words: Vec<String> =
        title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase).collect();
    format!("{}.{ending}", words.join("-"))
}

fn save_svg(app: App, index: usize) {
    let settings = saved(app);
    // On paper, whatever the theme of the screen is.
    let svg = app.read(|session| session.plot_svg(index, &settings, &figure::Palette::LIGHT));
    browser::save_text(&file_name(app, index, "svg"), "image/svg+xml", &svg);
}

fn save_csv(app: App, index: usize) {
    let csv = app.read(|session| session.plot_csv(index));
    browser::save_text(&file_name(app, index, "csv"), "text/csv", &csv);
}

fn save_png(app: App, index: usize) {
    let settings = saved(app);
    let Some(canvas) =
        document().create_element("canvas").ok().and_then(|node| node.dyn_into::<HtmlCanvasElement>().ok())
    else {
        return;
    };
    canvas.set_width((settings.width * SAVED_SCALE) as u32);
    canvas.set_height((settings.height * SAVED_SCALE) as u32);
    let context: Option<CanvasRenderingContext2d> =
        canvas.get_context("2d").ok().flatten().and_then(|context| context.dyn_into().ok());
    let Some(context) = context else { return };
    if let Some(figure) = app.read(|session| session.titled_figure(index, &settings)) {
        canvas::paint(&context, &figure, &Colours::default(), SAVED_SCALE);
    }
    let url = canvas.to_data_url_with_type("image/png").unwrap_or_default();
    browser::save_url(&file_name(app, index, "png"), &url);
}

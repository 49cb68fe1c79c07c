//! Toolbar of a plot: a menu with zoom, downloads and full screen.

use super::{canvas, full_screen};
use crate::app::App;
use crate::pieces::colours::Colours;
use crate::views::*;
use crate::{browser, pieces::icons};
use figure::Settings;
use play::PlotId;
use wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, Element, FocusEvent, HtmlCanvasElement, KeyboardEvent, Node};

/// Size of a downloaded figure, in CSS pixels.
const SAVED: Settings = Settings { width: 960.0, height: 540.0, font_size: 16.0, decimal_comma: false, level: None };
/// Pixels of a downloaded PNG per CSS pixel.
const SAVED_SCALE: f64 = 2.0;

/// Toolbar of the plot shown by the element `figure`.
pub fn view(app: App, id: PlotId, figure: Element) -> HtmlDiv {
    let words = app.words();
    let open = create_signal(false);
    let menu_id = format!("plot-menu-{id}");
    let more = button()
        .class("icon")
        .called(words.plot_menu)
        .id(format!("plot-more-{id}"))
        .attr("aria-expanded", move || open.get().to_string())
        .attr("aria-controls", menu_id.clone())
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
            browser::focus(&format!("plot-more-{id}"));
        }
    };
    tools
        .when(events::focusout, left)
        .when(events::keydown, escape)
        .child(more)
        .child(menu(app, id, menu_id, open, figure))
}

fn menu(app: App, id: PlotId, menu_id: String, open: Signal<bool>, figure: Element) -> HtmlDiv {
    let words = app.words();
    let item = |name: &'static str, label: &'static str, save: fn(App, PlotId)| {
        let save = move |_| {
            save(app, id);
            open.set(false);
            browser::focus(&format!("plot-more-{id}"));
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
    let automatic = move || app.plot(id).is_none_or(|plot| plot.automatic);
    let zoom = move |factor: f64| {
        app.act(|play| play.change_plots(|plots, _| plots.zoom(id, None, factor, figure::Direction::Both)))
    };
    let tool = |name: &'static str| button().class("icon").called(name);
    let fit = tool(words.fit)
        .attr("aria-disabled", move || automatic().to_string())
        .when(events::click, move |_| app.act(|play| play.change_plots(|plots, _| plots.reset(id))))
        .child(icons::fit());
    div()
        .class("menu")
        .id(menu_id)
        .role("group")
        .attr("aria-label", words.plot_menu)
        .hidden(move || !open.get())
        .child(tool(words.zoom_out).when(events::click, move |_| zoom(0.5)).child(icons::minus()))
        .child(tool(words.zoom_in).when(events::click, move |_| zoom(2.0)).child(icons::plus()))
        .child(fit)
        .child(item(words.save_svg, "SVG", save_svg))
        .child(item(words.save_png, "PNG", save_png))
        .child(item(words.save_plot_csv, "CSV", save_csv))
        .maybe(full)
}

fn saved(app: App) -> Settings {
    Settings { decimal_comma: app.language.get_untracked().style().decimal_comma, ..SAVED }
}

/// File name from the title of a plot: `phase-portrait` for `Phase portrait`.
fn file_name(app: App, id: PlotId, ending: &str) -> String {
    let title = app.plot(id).map(|plot| plot.title).unwrap_or_default();
    let title = String::from(js_sys::JsString::from(title).to_lower_case());
    let words: Vec<&str> = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    format!("{}.{ending}", words.join("-"))
}

fn save_svg(app: App, id: PlotId) {
    let settings = saved(app);
    // Colours for paper, independent of the theme of the screen.
    let svg = app.read(|play| play.plots_to_front().svg(id, &settings, &figure::Palette::LIGHT));
    browser::save_text(&file_name(app, id, "svg"), "image/svg+xml", &svg);
}

fn save_csv(app: App, id: PlotId) {
    let csv = app.read(|play| play.plots_to_front().csv(id));
    browser::save_text(&file_name(app, id, "csv"), "text/csv", &csv);
}

fn save_png(app: App, id: PlotId) {
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
    if let Some(figure) = app.read(|play| play.plots_to_front().titled(id, &settings)) {
        canvas::paint(&context, &figure, &Colours::default(), SAVED_SCALE);
    }
    let url = canvas.to_data_url_with_type("image/png").unwrap_or_default();
    browser::save_url(&file_name(app, id, "png"), &url);
}

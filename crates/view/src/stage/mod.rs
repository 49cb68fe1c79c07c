//! The stage: scene, plots and transport, always in sight.
//!
//! `narrow.rs` says which windows have room for one plot only; the layouts are in `crates/view/page/*.css`. The aspect of the
//! scene's view box decides whether it stands above or beside the plots.

pub mod brush;
pub mod canvas;
pub mod full_screen;
mod gesture;
mod gestures;
pub(crate) mod invitation;
mod legend;
pub(crate) mod level;
mod narrow;
mod pinned;
pub mod pins;
pub mod plot;
mod plot_tools;
pub mod plots;
pub mod ruler;
mod runs;
pub(crate) mod sound;
mod stopwatch;
pub(crate) mod tiles;
pub(crate) mod transport;

pub use narrow::NARROW;

use crate::app::App;
use crate::pieces::icons;
use crate::pieces::toolbar::Toolbar;
use crate::scene::SceneNodes;
use crate::views::*;
use play::PagePart;
use sycamore_reactive::untrack;

/// The stage, rebuilt for another program.
pub fn view(app: App) -> View {
    changing(move || {
        app.changes.program.track();
        untrack(|| stage(app))
    })
}

fn stage(app: App) -> HtmlSection {
    let words = app.words();
    let [picture, frames] = app.host().picture();
    let (aspect, extent) = shape(app);
    let body = div()
        .class(match aspect {
            aspect if aspect > WIDE => "stage-body wide",
            aspect if aspect < SLIM && app.read(|play| play.grips().level().is_some()) => "stage-body slim",
            _ => "stage-body",
        })
        .style(format!("--aspect:{aspect:.3};{extent}"))
        .child(picture)
        .child(scene(app))
        .child(plots::view(app))
        .child(level::view(app));
    section()
        .class("stage")
        .id("apparatus")
        .tabindex("-1")
        .attr("aria-label", words.apparatus)
        // First for the keyboard, drawn below the scene.
        .child(transport::view(app))
        .child(frames)
        .child(body)
        .child(app.host().strip())
}

/// Aspect (width / height) from which a scene is laid out above the plots instead of beside them.
const WIDE: f64 = 1.15;

/// Aspect (width / height) below which a scene that is a scale of its plot has room beside it on a phone, too.
const SLIM: f64 = 0.75;

/// Aspect (width / height) of the scene's view box, 1 without a fixed one; and its width and height as properties for the
/// styles, which keep the texts of the drawing as large as those of the page.
fn shape(app: App) -> (f64, String) {
    let language = app.language.get_untracked().tag();
    let size = app.read(|play| play.program().scene(language).and_then(program::Scene::size));
    size.map_or((1.0, String::new()), |[width, height]| {
        (width / height, format!("--scene-width:{width}px;--scene-height:{height}px"))
    })
}

fn scene(app: App) -> HtmlSection {
    let words = app.words();
    let mut place = div().class("drawing");
    let language = app.language.get_untracked().tag();
    let scene = app.read(|play| play.program().scene(language).cloned());
    let embedding = app.host().embedding();
    let (exists, has_handle) = (scene.is_some(), scene.as_ref().is_some_and(|scene| has_handle(&scene.root)));
    let draggable = has_handle && !embedding.locked;
    if let Some(scene) = &scene {
        let drawn = SceneNodes::build(app, scene, &place.node(), words.scene);
        app.nodes(|nodes| nodes.scene = drawn);
        app.wake();
    }
    part("scene", "scene card", words.scene)
        .hidden(embedding.hides(PagePart::Scene))
        .child(place)
        .child(instruments(app, exists))
        .child(changing(move || outline_legend(app)))
        .maybe(draggable.then(|| drag_hint(app)))
        .maybe((!exists).then(|| note(words.no_scene).class("no-scene")))
}

/// Instruments on the scene, and the buttons that show them.
fn instruments(app: App, has_scene: bool) -> HtmlDiv {
    let words = app.words();
    let (watch, rules) = (create_signal(false), create_signal(false));
    let measurable = has_scene && app.read(|play| play.grips().length(1.0)).is_some();
    let lay = move |_| {
        let laid = !rules.get_untracked();
        app.nodes(|nodes| {
            if let Some(scene) = &mut nodes.scene {
                scene.ruler = None;
            }
        });
        let root = app.nodes(|nodes| nodes.scene.as_ref().map(SceneNodes::root)).flatten();
        let ruler = root.filter(|_| laid).and_then(|root| ruler::lay(app, &root));
        rules.set(ruler.is_some());
        app.nodes(|nodes| {
            if let Some(scene) = &mut nodes.scene {
                scene.ruler = ruler;
            }
        });
    };
    let bar = Toolbar::new();
    let tool = |place: usize, id: &'static str, name: &'static str, on: Signal<bool>| {
        let tool = button().class("icon").id(id).called(name).attr("aria-pressed", move || on.get().to_string());
        tool.tabindex(move || bar.stop(place)).when(events::focus, move |_| bar.enter(place))
    };
    let take = move |_| watch.update(|shown| *shown = !*shown);
    div()
        .class("instruments")
        .role("toolbar")
        .attr("aria-label", words.instruments)
        .when(events::keydown, Toolbar::turn)
        .child(tool(0, "stopwatch", words.stopwatch, watch).when(events::click, take).child(icons::stopwatch()))
        .maybe(measurable.then(|| tool(1, "ruler", words.ruler, rules).when(events::click, lay).child(icons::ruler())))
        .child(changing(move || if watch.get() { stopwatch::view(app).into() } else { View::new() }))
}

/// Legend of the dashed outline in the scene; empty without outline.
fn outline_legend(app: App) -> View {
    app.changes.plots.track();
    let records = app.read(|play| play.values().outline().map_or_else(Vec::new, |outline| outline.sources.clone()));
    if records.is_empty() {
        return View::new();
    }
    let sample = span().class("outline-sample").attr("aria-hidden", "true");
    p().class("note scene-legend")
        .child(sample)
        .child(format!("{}: {}", app.words().outline, records.join(", ")))
        .into()
}

/// Instructions for dragging that suit the device: keys are mentioned only if there is a keyboard.
fn drag_hint(app: App) -> HtmlP {
    let words = app.words();
    let keys = span().class("for-keys").child(words.drag_hint);
    note(keys).child(span().class("for-touch").child(words.drag_hint_touch))
}

fn has_handle(element: &program::Element) -> bool {
    element.drag.is_some()
        || element.children.iter().any(|child| matches!(child, program::Child::Element(child) if has_handle(child)))
}

//! Opening of the laboratory. Its page begins with the player; then the laboratory takes over the running simulation
//! ([`Handed`]). Each module has a memory of its own, so that everything passes through an object of the page's script
//! (`crates/lab/page/opening.js`).

use crate::app::App;
use crate::page::message::Message;
use crate::stage::pins;
use crate::views::*;
use crate::{browser, panel::tabs};
use figure::{Point, Readout, Sample};
use js_sys::{Function, Promise, Reflect, Uint8Array};
use play::{Passed, Play, PlotId};
use serde::{Deserialize, Serialize};
use units::Language;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlElement;

/// Object of the page's script between the two modules.
pub struct Opening(JsValue);

impl Opening {
    /// The object of this page; `None` in a page without a laboratory.
    pub fn of_page() -> Option<Self> {
        let object = Reflect::get(&js_sys::global(), &"opening".into()).ok()?;
        object.is_object().then_some(Self(object))
    }

    /// File name of the document with which the page opens.
    pub fn name(&self) -> String {
        self.field("name").as_string().unwrap_or_default()
    }

    /// State in the address, to be restored; empty if there is none.
    pub fn state(&self) -> String {
        self.field("state").as_string().unwrap_or_default()
    }

    /// Asks for the laboratory. `pressed`: id of an element of its header to be pressed then; may be empty.
    pub fn ask(&self, pressed: &str) {
        if let Ok(ask) = self.field("ask").dyn_into::<Function>() {
            let _ = ask.call1(&self.0, &pressed.into());
        }
    }

    /// Sets the function that hands over the simulation and ends the player; `None` if the page shows none.
    pub fn offer(&self, give: Option<impl FnOnce() -> Handed + 'static>) {
        let packed = |handed: Handed| Uint8Array::from(postcard::to_allocvec(&handed).unwrap_or_default().as_slice());
        let give = give.map_or(JsValue::UNDEFINED, |give| Closure::once_into_js(move || packed(give())));
        if let Ok(offer) = self.field("offer").dyn_into::<Function>() {
            let _ = offer.call1(&self.0, &give);
        }
    }

    /// True if the player shows a simulation that the laboratory can take.
    pub fn is_offered(&self) -> bool {
        self.field("give").is_function()
    }

    /// The language in which the player shows its simulation.
    pub fn language(&self) -> Language {
        let root = document().document_element();
        Language::of(&root.and_then(|root| root.get_attribute("lang")).unwrap_or_default())
    }

    /// Waits until the laboratory may do the next part of its work, or with `is_last` replace what the player shows. Nothing comes
    /// between the end of the wait and what follows.
    pub async fn turn(&self, is_last: bool) {
        let Ok(turn) = self.field("turn").dyn_into::<Function>() else { return };
        if let Some(turn) = turn.call1(&self.0, &is_last.into()).ok().and_then(|turn| turn.dyn_into().ok()) {
            let _ = browser::wait(turn).await;
        }
    }

    /// Takes the simulation from the player; `None` if no player shows one.
    pub fn take(&self) -> Option<Handed> {
        let give: Function = self.field("give").dyn_into().ok()?;
        let bytes: Uint8Array = give.call0(&self.0).ok()?.dyn_into().ok()?;
        let handed: Handed = postcard::from_bytes(&bytes.to_vec()).ok()?;
        Some(Handed { pressed: self.field("pressed").as_string().unwrap_or_default(), ..handed })
    }

    /// Packed bytes of a part of the page.
    pub fn bytes(&self, id: &str) -> Option<Promise> {
        let bytes: Function = self.field("bytes").dyn_into().ok()?;
        bytes.call1(&self.0, &id.into()).ok()?.dyn_into().ok()
    }

    /// Text of a part of the player, as it stands in a page: its module, or the texts of a language.
    pub fn part(&self, id: &str) -> Option<Promise> {
        let part: Function = self.field("part").dyn_into().ok()?;
        part.call1(&self.0, &id.into()).ok()?.dyn_into().ok()
    }

    fn field(&self, name: &str) -> JsValue {
        Reflect::get(&self.0, &name.into()).unwrap_or(JsValue::UNDEFINED)
    }
}

/// Everything that a person has changed in the player, and what is in sight.
#[derive(Serialize, Deserialize)]
pub struct Handed {
    run: Option<Passed>,
    /// Time of the last frame, in milliseconds; `None` while the run is paused.
    moved: Option<f64>,
    /// Pinned read-outs with the place of their plot.
    pins: Vec<(usize, Pin)>,
    language: String,
    sound: bool,
    tab: String,
    everything: bool,
    more_open: bool,
    table_open: bool,
    numerics_open: bool,
    front_plot: Option<usize>,
    errors: Vec<String>,
    /// Id of the focused element.
    focus: String,
    /// Vertical scroll position, in CSS pixels.
    scroll: f64,
    /// Id of the element of the header that was pressed in order to get the laboratory.
    pressed: String,
}

/// A pinned read-out: its heading and samples.
type Pin = (String, Vec<(usize, usize, usize, [f64; 2], [f32; 2], String)>);

impl Handed {
    /// Takes everything from the views of the player.
    pub fn of(app: App) -> Self {
        let (moved, sound) = app.nodes(|nodes| (nodes.moved(), nodes.sound.is_on())).unwrap_or_default();
        let pins = pins::all(app).into_iter().map(|(place, readout)| (place, pin_of(readout))).collect();
        let errors = app.messages.get_clone_untracked().into_iter().filter(|message| message.is_error);
        Self {
            run: app.read(|play| Some(play.pass_on())),
            moved,
            pins,
            language: app.language.get_untracked().tag().to_owned(),
            sound,
            tab: app.tab.get_untracked().to_owned(),
            everything: app.everything.get_untracked(),
            more_open: app.more_open.get_untracked(),
            table_open: app.table_open.get_untracked(),
            numerics_open: app.numerics_open.get_untracked(),
            front_plot: app.front_plot.get_untracked().map(PlotId::place),
            errors: errors.map(|message| message.text).collect(),
            focus: browser::focused(),
            scroll: browser::scrolled(),
            pressed: String::new(),
        }
    }

    /// Language of the player.
    pub fn language(&self) -> Language {
        Language::of(&self.language)
    }

    /// Continues the simulation.
    pub fn continue_in(&mut self, play: &mut Play) {
        if let Some(run) = self.run.take() {
            play.take_over(run);
        }
    }

    /// Sets what the views show.
    pub fn prepare(&self, app: App) {
        app.tab.set(find_tab(&self.tab).unwrap_or(tabs::EXPLORE));
        app.everything.set(self.everything);
        app.more_open.set(self.more_open);
        app.table_open.set(self.table_open);
        app.numerics_open.set(self.numerics_open);
        app.front_plot.set(self.front_plot.map(PlotId::at));
        app.messages.set(self.errors.iter().cloned().map(Message::error).collect());
        app.nodes(|nodes| {
            nodes.go_on_from(self.moved);
            if self.sound {
                nodes.sound.turn(true);
            }
        });
    }

    /// Sets what needs the views: pins, focus and scroll position. Then presses the element that was pressed before.
    pub fn finish(self, app: App) {
        for (place, pin) in self.pins {
            pins::put_back(app, PlotId::at(place), readout_of(pin));
        }
        browser::focus_in_place(&self.focus);
        browser::scroll_to(self.scroll);
        if let Some(pressed) = browser::by_id::<HtmlElement>(&self.pressed) {
            pressed.click();
        }
    }
}

fn pin_of(readout: Readout) -> Pin {
    let samples = readout.samples.into_iter();
    let sample = |one: Sample| (one.series, one.row, one.axis, [one.x, one.y], [one.at.x, one.at.y], one.text);
    (readout.heading, samples.map(sample).collect())
}

fn readout_of((heading, samples): Pin) -> Readout {
    let samples = samples.into_iter().map(|(series, row, axis, [x, y], [right, down], text)| Sample {
        series,
        row,
        axis,
        x,
        y,
        at: Point { x: right, y: down },
        text,
    });
    Readout { heading, samples: samples.collect() }
}

/// Ends the views of the player: listeners and frames. Its nodes are removed afterwards.
pub fn end(app: App) {
    // While its listeners are still there.
    if let Some(focused) = document().active_element().and_then(|element| element.dyn_into::<HtmlElement>().ok()) {
        let _ = focused.blur();
    }
    browser::end_listening();
    app.nodes(|nodes| nodes.end());
}

/// Storage key of the tab shown last.
const SHOWN: &str = "tab";

/// Restores the tab of the laboratory that was shown before a reload, unless it is hidden now, and stores the present one from now on.
pub fn keep_tab(app: App) {
    let is_offered = |tab: &&str| app.everything.get_untracked() || ![tabs::WRITE, tabs::CLASS].contains(tab);
    if let Some(tab) = browser::remembered_in_tab(SHOWN).and_then(|shown| find_tab(&shown)).filter(is_offered) {
        app.tab.set(tab);
    }
    effect(move || browser::remember_in_tab(SHOWN, app.tab.get()));
}

/// The tab with this id.
fn find_tab(id: &str) -> Option<&'static str> {
    [tabs::EXPLORE, tabs::QUESTIONS, tabs::MEASURE, tabs::THEORY, tabs::WRITE, tabs::CLASS]
        .into_iter()
        .find(|tab| *tab == id)
}

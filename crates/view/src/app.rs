//! Handle shared by all views: access to the simulation, and signals for its changes.
//!
//! [`App::read`] and [`App::act`] reach the `Play`. [`App::act`] then compares revisions ([`App::publish`]), raises the
//! signals in `Changes`, and asks for a frame. Another document rebuilds the page (`App::rebuild`); another program while its
//! text is written rebuilds the stage and the tabs (`App::rebuild_program`), except a `Tab::lasting`, which holds the editor.
//! [`Host`] is what a page is around these views: where its `Play` is, what it brings up to the run before a drawing, what it
//! announces.

use crate::browser;
use crate::frame::Nodes;
use crate::page::{message::Message, texts};
use crate::panel::tabs;
use crate::stage;
use crate::stage::brush::Part;
use crate::views::*;
use crate::words::{Words, words_in};
use play::{Announcement, Embedding, Play, PlotId, PlotView, Prominence, Refusal, Revision};
use std::cell::{Cell, RefCell};
use std::ops::Deref;
use sycamore_reactive::{NodeHandle, batch, use_current_scope};
use units::Language;

/// Maximum number of errors shown at once; the oldest are dropped.
const MOST_ERRORS: usize = 3;

/// Page around the views of a simulation.
pub trait Host {
    /// Calls `work` with the simulation, if one is open. Calls must not be nested.
    fn with_play(&self, work: &mut dyn FnMut(&mut Play));

    /// Updates the content beside the simulation before each drawing. Returns true if work remains.
    fn follow(&self) -> bool {
        false
    }

    /// Continues the runs of plots over a parameter. Returns true if work remains for the next frame.
    fn work_on_plots(&self) -> bool {
        let mut remains = false;
        self.with_play(&mut |play| remains = play.change_plots(|plots, run| plots.work(run)));
        remains
    }

    /// Returns the events since the last call. With `by_slider`, changes of parameter values are omitted, because the
    /// slider itself announces its value.
    fn news(&self, by_slider: bool) -> Vec<News> {
        let mut news = Vec::new();
        self.with_play(&mut |play| {
            while let Some(announcement) = play.take_announcement() {
                if !(by_slider && matches!(announcement, Announcement::ParameterSet(..))) {
                    news.push(News::of_play(play, &announcement));
                }
            }
        });
        news
    }

    /// Raises the counters of changes outside the simulation.
    fn raise(&self) {}

    /// Alternative content of the stage and its transport bar, which can replace scene and transport.
    fn picture(&self) -> [View; 2] {
        Default::default()
    }

    /// What stands under the plots, always in sight: the strip of the measurer.
    fn strip(&self) -> View {
        View::new()
    }

    /// Way on from the opening document, under its plots.
    fn door(&self) -> View {
        View::new()
    }

    /// Called when a time in a plot against time is pointed at. `_time` computes this time of the run (SI) on demand.
    fn look_at(&self, _time: &mut dyn FnMut() -> Option<f64>) {}

    /// True while a press on a measured point leaves its row out of fits or takes it back, instead of pinning the read-out.
    fn leaves_points_out(&self) -> bool {
        false
    }

    /// Leaves a measured point out of fits, or takes it back. `_column`: number of its column among all that are drawn;
    /// `_place`: index of the point among the values of the column.
    fn leave_out(&self, _column: usize, _place: usize) {}

    /// Selected part of the time axis, if the plots are to show it.
    fn part(&self) -> Option<Part> {
        None
    }

    /// Sets the selected part of the time axis.
    fn set_part(&self, _part: Part) {}

    /// Undoes the removal with this number. Returns true if it was the last one.
    fn undo(&self, number: u32) -> bool {
        let mut undone = false;
        self.with_play(&mut |play| undone = play.undo(number));
        undone
    }

    /// Restores the document texts stored under this name.
    fn restore(&self, _version: &str) {}

    /// Options in the address of the page: parts left out, locked controls.
    fn embedding(&self) -> Embedding {
        Embedding::default()
    }

    /// True if the seat is given by a course and cannot be chosen.
    fn has_fixed_seat(&self) -> bool {
        false
    }

    /// True if the page can rebuild the model with other sizes of families.
    fn can_resize(&self) -> bool {
        false
    }

    /// Sets a size of families. Returns the reason if it is refused.
    fn resize(&self, _name: &str, _value: u32) -> Option<String> {
        None
    }

    /// Sets the language of the whole page.
    fn set_language(&self, language: Language) {
        self.with_play(&mut |play| play.set_language(language.tag()));
    }

    /// Beginning of the ids of the elements with texts for the module of this page.
    fn texts(&self) -> &'static str {
        texts::PLAYER
    }

    /// Base name of saved files, without extension.
    fn stem(&self) -> String {
        "run".to_owned()
    }

    /// Additional buttons beside those that save the recorded run.
    fn save_buttons(&self) -> View {
        View::new()
    }

    /// Goes to the element with this id, wherever it is in the page.
    fn show(&self, place: &str) {
        browser::reveal_later(place.to_owned());
    }
}

/// An event to be announced.
#[derive(Clone)]
pub struct News {
    /// Text for screen readers.
    pub spoken: String,
    /// Message for the line of messages, if any.
    pub message: Option<Message>,
}

impl News {
    /// News for an announcement of the simulation.
    pub fn of_play(play: &Play, announcement: &Announcement) -> Self {
        let spoken = announcement.text(play.basis(), play.time_line());
        let undo = play.removals().number().filter(|_| announcement.can_be_undone());
        let message = Message::new(announcement.prominence(), &spoken);
        Self { message: message.map(|message| message.undone_by(undo)), spoken }
    }

    /// News with this text, shown according to `prominence`.
    pub fn new(spoken: String, prominence: Prominence) -> Self {
        Self { message: Message::new(prominence, &spoken), spoken }
    }
}

/// Change counters, tracked by views. Each is raised when its part of the simulation has changed.
#[derive(Clone, Copy)]
pub struct Changes {
    /// Another document, or another language.
    pub document: Signal<u64>,
    /// Program replaced, for instance while its text is edited.
    pub program: Signal<u64>,
    /// Parameters, presets, method and step.
    pub parameters: Signal<u64>,
    /// Status, speed and problem.
    pub transport: Signal<u64>,
    /// Kept runs.
    pub runs: Signal<u64>,
    /// Visibility and zoom of plots; content added to plots and scene.
    pub plots: Signal<u64>,
    /// Results of the author's claims.
    pub claims: Signal<u64>,
    /// Time shown. Raised in every frame in which it has changed, for values that must stay in step with the curves.
    pub frame: Signal<u64>,
    /// Time shown and rows recorded. Raised at most ten times a second while the run is playing.
    pub values: Signal<u64>,
}

/// Handle of a page; cheap to copy.
#[derive(Clone, Copy)]
pub struct App(&'static Page);

/// Data behind the handle.
pub struct Page {
    host: &'static dyn Host,
    nodes: RefCell<Nodes>,
    /// Reactive scope of signals that live as long as the page.
    scope: NodeHandle,
    /// Revision shown by the views.
    seen: Cell<Revision>,
    /// Frame counter of the values shown.
    seen_frame: Cell<u64>,
    /// Change counters.
    pub changes: Changes,
    /// The language of the interface.
    pub language: Signal<Language>,
    /// Content of the live region for screen readers.
    pub spoken: Signal<String>,
    /// Content of the line of messages.
    pub messages: Signal<Vec<Message>>,
    /// True while the browser prepares to print.
    pub printing: Signal<bool>,
    /// True if single-key shortcuts are enabled.
    pub single_keys: Signal<bool>,
    /// Id of the open tab of the panel.
    pub tab: Signal<&'static str>,
    /// True if the page shows also what teachers and authors need; see [`crate::page::everything`].
    pub everything: Signal<bool>,
    /// True if the table of recorded values is shown.
    pub table_open: Signal<bool>,
    /// True if the window has room for only one plot.
    pub narrow: Signal<bool>,
    /// The plot shown in a narrow window.
    pub front_plot: Signal<Option<PlotId>>,
    /// True if the parameters beyond the main ones, state, method and recorded values are shown.
    pub more_open: Signal<bool>,
    /// True while the projector's view is shown: the stage alone, with large letters.
    pub projecting: Signal<bool>,
    /// True if method and step are shown.
    pub numerics_open: Signal<bool>,
}

impl Deref for App {
    type Target = Page;

    fn deref(&self) -> &Page {
        self.0
    }
}

impl App {
    /// Creates the handle for a page around `host`, which lives as long as the page.
    pub fn new(host: &'static dyn Host, language: Language) -> Self {
        let counter = || create_signal(0);
        let page = Page {
            host,
            nodes: RefCell::default(),
            scope: use_current_scope(),
            seen: Cell::default(),
            seen_frame: Cell::default(),
            changes: Changes {
                document: counter(),
                program: counter(),
                parameters: counter(),
                transport: counter(),
                runs: counter(),
                plots: counter(),
                claims: counter(),
                frame: counter(),
                values: counter(),
            },
            language: create_signal(language),
            spoken: create_signal(String::new()),
            messages: create_signal(Vec::new()),
            printing: create_signal(false),
            single_keys: create_signal(browser::remembered("keys").is_none()),
            tab: create_signal(tabs::EXPLORE),
            everything: create_signal(true),
            table_open: create_signal(false),
            narrow: create_signal(browser::matches(stage::NARROW)),
            front_plot: create_signal(None),
            more_open: create_signal(false),
            projecting: create_signal(false),
            numerics_open: create_signal(false),
        };
        Self(Box::leak(Box::new(page)))
    }

    /// Texts of the interface. Not tracked: views with texts are rebuilt when the language changes.
    pub fn words(self) -> &'static Words {
        words_in(self.language.get_untracked())
    }

    /// The page around these views.
    pub fn host(self) -> &'static dyn Host {
        self.0.host
    }

    /// Calls `work` with the nodes that are redrawn in each frame. Calls must not be nested; returns `None` for a
    /// nested call.
    pub fn nodes<T>(self, work: impl FnOnce(&mut Nodes) -> T) -> Option<T> {
        self.0.nodes.try_borrow_mut().ok().map(|mut nodes| work(&mut nodes))
    }

    /// Requests a frame, once.
    pub fn wake(self) {
        self.nodes(Nodes::ask);
    }

    /// Reads from the simulation; returns the default if none is open.
    pub fn read<T: Default>(self, read: impl FnOnce(&mut Play) -> T) -> T {
        let (mut read, mut result) = (Some(read), None);
        self.host().with_play(&mut |play| result = read.take().map(|read| read(play)));
        result.unwrap_or_default()
    }

    /// Present state of a plot; tracks the visibility of plots.
    pub fn plot(self, id: PlotId) -> Option<PlotView> {
        self.changes.plots.track();
        self.read(|play| play.plots().list().into_iter().nth(id.place()))
    }

    /// Performs an action on the simulation, notifies the views and redraws.
    pub fn act<T: Default>(self, act: impl FnOnce(&mut Play) -> T) -> T {
        let result = self.read(act);
        self.acted(false);
        result
    }

    /// As [`App::act`], for a slider, which announces its value itself.
    pub fn slide(self, act: impl FnOnce(&mut Play)) {
        self.read(act);
        self.acted(true);
    }

    /// As [`App::act`], for actions that can be refused. Returns the text of the refusal.
    pub fn attempt(self, act: impl FnOnce(&mut Play) -> Result<(), Refusal>) -> Option<String> {
        self.act(|play| act(play).err().map(|refusal| play.basis().refusal_text(&refusal)))
    }

    /// Calls `work` in the scope of the page: what it creates lives as long as the page.
    pub fn within(self, work: impl FnOnce()) {
        self.scope.run_in(work);
    }

    /// Notifies the views of an action and redraws.
    pub fn acted(self, by_slider: bool) {
        self.publish(true, by_slider);
        self.wake();
    }

    /// Raises the counters of all changes and announces the events. `values`: true if changing values are to be updated
    /// now.
    pub fn publish(self, values: bool, by_slider: bool) {
        let Some(revision) = self.read(|play| Some(play.revision())) else { return };
        // Updates the clock at once instead of one frame later.
        self.nodes(|nodes| {
            if let Some(transport) = &mut nodes.transport
                && values
            {
                self.read(|play| transport.draw(play));
            }
        });
        let news = self.host().news(by_slider);
        let (before, mut now) = (self.seen.get(), revision);
        let moved = self.seen_frame.replace(now.frame) != now.frame;
        if !values {
            (now.frame, now.rows) = (before.frame, before.rows);
        }
        self.seen.set(now);
        let changes = self.changes;
        let raise = |(changed, counter): (bool, Signal<u64>)| {
            if changed {
                counter.update(|count| *count += 1);
            }
        };
        let changed = [
            (before.parameters != now.parameters, changes.parameters),
            (before.transport != now.transport, changes.transport),
            (before.runs != now.runs, changes.runs),
            (before.plots != now.plots, changes.plots),
            (before.claims != now.claims, changes.claims),
            (moved, changes.frame),
            ((before.frame, before.rows) != (now.frame, now.rows), changes.values),
        ];
        let focused = browser::focused();
        // Batched, so that a view that tracks several counters is rebuilt only once.
        self.scope.run_in(|| {
            batch(|| {
                changed.into_iter().for_each(raise);
                self.host().raise();
            });
        });
        // Restores the focus to an element that was rebuilt.
        if browser::focused() != focused {
            browser::focus(&focused);
        }
        let spoken: Vec<&str> = news.iter().map(|news| news.spoken.as_str()).collect();
        if !spoken.is_empty() {
            self.say(spoken.join(". "));
        }
        for message in news.into_iter().filter_map(|news| news.message) {
            self.show(message);
        }
    }

    /// Shows a message. It replaces the previous one, unless that is an error.
    fn show(self, message: Message) {
        self.messages.update(|messages| {
            messages.retain(|other| other.is_error && *other != message);
            if message.is_error && messages.len() >= MOST_ERRORS {
                messages.remove(0);
            }
            messages.push(message);
        });
    }

    /// Announces and shows a success.
    pub fn notify(self, words: &str) {
        self.report(Message::notice(words.to_owned()));
    }

    /// Announces and shows an error.
    pub fn complain(self, words: String) {
        self.report(Message::error(words));
    }

    /// Announces and shows a message.
    pub fn report(self, message: Message) {
        self.say(message.text.clone());
        self.show(message);
    }

    /// Announces a text to screen readers only. A repeated text is modified invisibly; otherwise it would not be read
    /// again.
    pub fn say(self, mut words: String) {
        if self.spoken.with_untracked(|spoken| *spoken == words) {
            words.push('\u{a0}');
        }
        self.spoken.set(words);
    }

    /// Rebuilds all views, for another document or language.
    pub fn rebuild(self) {
        self.changes.document.update(|count| *count += 1);
        self.acted(false);
    }

    /// Rebuilds the views of the program after it was replaced. Lasting parts, such as the text editor, stay.
    pub fn rebuild_program(self) {
        self.nodes(Nodes::clear);
        self.changes.program.update(|count| *count += 1);
        self.acted(false);
    }

    /// Sets the language of the whole page as soon as its texts are there, and then calls `then`.
    pub fn set_language(self, language: Language, then: impl FnOnce() + 'static) {
        texts::when_there(self.host().texts(), language, move || {
            self.host().set_language(language);
            self.language.set(language);
            browser::remember("language", language.tag());
            self.rebuild();
            then();
        });
    }
}

/// Title of the simulation; the name of the application if none is open.
pub fn title(app: App) -> String {
    let language = app.language.get_untracked().tag();
    app.read(|play| Some(play.program().edition(language).title.clone()))
        .filter(|title| !title.is_empty())
        .unwrap_or_else(|| "Meniscus".to_owned())
}

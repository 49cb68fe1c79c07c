//! The handle that every view holds: it leads to the simulation, and tells the views which part of it has changed.

use crate::browser;
use crate::frame::Nodes;
use crate::message::Message;
use crate::stage;
use crate::stage::brush::Part;
use crate::tabs;
use crate::views::*;
use crate::words::{Words, words_in};
use play::{Announcement, Embedding, Play, PlotId, PlotView, Prominence, Refusal, Revision};
use std::cell::{Cell, RefCell};
use std::ops::Deref;
use sycamore_reactive::{NodeHandle, batch, use_current_scope};
use units::Language;

/// More errors are not shown at once; the oldest go.
const MOST_ERRORS: usize = 3;

/// What a page is around the views of its simulation.
pub trait Host {
    /// Works on the simulation, if one is open. Must not be nested.
    fn with_play(&self, work: &mut dyn FnMut(&mut Play));

    /// Brings what is shown beside the simulation up to it, before each drawing. Whether there is more to come.
    fn follow(&self) -> bool {
        false
    }

    /// What has happened since this was asked last. Of a slider that is being moved, `by_slider`, the value is left out: the
    /// slider says it.
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

    /// Raises the counters of what has changed besides the simulation.
    fn raise(&self) {}

    /// Another picture on the stage, and the bar with its frames: what can stand in the place of scene and transport.
    fn picture(&self) -> [View; 2] {
        Default::default()
    }

    /// A time of the run (SI) is pointed at in a plot against time; it is found out only if it is asked for.
    fn look_at(&self, _time: &mut dyn FnMut() -> Option<f64>) {}

    /// The part of the time that something is limited to, if the plots are to show it.
    fn part(&self) -> Option<Part> {
        None
    }

    /// Limits it to another part.
    fn set_part(&self, _part: Part) {}

    /// Puts back what the removal of this number took away. Whether it was the last one.
    fn undo(&self, number: u32) -> bool {
        let mut undone = false;
        self.with_play(&mut |play| undone = play.undo(number));
        undone
    }

    /// Goes back to the texts of the document that are kept under this name.
    fn restore(&self, _version: &str) {}

    /// What of the page is left out or locked where it stands inside another page.
    fn embedding(&self) -> Embedding {
        Embedding::default()
    }

    /// Whether the page can build the model with other sizes of families.
    fn can_resize(&self) -> bool {
        false
    }

    /// Gives a size of families another value; why it cannot have it, in words.
    fn resize(&self, _name: &str, _value: u32) -> Option<String> {
        None
    }

    /// Chooses the language of everything.
    fn set_language(&self, language: Language) {
        self.with_play(&mut |play| play.set_language(language.tag()));
    }

    /// What files that are saved are called, without an ending.
    fn stem(&self) -> String {
        "run".to_owned()
    }

    /// Further buttons beside those that save the recorded run.
    fn save_buttons(&self) -> View {
        View::new()
    }

    /// Goes to the element of this id, wherever it is.
    fn show(&self, place: &str) {
        browser::reveal_later(place.to_owned());
    }
}

/// Something that has happened.
#[derive(Clone)]
pub struct News {
    /// What is spoken.
    pub spoken: String,
    /// What the line of messages shows, if anything.
    pub message: Option<Message>,
}

impl News {
    /// What is spoken and shown of an announcement of the simulation.
    pub fn of_play(play: &Play, announcement: &Announcement) -> Self {
        let spoken = play.announcement_text(announcement);
        let undo = play.undo_number().filter(|_| announcement.can_be_undone());
        let message = Message::new(announcement.prominence(), &spoken);
        Self { message: message.map(|message| message.undone_by(undo)), spoken }
    }

    /// What is spoken, and shown as prominently as this.
    pub fn new(spoken: String, prominence: Prominence) -> Self {
        Self { message: Message::new(prominence, &spoken), spoken }
    }
}

/// Counters that views track. Each is raised when that part of the simulation has changed.
#[derive(Clone, Copy)]
pub struct Changes {
    /// Another document, or the document in another language.
    pub document: Signal<u64>,
    /// Another program in the place of the present one, while its text is written.
    pub program: Signal<u64>,
    /// Parameters, presets, method and step.
    pub parameters: Signal<u64>,
    /// Status, speed and problem.
    pub transport: Signal<u64>,
    /// Kept runs.
    pub runs: Signal<u64>,
    /// Which plots are shown, and whether they show everything; what others draw into plots and scene.
    pub plots: Signal<u64>,
    /// What is known of the author's claims.
    pub checks: Signal<u64>,
    /// The time shown: raised in every frame in which it has changed, for what must not lag behind the curves.
    pub frame: Signal<u64>,
    /// The time shown and the rows recorded; raised at most ten times a second while the run is playing.
    pub values: Signal<u64>,
}

/// The handle; copied freely.
#[derive(Clone, Copy)]
pub struct App(&'static Page);

/// Everything that the handle leads to.
pub struct Page {
    host: &'static dyn Host,
    nodes: RefCell<Nodes>,
    /// Where signals live that live as long as the page.
    scope: NodeHandle,
    /// What the views have shown.
    seen: Cell<Revision>,
    /// The frame that the values have shown.
    seen_frame: Cell<u64>,
    /// What has changed.
    pub changes: Changes,
    /// The language of the interface.
    pub language: Signal<Language>,
    /// What the live region says.
    pub spoken: Signal<String>,
    /// What the line of messages shows.
    pub messages: Signal<Vec<Message>>,
    /// Whether the browser is about to print.
    pub printing: Signal<bool>,
    /// Whether single keys act.
    pub single_keys: Signal<bool>,
    /// The open tab of the panel, by its id.
    pub tab: Signal<&'static str>,
    /// Whether the table of the recorded values is shown.
    pub table_open: Signal<bool>,
    /// Whether the window has room for one plot only.
    pub narrow: Signal<bool>,
    /// The plot shown there.
    pub front_plot: Signal<Option<PlotId>>,
    /// Whether method and step are shown.
    pub numerics_open: Signal<bool>,
}

impl Deref for App {
    type Target = Page;

    fn deref(&self) -> &Page {
        self.0
    }
}

impl App {
    /// A page around `host`, for as long as it is open.
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
                checks: counter(),
                frame: counter(),
                values: counter(),
            },
            language: create_signal(language),
            spoken: create_signal(String::new()),
            messages: create_signal(Vec::new()),
            printing: create_signal(false),
            single_keys: create_signal(browser::remembered("keys").is_none()),
            tab: create_signal(tabs::PLAY),
            table_open: create_signal(false),
            narrow: create_signal(browser::matches(stage::NARROW)),
            front_plot: create_signal(None),
            numerics_open: create_signal(false),
        };
        Self(Box::leak(Box::new(page)))
    }

    /// The words of the interface, without tracking: whatever shows words is built again for another language.
    pub fn words(self) -> &'static Words {
        words_in(self.language.get_untracked())
    }

    /// What the page is around these views.
    pub fn host(self) -> &'static dyn Host {
        self.0.host
    }

    /// Works on the nodes that are redrawn in each frame. Must not be nested.
    pub fn nodes<T>(self, work: impl FnOnce(&mut Nodes) -> T) -> Option<T> {
        self.0.nodes.try_borrow_mut().ok().map(|mut nodes| work(&mut nodes))
    }

    /// Asks for a frame, once.
    pub fn wake(self) {
        self.nodes(Nodes::ask);
    }

    /// Reads something from the simulation; its default where none is open.
    pub fn read<T: Default>(self, read: impl FnOnce(&mut Play) -> T) -> T {
        let (mut read, mut result) = (Some(read), None);
        self.host().with_play(&mut |play| result = read.take().map(|read| read(play)));
        result.unwrap_or_default()
    }

    /// A plot as it is now; tracks which plots are shown.
    pub fn plot(self, id: PlotId) -> Option<PlotView> {
        self.changes.plots.track();
        self.read(|play| play.plots().into_iter().nth(id.place()))
    }

    /// Does something in the simulation, tells the views and draws.
    pub fn act<T: Default>(self, act: impl FnOnce(&mut Play) -> T) -> T {
        let result = self.read(act);
        self.acted(false);
        result
    }

    /// As [`App::act`], for a slider, which tells its value itself.
    pub fn slide(self, act: impl FnOnce(&mut Play)) {
        self.read(act);
        self.acted(true);
    }

    /// As [`App::act`], for what may be refused: the refusal in words.
    pub fn attempt(self, act: impl FnOnce(&mut Play) -> Result<(), Refusal>) -> Option<String> {
        self.act(|play| act(play).err().map(|refusal| play.refusal_text(&refusal)))
    }

    /// Tells the views that something was done, and draws.
    pub fn acted(self, by_slider: bool) {
        self.publish(true, by_slider);
        self.wake();
    }

    /// Raises the counters of what has changed and says what has happened. `values` says whether it is time to show
    /// changing values again.
    pub fn publish(self, values: bool, by_slider: bool) {
        let Some(revision) = self.read(|play| Some(play.revision())) else { return };
        // The clock is right as soon as something was done, not a frame later.
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
            (before.checks != now.checks, changes.checks),
            (moved, changes.frame),
            ((before.frame, before.rows) != (now.frame, now.rows), changes.values),
        ];
        let focused = browser::focused();
        // What reads several of them is built once.
        self.scope.run_in(|| {
            batch(|| {
                changed.into_iter().for_each(raise);
                self.host().raise();
            });
        });
        // What had the focus and has been built again has it again.
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

    /// Shows a message; the next one takes its place, unless it is an error.
    fn show(self, message: Message) {
        self.messages.update(|messages| {
            messages.retain(|other| other.is_error && *other != message);
            if message.is_error && messages.len() >= MOST_ERRORS {
                messages.remove(0);
            }
            messages.push(message);
        });
    }

    /// Says and shows that something has been done.
    pub fn notify(self, words: &str) {
        self.report(Message::notice(words.to_owned()));
    }

    /// Says and shows why something was not done.
    pub fn complain(self, words: String) {
        self.report(Message::error(words));
    }

    /// Says and shows a message.
    pub fn report(self, message: Message) {
        self.say(message.text.clone());
        self.show(message);
    }

    /// Says something through the live region alone: what a person who sees the page sees anyway. The same words twice must
    /// differ, or they are said once.
    pub fn say(self, mut words: String) {
        if self.spoken.with_untracked(|spoken| *spoken == words) {
            words.push('\u{a0}');
        }
        self.spoken.set(words);
    }

    /// Everything is built again: for another document or language.
    pub fn rebuild(self) {
        self.changes.document.update(|count| *count += 1);
        self.acted(false);
    }

    /// What shows the program is built again: another one has taken its place. What lasts, such as the editor of its text, stays as
    /// it is.
    pub fn rebuild_program(self) {
        self.nodes(Nodes::clear);
        self.changes.program.update(|count| *count += 1);
        self.acted(false);
    }

    /// Chooses the language of everything.
    pub fn set_language(self, language: Language) {
        self.host().set_language(language);
        self.language.set(language);
        browser::remember("language", language.tag());
        self.rebuild();
    }
}

/// The title of the simulation; the program's name where none is open.
pub fn title(app: App) -> String {
    let language = app.language.get_untracked().tag();
    app.read(|play| Some(play.program().edition(language).title.clone()))
        .filter(|title| !title.is_empty())
        .unwrap_or_else(|| "Meniscus".to_owned())
}

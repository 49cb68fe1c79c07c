//! The handle that every view holds: it leads to the one desk and its simulation, and signals to the views which part of them
//! has changed.

use crate::browser;
use crate::frame::{self, Stage};
use crate::messages::{self, Message};
use crate::opening::Findings;
use crate::panel::Tab;
use crate::saved::{self, Saved};
use crate::sound::Sound;
use crate::stage;
use crate::views::*;
use crate::words::{Words, words_in};
use desk::{Announcement, Desk, FitProgress, RecordProgress, Revision};
use document::page::Source;
use play::{Play, PlotId};
use std::cell::{RefCell, RefMut};
use std::collections::{BTreeMap, VecDeque};
use std::ops::Deref;
use sycamore_reactive::{NodeHandle, batch, use_current_scope};
use units::Language;
use web_sys::File;

/// What the page holds for as long as it is open.
#[derive(Default)]
pub struct Lab {
    /// The desk, when a document is open that has no errors.
    pub desk: Option<Desk>,
    /// The desk of the last document that ran, while another is open that does not: it holds the records.
    pub parked: Option<Desk>,
    /// The files of the document.
    pub sources: Vec<Source>,
    /// The files of the last document that ran, while another is open that does not.
    pub sources_before: Vec<Source>,
    /// What a person has made of the texts of a document that does not run; empty while nothing has been typed.
    pub drafts: Vec<String>,
    /// What was found in them.
    pub findings: Findings,
    /// The nodes that are redrawn in each frame.
    pub stage: Stage,
    /// What is heard.
    pub sound: Sound,
    /// What is stored of the laboratory.
    pub saved: Saved,
    /// A file that a link needs, and the state of its document.
    pub awaited: Option<(String, String)>,
    /// Whether the equations of the theories have been asked for.
    pub reads_equations: bool,
    /// Whether fits are being worked on.
    pub fitting: bool,
    /// Files that are to be read as records, and whether one is being read.
    pub files: VecDeque<File>,
    /// See `files`.
    pub reading: bool,
    /// The revision that the views show.
    seen: Revision,
    /// The frame that the values show.
    seen_frame: u64,
}

/// Counters that views track. Each is raised when that part of the desk or of its simulation has changed.
#[derive(Clone, Copy)]
pub struct Changes {
    /// Another document, or the document in another language.
    pub document: Signal<u64>,
    /// Parameters, presets, method and step.
    pub parameters: Signal<u64>,
    /// Status, speed and problem.
    pub transport: Signal<u64>,
    /// Kept runs.
    pub runs: Signal<u64>,
    /// Which plots are shown, and whether they show everything.
    pub plots: Signal<u64>,
    /// Records, and what their columns are taken for.
    pub records: Signal<u64>,
    /// Fits, what they vary and what has come of them.
    pub fits: Signal<u64>,
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
    lab: RefCell<Lab>,
    /// Where signals live that live as long as the page.
    scope: NodeHandle,
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
    /// Whether files are being dragged over the page.
    pub dragging_files: Signal<bool>,
    /// The record that was added last, until a person has seen it.
    pub new_record: Signal<Option<u32>>,
    /// Whether single keys act.
    pub single_keys: Signal<bool>,
    /// How far the fits have come that a person has begun.
    pub fit_progress: Signal<Option<FitProgress>>,
    /// How far the file has been read that is being read as a record.
    pub record_progress: Signal<Option<RecordProgress>>,
    /// Why the last record could not be read.
    pub record_refusal: Signal<Option<String>>,
    /// Whether the list of documents has been asked for.
    pub library_asked_for: Signal<bool>,
    /// The open tab of the panel.
    pub tab: Signal<Tab>,
    /// Whether the table of the recorded values is shown.
    pub table_open: Signal<bool>,
    /// Whether the window has room for one plot only.
    pub narrow: Signal<bool>,
    /// The plot shown there.
    pub front_plot: Signal<Option<PlotId>>,
    /// The first equation of each theory that has been read so far, by its file.
    pub equations: Signal<BTreeMap<String, String>>,
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
    /// An empty laboratory, for as long as the page is open.
    pub fn new(language: Language, single_keys: bool) -> Self {
        let counter = || create_signal(0);
        let page = Page {
            lab: RefCell::default(),
            scope: use_current_scope(),
            changes: Changes {
                document: counter(),
                parameters: counter(),
                transport: counter(),
                runs: counter(),
                plots: counter(),
                records: counter(),
                fits: counter(),
                frame: counter(),
                values: counter(),
            },
            language: create_signal(language),
            spoken: create_signal(String::new()),
            messages: create_signal(Vec::new()),
            printing: create_signal(false),
            dragging_files: create_signal(false),
            new_record: create_signal(None),
            single_keys: create_signal(single_keys),
            fit_progress: create_signal(None),
            record_progress: create_signal(None),
            record_refusal: create_signal(None),
            library_asked_for: create_signal(false),
            tab: create_signal(Tab::default()),
            table_open: create_signal(false),
            narrow: create_signal(browser::matches(stage::NARROW)),
            front_plot: create_signal(None),
            equations: create_signal(BTreeMap::new()),
            numerics_open: create_signal(false),
        };
        Self(Box::leak(Box::new(page)))
    }

    /// The words of the interface, without tracking: every view with words is rebuilt for another language.
    pub fn words(self) -> &'static Words {
        words_in(self.language.get_untracked())
    }

    /// Works on everything the page holds. Must not be nested.
    pub fn with<T>(self, work: impl FnOnce(&mut Lab) -> T) -> Option<T> {
        self.lab.try_borrow_mut().ok().map(|mut lab| work(&mut lab))
    }

    /// Reads something from the simulation; its default where no document is open.
    pub fn read<T: Default>(self, read: impl FnOnce(&mut Play) -> T) -> T {
        self.read_desk(|desk| read(desk.play_mut()))
    }

    /// Reads something from the desk; its default where no document is open.
    pub fn read_desk<T: Default>(self, read: impl FnOnce(&mut Desk) -> T) -> T {
        match self.desk() {
            Some(mut desk) => read(&mut desk),
            None => T::default(),
        }
    }

    /// The desk, if a document is open.
    #[inline(never)]
    fn desk(self) -> Option<RefMut<'static, Desk>> {
        RefMut::filter_map(self.0.lab.try_borrow_mut().ok()?, |lab| lab.desk.as_mut()).ok()
    }

    /// Does something in the simulation, tells the views and draws.
    pub fn act<T: Default>(self, act: impl FnOnce(&mut Play) -> T) -> T {
        self.act_on_desk(|desk| act(desk.play_mut()))
    }

    /// Does something at the desk, tells the views and draws.
    pub fn act_on_desk<T: Default>(self, act: impl FnOnce(&mut Desk) -> T) -> T {
        let result = self.read_desk(act);
        self.acted(false);
        result
    }

    /// As [`App::act`], for a slider, which tells its value itself.
    pub fn slide(self, act: impl FnOnce(&mut Play)) {
        self.read(act);
        self.acted(true);
    }

    /// As [`App::act`], for what may be refused: the refusal in words.
    pub fn attempt(self, act: impl FnOnce(&mut Play) -> Result<(), play::Refusal>) -> Option<String> {
        self.act(|play| act(play).err().map(|refusal| play.refusal_text(&refusal)))
    }

    /// The same at the desk.
    pub fn attempt_on_desk(self, act: impl FnOnce(&mut Desk) -> Result<(), desk::Refusal>) -> Option<String> {
        self.act_on_desk(|desk| act(desk).err().map(|refusal| desk.refusal_text(&refusal)))
    }

    fn acted(self, by_slider: bool) {
        self.publish(true, by_slider);
        frame::wake(self);
    }

    /// Raises the counters of what has changed and speaks the announcements. `values` says whether it is time to show
    /// changing values again.
    pub fn publish(self, values: bool, by_slider: bool) {
        let news = self.with(|lab| {
            let desk = lab.desk.as_mut()?;
            // The clock is right as soon as something was done, not a frame later.
            if let Some(transport) = &mut lab.stage.transport {
                transport.draw(desk.play_mut());
            }
            let (mut told, mut shown, mut added) = (Vec::new(), Vec::new(), None);
            while let Some(announcement) = desk.take_announcement() {
                if !(by_slider && matches!(announcement, Announcement::Play(play::Announcement::ParameterSet(..)))) {
                    let text = desk.announcement_text(&announcement);
                    if matches!(announcement, Announcement::RecordAdded(_)) {
                        added = desk.newest_record();
                    }
                    // What has come of a fit is brought into sight where it was begun.
                    if !(matches!(announcement, Announcement::FitFinished) && self.tab.get_untracked() == Tab::Fit) {
                        shown.extend(Message::of(desk, &announcement, &text));
                    }
                    told.push(text);
                }
            }
            let (before, mut now) = (lab.seen, desk.revision());
            let moved = std::mem::replace(&mut lab.seen_frame, now.play.frame) != now.play.frame;
            if !values {
                (now.play.frame, now.play.rows) = (before.play.frame, before.play.rows);
            }
            lab.seen = now;
            Some((before, now, told.join(". "), shown, added, moved))
        });
        let Some((before, now, told, shown, added, moved)) = news.flatten() else { return };
        let lasting = |revision: &Revision| (revision.records, revision.fits, revision.play.answers);
        if lasting(&before) != lasting(&now) {
            saved::later(self);
        }
        let changes = self.changes;
        let raise = |(changed, counter): (bool, Signal<u64>)| {
            if changed {
                counter.update(|count| *count += 1);
            }
        };
        let changed = [
            (before.play.parameters != now.play.parameters, changes.parameters),
            (before.play.transport != now.play.transport, changes.transport),
            (before.play.runs != now.play.runs, changes.runs),
            (before.play.plots != now.play.plots, changes.plots),
            (before.records != now.records, changes.records),
            (before.fits != now.fits, changes.fits),
            (moved, changes.frame),
            ((before.play.frame, before.play.rows) != (now.play.frame, now.play.rows), changes.values),
        ];
        let focused = browser::focused();
        // What reads several of them is built once.
        self.scope.run_in(|| batch(|| changed.into_iter().for_each(raise)));
        // An element that had the focus and was rebuilt gets it again.
        if browser::focused() != focused {
            browser::focus(&focused);
        }
        if !told.is_empty() {
            self.say(told);
        }
        if added.is_some() {
            self.new_record.set(added);
        }
        for message in shown {
            messages::show(self, message);
        }
    }

    /// Says and shows that something has been done.
    pub fn notify(self, words: &str) {
        self.say(words.to_owned());
        messages::show(self, Message::notice(words.to_owned()));
    }

    /// Says and shows why something was not done.
    pub fn complain(self, words: String) {
        self.say(words.clone());
        messages::show(self, Message::error(words));
    }

    /// Says something through the live region alone: what a person who sees the page sees anyway. The same words twice must differ, or they are said once.
    pub fn say(self, mut words: String) {
        if self.spoken.with_untracked(|spoken| *spoken == words) {
            words.push('\u{a0}');
        }
        self.spoken.set(words);
    }

    /// Rebuilds everything, for another document or language.
    pub fn rebuild(self) {
        self.changes.document.update(|count| *count += 1);
        self.acted(false);
    }

    /// Chooses the language of everything.
    pub fn set_language(self, language: Language) {
        self.read_desk(|desk| desk.set_language(language.tag()));
        self.language.set(language);
        browser::remember("language", language.tag());
        self.rebuild();
    }
}

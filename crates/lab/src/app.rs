//! The handle of the laboratory: the page's views of the simulation, and the desk beside it.

mod host;

use crate::film::{Films, Player};
use crate::stored::{Kept, Saved, VersionTimes};
use crate::words::{Words, words_in};
use crate::write::{Editor, Panel};
use desk::{Desk, FitProgress, Insight, RecordProgress, Refusal, Writing};
use document::page::Source;
use model::Diagnostic;
use std::cell::{Cell, OnceCell, RefCell, RefMut};
use std::collections::{BTreeMap, VecDeque};
use std::ops::Deref;
use std::panic::Location;
use std::rc::Rc;
use units::Language;
use view::views::*;
use web_sys::{File, console};

/// What was found in the files, each with the number of its file.
pub type Findings = Vec<(usize, Diagnostic)>;

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
    /// The texts of a document in which nothing runs, while one is open.
    pub faulty: Writing,
    /// What was found in them.
    pub findings: Findings,
    /// What is stored of the laboratory.
    pub saved: Saved,
    /// A file that a link needs, and the state of its document.
    pub awaited: Option<(String, String)>,
    /// Whether the equations of the theories have been asked for.
    pub reads_equations: bool,
    /// The editor, once it has been started.
    pub editor: Option<Editor>,
    /// Under which name the browser keeps what is written of the open document, and what this page has kept there last.
    pub written_as: Option<Kept>,
    /// When the text was changed, and when a version of it was made.
    pub version_times: VersionTimes,
    /// Whether the editor shows the open document, and not the one before it.
    pub editor_is_current: bool,
    /// Whether the editor takes the focus when it is there.
    pub focuses_editor: bool,
    /// Whether fits are being worked on.
    pub fitting: bool,
    /// Files that are to be read as records, and whether one is being read.
    pub files: VecDeque<File>,
    /// See `files`.
    pub reading: bool,
    /// The pictures of the film that is open.
    pub player: Option<Rc<Player>>,
    /// Whether it is being tracked.
    pub tracking: bool,
    /// Whether the run is being brought to where the film is.
    pub bringing: bool,
}

impl Lab {
    /// The texts in the editor and what was found in them.
    pub fn writing(&self) -> &Writing {
        self.desk.as_ref().map_or(&self.faulty, Desk::writing)
    }
}

/// The handle; copied freely.
#[derive(Clone, Copy)]
pub struct App(&'static Laboratory);

/// Everything that the handle leads to; the views of the simulation among it.
pub struct Laboratory {
    /// The views of the simulation.
    pub page: view::App,
    store: &'static Store,
    /// Raised when records have changed, or what their columns are taken for.
    pub records: Signal<u64>,
    /// Raised when fits have changed, what they vary and what has come of them.
    pub fits: Signal<u64>,
    /// Whether files are being dragged over the page.
    pub dragging_files: Signal<bool>,
    /// The record that was added last, until a person has seen it.
    pub new_record: Signal<Option<u32>>,
    /// The film that is open.
    pub films: Films,
    /// How far the fits have come that a person has begun.
    pub fit_progress: Signal<Option<FitProgress>>,
    /// How far the file has been read that is being read as a record.
    pub record_progress: Signal<Option<RecordProgress>>,
    /// Why the last record could not be read.
    pub record_refusal: Signal<Option<String>>,
    /// Whether the list of documents has been asked for.
    pub library_asked_for: Signal<bool>,
    /// Whether the ways to publish the document have been asked for.
    pub publishing: Signal<bool>,
    /// Raised when a text in the editor has been checked.
    pub written: Signal<u64>,
    /// Raised when a text has been changed from outside the editor, before it is checked.
    pub typed: Signal<u64>,
    /// Which file the editor shows.
    pub written_file: Signal<usize>,
    /// What is under the cursor.
    pub insight: Signal<Insight>,
    /// Counts the moves of the cursor in a form, so that only the last one is followed.
    pub resting: Signal<u64>,
    /// In which form the document is written.
    pub writing_panel: Signal<Panel>,
    /// The first equation of each theory that has been read so far, by its file.
    pub equations: Signal<BTreeMap<String, String>>,
}

impl Deref for App {
    type Target = Laboratory;

    fn deref(&self) -> &Laboratory {
        self.0
    }
}

impl Deref for Laboratory {
    type Target = view::App;

    fn deref(&self) -> &view::App {
        &self.page
    }
}

/// What the views reach the laboratory through.
#[derive(Default)]
struct Store {
    lab: RefCell<Lab>,
    app: OnceCell<App>,
    /// What the views have shown of records, fits, answers and the film.
    seen: Cell<(u64, u64, u64, u64)>,
}

impl Store {
    /// The laboratory's state; none where it is in use already. That is a fault of the page, and the console says where.
    #[inline(never)]
    #[track_caller]
    fn lab(&self) -> Option<RefMut<'_, Lab>> {
        let lab = self.lab.try_borrow_mut().ok();
        if lab.is_none() {
            let place = Location::caller();
            console::error_1(&format!("the laboratory's state is used inside another use of it: {place}").into());
        }
        lab
    }

    /// The desk, if a document is open.
    #[inline(never)]
    #[track_caller]
    fn desk(&self) -> Option<RefMut<'_, Desk>> {
        RefMut::filter_map(self.lab()?, |lab| lab.desk.as_mut()).ok()
    }
}

impl App {
    /// An empty laboratory, for as long as the page is open.
    pub fn new(language: Language) -> Self {
        let counter = || create_signal(0);
        let store: &'static Store = Box::leak(Box::default());
        let laboratory = Laboratory {
            page: view::App::new(store, language),
            store,
            records: counter(),
            fits: counter(),
            dragging_files: create_signal(false),
            new_record: create_signal(None),
            films: Films::new(),
            fit_progress: create_signal(None),
            record_progress: create_signal(None),
            record_refusal: create_signal(None),
            library_asked_for: create_signal(false),
            publishing: create_signal(false),
            written: counter(),
            typed: counter(),
            written_file: create_signal(0),
            insight: create_signal(Insight::default()),
            resting: counter(),
            writing_panel: create_signal(Panel::default()),
            equations: create_signal(BTreeMap::new()),
        };
        let app = Self(Box::leak(Box::new(laboratory)));
        // It is empty, since it was just made.
        let _ = store.app.set(app);
        app
    }

    /// The words of the interface, without tracking: whatever shows words is built again for another language.
    pub fn words(self) -> &'static Words {
        words_in(self.language.get_untracked())
    }

    /// Works on everything the page holds. Must not be nested: the inner use does nothing and is reported in the console.
    #[track_caller]
    pub fn with<T>(self, work: impl FnOnce(&mut Lab) -> T) -> Option<T> {
        self.store.lab().map(|mut lab| work(&mut lab))
    }

    /// Reads something from the desk; its default where no document is open. Must not be nested.
    #[track_caller]
    pub fn read_desk<T: Default>(self, read: impl FnOnce(&mut Desk) -> T) -> T {
        match self.store.desk() {
            Some(mut desk) => read(&mut desk),
            None => T::default(),
        }
    }

    /// Reads something of the texts in the editor.
    #[track_caller]
    pub fn read_writing<T: Default>(self, read: impl FnOnce(&Writing) -> T) -> T {
        self.with(|lab| read(lab.writing())).unwrap_or_default()
    }

    /// Does something at the desk, tells the views and draws.
    #[track_caller]
    pub fn act_on_desk<T: Default>(self, act: impl FnOnce(&mut Desk) -> T) -> T {
        let result = self.read_desk(act);
        self.acted(false);
        result
    }

    /// As [`App::act_on_desk`], for what may be refused: the refusal in words.
    #[track_caller]
    pub fn attempt_on_desk(self, act: impl FnOnce(&mut Desk) -> Result<(), Refusal>) -> Option<String> {
        self.act_on_desk(|desk| act(desk).err().map(|refusal| desk.refusal_text(&refusal)))
    }
}

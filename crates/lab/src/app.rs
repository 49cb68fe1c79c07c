//! Handle of the laboratory: the views of the simulation, and the desk beside it.

mod host;

use crate::class::{Room, SurveyRoom};
use crate::documents::import_report::Report as Imported;
use crate::documents::stored::{Kept, Saved, VersionTimes};
use crate::film::{Films, Player};
use crate::fit::Fitting;
use crate::guide::Step;
use crate::publish::Sheet;
use crate::verifying::verdict::Verified;
use crate::words::{Words, words_in};
use crate::workers::{FitWorkers, SweepPool};
use crate::write::{Editor, Panel};
use desk::{DateOrder, Desk, FitProgress, Insight, RecordProgress, Refusal, Writing};
use document::page::Source;
use model::Diagnostic;
use play::{Embedding, PagePart};
use std::cell::{Cell, OnceCell, RefCell, RefMut};
use std::collections::{BTreeMap, VecDeque};
use std::ops::Deref;
use std::panic::Location;
use std::rc::Rc;
use units::Language;
use view::page::welcome;
use view::views::*;
use web_sys::{File, console};

/// Diagnostics of the files: (file index, diagnostic).
pub type Findings = Vec<(usize, Diagnostic)>;

/// State of the page, as long as it is open.
#[derive(Default)]
pub struct Lab {
    /// Desk of the open document; `None` if no document is open or it has errors.
    pub desk: Option<Desk>,
    /// Desk of the last document that ran, while a document that does not run is open: it holds the records.
    pub parked: Option<Desk>,
    /// Files of the document.
    pub sources: Vec<Source>,
    /// Files of the last document that ran, while a document that does not run is open.
    pub sources_before: Vec<Source>,
    /// Texts of an open document that does not run.
    pub faulty: Writing,
    /// Diagnostics of these texts.
    pub findings: Findings,
    /// State of the browser's storage.
    pub saved: Saved,
    /// Number of documents that have been asked for: only the last one is shown.
    pub asked_for: u32,
    /// A file that a link needs (its name), and the state to be restored with it.
    pub awaited: Option<(String, String)>,
    /// True once the equations of the theories have been requested.
    pub reads_equations: bool,
    /// The editor, once started.
    pub editor: Option<Editor>,
    /// Name under which the browser stores the written text of the open document, and the text stored last by this
    /// page.
    pub written_as: Option<Kept>,
    /// Times of the last change of the text and of the last version.
    pub version_times: VersionTimes,
    /// True if the editor shows the open document and not the previous one.
    pub editor_is_current: bool,
    /// True if the editor takes the focus when it appears.
    pub focuses_editor: bool,
    /// True while this page takes its part in the computation of fits.
    pub fitting: bool,
    /// Computes fits beside the page.
    pub workers: FitWorkers,
    /// Computes plots over a parameter beside the page.
    pub sweeps: SweepPool,
    /// Queue of files to be read as records, with the order of day and month in their dates where it was chosen.
    pub files: VecDeque<(File, Option<DateOrder>)>,
    /// True while a file of the queue is being read.
    pub reading: bool,
    /// Player of the open film.
    pub player: Option<Rc<Player>>,
    /// True while the film is being tracked.
    pub tracking: bool,
    /// True while the run is being computed up to the time of the film.
    pub bringing: bool,
}

impl Lab {
    /// Counts a document that is asked for. Returns its number.
    pub fn ask_for_document(&mut self) -> u32 {
        self.asked_for += 1;
        self.asked_for
    }

    /// Texts in the editor with their diagnostics.
    pub fn writing(&self) -> &Writing {
        self.desk.as_ref().map_or(&self.faulty, Desk::writing)
    }
}

/// Handle of the laboratory; cheap to copy.
#[derive(Clone, Copy)]
pub struct App(&'static Laboratory);

/// Data behind the handle, including the views of the simulation.
pub struct Laboratory {
    /// Views of the simulation.
    pub page: view::App,
    store: &'static Store,
    /// Raised when records or the meaning of their columns have changed.
    pub records: Signal<u64>,
    /// True while a press on a measured point in a plot leaves its row out of fits.
    pub leaving_out: Signal<bool>,
    /// Raised when fits, their varied parameters or their results have changed.
    pub fits: Signal<u64>,
    /// True while files are being dragged over the page.
    pub dragging_files: Signal<bool>,
    /// Id of the record added last, until the user has seen it.
    pub new_record: Signal<Option<u32>>,
    /// The open film.
    pub films: Films,
    /// Number of parts of the page that may be built; see [`App::part`].
    built: Signal<usize>,
    /// The hand-ins of a class.
    pub class: Room,
    /// The answers of the class to surveys.
    pub survey: SurveyRoom,
    /// State of fits that the strip under the plots and the tab *Measure* share.
    pub fit: Fitting,
    /// Progress of the fits started by the user, `None` while none runs.
    pub fit_progress: Signal<Option<FitProgress>>,
    /// Progress of reading a file as a record, `None` while none is read.
    pub record_progress: Signal<Option<RecordProgress>>,
    /// Reason why the last record could not be read.
    pub record_refusal: Signal<Option<String>>,
    /// Files whose dates can have the day or the month first.
    pub undated: Signal<Vec<File>>,
    /// True until the guided start has been begun or declined on the first visit.
    pub is_first_visit: Signal<bool>,
    /// Action that the guided start asks for, `None` while there is none.
    pub guide: Signal<Option<Step>>,
    /// True while the list of documents is open.
    pub library_asked_for: Signal<bool>,
    /// True while the publishing dialog is open.
    pub publishing: Signal<bool>,
    /// The parts of the worksheet.
    pub sheet: Sheet,
    /// The hand-in that is verified in a dialog, with the result.
    pub verified: Signal<Option<Verified>>,
    /// Raised when a text in the editor has been checked.
    pub written: Signal<u64>,
    /// Raised when a text has been changed from outside the editor, before it is checked.
    pub typed: Signal<u64>,
    /// Index of the file shown by the editor.
    pub written_file: Signal<usize>,
    /// Information on the word under the cursor.
    pub insight: Signal<Insight>,
    /// Counts the cursor moves in a form, so that only the last one is handled.
    pub resting: Signal<u64>,
    /// Form in which the document is edited.
    pub writing_panel: Signal<Panel>,
    /// Report of the last import.
    pub imported: Signal<Option<Rc<Imported>>>,
    /// First equation of each theory read so far, by file name.
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

/// Owner of the state, through which views access the laboratory.
#[derive(Default)]
struct Store {
    lab: RefCell<Lab>,
    app: OnceCell<App>,
    /// Options in the address of the page.
    embedding: RefCell<Embedding>,
    /// Revisions of records, fits, answers and film that the views have shown.
    seen: Cell<(u64, u64, u64, u64)>,
}

impl Store {
    /// State of the laboratory; `None` if it is already in use. Nested use is a programming error: debug builds panic,
    /// others report its place in the console, where the tests of the page take it for a fault.
    #[inline(never)]
    #[track_caller]
    fn lab(&self) -> Option<RefMut<'_, Lab>> {
        let lab = self.lab.try_borrow_mut().ok();
        if lab.is_none() {
            let fault = format!("the laboratory's state is used inside another use of it: {}", Location::caller());
            debug_assert!(false, "{fault}");
            console::error_1(&fault.into());
        }
        lab
    }

    /// The desk; `None` if no document is open or the state is in use.
    #[inline(never)]
    #[track_caller]
    fn desk(&self) -> Option<RefMut<'_, Desk>> {
        RefMut::filter_map(self.lab()?, |lab| lab.desk.as_mut()).ok()
    }
}

impl App {
    /// Creates an empty laboratory with the options of its address. It lives as long as the page.
    pub fn new(language: Language, embedding: Embedding) -> Self {
        let counter = || create_signal(0);
        let store: &'static Store =
            Box::leak(Box::new(Store { embedding: RefCell::new(embedding), ..Store::default() }));
        let laboratory = Laboratory {
            page: view::App::new(store, language),
            store,
            records: counter(),
            fits: counter(),
            dragging_files: create_signal(false),
            new_record: create_signal(None),
            leaving_out: create_signal(false),
            films: Films::new(),
            built: create_signal(usize::MAX),
            class: Room::new(language),
            survey: SurveyRoom::new(),
            fit: Fitting::new(),
            fit_progress: create_signal(None),
            record_progress: create_signal(None),
            record_refusal: create_signal(None),
            undated: create_signal(Vec::new()),
            is_first_visit: create_signal(welcome::is_first_visit()),
            guide: create_signal(None),
            library_asked_for: create_signal(false),
            publishing: create_signal(false),
            sheet: Sheet::new(),
            verified: create_signal(None),
            written: counter(),
            typed: counter(),
            written_file: create_signal(0),
            insight: create_signal(Insight::default()),
            resting: counter(),
            writing_panel: create_signal(Panel::default()),
            imported: create_signal(None),
            equations: create_signal(BTreeMap::new()),
        };
        let app = Self(Box::leak(Box::new(laboratory)));
        // Set here for the first time, so this cannot fail.
        let _ = store.app.set(app);
        app
    }

    /// Shows a part that the address of the page leaves out, from the next rebuild on. Returns true if it was left out.
    pub fn bring_back(self, part: PagePart) -> bool {
        let Ok(mut embedding) = self.store.embedding.try_borrow_mut() else { return false };
        let was_hidden = embedding.hides(part);
        embedding.hidden.retain(|other| *other != part);
        was_hidden
    }

    /// A part of the page. Its turn comes by its number while a page is built part by part, beside another one.
    pub fn part(self, number: usize, mut build: impl FnMut() -> View + 'static) -> View {
        let is_due = memo(move || number < self.built.get());
        changing(move || if is_due.get() { build() } else { View::new() })
    }

    /// Lets this number of parts be built.
    pub fn build_parts(self, number: usize) {
        self.page.within(|| self.built.set(number));
    }

    /// Texts of the interface. Not tracked: views with texts are rebuilt when the language changes.
    pub fn words(self) -> &'static Words {
        words_in(self.language.get_untracked())
    }

    /// Calls `work` with the state of the page. Calls must not be nested: an inner call panics in debug builds; otherwise
    /// it does nothing and is reported in the console.
    #[track_caller]
    pub fn with<T>(self, work: impl FnOnce(&mut Lab) -> T) -> Option<T> {
        self.store.lab().map(|mut lab| work(&mut lab))
    }

    /// Reads from the desk; returns the default if no document is open. Calls must not be nested.
    #[track_caller]
    pub fn read_desk<T: Default>(self, read: impl FnOnce(&mut Desk) -> T) -> T {
        match self.store.desk() {
            Some(mut desk) => read(&mut desk),
            None => T::default(),
        }
    }

    /// Reads from the texts in the editor.
    #[track_caller]
    pub fn read_writing<T: Default>(self, read: impl FnOnce(&Writing) -> T) -> T {
        self.with(|lab| read(lab.writing())).unwrap_or_default()
    }

    /// Performs an action on the desk, notifies the views and redraws.
    #[track_caller]
    pub fn act_on_desk<T: Default>(self, act: impl FnOnce(&mut Desk) -> T) -> T {
        let result = self.read_desk(act);
        self.acted(false);
        result
    }

    /// As [`App::act_on_desk`], for actions that can be refused. Returns the text of the refusal.
    #[track_caller]
    pub fn attempt_on_desk(self, act: impl FnOnce(&mut Desk) -> Result<(), Refusal>) -> Option<String> {
        self.act_on_desk(|desk| act(desk).err().map(|refusal| refusal.text(desk.play())))
    }
}

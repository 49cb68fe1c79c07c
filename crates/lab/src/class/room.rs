//! State of the dashboard: the hand-ins, what is collected for the wall, and the names on this device.

use super::computing::Computing;
use class::collection::{Collection, References, Snapshot, Snapshots};
use class::results::Quantity;
use desk::saved::hand_in::{HandIn, HandInError};
use document::page::Source;
use std::collections::BTreeMap;
use units::Language;
use view::browser;
use view::views::*;

/// Storage key of the names beside pseudonyms: a line with pseudonym, tabulator and name for each.
const NAMES: &str = "class-names";
/// Duration of a slice of the computation, in milliseconds.
const SLICE: f64 = 12.0;
/// Least time between two updates of the dashboard while files are read or computed, in milliseconds, and in multiples of the
/// duration of the last update: many hand-ins are shown less often.
const UPDATE: f64 = 500.0;
const SPACING: f64 = 20.0;

/// A part of the dashboard that is drawn in a task of its own, so that the page reacts in between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Status,
    HandIns,
    Copies,
    Curves,
    Residuals,
    Chips,
    /// The pooled quantities, which `Results` and `Stuck` show.
    Quantities,
    Results,
    Against,
    Stuck,
    Answers,
}

/// The parts in the order in which they are drawn.
const PARTS: [Part; 11] = [
    Part::Status,
    Part::HandIns,
    Part::Copies,
    Part::Curves,
    Part::Residuals,
    Part::Chips,
    Part::Quantities,
    Part::Results,
    Part::Against,
    Part::Stuck,
    Part::Answers,
];

/// The hand-ins of a class in the page; cheap to copy.
#[derive(Clone, Copy)]
pub struct Room {
    collection: Signal<Collection>,
    quantities: Signal<Vec<Quantity>>,
    /// One signal for each part, in the order of [`Part`].
    parts: [Signal<()>; PARTS.len()],
    /// Number of parts of the present update that are drawn.
    drawn: Signal<usize>,
    /// Powers of the parameter and of the quantity that are set against each other; empty for none.
    axes: (Signal<String>, Signal<String>),
    snapshots: Signal<Snapshots>,
    names: Signal<BTreeMap<String, String>>,
    is_open: Signal<bool>,
    is_computing: Signal<bool>,
    /// True if a computation was asked for since the one that runs last looked for work.
    is_asked: Signal<bool>,
    /// Computes hand-ins beside the page.
    computing: Signal<Computing>,
    /// Reason why the last files were refused; empty if they were not.
    refusal: Signal<String>,
    /// End of the last update of the dashboard, and the duration of all its parts, in milliseconds.
    updated: Signal<(f64, f64)>,
    /// Part of the collected work that the wall shows.
    wall: Signal<Wall>,
}

/// Shown part of the collected work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// Nothing is shown.
    Closed,
    /// All curves of the same quantity in one figure.
    Together,
    /// The piece of work at this place.
    One(usize),
}

impl Room {
    /// An empty room. `language`: language of the questions.
    pub fn new(language: Language) -> Self {
        Self {
            collection: create_signal(Collection::new(language)),
            quantities: create_signal(Vec::new()),
            parts: PARTS.map(|_| create_signal(())),
            drawn: create_signal(PARTS.len()),
            axes: (create_signal(String::new()), create_signal(String::new())),
            snapshots: create_signal(Snapshots::default()),
            names: create_signal(BTreeMap::new()),
            is_open: create_signal(false),
            is_computing: create_signal(false),
            is_asked: create_signal(false),
            computing: create_signal(Computing::default()),
            refusal: create_signal(String::new()),
            updated: create_signal((0.0, 0.0)),
            wall: create_signal(Wall::Closed),
        }
    }

    /// True while the dashboard is open.
    pub fn is_open(self) -> bool {
        self.is_open.get()
    }

    /// Opens the dashboard, or closes it. Names are read from this device.
    pub fn set_open(self, open: bool) {
        if open == self.is_open.get_untracked() {
            return;
        }
        if open {
            let stored = browser::remembered(NAMES).unwrap_or_default();
            let names = stored.lines().filter_map(|line| line.split_once('\t'));
            let names = names.map(|(pseudonym, name)| (pseudonym.to_owned(), name.to_owned()));
            self.names.set_silent(names.collect());
        }
        self.is_open.set(open);
    }

    /// Reads the hand-ins for a part of the dashboard; a view that does is rebuilt when the part is drawn. No view may be built
    /// inside.
    pub fn read<T>(self, part: Part, read: impl FnOnce(&Collection) -> T) -> T {
        self.follow(part);
        self.collection.with_untracked(read)
    }

    /// A view that calls this is rebuilt when the part is drawn.
    pub fn follow(self, part: Part) {
        if let Some(signal) = self.parts.get(part as usize) {
            signal.track();
        }
    }

    /// Reads the pooled quantities for a part of the dashboard.
    pub fn read_quantities<T>(self, part: Part, read: impl FnOnce(&[Quantity]) -> T) -> T {
        self.follow(part);
        self.quantities.with_untracked(|quantities| read(quantities))
    }

    /// Reads the hand-ins without following them.
    pub fn read_once<T>(self, read: impl FnOnce(&Collection) -> T) -> T {
        self.collection.with_untracked(read)
    }

    /// Reason why the last files were refused; empty if they were not.
    pub fn refusal(self) -> String {
        self.refusal.get_clone()
    }

    /// Shows why files were refused. Returns false if the dashboard is not open.
    pub fn refuse(self, why: &str) -> bool {
        self.refusal.set(why.to_owned());
        self.is_open.get_untracked()
    }

    /// Adds a file; the dashboard follows with [`Room::show`]. Of a folder, a page without the data of a hand-in is left out;
    /// the result is then false.
    pub fn add(self, name: &str, content: Result<HandIn, HandInError>, is_of_folder: bool) -> bool {
        let mut is_taken = true;
        self.collection.update_silent(|collection| match is_of_folder {
            true => is_taken = collection.add_of_folder(name, content),
            false => collection.add(name, content),
        });
        is_taken
    }

    /// Sets the teacher's documents.
    pub fn set_references(self, references: References) {
        self.collection.update_silent(|collection| collection.set_references(references));
    }

    /// The document that is open here, which may be that of the class.
    pub fn offer_document(self, document: Vec<Source>) {
        self.collection.update_silent(|collection| collection.offer_document(document));
    }

    /// Adds a hand-in of a running lesson, or a later form of one.
    pub fn update(self, name: &str, content: Result<HandIn, HandInError>) {
        self.collection.update_silent(|collection| collection.update(name, content));
    }

    /// Draws the next part of the dashboard. Begins with the first one if the last update is long enough ago.
    pub async fn show_sometimes(self) {
        let (ended, duration) = self.updated.get_untracked();
        let is_complete = self.drawn.get_untracked() == PARTS.len();
        if is_complete && js_sys::Date::now() - ended > UPDATE.max(SPACING * duration) {
            self.begin_update();
        }
        if self.draw_next() {
            browser::breathe().await;
        }
    }

    /// Draws the dashboard, part after part. The focus stays.
    pub async fn show(self) {
        self.begin_update();
        while self.draw_next() {
            browser::breathe().await;
        }
    }

    fn begin_update(self) {
        self.drawn.set_silent(0);
        let now = self.updated.get_untracked().0;
        self.updated.set_silent((now, 0.0));
        self.snapshots.update_silent(|snapshots| self.collection.with_untracked(|all| snapshots.retain(all)));
    }

    /// Draws the next part. Returns false if all are drawn.
    fn draw_next(self) -> bool {
        let drawn = self.drawn.get_untracked();
        let Some(part) = PARTS.get(drawn) else { return false };
        let begun = js_sys::Date::now();
        let focused = browser::focused();
        self.drawn.set_silent(drawn + 1);
        if *part == Part::Quantities {
            self.quantities.set_silent(self.collection.with_untracked(Collection::quantities));
        }
        if let Some(signal) = self.parts.get(*part as usize) {
            signal.set(());
        }
        if !focused.is_empty() {
            browser::focus_in_place(&focused);
        }
        let now = js_sys::Date::now();
        let before = self.updated.get_untracked().1;
        self.updated.set_silent((now, before + now - begun));
        true
    }

    /// Removes all hand-ins.
    pub fn clear(self) {
        self.collection.update_silent(Collection::clear);
        self.computing.update_silent(Computing::end);
        self.snapshots.set(Snapshots::default());
        self.begin_update();
        while self.draw_next() {}
    }

    /// Computes the hand-ins in workers; compares them here in slices, between which the page reacts. Called again when workers
    /// have computed something, and when a hand-in was added.
    pub fn compute(self) {
        self.is_asked.set_silent(true);
        if self.is_computing.replace(true) {
            return;
        }
        self.computing.update_silent(|computing| computing.wake_by(move || self.compute()));
        wasm_bindgen_futures::spawn_local(async move {
            loop {
                self.is_asked.set_silent(false);
                let waits = self.exchange();
                let goes_on = !waits && self.work_for_a_slice();
                browser::breathe().await;
                self.show_sometimes().await;
                // Workers that have computed something have called this.
                if self.is_asked.get_untracked() {
                    continue;
                }
                if waits || !goes_on {
                    self.is_computing.set_silent(false);
                    return if !waits {
                        self.show().await
                    };
                }
            }
        });
    }

    /// Returns true while hand-ins are computed in workers.
    fn exchange(self) -> bool {
        let mut waits = false;
        self.collection.update_silent(|collection| {
            self.computing.update_silent(|computing| waits = computing.exchange(collection));
        });
        waits
    }

    /// Returns false if nothing is left to do.
    fn work_for_a_slice(self) -> bool {
        let end = js_sys::Date::now() + SLICE;
        let mut goes_on = true;
        self.collection.update_silent(|collection| {
            while goes_on && js_sys::Date::now() < end {
                goes_on = collection.advance();
            }
        });
        goes_on
    }

    /// Powers of the parameter and of the quantity that are set against each other, as typed; empty for none.
    pub fn axes(self) -> (Signal<String>, Signal<String>) {
        self.axes
    }

    /// The work collected for the wall.
    pub fn snapshots(self) -> Snapshots {
        self.snapshots.get_clone()
    }

    /// Collects a piece of work, or removes it.
    pub fn toggle(self, snapshot: Snapshot) {
        self.snapshots.update(|snapshots| snapshots.toggle(snapshot));
    }

    /// Shows a collected piece of work earlier.
    pub fn move_up(self, place: usize) {
        self.snapshots.update(|snapshots| snapshots.move_up(place));
    }

    /// True if a piece of work is collected.
    pub fn is_collected(self, snapshot: Snapshot) -> bool {
        self.snapshots.with(|snapshots| snapshots.list().contains(&snapshot))
    }

    /// Part of the collected work that the wall shows.
    pub fn wall(self) -> Wall {
        self.wall.get()
    }

    /// Changes the part of the collected work that the wall shows.
    pub fn set_wall(self, wall: Wall) {
        self.wall.set(wall);
    }

    /// Name of a pseudonym on this device; empty if there is none.
    pub fn name(self, pseudonym: &str) -> String {
        self.names.with_untracked(|names| names.get(pseudonym).cloned().unwrap_or_default())
    }

    /// Name of a pseudonym, or the pseudonym if there is none.
    pub fn called(self, pseudonym: &str) -> String {
        let name = self.name(pseudonym);
        if name.is_empty() { pseudonym.to_owned() } else { name }
    }

    /// Stores the name of a pseudonym on this device; an empty name removes it. Returns false if the browser refuses.
    pub fn set_name(self, pseudonym: &str, name: &str) -> bool {
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        self.names.update_silent(|names| {
            if name.trim().is_empty() {
                names.remove(pseudonym);
            } else {
                names.insert(pseudonym.to_owned(), name.trim().to_owned());
            }
        });
        let mut lines = String::new();
        self.names.with_untracked(|names| {
            names.iter().for_each(|(pseudonym, name)| lines.extend([pseudonym, "\t", name, "\n"]));
        });
        browser::remember(NAMES, &lines)
    }
}

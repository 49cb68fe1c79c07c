//! Pictures on the cards of the library. Each shows the scene of its document some time after the start, and moves
//! while the card is hovered or focused.
//!
//! Opening a document takes a few to some hundreds of milliseconds, longer on a cheap phone. Therefore only documents
//! in sight are opened, one after the other with pauses, not while the user types or scrolls, and the number of
//! pictures is limited.

use document::page::Source;
use play::{Play, Status};
use program::Child;
use std::cell::RefCell;
use std::rc::{Rc, Weak};
use sycamore_reactive::on_cleanup;
use units::order::sort_by_key;
use view::browser;
use view::pieces::sight::Sight;
use view::scene::picture::Picture;
use view::views::{document as page, window};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::Element;

/// Maximum number of pictures, and of pictures out of sight: those out of sight for the longest time are dropped first.
const MOST: usize = 32;
const OUT_OF_SIGHT: usize = 6;
/// Time budget for pictures per frame, in milliseconds; a started step is completed.
const WORK: f64 = 5.0;
/// A picture shows the moment after this number of ticks, each of this many seconds of wall time.
const TICKS: u32 = 50;
const TICK: f64 = 0.05;
/// A moving picture restarts after this time, in seconds, or when its rows need this many bytes.
const LONGEST: f64 = 60.0;
const ROWS: usize = 2 << 20;
/// Pause after the user has typed or scrolled, in milliseconds, in which no document is opened.
const PAUSE: f64 = 120.0;
/// After opening a document, the pause is as long as the opening took, up to this limit in milliseconds.
const LONGEST_PAUSE: f64 = 100.0;

/// All pictures of the open library.
#[derive(Clone)]
pub struct Pictures(Rc<RefCell<Gallery>>);

struct Gallery {
    /// Cards in the order of the library.
    cards: Vec<Option<Card>>,
    language: &'static str,
    /// Index of the card whose picture moves, and the time of its last frame, in milliseconds.
    moving: Option<(usize, Option<f64>)>,
    /// True if pictures may move.
    moves: bool,
    /// True if there is no hovering pointer: the card nearest to the centre of the window moves.
    by_place: bool,
    /// No document is opened before this time, in milliseconds.
    not_before: f64,
    /// Counter of cards that have gone out of sight.
    gone: u64,
    callback: Option<Closure<dyn FnMut(f64)>>,
    frame: Option<i32>,
}

struct Card {
    files: Vec<Source>,
    place: Element,
    content: Content,
    in_sight: bool,
    /// Value of the counter when it went out of sight last.
    gone: u64,
    /// Updates `in_sight`.
    _sight: Sight,
}

enum Content {
    /// Not opened yet, or dropped.
    Nothing,
    Picture(Box<Opened>),
    /// The document has errors or no scene.
    Impossible,
}

struct Opened {
    play: Play,
    picture: Picture,
    /// Element that contains the picture once it shows a moment of the run.
    place: Element,
    node: Element,
    /// Number of ticks left until it is shown.
    ahead: u32,
    /// Duration of the motion, in seconds.
    moved: f64,
}

impl Pictures {
    /// Creates an empty gallery for documents in this language. It is dropped with the view that is being built.
    pub fn new(language: &'static str) -> Self {
        let gallery = Rc::new(RefCell::new(Gallery {
            cards: Vec::new(),
            language,
            moving: None,
            moves: !browser::matches("(prefers-reduced-motion: reduce)"),
            by_place: browser::matches("(hover: none)"),
            not_before: 0.0,
            gone: 0,
            callback: None,
            frame: None,
        }));
        let own = Rc::downgrade(&gallery);
        let callback = Closure::new(move |now| with(&own, |gallery| gallery.draw(now)));
        gallery.borrow_mut().callback = Some(callback);
        let pictures = Self(gallery);
        let kept = pictures.clone();
        on_cleanup(move || kept.close());
        pictures
    }

    /// Adds the card with this index; the picture of its document is shown in `place`.
    pub fn add(&self, number: usize, files: Vec<Source>, place: &Element) {
        let own = Rc::downgrade(&self.0);
        let sight = Sight::of(place, move |in_sight| with(&own, |gallery| gallery.seen(number, in_sight)));
        let card =
            Card { files, place: place.clone(), content: Content::Nothing, in_sight: false, gone: 0, _sight: sight };
        if let Ok(mut gallery) = self.0.try_borrow_mut() {
            if gallery.cards.len() <= number {
                gallery.cards.resize_with(number + 1, || None);
            }
            if let Some(place) = gallery.cards.get_mut(number) {
                *place = Some(card);
            }
        }
    }

    /// Makes the picture of this card move, and no other one.
    pub fn attend(&self, number: usize) {
        with(&Rc::downgrade(&self.0), |gallery| {
            if !gallery.by_place {
                gallery.choose(Some(number));
            }
        });
    }

    /// Stops the picture when the pointer or the focus has left the card.
    pub fn leave(&self, number: usize) {
        with(&Rc::downgrade(&self.0), |gallery| {
            if !gallery.by_place && gallery.moving.is_some_and(|(moving, _)| moving == number) {
                gallery.choose(None);
            }
        });
    }

    /// Called when the user types or scrolls: postpones the opening of documents.
    pub fn wait(&self) {
        with(&Rc::downgrade(&self.0), |gallery| {
            gallery.not_before = gallery.not_before.max(now() + PAUSE);
            gallery.ask();
        });
    }

    fn close(&self) {
        if let Ok(mut gallery) = self.0.try_borrow_mut() {
            if let Some(frame) = gallery.frame.take() {
                let _ = window().cancel_animation_frame(frame);
            }
            gallery.cards.clear();
        }
    }
}

/// Calls `work` with the gallery, if it still exists.
fn with(gallery: &Weak<RefCell<Gallery>>, work: impl FnOnce(&mut Gallery)) {
    if let Some(gallery) = gallery.upgrade()
        && let Ok(mut gallery) = gallery.try_borrow_mut()
    {
        work(&mut gallery);
    }
}

/// Present time in milliseconds, on the clock of the frames.
fn now() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}

impl Gallery {
    /// Requests a frame, once.
    fn ask(&mut self) {
        if self.frame.is_none()
            && let Some(callback) = &self.callback
        {
            self.frame = window().request_animation_frame(callback.as_ref().unchecked_ref()).ok();
        }
    }

    fn seen(&mut self, number: usize, in_sight: bool) {
        self.gone += 1;
        let gone = self.gone;
        if let Some(card) = self.card(number) {
            (card.in_sight, card.gone) = (in_sight, gone);
        }
        self.ask();
    }

    fn card(&mut self, number: usize) -> Option<&mut Card> {
        self.cards.get_mut(number)?.as_mut()
    }

    fn opened(&mut self, number: usize) -> Option<&mut Opened> {
        match &mut self.card(number)?.content {
            Content::Picture(opened) => Some(opened),
            Content::Nothing | Content::Impossible => None,
        }
    }

    /// Makes this picture move, and no other one.
    fn choose(&mut self, number: Option<usize>) {
        let before = self.moving.map(|(moving, _)| moving);
        let number = number.filter(|_| self.moves);
        if before == number {
            return;
        }
        self.moving = number.map(|number| (number, None));
        if number.is_some() {
            self.ask();
        }
    }

    /// Handles one frame.
    fn draw(&mut self, now: f64) {
        self.frame = None;
        if self.by_place {
            let nearest = self.nearest();
            self.choose(nearest);
        }
        self.proceed(now);
        let works = self.prepare();
        let can_move = self.moving.is_some_and(|(number, _)| self.opened(number).is_some());
        if works || can_move {
            self.ask();
        }
    }

    /// Index of the visible card nearest to the centre of the window.
    fn nearest(&self) -> Option<usize> {
        let size = |length: Result<wasm_bindgen::JsValue, _>| length.ok().and_then(|length| length.as_f64());
        let (width, height) = (size(window().inner_width())?, size(window().inner_height())?);
        let seen = self.cards.iter().enumerate().filter_map(|(number, card)| {
            let bounds = card.as_ref().filter(|card| card.in_sight)?.place.get_bounding_client_rect();
            let x = bounds.left() + bounds.width() / 2.0 - width / 2.0;
            let y = bounds.top() + bounds.height() / 2.0 - height / 2.0;
            Some((x * x + y * y, number))
        });
        seen.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, number)| number)
    }

    /// Advances the moving picture, if it is ready.
    fn proceed(&mut self, now: f64) {
        let Some((number, before)) = self.moving else { return };
        let Some(opened) = self.opened(number).filter(|opened| opened.ahead == 0) else { return };
        // A late frame must not cause a jump.
        let seconds = before.map_or(0.0, |before| ((now - before) / 1000.0).clamp(0.0, 0.1));
        let goes_on = opened.proceed(seconds);
        self.moving = goes_on.then_some((number, Some(now)));
    }

    /// Works on visible pictures that are not ready. Returns true if work remains.
    fn prepare(&mut self) -> bool {
        let start = now();
        while let Some(number) = self.next() {
            let (present, not_before) = (now(), self.not_before);
            if present - start >= WORK {
                return true;
            }
            match self.opened(number) {
                Some(opened) => opened.hasten(),
                None if present < not_before => return true,
                None => {
                    self.open(number);
                    // Gives keys and pointers a chance.
                    let end = now();
                    self.not_before = end + (end - present).min(LONGEST_PAUSE);
                }
            }
        }
        false
    }

    /// Next picture to work on: a started one, otherwise a missing one if there is room for it.
    fn next(&mut self) -> Option<usize> {
        let find = |fits: fn(&Content) -> bool| {
            let fits = |card: &Option<Card>| card.as_ref().is_some_and(|card| card.in_sight && fits(&card.content));
            self.cards.iter().position(fits)
        };
        let begun = find(|content| matches!(content, Content::Picture(opened) if opened.ahead > 0));
        let missing = || find(|content| matches!(content, Content::Nothing));
        begun.or_else(missing).filter(|_| begun.is_some() || self.make_room())
    }

    /// Drops pictures that have been out of sight for the longest time. Returns true if there is room for another one.
    fn make_room(&mut self) -> bool {
        let pictures = self.cards.iter_mut().flatten().filter(|card| matches!(card.content, Content::Picture(_)));
        let (in_sight, mut hidden): (Vec<&mut Card>, Vec<&mut Card>) = pictures.partition(|card| card.in_sight);
        let room = MOST.saturating_sub(in_sight.len());
        sort_by_key(&mut hidden, |card| std::cmp::Reverse(card.gone));
        for card in hidden.into_iter().skip(room.saturating_sub(1).min(OUT_OF_SIGHT)) {
            card.content = Content::Nothing;
        }
        room > 0
    }

    fn open(&mut self, number: usize) {
        let language = self.language;
        if let Some(card) = self.card(number) {
            let opened = Opened::of(&card.files, language, &card.place);
            card.content = opened.map_or(Content::Impossible, |opened| Content::Picture(Box::new(opened)));
            if matches!(card.content, Content::Impossible) {
                let _ = card.place.set_attribute("hidden", "");
            }
        }
    }
}

impl Opened {
    /// Opens the document in one language, reduced to what its scene needs.
    fn of(files: &[Source], language: &str, place: &Element) -> Option<Self> {
        let (base, translations) = files.split_first()?;
        let own = translations.iter().find(|file| document::card(&file.text).language == language);
        let translations: Vec<&str> = own.iter().map(|file| file.text.as_str()).collect();
        let mut program = document::open(&base.text, &translations).document?.program;
        program.plots.clear();
        program.presets.clear();
        program.questions.clear();
        program.checks.clear();
        let node = page().create_element("div").ok()?;
        node.set_class_name("drawing");
        let mut scene = program.scene(language)?.clone();
        remove_texts(&mut scene.root);
        let picture = Picture::build(&scene, &node)?;
        let mut play = Play::open(program);
        play.set_language(language);
        Some(Self { play, picture, place: place.clone(), node, ahead: TICKS, moved: 0.0 })
    }

    /// Performs one tick towards the moment shown first.
    fn hasten(&mut self) {
        self.play.change_run(|line, _| line.play());
        let goes_on = self.play.change_run(|line, _| line.tick(TICK)) && self.play.time_line().is_playing();
        self.ahead = if goes_on { self.ahead.saturating_sub(1) } else { 0 };
        if self.ahead == 0 {
            self.picture.draw(&mut self.play);
            let _ = self.place.append_child(&self.node);
        }
    }

    /// Advances by `seconds` of wall time. Returns true if it can continue.
    fn proceed(&mut self, seconds: f64) -> bool {
        let rows = self.play.course().history().map_or(0, |history| history.bytes());
        self.moved += seconds;
        let has_ended = matches!(self.play.time_line().status(), Status::Ended | Status::Failed | Status::Full);
        if has_ended || self.moved > LONGEST || rows > ROWS {
            self.play.change_run(|line, basis| line.back_to_start(basis));
            self.moved = 0.0;
        }
        self.play.change_run(|line, _| line.play());
        self.play.change_run(|line, _| line.tick(seconds));
        self.picture.draw(&mut self.play);
        self.play.time_line().status() != Status::Failed || self.play.course().time() > 0.0
    }
}

/// Texts would be too small to read on a card.
fn remove_texts(element: &mut program::Element) {
    element.children.retain_mut(|child| match child {
        Child::Element(child) if child.name == "text" => false,
        Child::Element(child) => {
            remove_texts(child);
            true
        }
        Child::Text(_) => true,
    });
}

impl Drop for Opened {
    fn drop(&mut self) {
        self.node.remove();
    }
}

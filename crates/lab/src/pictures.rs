//! The pictures on the cards of the library. Each is the scene of its document some moments after the start, and moves while
//! somebody attends to its card.
//!
//! Opening a document takes from a few milliseconds to some hundreds, and more on a cheap phone. So only documents in sight are
//! opened, one after the other with pauses, not while somebody types or scrolls, and only so many pictures exist at once.

use document::page::Source;
use play::{Play, Status};
use program::Child;
use std::cell::RefCell;
use std::rc::{Rc, Weak};
use sycamore_reactive::on_cleanup;
use view::browser;
use view::picture::Picture;
use view::sight::Sight;
use view::views::{document as page, window};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::Element;

/// As many pictures exist at once, and as many of them out of sight: those that have been so for the longest time go first.
const MOST: usize = 32;
const OUT_OF_SIGHT: usize = 6;
/// A frame works on pictures for so many milliseconds, and then finishes what it has begun.
const WORK: f64 = 5.0;
/// A picture shows the moment so many ticks after the start, of so many seconds of watching each.
const TICKS: u32 = 50;
const TICK: f64 = 0.05;
/// A moving picture begins again when it has moved for so many seconds, or its rows need so many bytes.
const LONGEST: f64 = 60.0;
const ROWS: usize = 2 << 20;
/// Nothing is opened for so many milliseconds after somebody has typed or scrolled.
const PAUSE: f64 = 120.0;
/// After a document was opened there is a pause of the same length, but no longer than so many milliseconds.
const LONGEST_PAUSE: f64 = 100.0;

/// All pictures of the open library.
#[derive(Clone)]
pub struct Pictures(Rc<RefCell<Gallery>>);

struct Gallery {
    /// In the order of the library.
    cards: Vec<Option<Card>>,
    language: &'static str,
    /// The card whose picture moves, and when it was drawn last, in milliseconds.
    moving: Option<(usize, Option<f64>)>,
    /// Whether pictures may move.
    moves: bool,
    /// Whether that card moves which is nearest to the middle of the window: there is no pointer that could choose one.
    by_place: bool,
    /// No document is opened before this time, in milliseconds.
    not_before: f64,
    /// Counts what has gone out of sight.
    gone: u64,
    callback: Option<Closure<dyn FnMut(f64)>>,
    frame: Option<i32>,
}

struct Card {
    files: Vec<Source>,
    place: Element,
    content: Content,
    in_sight: bool,
    /// When it went out of sight.
    gone: u64,
    /// Reports `in_sight`.
    _sight: Sight,
}

enum Content {
    /// Not opened yet, or given up.
    Nothing,
    Picture(Box<Opened>),
    /// The document has errors or no scene.
    Impossible,
}

struct Opened {
    play: Play,
    picture: Picture,
    /// Where it is shown, once it shows a moment of the run.
    place: Element,
    node: Element,
    /// The ticks that are left until it is shown.
    ahead: u32,
    /// How long it has moved, in seconds.
    moved: f64,
}

impl Pictures {
    /// No pictures yet, for documents in this language. They go with the view that is being built.
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

    /// Adds the card with this number: the picture of a document, to be shown in `place`.
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

    /// Somebody attends to a card: its picture moves, and no other one.
    pub fn attend(&self, number: usize) {
        with(&Rc::downgrade(&self.0), |gallery| {
            if !gallery.by_place {
                gallery.choose(Some(number));
            }
        });
    }

    /// The pointer or the focus has left the card.
    pub fn leave(&self, number: usize) {
        with(&Rc::downgrade(&self.0), |gallery| {
            if !gallery.by_place && gallery.moving.is_some_and(|(moving, _)| moving == number) {
                gallery.choose(None);
            }
        });
    }

    /// Somebody types or scrolls: nothing is opened for a moment.
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

/// Works on the gallery, if it is still there.
fn with(gallery: &Weak<RefCell<Gallery>>, work: impl FnOnce(&mut Gallery)) {
    if let Some(gallery) = gallery.upgrade()
        && let Ok(mut gallery) = gallery.try_borrow_mut()
    {
        work(&mut gallery);
    }
}

/// Milliseconds, as those of frames.
fn now() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}

impl Gallery {
    /// Asks for a frame, once.
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

    /// Lets this picture move and no other one.
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

    /// One frame.
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

    /// The card in sight that is nearest to the middle of the window.
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

    /// Moves the picture that is to move, once it is there.
    fn proceed(&mut self, now: f64) {
        let Some((number, before)) = self.moving else { return };
        let Some(opened) = self.opened(number).filter(|opened| opened.ahead == 0) else { return };
        // A frame that comes late does not make it jump.
        let seconds = before.map_or(0.0, |before| ((now - before) / 1000.0).clamp(0.0, 0.1));
        let goes_on = opened.proceed(seconds);
        self.moving = goes_on.then_some((number, Some(now)));
    }

    /// Works on pictures that are in sight and not there yet. Whether there is more to do.
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
                    // Keys and pointers have their turn.
                    let end = now();
                    self.not_before = end + (end - present).min(LONGEST_PAUSE);
                }
            }
        }
        false
    }

    /// What is to be worked on: a picture that has been begun, else one that is missing, if there is room for it.
    fn next(&mut self) -> Option<usize> {
        let find = |fits: fn(&Content) -> bool| {
            let fits = |card: &Option<Card>| card.as_ref().is_some_and(|card| card.in_sight && fits(&card.content));
            self.cards.iter().position(fits)
        };
        let begun = find(|content| matches!(content, Content::Picture(opened) if opened.ahead > 0));
        let missing = || find(|content| matches!(content, Content::Nothing));
        begun.or_else(missing).filter(|_| begun.is_some() || self.make_room())
    }

    /// Gives up pictures that have been out of sight for a long time. Whether one more may exist then.
    fn make_room(&mut self) -> bool {
        let pictures = self.cards.iter_mut().flatten().filter(|card| matches!(card.content, Content::Picture(_)));
        let (in_sight, mut hidden): (Vec<&mut Card>, Vec<&mut Card>) = pictures.partition(|card| card.in_sight);
        let room = MOST.saturating_sub(in_sight.len());
        hidden.sort_by_key(|card| std::cmp::Reverse(card.gone));
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
    /// The document in one language; of everything in it only what its scene needs.
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

    /// One tick towards the moment that is shown first.
    fn hasten(&mut self) {
        self.play.play();
        let goes_on = self.play.tick(TICK) && self.play.is_playing();
        self.ahead = if goes_on { self.ahead.saturating_sub(1) } else { 0 };
        if self.ahead == 0 {
            self.picture.draw(&mut self.play);
            let _ = self.place.append_child(&self.node);
        }
    }

    /// Moves on. Whether it can.
    fn proceed(&mut self, seconds: f64) -> bool {
        let rows = self.play.course().history().map_or(0, |history| history.bytes());
        self.moved += seconds;
        let has_ended = matches!(self.play.status(), Status::Ended | Status::Failed | Status::Full);
        if has_ended || self.moved > LONGEST || rows > ROWS {
            self.play.back_to_start();
            self.moved = 0.0;
        }
        self.play.play();
        self.play.tick(seconds);
        self.picture.draw(&mut self.play);
        self.play.status() != Status::Failed || self.play.time() > 0.0
    }
}

/// On a card they would be too small to be read.
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

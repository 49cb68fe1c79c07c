//! Display of single frames of the open film: the last one requested, with a cache of recent ones.

use super::decoder::Reader;
use super::picture::{Greys, Picture};
use super::source::Source;
use super::trouble::Trouble;
use film::Plane;
use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::Rc;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::HtmlCanvasElement;

/// Maximum size of the cached pictures in bytes, at four bytes per pixel.
const BYTES: usize = 48 << 20;
/// Number of preceding frames that are decoded together when stepping backwards.
const BACK: usize = 6;

/// Pictures of the open film.
pub struct Player {
    /// Open film.
    pub source: Rc<Source>,
    /// Canvas with the frame. It outlives the views.
    pub canvas: HtmlCanvasElement,
    reader: RefCell<Option<Reader>>,
    kept: RefCell<VecDeque<(usize, Rc<Picture>)>>,
    wanted: Cell<usize>,
    painted: Cell<Option<usize>>,
    working: Cell<bool>,
}

impl Player {
    /// Player of an opened film.
    pub fn new(source: Rc<Source>) -> Option<Rc<Self>> {
        let canvas: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
        let [width, height] = source.film.display_size();
        canvas.set_width(width.round() as u32);
        canvas.set_height(height.round() as u32);
        canvas.set_id("film-picture");
        let _ = canvas.set_attribute("aria-hidden", "true");
        let reader = RefCell::new(Some(Reader::new(source.clone())));
        Some(Rc::new(Self {
            source,
            canvas,
            reader,
            kept: RefCell::default(),
            wanted: Cell::new(0),
            painted: Cell::new(None),
            working: Cell::new(false),
        }))
    }

    /// Width and height of the upright picture, px.
    pub fn size(&self) -> [f64; 2] {
        [self.canvas.width(), self.canvas.height()].map(f64::from)
    }

    /// Shows a frame once it is decoded. Of several requests meanwhile, only the last is served. `painted` is called
    /// with each frame shown, or with the error that prevented it.
    pub fn show(self: &Rc<Self>, frame: usize, painted: impl Fn(usize, Option<Trouble>) + 'static) {
        self.wanted.set(frame);
        if self.working.replace(true) {
            return;
        }
        let player = self.clone();
        wasm_bindgen_futures::spawn_local(async move {
            while player.painted.get() != Some(player.wanted.get()) {
                let frame = player.wanted.get();
                let trouble = match player.picture(frame).await {
                    Ok(picture) => {
                        picture.paint(&player.canvas, player.source.film.orientation);
                        None
                    }
                    Err(trouble) => Some(trouble),
                };
                player.painted.set(Some(frame));
                painted(frame, trouble);
            }
            player.working.set(false);
        });
    }

    /// Grey values of a frame as stored.
    ///
    /// # Errors
    ///
    /// A [`Trouble`] if the frame cannot be decoded.
    pub async fn plane(&self, frame: usize) -> Result<Plane, Trouble> {
        let picture = self.picture(frame).await?;
        Greys::of(&self.source).read(&picture).await.ok_or(Trouble::Frame(frame + 1))
    }

    async fn picture(&self, frame: usize) -> Result<Rc<Picture>, Trouble> {
        if let Some(picture) = self.at_hand(frame) {
            return Ok(picture);
        }
        // If the reader is in use elsewhere, a second one decodes this frame.
        let shared = self.reader.borrow_mut().take();
        let is_shared = shared.is_some();
        let mut reader = shared.unwrap_or_else(|| Reader::new(self.source.clone()));
        let backwards = self.painted.get().is_some_and(|painted| painted > frame);
        let mut found = Err(Trouble::Closed);
        for at in if backwards { frame.saturating_sub(BACK)..=frame } else { frame..=frame } {
            found = match reader.picture(at).await {
                Ok(picture) => picture.kept().await.map(Rc::new).ok_or(Trouble::Frame(at + 1)),
                Err(trouble) => Err(trouble),
            };
            if let Ok(picture) = &found {
                self.keep(at, picture.clone());
            }
        }
        if is_shared {
            *self.reader.borrow_mut() = Some(reader);
        }
        found
    }

    fn at_hand(&self, frame: usize) -> Option<Rc<Picture>> {
        self.kept.borrow().iter().find(|(at, _)| *at == frame).map(|(_, picture)| picture.clone())
    }

    fn keep(&self, frame: usize, picture: Rc<Picture>) {
        let [width, height] = picture.size();
        let most = (BYTES / (4 * width * height).max(1)).clamp(BACK + 2, 60);
        let mut kept = self.kept.borrow_mut();
        kept.retain(|(at, _)| *at != frame);
        kept.push_back((frame, picture));
        while kept.len() > most {
            kept.pop_front();
        }
    }
}

//! Decoding of the pictures of a film, in order or single ones.

use super::codecs::{self, EncodedVideoChunk, VideoDecoder, VideoFrame};
use super::picture::Picture;
use super::source::{Source, object};
use super::trouble::Trouble;
use film::containers::Coding;
use js_sys::Array;
use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::future::poll_fn;
use std::rc::Rc;
use std::task::{Poll, Waker};
use view::browser;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Blob;

/// Maximum number of encoded frames in the queue of the decoder.
const QUEUE: u32 = 8;
/// Maximum number of decoded pictures not yet taken. Each holds memory of the decoder.
const READY: usize = 3;
/// Maximum number of decoders created for one frame. A browser may reclaim a decoder, for instance from a hidden page.
const ATTEMPTS: usize = 3;
/// Difference of successive time stamps, microseconds. Time stamps serve only as identifiers.
const TICK: f64 = 10_000.0;

/// Reader of pictures. Reading in order is fast; otherwise decoding restarts at a key frame.
pub struct Reader {
    source: Rc<Source>,
    run: Option<Run>,
}

impl Reader {
    /// A reader of a film.
    pub fn new(source: Rc<Source>) -> Self {
        Self { source, run: None }
    }

    /// Picture of a frame.
    ///
    /// # Errors
    ///
    /// A [`Trouble`] if the file cannot be read, or the decoder does not deliver this frame.
    pub async fn picture(&mut self, frame: usize) -> Result<Picture, Trouble> {
        if let Some(plane) = self.source.plane(frame) {
            return Ok(Picture::Grey(plane));
        }
        let lost = Trouble::Frame(frame + 1);
        let sample = self.source.sample_of(frame).ok_or_else(|| lost.clone())?;
        if self.source.film.codec.coding == Coding::Jpeg {
            return still(&self.source, sample).await.ok_or(lost);
        }
        let key = self.source.film.key_before(sample);
        let mut from = key;
        for _ in 0..ATTEMPTS {
            let run = match self.run.take().filter(|run| run.leads_to(frame, key)) {
                Some(run) => run,
                None => Run::begin(&self.source, from).ok_or_else(|| lost.clone())?,
            };
            let (run, found) = run.find(&self.source, frame).await?;
            self.run = run;
            if let Some(picture) = found {
                return Ok(picture);
            }
            // Pictures between two key frames may depend on those before the first.
            from = self.source.film.key_before(from.saturating_sub(1));
        }
        Err(lost)
    }
}

/// Picture of a film that consists of still pictures.
async fn still(source: &Source, sample: usize) -> Option<Picture> {
    let bytes = source.sample(sample).await.ok()?;
    let blob = Blob::new_with_u8_array_sequence(&Array::of1(&bytes)).ok()?;
    let bitmap = browser::wait(codecs::create_image_bitmap(&blob).ok()?).await.ok()?;
    Some(Picture::Bitmap(bitmap.dyn_into().ok()?))
}

/// Results of the decoder callbacks.
#[derive(Default)]
struct Mailbox {
    ready: RefCell<VecDeque<VideoFrame>>,
    failed: Cell<bool>,
    flushed: Cell<bool>,
    closed: Cell<bool>,
    news: Cell<bool>,
    waker: RefCell<Option<Waker>>,
}

impl Mailbox {
    fn wake(&self) {
        self.news.set(true);
        if let Some(waker) = self.waker.take() {
            waker.wake();
        }
    }

    /// Waits until something has happened since the last call.
    async fn wait(&self) {
        poll_fn(|context| {
            if self.news.take() {
                return Poll::Ready(());
            }
            *self.waker.borrow_mut() = Some(context.waker().clone());
            Poll::Pending
        })
        .await;
    }
}

/// Decoder that proceeds from a key frame through the film.
struct Run {
    decoder: VideoDecoder,
    mailbox: Rc<Mailbox>,
    /// Index of the next sample to be decoded.
    next: usize,
    /// First frame that has not been delivered.
    frame: usize,
    flushing: bool,
    callbacks: Option<Callbacks>,
}

/// Callbacks of the decoder.
struct Callbacks {
    output: Closure<dyn FnMut(VideoFrame)>,
    error: Closure<dyn FnMut(JsValue)>,
    dequeue: Closure<dyn FnMut()>,
}

impl Run {
    /// Starts a decoder at a key frame.
    fn begin(source: &Source, key: usize) -> Option<Self> {
        let mailbox = Rc::<Mailbox>::default();
        let place = mailbox.clone();
        let output = Closure::<dyn FnMut(VideoFrame)>::new(move |frame: VideoFrame| {
            if place.closed.get() {
                return frame.close();
            }
            place.ready.borrow_mut().push_back(frame);
            place.wake();
        });
        let place = mailbox.clone();
        let error = Closure::<dyn FnMut(JsValue)>::new(move |_| {
            place.failed.set(true);
            place.wake();
        });
        let place = mailbox.clone();
        let dequeue = Closure::<dyn FnMut()>::new(move || place.wake());
        let callbacks = Callbacks { output, error, dequeue };
        let reactions = [("output", callbacks.output.as_ref().clone()), ("error", callbacks.error.as_ref().clone())];
        let decoder = VideoDecoder::new(&object(&reactions)).ok()?;
        decoder.set_ondequeue(Some(callbacks.dequeue.as_ref().unchecked_ref()));
        decoder.configure(&source.configuration()).ok()?;
        Some(Self { decoder, mailbox, next: key, frame: 0, flushing: false, callbacks: Some(callbacks) })
    }

    /// True if this decoder reaches `frame` sooner than a new one that starts at the sample `key`.
    fn leads_to(&self, frame: usize, key: usize) -> bool {
        frame >= self.frame && self.next >= key && !self.mailbox.failed.get()
            || frame >= self.frame && self.next + QUEUE as usize >= key
    }

    /// Decodes up to a frame. Without a picture, the decoder does not deliver the frame.
    async fn find(mut self, source: &Source, frame: usize) -> Result<(Option<Self>, Option<Picture>), Trouble> {
        loop {
            while let Some(picture) = self.take() {
                let Some(found) = source.frame_of((picture.timestamp() / TICK).round() as usize) else {
                    picture.close();
                    continue;
                };
                self.frame = found + 1;
                if found == frame {
                    return Ok((Some(self), Some(Picture::Frame(picture))));
                }
                picture.close();
                if found > frame {
                    return Ok((None, None));
                }
            }
            if self.mailbox.failed.get() || self.mailbox.flushed.get() {
                return Ok((None, None));
            }
            if !self.feed(source).await? {
                self.mailbox.wait().await;
            }
        }
    }

    fn take(&self) -> Option<VideoFrame> {
        self.mailbox.ready.borrow_mut().pop_front()
    }

    /// Passes the next sample to the decoder. Returns false if the queue is full or the film has ended.
    async fn feed(&mut self, source: &Source) -> Result<bool, Trouble> {
        if self.flushing || self.decoder.decode_queue_size() >= QUEUE || self.mailbox.ready.borrow().len() >= READY {
            return Ok(false);
        }
        let (at, samples) = (self.next, &source.film.samples);
        let Some((sample, rank)) = samples.get(at).zip(source.rank_of(at)) else {
            self.flushing = true;
            let mailbox = self.mailbox.clone();
            if let Ok(promise) = self.decoder.flush() {
                wasm_bindgen_futures::spawn_local(async move {
                    // The promise is rejected if the decoder is closed first.
                    let _ = browser::wait(promise).await;
                    mailbox.flushed.set(true);
                    mailbox.wake();
                });
            } else {
                self.mailbox.failed.set(true);
            }
            return Ok(false);
        };
        let bytes = source.sample(at).await?;
        let kind = if sample.key { "key" } else { "delta" };
        let parts = [("type", kind.into()), ("timestamp", (rank as f64 * TICK).into()), ("data", bytes.into())];
        let given = EncodedVideoChunk::new(&object(&parts)).and_then(|chunk| self.decoder.decode(&chunk));
        if given.is_err() {
            self.mailbox.failed.set(true);
        }
        self.next += 1;
        Ok(true)
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        self.mailbox.closed.set(true);
        self.decoder.set_ondequeue(None);
        // A failed decoder is already closed.
        let _ = self.decoder.close();
        self.mailbox.ready.borrow_mut().drain(..).for_each(|frame| frame.close());
        // Pending calls still find the callbacks.
        let callbacks = self.callbacks.take();
        wasm_bindgen_futures::spawn_local(async move {
            browser::breathe().await;
            drop(callbacks);
        });
    }
}

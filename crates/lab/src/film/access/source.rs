//! A film in a file that the browser gives in ranges: what it says of itself, and the bytes of its frames.

use super::codecs;
use super::trouble::Trouble;
use film::Plane;
use film::containers::{Coding, Film, FilmError, Opening};
use js_sys::{Object, Reflect, Uint8Array};
use std::cell::RefCell;
use std::ops::Range;
use std::rc::Rc;
use view::browser;
use wasm_bindgen::JsValue;
use web_sys::File;

/// So many bytes are read at once: some hundred coded frames.
const AHEAD: u64 = 1 << 20;
/// The identity of a film is found from so many bytes.
const BEGINNING: u64 = 1 << 20;

/// Where the pictures of a film are.
enum Content {
    /// In a file, coded.
    File(File),
    /// In memory, in the order in which they are shown.
    Planes(Vec<Rc<Plane>>),
}

/// A film that has been opened.
pub struct Source {
    content: Content,
    /// What its container says.
    pub film: Film,
    /// The place in `film.samples` of each frame that is shown.
    samples: Vec<usize>,
    /// Of each sample its place in the order of time among all of them, which its decoded picture carries as a time stamp.
    ranks: Vec<usize>,
    /// Of each rank the frame, if it is shown.
    frames: Vec<Option<usize>>,
    /// The bytes that were read last, and where they begin.
    piece: RefCell<Option<(u64, Uint8Array)>>,
}

impl Source {
    /// Reads the headers of a film and asks the browser whether it can decode it.
    ///
    /// # Errors
    ///
    /// The file is no film, or one that this browser cannot decode.
    pub async fn open(file: File) -> Result<Self, Trouble> {
        let size = file.size() as u64;
        let mut opening = Opening::new(size);
        let film = loop {
            match opening {
                Opening::Needs(request) => {
                    let bytes = read(&file, request.range()).await?;
                    opening = request.supply(bytes.to_vec());
                }
                Opening::Done(film) => break *film?,
            }
        };
        let source = Self::new(Content::File(file), film);
        source.check().await?;
        Ok(source)
    }

    /// A film that has been drawn.
    pub fn drawn(film: Film, planes: Vec<Plane>) -> Self {
        Self::new(Content::Planes(planes.into_iter().map(Rc::new).collect()), film)
    }

    fn new(content: Content, film: Film) -> Self {
        let samples = film.shown();
        let mut order: Vec<usize> = (0..film.samples.len()).collect();
        order.sort_by_key(|&at| film.samples[at].ticks);
        let mut ranks = vec![0; order.len()];
        order.iter().enumerate().for_each(|(rank, &at)| ranks[at] = rank);
        let mut frames = vec![None; order.len()];
        samples.iter().enumerate().for_each(|(frame, &at)| frames[ranks[at]] = Some(frame));
        Self { content, film, samples, ranks, frames, piece: RefCell::default() }
    }

    /// The picture of a frame that is in memory.
    pub fn plane(&self, frame: usize) -> Option<Rc<Plane>> {
        match &self.content {
            Content::File(_) => None,
            Content::Planes(planes) => planes.get(frame).cloned(),
        }
    }

    fn file(&self) -> Option<&File> {
        match &self.content {
            Content::File(file) => Some(file),
            Content::Planes(_) => None,
        }
    }

    /// Whether the browser has a decoder.
    async fn check(&self) -> Result<(), Trouble> {
        let coding = self.film.codec.coding;
        let no_decoder = || FilmError::NoDecoder(self.film.codec.clone()).into();
        if coding == Coding::Jpeg {
            return Ok(());
        }
        if !coding.is_in_browsers() {
            return Err(no_decoder());
        }
        if !codecs::are_offered() {
            return Err(Trouble::Insecure);
        }
        let supported = match codecs::VideoDecoder::is_config_supported(&self.configuration()) {
            Ok(promise) => browser::wait(promise).await.ok(),
            Err(_) => None,
        };
        let supported = supported.and_then(|answer| Reflect::get(&answer, &"supported".into()).ok());
        if supported.is_some_and(|supported| supported.is_truthy()) { Ok(()) } else { Err(no_decoder()) }
    }

    /// What a decoder is configured with.
    pub fn configuration(&self) -> JsValue {
        let codec = &self.film.codec;
        let [width, height] = self.film.size.map(JsValue::from);
        let mut parts = vec![("codec", codec.name.as_str().into()), ("codedWidth", width), ("codedHeight", height)];
        if !codec.description.is_empty() {
            parts.push(("description", Uint8Array::from(&codec.description[..]).into()));
        }
        object(&parts)
    }

    /// The name of the file.
    pub fn name(&self) -> String {
        self.file().map(File::name).unwrap_or_default()
    }

    /// Its size in bytes.
    pub fn bytes(&self) -> u64 {
        self.file().map_or(0, |file| file.size() as u64)
    }

    /// Its first bytes, from which it is known again.
    ///
    /// # Errors
    ///
    /// The file cannot be read any more.
    pub async fn beginning(&self) -> Result<Vec<u8>, Trouble> {
        let file = self.file().ok_or(Trouble::Unreadable)?;
        Ok(read(file, 0..BEGINNING.min(self.bytes())).await?.to_vec())
    }

    /// How many frames are shown.
    pub fn count(&self) -> usize {
        self.samples.len()
    }

    /// The sample of a frame.
    pub fn sample_of(&self, frame: usize) -> Option<usize> {
        self.samples.get(frame).copied()
    }

    /// The rank of a sample.
    pub fn rank_of(&self, sample: usize) -> Option<usize> {
        self.ranks.get(sample).copied()
    }

    /// The frame of a rank, if it is shown.
    pub fn frame_of(&self, rank: usize) -> Option<usize> {
        self.frames.get(rank).copied().flatten()
    }

    /// The coded bytes of a sample; further ones are read with them.
    ///
    /// # Errors
    ///
    /// The file cannot be read any more.
    pub async fn sample(&self, at: usize) -> Result<Uint8Array, Trouble> {
        let sample = self.film.samples.get(at).ok_or(Trouble::Unreadable)?;
        let range = sample.offset..sample.offset + u64::from(sample.size);
        if let Some(bytes) = self.at_hand(&range) {
            return Ok(bytes);
        }
        let wide = range.start..range.end.max((range.start + AHEAD).min(self.bytes()));
        let bytes = read(self.file().ok_or(Trouble::Unreadable)?, wide).await?;
        *self.piece.borrow_mut() = Some((range.start, bytes));
        self.at_hand(&range).ok_or(Trouble::Unreadable)
    }

    fn at_hand(&self, range: &Range<u64>) -> Option<Uint8Array> {
        let piece = self.piece.borrow();
        let (start, bytes) = piece.as_ref()?;
        let from = u32::try_from(range.start.checked_sub(*start)?).ok()?;
        let to = u32::try_from(range.end.checked_sub(*start)?).ok()?;
        (to <= bytes.length()).then(|| bytes.subarray(from, to))
    }
}

/// The bytes of a range of a file.
async fn read(file: &File, range: Range<u64>) -> Result<Uint8Array, Trouble> {
    let part = file.slice_with_f64_and_f64(range.start as f64, range.end as f64).map_err(|_| Trouble::Unreadable)?;
    let buffer = browser::wait(part.array_buffer()).await.map_err(|_| Trouble::Unreadable)?;
    Ok(Uint8Array::new(&buffer))
}

/// A plain object with these properties.
pub fn object(parts: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in parts {
        // A plain object takes everything.
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object.into()
}

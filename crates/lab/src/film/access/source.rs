//! Film in a file that the browser reads in ranges: its description and the bytes of its frames.

use super::codecs;
use super::trouble::Trouble;
use film::Plane;
use film::containers::{Coding, Film, FilmError, Opening};
use js_sys::{Object, Reflect, Uint8Array};
use std::cell::RefCell;
use std::ops::Range;
use std::rc::Rc;
use units::order::sort_by_key;
use view::browser;
use wasm_bindgen::JsValue;
use web_sys::File;

/// Number of bytes read at once: several hundred encoded frames.
const AHEAD: u64 = 1 << 20;
/// Number of bytes that identify a film.
const BEGINNING: u64 = 1 << 20;

/// Storage of the pictures.
enum Content {
    /// Encoded in a file.
    File(File),
    /// In memory, in order of presentation.
    Planes(Vec<Rc<Plane>>),
}

/// Opened film.
pub struct Source {
    content: Content,
    /// Description by the container.
    pub film: Film,
    /// Index in `film.samples` of each shown frame.
    samples: Vec<usize>,
    /// Rank in time of each sample among all samples. It is the time stamp of the decoded picture.
    ranks: Vec<usize>,
    /// Frame of each rank, if it is shown.
    frames: Vec<Option<usize>>,
    /// Bytes read last, with their offset in the file.
    piece: RefCell<Option<(u64, Uint8Array)>>,
}

impl Source {
    /// Reads the headers of a film and checks that the browser can decode it.
    ///
    /// # Errors
    ///
    /// A [`Trouble`] if the file is not a film, or this browser cannot decode it.
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

    /// Film of drawn pictures.
    pub fn drawn(film: Film, planes: Vec<Plane>) -> Self {
        Self::new(Content::Planes(planes.into_iter().map(Rc::new).collect()), film)
    }

    fn new(content: Content, film: Film) -> Self {
        let samples = film.shown();
        let mut order: Vec<usize> = (0..film.samples.len()).collect();
        sort_by_key(&mut order, |&at| film.samples[at].ticks);
        let mut ranks = vec![0; order.len()];
        order.iter().enumerate().for_each(|(rank, &at)| ranks[at] = rank);
        let mut frames = vec![None; order.len()];
        samples.iter().enumerate().for_each(|(frame, &at)| frames[ranks[at]] = Some(frame));
        Self { content, film, samples, ranks, frames, piece: RefCell::default() }
    }

    /// Picture of a frame in memory.
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

    /// Checks that the browser has a decoder.
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

    /// Configuration of the decoder.
    pub fn configuration(&self) -> JsValue {
        let codec = &self.film.codec;
        let [width, height] = self.film.size.map(JsValue::from);
        let mut parts = vec![("codec", codec.name.as_str().into()), ("codedWidth", width), ("codedHeight", height)];
        if !codec.description.is_empty() {
            parts.push(("description", Uint8Array::from(&codec.description[..]).into()));
        }
        object(&parts)
    }

    /// Name of the file; empty for a drawn film.
    pub fn name(&self) -> String {
        self.file().map(File::name).unwrap_or_default()
    }

    /// Size of the file in bytes; 0 for a drawn film.
    pub fn bytes(&self) -> u64 {
        self.file().map_or(0, |file| file.size() as u64)
    }

    /// First bytes of the file, which identify the film.
    ///
    /// # Errors
    ///
    /// [`Trouble::Unreadable`] if the file cannot be read any more.
    pub async fn beginning(&self) -> Result<Vec<u8>, Trouble> {
        let file = self.file().ok_or(Trouble::Unreadable)?;
        Ok(read(file, 0..BEGINNING.min(self.bytes())).await?.to_vec())
    }

    /// Number of shown frames.
    pub fn count(&self) -> usize {
        self.samples.len()
    }

    /// Index of the sample of a frame.
    pub fn sample_of(&self, frame: usize) -> Option<usize> {
        self.samples.get(frame).copied()
    }

    /// Rank in time of a sample.
    pub fn rank_of(&self, sample: usize) -> Option<usize> {
        self.ranks.get(sample).copied()
    }

    /// Frame of a rank, if it is shown.
    pub fn frame_of(&self, rank: usize) -> Option<usize> {
        self.frames.get(rank).copied().flatten()
    }

    /// Encoded bytes of a sample. Following bytes are read ahead.
    ///
    /// # Errors
    ///
    /// [`Trouble::Unreadable`] if the file cannot be read any more.
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

/// Bytes of a range of a file.
async fn read(file: &File, range: Range<u64>) -> Result<Uint8Array, Trouble> {
    let part = file.slice_with_f64_and_f64(range.start as f64, range.end as f64).map_err(|_| Trouble::Unreadable)?;
    let buffer = browser::wait(part.array_buffer()).await.map_err(|_| Trouble::Unreadable)?;
    Ok(Uint8Array::new(&buffer))
}

/// JavaScript object with these properties.
pub fn object(parts: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in parts {
        // Setting a property of a plain object does not fail.
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object.into()
}

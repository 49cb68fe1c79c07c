//! Opening a film: what its file says, without its pixels.

use crate::failure::Failure;
use film::calibration::Rotation;
use film::containers::{Film, FilmError, MOST_SAMPLES, Notice, Opening};
use film::y4m;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use units::{Words, words};

/// How a film of this kind begins.
const Y4M: &[u8] = b"YUV4MPEG2";
/// Bytes that are read at once.
const CHUNK: usize = 1 << 20;

/// A film as its file describes it.
#[derive(Debug)]
pub struct Opened {
    /// Its file.
    pub path: PathBuf,
    /// Its size in bytes.
    pub bytes: u64,
    /// The name of its coding.
    pub coding: String,
    /// Where its pixels come from.
    pub pixels: Pixels,
    /// Width and height of the picture as it is stored, with square pixels.
    pub size: [usize; 2],
    /// How it must be turned to be upright.
    pub rotation: Rotation,
    /// Whether left and right of the stored picture are exchanged.
    pub mirrored: bool,
    /// When each frame is shown, in seconds.
    pub times: Vec<f64>,
    /// Frames a second, if the file states them apart from the times.
    pub stated_rate: Option<f64>,
    /// Frames that the camera took in a second, if the file says so.
    pub capture_rate: Option<f64>,
    /// True if the file is cut or damaged: `ffmpeg` may then decode more frames than are whole.
    pub cut: bool,
    /// What a person should know about the file.
    pub notes: Vec<Words>,
}

/// Where pixels come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// The file holds grey values as they are.
    Plain,
    /// `ffmpeg` decodes them.
    Coded,
}

impl Opened {
    /// Opens a film, whatever its format.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let mut file = File::open(path).map_err(failure)?;
        let metadata = file.metadata().map_err(failure)?;
        if metadata.is_dir() {
            return Err(refused(path, words("it is a folder", "es una carpeta")));
        }
        let mut start = Vec::new();
        Read::by_ref(&mut file).take(Y4M.len() as u64).read_to_end(&mut start).map_err(failure)?;
        file.rewind().map_err(failure)?;
        let bytes = metadata.len();
        if start == Y4M { Self::plain(path, file, bytes) } else { Self::coded(path, file, bytes) }
    }

    fn coded(path: &Path, mut file: File, bytes: u64) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let mut opening = Opening::new(bytes);
        let film = loop {
            match opening {
                Opening::Done(result) => break result.map_err(|error| refused(path, error.words()))?,
                Opening::Needs(request) => {
                    let range = request.range();
                    let mut part = Vec::new();
                    file.seek(SeekFrom::Start(range.start)).map_err(failure)?;
                    let wanted = range.end - range.start;
                    Read::by_ref(&mut file).take(wanted).read_to_end(&mut part).map_err(failure)?;
                    opening = request.supply(part);
                }
            }
        };
        Ok(Self::of(path, &film, bytes))
    }

    fn of(path: &Path, film: &Film, bytes: u64) -> Self {
        let upright = film.display_size();
        let stored = film.orientation.upright_size(upright);
        let rotation = match film.orientation.quarter_turns % 4 {
            0 => Rotation::None,
            1 => Rotation::Quarter,
            2 => Rotation::Half,
            _ => Rotation::ThreeQuarters,
        };
        let mut notes: Vec<Words> = film.notices.iter().map(Notice::words).collect();
        let ([width, height], coding) = (upright.map(f64::round), film.codec.label().to_owned());
        notes.insert(0, words!("{coding}, {width} x {height} pixels", "{coding}, {width} x {height} píxeles"));
        Self {
            path: path.to_owned(),
            bytes,
            coding,
            pixels: Pixels::Coded,
            size: stored.map(|side| side.round() as usize),
            rotation,
            mirrored: film.orientation.mirrored,
            times: film.times(),
            stated_rate: film.stated_rate,
            capture_rate: film.capture_rate,
            cut: film.notices.iter().any(|notice| matches!(notice, Notice::Truncated { .. } | Notice::Broken { .. })),
            notes,
        }
    }

    /// A Y4M film, whose frames are counted by reading it once.
    fn plain(path: &Path, file: File, bytes: u64) -> Result<Self, Failure> {
        let mut frames = Frames::new(path.to_owned(), file);
        let mut count = 0_usize;
        while frames.next()?.is_some() {
            count += 1;
            if count > MOST_SAMPLES {
                return Err(refused(path, FilmError::TooLarge.words()));
            }
        }
        let Some(header) = frames.reader.header() else {
            return Err(refused(path, y4m::Fault::Signature.words()));
        };
        let Some(rate) = header.rate else {
            return Err(refused(
                path,
                words(
                    "its header states no frame rate; convert the film again with one, as `ffmpeg -r 30` does",
                    "su cabecera no indica una frecuencia de fotogramas; convierte el vídeo de nuevo con una, como hace `ffmpeg -r 30`",
                ),
            ));
        };
        if count == 0 {
            return Err(refused(path, FilmError::NoFrames.words()));
        }
        let (width, height) = (header.width, header.height);
        Ok(Self {
            path: path.to_owned(),
            bytes,
            coding: "Y4M".to_owned(),
            pixels: Pixels::Plain,
            size: [width, height],
            rotation: Rotation::None,
            mirrored: false,
            // The format has nothing but a rate.
            times: (0..count).map(|frame| frame as f64 / rate).collect(),
            stated_rate: None,
            capture_rate: None,
            cut: false,
            notes: vec![words!("Y4M, {width} x {height} pixels", "Y4M, {width} x {height} píxeles")],
        })
    }

    /// Width and height of the picture as it is seen upright.
    pub fn upright_size(&self) -> [f64; 2] {
        let [width, height] = self.stored_size();
        match self.rotation {
            Rotation::None | Rotation::Half => [width, height],
            Rotation::Quarter | Rotation::ThreeQuarters => [height, width],
        }
    }

    /// Where a point of the upright picture is in the stored one.
    pub fn stored(&self, point: [f64; 2]) -> [f64; 2] {
        self.rotation.undo(point, self.stored_size())
    }

    /// Where a point of the stored picture is in the upright one.
    pub fn upright(&self, point: [f64; 2]) -> [f64; 2] {
        self.rotation.apply(point, self.stored_size())
    }

    fn stored_size(&self) -> [f64; 2] {
        self.size.map(|side| side as f64)
    }
}

/// The frames of a stream in the format Y4M.
pub struct Frames<R> {
    path: PathBuf,
    source: R,
    reader: y4m::Reader,
    bytes: Vec<u8>,
    /// How many of the bytes were used.
    used: usize,
}

impl<R: Read> Frames<R> {
    /// Before the first frame. The path stands in messages.
    pub fn new(path: PathBuf, source: R) -> Self {
        Self { path, source, reader: y4m::Reader::default(), bytes: Vec::new(), used: 0 }
    }

    /// The next frame; `None` at the end.
    pub fn next(&mut self) -> Result<Option<film::Plane>, Failure> {
        loop {
            let mut rest = self.bytes.get(self.used..).unwrap_or_default();
            let frame = self.reader.frame(&mut rest).map_err(|fault| refused(&self.path, fault.words()))?;
            self.used = self.bytes.len() - rest.len();
            if frame.is_some() {
                return Ok(frame);
            }
            self.bytes.resize(CHUNK, 0);
            let read = self.source.read(&mut self.bytes).map_err(|error| Failure::file("read", &self.path, &error))?;
            self.bytes.truncate(read);
            self.used = 0;
            if read == 0 {
                return Ok(None);
            }
        }
    }
}

/// A film that is not tracked, and why.
pub fn refused(path: &Path, why: Words) -> Failure {
    Failure::Request { message: named(path, why), hint: None }
}

/// The same, and what to do.
pub fn refused_with(path: &Path, why: Words, hint: Words) -> Failure {
    Failure::in_words(named(path, why), hint)
}

fn named(path: &Path, why: Words) -> Words {
    let name = Words::same(path.display().to_string());
    words!("{name}: {why}", "{name}: {why}", name = name, why = why)
}

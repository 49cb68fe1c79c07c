//! Pixels of a film, from `ffmpeg` or from the file.

use super::opened::{Frames, Opened, Pixels, refused};
use crate::failure::Failure;
use film::{Colour, Plane};
use std::fs::File;
use std::io::{ErrorKind, Read, Seek};
use std::process::{Child, ChildStdout, Command, Stdio};
use units::{Words, words};

/// Maximum length of the error output of `ffmpeg` that is read, bytes.
const COMPLAINT: u64 = 4096;

/// Decoder of the frames of a film in order.
pub enum Decoding {
    /// Reads the file.
    Plain(Frames<File>),
    /// Runs `ffmpeg`.
    Coded(Box<Decoder>),
}

/// Running `ffmpeg`, terminated when dropped.
pub struct Decoder {
    child: Child,
    frames: Frames<ChildStdout>,
    /// Error output: a file, since it is not read while `ffmpeg` runs.
    complaints: File,
    mirrored: bool,
}

impl Drop for Decoder {
    fn drop(&mut self) {
        // It has ended, or the remaining frames are not needed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Decoding {
    /// Starts at the first frame and stops after `most` frames, if given. `coloured`: decodes colours.
    pub fn begin(film: &Opened, most: Option<usize>, coloured: bool) -> Result<Self, Failure> {
        let failure = |error| Failure::file("read", &film.path, &error);
        match film.pixels {
            Pixels::Plain => Ok(Self::Plain(Frames::new(film.path.clone(), File::open(&film.path).map_err(failure)?))),
            Pixels::Coded => Ok(Self::Coded(Box::new(Decoder::begin(film, most, coloured)?))),
        }
    }

    /// Next frame; `None` at the end.
    pub fn next(&mut self) -> Result<Option<Plane>, Failure> {
        match self {
            Self::Plain(frames) => frames.next(),
            Self::Coded(decoder) => {
                let plane = decoder.frames.next()?;
                Ok(if decoder.mirrored { plane.and_then(|plane| mirrored(&plane)) } else { plane })
            }
        }
    }

    /// Failure with the reason `why`, and with the error output of `ffmpeg` as hint.
    pub fn failure(&mut self, film: &Opened, why: Words) -> Failure {
        let Self::Coded(decoder) = self else { return refused(&film.path, why) };
        let complaint = decoder.complaint();
        let failure = refused(&film.path, why);
        match failure {
            Failure::Request { message, .. } if !complaint.is_empty() => {
                Failure::in_words(message, words!("ffmpeg reports: {complaint}"))
            }
            other => other,
        }
    }
}

impl Decoder {
    fn begin(film: &Opened, most: Option<usize>, coloured: bool) -> Result<Self, Failure> {
        let complaints = tempfile::tempfile().map_err(|error| Failure::file("write", &std::env::temp_dir(), &error))?;
        let for_child = complaints.try_clone().map_err(|error| Failure::file("read", &film.path, &error))?;
        // The prefix prevents that the name is read as an option or an address. The whitelist prevents that the film
        // refers to other protocols.
        let mut name = std::ffi::OsString::from("file:");
        name.push(&film.path);
        let mut command = Command::new("ffmpeg");
        command.args(["-v", "error", "-nostdin", "-protocol_whitelist", "file", "-noautorotate", "-i"]).arg(name);
        command.args(["-map", "0:V:0", "-fps_mode", "passthrough"]);
        if let Some(most) = most {
            command.args(["-frames:v", &most.to_string()]);
        }
        // Size of the display, since pixels may not be square.
        command.args(["-vf", &format!("scale={}:{}", film.size[0], film.size[1])]);
        // The format states the size in a header and marks each frame.
        let pixels = if coloured { "yuv420p" } else { "gray" };
        command.args(["-f", "yuv4mpegpipe", "-pix_fmt", pixels, "-"]);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::from(for_child));
        let mut child = command.spawn().map_err(|error| not_started(film, &error))?;
        let stdout = child.stdout.take().ok_or_else(|| Failure::request("ffmpeg has no output"))?;
        Ok(Self { child, frames: Frames::new(film.path.clone(), stdout), complaints, mirrored: film.mirrored })
    }

    /// First line of the error output.
    fn complaint(&mut self) -> String {
        let _ = self.child.wait();
        let mut text = Vec::new();
        // The failure is reported even if the output cannot be read.
        let _ = self.complaints.rewind();
        let _ = Read::by_ref(&mut self.complaints).take(COMPLAINT).read_to_end(&mut text);
        String::from_utf8_lossy(&text).lines().next().unwrap_or_default().to_owned()
    }
}

fn not_started(film: &Opened, error: &std::io::Error) -> Failure {
    if error.kind() != ErrorKind::NotFound {
        let why = words!("ffmpeg could not be started: {error}");
        return refused(&film.path, why);
    }
    let install = if cfg!(target_os = "macos") {
        "brew install ffmpeg"
    } else if cfg!(target_os = "windows") {
        "winget install ffmpeg"
    } else {
        "sudo apt install ffmpeg"
    };
    let name = film.path.display();
    Failure::in_words(
        words!("{name} cannot be decoded: ffmpeg is not installed, or not on the PATH"),
        words!(
            "install it with `{install}`; without it convert the film elsewhere with `ffmpeg -i FILM -pix_fmt yuv420p FILM.y4m`, which is read as it is"
        ),
    )
}

/// Picture with left and right exchanged.
fn mirrored(plane: &Plane) -> Option<Plane> {
    let turned = |values: &[u8], width: usize| -> Vec<u8> {
        values.chunks(width).flat_map(|row| row.iter().rev().copied()).collect()
    };
    let grey = Plane::new(plane.width(), plane.height(), turned(plane.grey(), plane.width()))?;
    let Some(colour) = plane.colour() else { return Some(grey) };
    let half = plane.width().div_ceil(2);
    grey.coloured(Colour { blue: turned(&colour.blue, half), red: turned(&colour.red, half) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirrored_picture_has_its_rows_reversed() {
        let plane = Plane::new(3, 2, vec![1, 2, 3, 4, 5, 6]).expect("six pixels");
        let plane = plane.coloured(Colour { blue: vec![7, 8], red: vec![9, 10] }).expect("two blocks");
        let turned = mirrored(&plane).expect("a picture");
        assert_eq!(turned.grey(), [3, 2, 1, 6, 5, 4]);
        assert_eq!(turned.colour(), Some(&Colour { blue: vec![8, 7], red: vec![10, 9] }));
    }
}

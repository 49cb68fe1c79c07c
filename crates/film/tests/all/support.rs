//! Opening films that are in memory, and the films of `tests/films`.

use film::containers::{Film, FilmError, Opening};
use std::path::Path;

/// Result and cost of opening a film.
pub struct Reading {
    pub result: Result<Box<Film>, FilmError>,
    /// Number of requests and of bytes read.
    pub requests: usize,
    pub bytes: u64,
}

/// Opens a film whose file says that it has `size` bytes, of which `file` holds the first.
pub fn open_of_size(file: &[u8], size: u64) -> Reading {
    let mut opening = Opening::new(size);
    let (mut requests, mut bytes) = (0, 0);
    loop {
        match opening {
            Opening::Done(result) => return Reading { result, requests, bytes },
            Opening::Needs(request) => {
                let range = request.range();
                assert!(range.start < range.end && range.end <= size, "{range:?}");
                requests += 1;
                bytes += range.end - range.start;
                let place = |offset: u64| usize::try_from(offset).unwrap().min(file.len());
                opening = request.supply(file[place(range.start)..place(range.end)].to_vec());
            }
        }
    }
}

/// Opens a film.
pub fn open(file: &[u8]) -> Result<Box<Film>, FilmError> {
    open_of_size(file, file.len() as u64).result
}

/// The bytes of a film of `tests/films`.
pub fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/films")
}

/// Description of a film by `ffprobe`: packets in decoding order (time in s, size and offset in bytes, flags), and the
/// presentation times in s.
pub struct Expected {
    pub packets: Vec<(f64, u32, u64, String)>,
    pub times: Vec<f64>,
}

/// Reads the file beside a film.
pub fn expected(name: &str) -> Expected {
    let mut expected = Expected { packets: Vec::new(), times: Vec::new() };
    for line in String::from_utf8(bytes(&format!("{name}.csv"))).unwrap().lines() {
        let fields: Vec<&str> = line.split(',').collect();
        match fields[..] {
            ["frame", time, ..] => expected.times.push(time.parse().unwrap()),
            [time, size, offset, flags, ..] => {
                let time = time.parse().unwrap();
                expected.packets.push((time, size.parse().unwrap(), offset.parse().unwrap(), flags.to_owned()));
            }
            _ => panic!("{name}: {line}"),
        }
    }
    expected
}

//! AVI files made here and cut anywhere: what is there is read, and what is missing is counted.

use crate::support::open;
use film::containers::{Coding, Film, FilmError, Notice};

const FRAMES: usize = 9;
/// Frames in the first of two parts of OpenDML.
const FIRST: usize = 5;
/// A frame that was missed: its chunk is empty.
const MISSED: usize = 3;

/// Index of the frames of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Index {
    /// `idx1` after the frames.
    Old,
    /// None.
    Without,
    /// OpenDML in two parts.
    OpenDml,
    /// None; sizes of lists and number of frames are missing, as in a file written to a pipe or unfinished.
    Unfinished,
}

fn little(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

fn chunk(id: &[u8], content: &[u8]) -> Vec<u8> {
    let mut chunk = [id, &little(&[content.len() as u32]), content].concat();
    chunk.resize(chunk.len() + chunk.len() % 2, 0);
    chunk
}

fn list(kind: &[u8], parts: &[Vec<u8>]) -> Vec<u8> {
    chunk(b"LIST", &[kind, &parts.concat()].concat())
}

/// A frame: of odd length here and there.
fn frame(number: usize) -> Vec<u8> {
    if number == MISSED { Vec::new() } else { vec![0x80 + number as u8; 40 + 7 * number] }
}

/// A file, and where the bytes of each frame end.
fn made(four: &[u8; 4], index: Index) -> (Vec<u8>, Vec<usize>) {
    let stated = if index == Index::Unfinished { 1 << 30 } else { FRAMES as u32 };
    let first = if index == Index::OpenDml { FIRST } else { FRAMES };
    let header = [
        &b"vids"[..],
        four,
        &little(&[0, 0, 0, 1, 25, 0]),
        &little(&[if index == Index::OpenDml { FIRST as u32 } else { stated }, 0, 0, 0, 0, 0]),
    ]
    .concat();
    let format = [&little(&[40, 64, 48, 0x18_0001])[..], four, &[0; 20]].concat();
    let parts: Vec<std::ops::Range<usize>> = vec![0..first, first..FRAMES];
    let mut file = Vec::new();
    let mut ends = Vec::new();
    // The offsets of the index parts are unknown in the first round.
    let mut places = [[0_u32; 2]; 2];
    for _ in 0..2 {
        (file, ends) = (Vec::new(), Vec::new());
        let mut rows: Vec<Vec<u8>> = Vec::new();
        let entries: Vec<u8> = places.iter().flat_map(|[at, size]| little(&[*at, 0, *size, 0])).collect();
        let super_index = [&[4, 0, 0, 0][..], &little(&[2]), b"00dc", &[0; 12], &entries].concat();
        let mut stream = vec![chunk(b"strh", &header), chunk(b"strf", &format)];
        let mut headers = vec![chunk(b"avih", &[0; 56])];
        if index == Index::OpenDml {
            stream.push(chunk(b"indx", &super_index));
        }
        headers.push(list(b"strl", &stream));
        if index == Index::OpenDml {
            headers.push(list(b"odml", &[chunk(b"dmlh", &little(&[FRAMES as u32]))]));
        }
        for (part, frames) in parts.iter().filter(|frames| !frames.is_empty()).enumerate() {
            let begin = file.len();
            file.extend([&b"RIFF\0\0\0\0"[..], if part == 0 { b"AVI " } else { b"AVIX" }].concat());
            if part == 0 {
                file.extend(list(b"hdrl", &headers));
            }
            let frames_at = file.len();
            file.extend(b"LIST\0\0\0\0movi");
            let mut standard = Vec::new();
            for number in frames.clone() {
                let content = frame(number);
                rows.push(
                    [&b"00dc"[..], &little(&[0x10, (file.len() - frames_at - 8) as u32, content.len() as u32])]
                        .concat(),
                );
                standard.extend(little(&[file.len() as u32 + 8, content.len() as u32]));
                file.extend(chunk(b"00dc", &content));
                ends.push(file.len() - content.len() % 2);
                file.extend(chunk(b"01wb", &[number as u8; 11]));
            }
            if index == Index::OpenDml {
                let head = [&[2, 0, 0, 1][..], &little(&[frames.len() as u32]), b"00dc", &[0; 12]].concat();
                let own = chunk(b"ix00", &[head, standard].concat());
                places[part] = [file.len() as u32, own.len() as u32];
                file.extend(own);
            }
            let size = |from: usize, to: usize| {
                if index == Index::Unfinished { [0xff; 4] } else { ((to - from - 8) as u32).to_le_bytes() }
            };
            let movi = size(frames_at, file.len());
            file[frames_at + 4..frames_at + 8].copy_from_slice(&movi);
            if index == Index::Old {
                file.extend(chunk(b"idx1", &rows.concat()));
            }
            let riff = size(begin, file.len());
            file[begin + 4..begin + 8].copy_from_slice(&riff);
        }
    }
    (file, ends)
}

/// Offset, size and time of each frame. Key frames follow from the index alone.
fn places(film: &Film) -> Vec<(u64, u32, i64)> {
    film.samples.iter().map(|sample| (sample.offset, sample.size, sample.ticks)).collect()
}

/// Cuts at every byte: at every boundary of chunks, in their headers, and inside.
#[test]
fn a_cut_avi_gives_the_frames_that_are_there() {
    for four in [b"MJPG", b"XVID"] {
        for index in [Index::Old, Index::Without, Index::OpenDml, Index::Unfinished] {
            let (file, ends) = made(four, index);
            let whole = open(&file).unwrap();
            assert_eq!((whole.samples.len(), &whole.notices), (FRAMES - 1, &vec![]), "{index:?}");
            let expected: Vec<i64> = (0..FRAMES as i64).filter(|&number| number != MISSED as i64).collect();
            assert_eq!(whole.samples.iter().map(|sample| sample.ticks).collect::<Vec<_>>(), expected, "{index:?}");
            let first = ends[0];
            for length in 0..file.len() {
                let context = format!("{index:?}, {length} of {} bytes", file.len());
                let cut = open(&file[..length]);
                if length < first {
                    assert!(cut.is_err_and(|error| error != FilmError::TooLarge), "{context}");
                    continue;
                }
                let cut = cut.unwrap_or_else(|error| panic!("{context}: {error:?}"));
                // The chunk of a missed frame has no bytes, and is there as soon as its header is.
                let there = ends.iter().filter(|&&end| end <= length).count();
                let present = there - usize::from(there > MISSED);
                assert_eq!(places(&cut), places(&whole)[..present], "{context}");
                let notice = Notice::Truncated { present, lost: FRAMES - there, bytes: length as u64 };
                match index {
                    // Nothing tells how many there should be, nor whether the end of a chunk is that of the film.
                    Index::Unfinished => assert!(
                        cut.notices
                            .iter()
                            .all(|notice| { *notice == Notice::Truncated { present, lost: 0, bytes: length as u64 } }),
                        "{context}: {:?}",
                        cut.notices
                    ),
                    _ if there == FRAMES => assert_eq!(cut.notices, [], "{context}: only the index is cut"),
                    _ => assert_eq!(cut.notices, [notice], "{context}"),
                }
            }
        }
    }
}

#[test]
fn key_frames_of_avi_are_those_of_its_index() {
    let (mut file, _) = made(b"DX50", Index::Old);
    let film = open(&file).unwrap();
    assert_eq!(film.codec.coding, Coding::Mpeg4);
    assert!(film.samples.iter().all(|sample| sample.key));
    let index = file.windows(4).position(|part| part == b"idx1").unwrap();
    file[index + 8 + 16 + 4] = 0;
    let keys: Vec<bool> = open(&file).unwrap().samples.iter().map(|sample| sample.key).collect();
    assert_eq!(keys[..3], [true, false, true]);
}

/// A recording that was not finished states no length that could be believed.
#[test]
fn the_length_of_an_unfinished_recording_is_not_known() {
    assert_eq!(open(&made(b"MJPG", Index::Unfinished).0).unwrap().duration, None);
    assert_eq!(open(&made(b"MJPG", Index::OpenDml).0).unwrap().duration, Some(FRAMES as f64 / 25.0));
}

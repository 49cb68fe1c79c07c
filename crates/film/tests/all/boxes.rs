//! MP4 files made here box by box: what no encoder at hand writes.

use crate::support::open;
use film::containers::{Coding, Container, FilmError, Notice};

/// A box.
fn boxed(kind: &[u8; 4], parts: &[&[u8]]) -> Vec<u8> {
    let content = parts.concat();
    [&u32::try_from(content.len() + 8).unwrap().to_be_bytes()[..], kind, &content].concat()
}

/// Numbers of four bytes.
fn words(numbers: &[i64]) -> Vec<u8> {
    numbers.iter().flat_map(|&number| (number as u32).to_be_bytes()).collect()
}

/// Variable contents of the films. By default four frames of 10 bytes, 100 ticks each, at 1000 ticks per second.
#[derive(Clone)]
struct Made {
    sizes: Vec<u8>,
    offsets: Vec<u8>,
    chunks: Vec<i64>,
    composition: Vec<u8>,
    edits: Vec<u8>,
    matrix: [i64; 9],
    entry: [u8; 4],
    pixel_aspect: [i64; 2],
    movie: Vec<u8>,
}

impl Made {
    /// Frames from byte 1000 on, in one chunk.
    fn new() -> Self {
        Self {
            sizes: boxed(b"stsz", &[&words(&[0, 10, 4])]),
            offsets: boxed(b"stco", &[&words(&[0, 1, 1000])]),
            chunks: vec![1, 4, 1],
            composition: Vec::new(),
            edits: Vec::new(),
            matrix: [1 << 16, 0, 0, 0, 1 << 16, 0, 0, 0, 1 << 30],
            entry: *b"avc1",
            pixel_aspect: [1, 1],
            movie: Vec::new(),
        }
    }

    fn movie_box(&self) -> Vec<u8> {
        let record = boxed(b"avcC", &[&[1, 0x42, 0xc0, 0x1e, 0xff, 0xe0, 0]]);
        let aspect = boxed(b"pasp", &[&words(&self.pixel_aspect)]);
        let size = [&[0; 24][..], &[2, 128, 1, 104], &[0; 50]].concat();
        let entry = boxed(&self.entry, &[&size, &record, &aspect]);
        let chunks = [&[0, self.chunks.len() as i64 / 3][..], &self.chunks].concat();
        let tables = boxed(
            b"stbl",
            &[
                &boxed(b"stsd", &[&words(&[0, 1]), &entry]),
                &boxed(b"stts", &[&words(&[0, 1, 4, 100])]),
                &boxed(b"stsc", &[&words(&chunks)]),
                &self.sizes,
                &self.offsets,
                &self.composition,
            ],
        );
        let media = boxed(
            b"mdia",
            &[
                &boxed(b"mdhd", &[&words(&[0, 0, 0, 1000, 400, 0])]),
                &boxed(b"hdlr", &[&words(&[0, 0]), b"vide", &[0; 13]]),
                &boxed(b"minf", &[&tables]),
            ],
        );
        let header =
            [&words(&[3, 0, 0, 1, 0, 400, 0, 0, 0, 0])[..], &words(&self.matrix), &words(&[640 << 16, 360 << 16])]
                .concat();
        let track = boxed(b"trak", &[&boxed(b"tkhd", &[&header]), &self.edits, &media]);
        boxed(b"moov", &[&boxed(b"mvhd", &[&words(&[0, 0, 0, 600, 240]), &[0; 80]]), &track, &self.movie])
    }

    /// The file: `moov`, then `mdat` up to byte 2000.
    fn file(&self) -> Vec<u8> {
        let mut file = [boxed(b"ftyp", &[b"isom\0\0\0\0"]), self.movie_box()].concat();
        let data = words(&[2000 - file.len() as i64]);
        file.extend([&data[..], b"mdat"].concat());
        file.resize(2000, 0);
        file
    }

    fn ticks(&self) -> Vec<i64> {
        open(&self.file()).unwrap().samples.iter().map(|sample| sample.ticks).collect()
    }
}

fn edits(rows: &[(i64, i64)]) -> Vec<u8> {
    let rows: Vec<i64> = rows.iter().flat_map(|&(duration, media)| [duration, media, 1 << 16]).collect();
    boxed(b"edts", &[&boxed(b"elst", &[&words(&[0, rows.len() as i64 / 3]), &words(&rows)])])
}

#[test]
fn the_plain_film() {
    let film = open(&Made::new().file()).unwrap();
    assert_eq!((film.container, film.codec.name.as_str(), film.size), (Container::Mp4, "avc1.42c01e", [640, 360]));
    assert_eq!(
        film.samples.iter().map(|sample| (sample.offset, sample.size)).collect::<Vec<_>>(),
        [(1000, 10), (1010, 10), (1020, 10), (1030, 10)]
    );
    assert_eq!((film.times(), film.duration), (vec![0.0, 0.1, 0.2, 0.3], Some(0.4)));
    assert!(film.samples.iter().all(|sample| sample.key), "without stss all are");
}

#[test]
fn offsets_of_64_bits_and_chunks_of_several_lengths() {
    let mut made = Made::new();
    made.offsets = boxed(b"co64", &[&words(&[0, 3, 0, 1000, 0, 1500, 0, 1200])]);
    made.chunks = vec![1, 1, 1, 2, 2, 1, 3, 1, 1];
    let film = open(&made.file()).unwrap();
    assert_eq!(film.samples.iter().map(|sample| sample.offset).collect::<Vec<_>>(), [1000, 1500, 1510, 1200]);
}

#[test]
fn compact_sizes() {
    for (bits, table, sizes) in [
        (8, vec![5, 6, 7, 8], [5, 6, 7, 8]),
        (16, vec![0, 5, 1, 0, 0, 7, 0, 8], [5, 256, 7, 8]),
        (4, vec![0x56, 0x78], [5, 6, 7, 8]),
    ] {
        let mut made = Made::new();
        made.sizes = boxed(b"stz2", &[&words(&[0, bits, 4]), &table]);
        let film = open(&made.file()).unwrap();
        assert_eq!(film.samples.iter().map(|sample| sample.size).collect::<Vec<_>>(), sizes, "{bits} bits");
    }
}

#[test]
fn composition_offsets_of_both_versions_may_be_negative() {
    for version in [0, 1 << 24] {
        let mut made = Made::new();
        made.composition = boxed(b"ctts", &[&words(&[version, 3, 1, 0, 1, 100, 2, -100])]);
        assert_eq!(made.ticks(), [0, 200, 100, 200]);
    }
}

/// The movie has 600 ticks in a second, the media 1000.
#[test]
fn edit_lists() {
    let shown = |rows: &[(i64, i64)]| {
        let mut made = Made::new();
        made.edits = edits(rows);
        let film = open(&made.file()).unwrap();
        film.samples.iter().map(|sample| sample.shown.then_some(sample.ticks)).collect::<Vec<_>>()
    };
    assert_eq!(shown(&[(240, 0)]), [Some(0), Some(100), Some(200), Some(300)]);
    assert_eq!(shown(&[(300, -1), (240, 0)]), [Some(500), Some(600), Some(700), Some(800)], "a pause of 0.5 s");
    assert_eq!(shown(&[(60, 200)]), [None, None, Some(0), None], "0.1 s from 0.2 s on");
    let mut made = Made::new();
    made.edits = edits(&[(60, 9000)]);
    assert_eq!(open(&made.file()), Err(FilmError::NoFrames), "all cut off");
    made.edits = edits(&[(1, 0); 101]);
    assert_eq!(open(&made.file()), Err(FilmError::Damaged { part: "elst" }));
}

#[test]
fn aspect_and_angle() {
    let mut made = Made::new();
    made.pixel_aspect = [66, 44];
    made.matrix = [0, -(1 << 16), 0, -(1 << 16), 0, 0, 0, 0, 1 << 30];
    let film = open(&made.file()).unwrap();
    assert_eq!((film.pixel_aspect, film.orientation.quarter_turns, film.orientation.mirrored), ([3, 2], 1, true));
    assert_eq!(film.display_size(), [360.0, 960.0]);
    made.matrix = [46341, 46341, 0, -46341, 46341, 0, 0, 0, 1 << 30];
    assert_eq!(open(&made.file()).unwrap().notices, [Notice::Skewed]);
}

/// QuickTime and MP4 write `meta` in two ways, at two places, and the number in several types.
#[test]
fn capture_rates() {
    let handler = boxed(b"hdlr", &[&words(&[0, 0]), b"mdta", &[0; 13]]);
    let names: [&[u8]; 2] = [b"com.android.version", b"com.android.capture.fps"];
    let names: Vec<u8> = names.iter().flat_map(|name| boxed(b"mdta", &[name])).collect();
    let names = boxed(b"keys", &[&words(&[0, 2]), &names]);
    let written = |kind: i64, value: &[u8]| {
        let value = boxed(b"data", &[&words(&[kind, 0]), value]);
        [handler.clone(), names.clone(), boxed(b"ilst", &[&boxed(&2_u32.to_be_bytes(), &[&value])])].concat()
    };
    let rate = |movie: Vec<u8>| open(&Made { movie, ..Made::new() }.file()).unwrap().capture_rate;
    let float = written(23, &240.0_f32.to_be_bytes());
    for (boxes, expected) in [
        (float.clone(), Some(240.0)),
        (written(24, &119.88_f64.to_be_bytes()), Some(119.88)),
        (written(22, &120_u32.to_be_bytes()), Some(120.0)),
        (written(1, b"960.0"), Some(960.0)),
        (written(23, &f32::NAN.to_be_bytes()), None),
        (written(23, &(-1.0_f32).to_be_bytes()), None),
        (written(99, b"240"), None),
    ] {
        assert_eq!(rate(boxed(b"meta", &[&boxes])), expected);
    }
    assert_eq!(rate(boxed(b"meta", &[&[0; 4], &float])), Some(240.0), "with version and flags");
    assert_eq!(rate(boxed(b"udta", &[&boxed(b"meta", &[&[0; 4], &float])])), Some(240.0), "in udta");
}

#[test]
fn what_is_not_read_is_named() {
    let coded = |entry: &[u8; 4]| open(&Made { entry: *entry, ..Made::new() }.file()).unwrap_err();
    assert_eq!(coded(b"encv"), FilmError::Encrypted);
    assert_eq!(coded(b"hvc1"), FilmError::Damaged { part: "stsd" }, "without its record");
}

/// Codings that browsers do not decode are read for the program, and named for the page.
#[test]
fn codings_without_a_decoder_in_browsers_are_named() {
    for (entry, coding, label) in [
        (b"mp4v", Coding::Mpeg4, "MPEG-4 Part 2 (XVID, DivX)"),
        (b"XVID", Coding::Mpeg4, "MPEG-4 Part 2 (XVID, DivX)"),
        (b"apcn", Coding::ProRes, "Apple ProRes"),
        (b"ap4x", Coding::ProRes, "Apple ProRes"),
        (b"AVdh", Coding::Other, "AVdh"),
        (b"\xa9\x00sv", Coding::Other, "??sv"),
    ] {
        let film = open(&Made { entry: *entry, ..Made::new() }.file()).unwrap();
        assert_eq!((film.codec.coding, film.codec.label()), (coding, label));
        assert!(!coding.is_in_browsers());
        let refusal = FilmError::NoDecoder(film.codec).words();
        for text in [refusal.english(), refusal.text(catalogues::with(units::Language::Spanish)).into_owned()] {
            assert!(text.contains(label) && text.contains("ffmpeg -i") && text.contains("`meniscus track`"), "{text}");
        }
    }
}

/// Tables that promise more than they hold, before anything is allocated for them.
#[test]
fn tables_are_bounded() {
    let mut made = Made::new();
    made.sizes = boxed(b"stsz", &[&words(&[0, 0, 1 << 30])]);
    assert_eq!(open(&made.file()), Err(FilmError::Damaged { part: "stsz" }));
    made.sizes = boxed(b"stsz", &[&words(&[0, 1, 0xffff_ffff])]);
    assert_eq!(open(&made.file()), Err(FilmError::TooLarge));
    made.sizes = boxed(b"stsz", &[&words(&[0, 1, 2_000_000])]);
    made.chunks = vec![1, 0xffff_ffff, 1];
    let film = open(&made.file()).unwrap();
    assert_eq!(film.samples.len(), 1000);
    assert_eq!(film.notices, [Notice::Truncated { present: 1000, lost: 1_999_000, bytes: 2000 }]);
}

/// Fragments whose offsets count from the fragment, from the one before, or from a stated place; sizes and durations by default.
#[test]
fn fragments() {
    let mut made = Made::new();
    let track_defaults = words(&[0, 1, 1, 100, 20, 0x1_0000]);
    made.movie = boxed(b"mvex", &[&boxed(b"trex", &[&track_defaults])]);
    made.sizes = boxed(b"stsz", &[&words(&[0, 0, 0])]);
    let mut file = made.file();
    let fragment = |header: &[i64], time: Option<i64>, runs: &[&[i64]]| {
        let time = time.map(|time| boxed(b"tfdt", &[&words(&[1 << 24, 0, time])])).unwrap_or_default();
        let runs: Vec<u8> = runs.iter().flat_map(|run| boxed(b"trun", &[&words(run)])).collect();
        boxed(b"moof", &[&boxed(b"traf", &[&boxed(b"tfhd", &[&words(header)]), &time, &runs])])
    };
    let data = boxed(b"mdat", &[&[0; 200]]);
    // Base is the fragment; the first frame is a key frame; two runs, one behind the other.
    let first = fragment(&[0x2_0000, 1], Some(1000), &[&[0x5, 2, 100, 0], &[0, 1]]);
    // Base is stated, and a duration of 50; sizes, flags and offsets of each.
    let stated = fragment(&[0x9, 1, 0, 1000, 50], None, &[&[0xe01, 2, 0, 30, 0, 20, 40, 0x1_0000, -20]]);
    file.extend([first, data.clone(), stated, data].concat());
    let film = open(&file).unwrap();
    let found: Vec<_> =
        film.samples.iter().map(|sample| (sample.offset, sample.size, sample.ticks, sample.key)).collect();
    assert_eq!(
        found,
        [
            (2100, 20, 1000, true),
            (2120, 20, 1100, false),
            (2140, 20, 1200, false),
            (1000, 30, 1320, true),
            (1030, 40, 1330, false)
        ]
    );
    // A run without end of frames without size.
    let mut endless = made.clone();
    endless.movie = boxed(b"mvex", &[&boxed(b"trex", &[&words(&[0, 1, 1, 100, 0, 0])])]);
    let file = [endless.file(), fragment(&[0x2_0000, 1], None, &[&[0, 0xffff_ffff]])].concat();
    assert_eq!(open(&file), Err(FilmError::TooLarge));
}

//! Matroska and AVI files made here: live ones, groups of blocks, indexes.

use crate::support::{bytes, open, open_of_size};
use film::containers::{Coding, Container, FilmError, Notice};

/// A part of the content of an element.
enum Part {
    /// Number and content.
    Known(u32, Vec<Part>),
    /// Number and content of one whose size is not known.
    Live(u32, Vec<Part>),
    /// A number and the bytes.
    Bytes(u32, Vec<u8>),
}
use Part::{Bytes, Known, Live};

fn write(parts: &[Part]) -> Vec<u8> {
    let number = |id: u32| id.to_be_bytes().into_iter().skip_while(|&byte| byte == 0).collect::<Vec<u8>>();
    let sized = |id: u32, content: &[u8]| {
        let size = (content.len() as u32 | 0x1000_0000).to_be_bytes();
        [&number(id)[..], &size, content].concat()
    };
    let written = |part: &Part| match part {
        Known(id, parts) => sized(*id, &write(parts)),
        Live(id, parts) => [number(*id), vec![0xff], write(parts)].concat(),
        Bytes(id, bytes) => sized(*id, bytes),
    };
    parts.iter().flat_map(written).collect()
}

const VP9: &[u8] = b"V_VP9";

/// A track entry of 640 by 360 pixels with further elements, and of the video part.
fn track(codec: &[u8], further: Vec<Part>, video: Vec<Part>) -> Part {
    let mut size = vec![Bytes(0xb0, vec![2, 128]), Bytes(0xba, vec![1, 104])];
    size.extend(video);
    let mut parts = vec![Bytes(0xd7, vec![1]), Bytes(0x83, vec![1]), Bytes(0x86, codec.to_vec()), Known(0xe0, size)];
    parts.extend(further);
    Known(0x1654_ae6b, vec![Known(0xae, parts)])
}

/// A block of the track: number, time, flags, and a VP9 frame of profile 0.
fn block(time: i16, flags: u8) -> Vec<u8> {
    [&[0x81][..], &time.to_be_bytes(), &[flags, 0x82, 0x49, 0x83, 0x42]].concat()
}

fn start() -> Part {
    Known(0x1a45_dfa3, vec![Bytes(0x4282, b"matroska".to_vec())])
}

fn film(track: Part, clusters: Vec<Part>) -> Vec<u8> {
    let mut parts = vec![track];
    parts.extend(clusters);
    write(&[start(), Known(0x1853_8067, parts)])
}

fn one_block() -> Vec<Part> {
    vec![Known(0x1f43_b675, vec![Bytes(0xe7, vec![0]), Bytes(0xa3, block(0, 0x80))])]
}

/// Segments and clusters without sizes, and blocks in groups, of which one refers to another.
#[test]
fn live_films() {
    let group = |time, refers: bool| {
        let mut parts = vec![Bytes(0xa1, block(time, 0))];
        parts.extend(refers.then(|| Bytes(0xfb, vec![0xdf])));
        Known(0xa0, parts)
    };
    let clusters = vec![
        Live(0x1f43_b675, vec![Bytes(0xe7, vec![10]), group(0, false), group(33, true), Bytes(0xa3, block(-5, 0))]),
        Live(0x1f43_b675, vec![Bytes(0xe7, vec![1, 0]), Bytes(0xa3, block(2, 0x80)), Bytes(0xec, vec![0; 9])]),
    ];
    let info = Known(0x1549_a966, vec![Bytes(0x002a_d7b1, vec![0x07, 0xa1, 0x20])]);
    let mut parts = vec![info, track(VP9, vec![Bytes(0x0023_e383, vec![0x01, 0xfc, 0xa0, 0x55])], vec![])];
    parts.extend(clusters);
    let film = open(&write(&[start(), Live(0x1853_8067, parts)])).unwrap();
    // 500,000 ns in a tick.
    let found: Vec<_> = film.samples.iter().map(|sample| (sample.ticks / 500_000, sample.size, sample.key)).collect();
    assert_eq!(found, [(10, 4, true), (43, 4, false), (5, 4, false), (258, 4, true)]);
    assert_eq!(
        (film.container, film.codec.name.as_str(), &film.notices),
        (Container::Matroska, "vp09.00.10.08", &vec![])
    );
    assert!((film.stated_rate.unwrap() - 30.0).abs() < 1e-3);
    assert_eq!(film.shown(), [2, 0, 1, 3]);
}

/// As browsers record H.264 in Matroska: the parameters stand in the frames.
#[test]
fn h264_without_a_record() {
    let frame = [0, 0, 0, 1, 0x67, 0x42, 0xc0, 0x0c, 0xda, 0x0f];
    let block = [&[0x81, 0, 0, 0x80][..], &frame].concat();
    let clusters = |block| vec![Known(0x1f43_b675, vec![Bytes(0xe7, vec![0]), Bytes(0xa3, block)])];
    let track = || track(b"V_MPEG4/ISO/AVC", vec![], vec![]);
    let codec = open(&film(track(), clusters(block))).unwrap().codec;
    assert_eq!((codec.name.as_str(), codec.description.len()), ("avc1.42c00c", 0));
    let error = open(&film(track(), clusters(vec![0x81, 0, 0, 0x80, 1, 2, 3]))).unwrap_err();
    assert_eq!(error, FilmError::Damaged { part: "CodecPrivate" });
}

/// Blocks far apart are found by separate requests, of which none reads what lies between.
#[test]
fn large_blocks_are_passed_over() {
    let far = || Bytes(0xec, vec![0; 300_000]);
    let block = |time| Bytes(0xa3, block(time, 0x80));
    let blocks = (0..20).flat_map(|n| [block(33 * n), far()]).collect::<Vec<_>>();
    let mut cluster = vec![Bytes(0xe7, vec![0])];
    cluster.extend(blocks);
    let file = film(track(VP9, vec![], vec![]), vec![Live(0x1f43_b675, cluster)]);
    let reading = open_of_size(&file, file.len() as u64);
    let film = reading.result.unwrap();
    assert_eq!((film.samples.len(), film.samples[19].ticks), (20, 627_000_000));
    assert!(reading.requests > 15 && reading.bytes < 200_000, "{} {}", reading.requests, reading.bytes);
}

#[test]
fn how_the_picture_is_shown() {
    let angle = |roll: f32| {
        let projection = Known(0x7670, vec![Bytes(0x7671, vec![0]), Bytes(0x7675, roll.to_be_bytes().to_vec())]);
        open(&film(track(VP9, vec![], vec![projection]), one_block())).unwrap()
    };
    for (roll, turns) in [(0.0, 0), (-90.0, 1), (180.0, 2), (-180.0, 2), (90.0, 3)] {
        assert_eq!(angle(roll).orientation.quarter_turns, turns, "{roll}");
    }
    assert_eq!(angle(30.0).notices, [Notice::Skewed]);
    let shown = vec![Bytes(0x54b0, vec![3, 0x55]), Bytes(0x54ba, vec![1, 104])];
    assert_eq!(open(&film(track(VP9, vec![], shown), one_block())).unwrap().pixel_aspect, [853, 640]);
}

#[test]
fn what_is_not_read_is_named() {
    let error = |track, clusters| open(&film(track, clusters)).unwrap_err();
    let encoded = |kind| vec![Known(0x6d80, vec![Known(0x6240, vec![Bytes(0x5033, vec![kind])])])];
    assert_eq!(error(track(VP9, encoded(1), vec![]), one_block()), FilmError::Encrypted);
    assert_eq!(error(track(VP9, encoded(0), vec![]), one_block()), FilmError::Packed);
    let laced = vec![Known(0x1f43_b675, vec![Bytes(0xe7, vec![0]), Bytes(0xa3, block(0, 0x86))])];
    assert_eq!(error(track(VP9, vec![], vec![]), laced), FilmError::Packed);
    assert_eq!(error(track(b"V_AV1", vec![], vec![]), one_block()), FilmError::Damaged { part: "CodecPrivate" });
    assert_eq!(error(track(VP9, vec![], vec![]), vec![]), FilmError::NoFrames);
    assert_eq!(error(Known(0x1654_ae6b, vec![]), one_block()), FilmError::NoVideo);
}

/// Codings that browsers do not decode: by the name of Matroska, and by the four characters in a header of Windows.
#[test]
fn codings_for_the_program_are_named() {
    let header = |four: &[u8; 4]| vec![Bytes(0x63a2, [&[0; 16][..], four, &[0; 20]].concat())];
    for (name, parts, coding, label) in [
        (&b"V_THEORA"[..], vec![], Coding::Other, "V_THEORA"),
        (b"V_MPEG4/ISO/ASP", vec![], Coding::Mpeg4, "MPEG-4 Part 2 (XVID, DivX)"),
        (b"V_MS/VFW/FOURCC", header(b"DX50"), Coding::Mpeg4, "MPEG-4 Part 2 (XVID, DivX)"),
        (b"V_MS/VFW/FOURCC", header(b"HFYU"), Coding::Other, "HFYU"),
        (b"V_MS/VFW/FOURCC", header(b"MJPG"), Coding::Jpeg, "Motion JPEG"),
        (b"V_PRORES", vec![], Coding::ProRes, "Apple ProRes"),
    ] {
        let film = open(&film(track(name, parts, vec![]), one_block())).unwrap();
        assert_eq!((film.codec.coding, film.codec.label()), (coding, label));
    }
}

#[test]
fn bytes_that_are_no_element_end_the_film() {
    let mut file = write(&[start(), Live(0x1853_8067, vec![track(VP9, vec![], vec![])])]);
    file.extend(write(&one_block()));
    let at = file.len() as u64;
    file.extend([0; 64]);
    let film = open(&file).unwrap();
    assert_eq!((film.samples.len(), film.notices), (1, vec![Notice::Broken { at }]));
}

fn place(file: &[u8], what: &[u8]) -> usize {
    file.windows(what.len()).position(|part| part == what).unwrap()
}

/// Without its index, with offsets from the start of the file, and with an index of OpenDML, the film is the same.
#[test]
fn avi_films_are_found_by_every_index() {
    let file = bytes("mjpeg.avi");
    let whole = open(&file).unwrap();
    let (index, frames) = (place(&file, b"idx1"), place(&file, b"movi"));
    assert_eq!(open(&file[..index]).unwrap().samples, whole.samples, "no index");
    let mut unnamed = file.clone();
    unnamed[index..index + 4].copy_from_slice(b"JUNK");
    assert_eq!(open(&unnamed).unwrap().samples, whole.samples, "no index, but something behind");

    let mut absolute = file.clone();
    for row in absolute[index + 8..].chunks_exact_mut(16) {
        let offset = u32::from_le_bytes(row[8..12].try_into().unwrap()) + frames as u32;
        row[8..12].copy_from_slice(&offset.to_le_bytes());
    }
    assert_eq!(open(&absolute).unwrap().samples, whole.samples, "from the start");

    // ffmpeg leaves room for the index of OpenDML in each stream: `JUNK` in `strl`.
    let mut open_dml = file.clone();
    let room = place(&file, b"JUNK");
    let little = |numbers: &[u32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let count = whole.samples.len() as u32;
    let mut part =
        [b"ix00", &little(&[24 + 8 * count])[..], &[2, 0, 0, 1], &little(&[count]), b"00dc", &little(&[1000, 0, 0])]
            .concat();
    for sample in &whole.samples {
        part.extend(little(&[sample.offset as u32 - 1000, sample.size | 0x8000_0000]));
    }
    let super_index = [
        &[4, 0, 0, 0][..],
        &little(&[1]),
        b"00dc",
        &[0; 12],
        &little(&[file.len() as u32, 0, part.len() as u32, count]),
    ]
    .concat();
    open_dml[room..room + 4].copy_from_slice(b"indx");
    open_dml[room + 8..room + 8 + super_index.len()].copy_from_slice(&super_index);
    open_dml[index..index + 4].copy_from_slice(b"JUNK");
    let frames_kept = open_dml[frames..frames + 4].to_vec();
    open_dml.extend(part);
    assert_eq!(open(&open_dml).unwrap().samples, whole.samples, "OpenDML");
    assert_eq!(frames_kept, b"movi");
}

/// Frames far apart, without an index.
#[test]
fn avi_films_are_walked_by_headers() {
    let file = bytes("mjpeg.avi");
    let whole = open(&file).unwrap();
    let mut far = file[..place(&file, b"movi") + 4].to_vec();
    for sample in &whole.samples {
        let frame = &file[sample.offset as usize..][..sample.size as usize];
        for (id, content) in [(b"00dc", frame), (b"JUNK", &vec![0; 200_000][..])] {
            far.extend([&id[..], &(content.len() as u32).to_le_bytes(), content].concat());
            far.resize(far.len() + far.len() % 2, 0);
        }
    }
    let list = far.len() as u32 - (place(&far, b"movi") as u32 - 4);
    let at = place(&far, b"movi") - 4;
    far[at..at + 4].copy_from_slice(&list.to_le_bytes());
    let reading = open_of_size(&far, far.len() as u64);
    let film = reading.result.unwrap();
    assert_eq!(film.times(), whole.times());
    assert!(reading.requests > 10 && reading.bytes < 200_000, "{} {}", reading.requests, reading.bytes);
}

/// A camera writes an empty chunk where it missed a frame; the times of the others stay.
#[test]
fn missed_frames_of_avi() {
    let mut file = bytes("mjpeg.avi");
    let index = place(&file, b"idx1");
    let rows: Vec<usize> =
        (index + 8..file.len() - 15).step_by(16).filter(|&at| &file[at..at + 4] == b"00dc").collect();
    file[rows[3] + 12..rows[3] + 16].fill(0);
    let film = open(&file).unwrap();
    let times = film.times();
    assert_eq!((film.samples.len(), film.duration), (11, Some(0.4)));
    assert!((times[3] - 4.0 / 30.0).abs() < 1e-9 && (times[2] - 2.0 / 30.0).abs() < 1e-9);
}

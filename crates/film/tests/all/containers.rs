//! The films of `tests/films`, in every container and coding, against what `ffprobe` says of them.

use crate::support::{bytes, expected, open, open_of_size};
use film::containers::Coding::{self, Av1, H264, Hevc, Jpeg, Vp8, Vp9};
use film::containers::Container::{self, Avi, Matroska, Mp4, QuickTime, WebM};

/// Container, coding, codec string, and length of the description. Strings by `MP4Box -info` and the first bytes of the records.
const FILMS: [(&str, Container, Coding, &str, usize); 17] = [
    ("h264.mp4", Mp4, H264, "avc1.64000a", 44),
    ("capture-rate.mp4", Mp4, H264, "avc1.64000a", 44),
    ("fragments.mp4", Mp4, H264, "avc1.64000a", 44),
    ("fragments-of-old.mp4", Mp4, H264, "avc1.64000a", 44),
    ("rotated-90.mp4", Mp4, H264, "avc1.64000a", 44),
    ("rotated-180.mp4", Mp4, H264, "avc1.64000a", 44),
    ("rotated-270.mp4", Mp4, H264, "avc1.64000a", 44),
    ("variable.mp4", Mp4, H264, "avc1.64000a", 43),
    ("trimmed.mp4", Mp4, H264, "avc1.64000a", 44),
    ("late.mov", QuickTime, H264, "avc1.64000a", 44),
    ("h264.mkv", Matroska, H264, "avc1.64000a", 44),
    ("hevc.mp4", Mp4, Hevc, "hvc1.1.6.L30.90", 108),
    ("av1.mp4", Mp4, Av1, "av01.0.00M.08", 0),
    ("vp9.webm", WebM, Vp9, "vp09.00.10.08", 0),
    ("live.webm", WebM, Vp9, "vp09.00.10.08", 0),
    ("vp8.webm", WebM, Vp8, "vp8", 0),
    ("mjpeg.avi", Avi, Jpeg, "image/jpeg", 0),
];

#[test]
fn films_are_described() {
    for (name, container, coding, codec, description) in FILMS {
        let film = open(&bytes(name)).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        assert_eq!((film.container, film.codec.coding), (container, coding), "{name}");
        assert_eq!((film.codec.name.as_str(), film.codec.description.len()), (codec, description), "{name}");
        assert_eq!((film.size, film.pixel_aspect, &film.notices), ([96, 64], [1, 1], &vec![]), "{name}");
    }
    let film = open(&bytes("mjpeg.mov")).unwrap();
    assert_eq!((film.container, film.codec.coding), (QuickTime, Jpeg));
}

#[test]
fn frames_are_where_and_when_ffprobe_finds_them() {
    for name in FILMS.iter().map(|film| film.0).chain(["mjpeg.mov"]) {
        let (bytes, expected) = (bytes(name), expected(name));
        let film = open(&bytes).unwrap();
        assert_eq!(film.samples.len(), expected.packets.len(), "{name}");
        for (sample, (time, size, offset, flags)) in film.samples.iter().zip(&expected.packets) {
            let found = film.seconds(sample.ticks);
            assert!((found - time).abs() < 1e-6, "{name}: {found} {time}");
            assert_eq!((sample.size, sample.key), (*size, flags.contains('K')), "{name}");
            assert_eq!(sample.shown, !flags.contains('D'), "{name}");
            match film.container {
                Mp4 | QuickTime | Avi => assert_eq!(sample.offset, *offset, "{name}"),
                // ffprobe gives the offset of the block.
                _ => assert!((2..=12).contains(&(sample.offset - offset)), "{name}: {} {offset}", sample.offset),
            }
            let start = usize::try_from(sample.offset).unwrap();
            match film.codec.coding {
                Jpeg => assert_eq!(bytes[start..start + 2], [0xff, 0xd8], "{name}"),
                // The length of the first unit, which lies in the frame.
                H264 | Hevc => {
                    assert!(u32::from_be_bytes(bytes[start..start + 4].try_into().unwrap()) <= sample.size - 4)
                }
                Vp9 => assert_eq!(bytes[start] >> 6, 2, "{name}"),
                _ => {}
            }
        }
        let times = film.times();
        assert_eq!(times.len(), expected.times.len(), "{name}");
        assert!(
            times.iter().zip(&expected.times).all(|(found, time)| (found - time).abs() < 1e-6),
            "{name}: {times:?}"
        );
    }
}

#[test]
fn pictures_are_turned_as_the_film_says() {
    for (name, turns) in [("h264.mp4", 0), ("rotated-90.mp4", 1), ("rotated-180.mp4", 2), ("rotated-270.mp4", 3)] {
        let orientation = open(&bytes(name)).unwrap().orientation;
        assert_eq!((orientation.quarter_turns, orientation.mirrored), (turns, false), "{name}");
    }
}

#[test]
fn cameras_say_how_fast_they_filmed_and_when() {
    let film = open(&bytes("capture-rate.mp4")).unwrap();
    assert_eq!((film.capture_rate, film.created), (Some(240.0), Some(1_772_359_200)));
    assert_eq!(open(&bytes("h264.mp4")).unwrap().capture_rate, None);
    assert_eq!(open(&bytes("mjpeg.avi")).unwrap().stated_rate, Some(30.0));
}

#[test]
fn decoding_begins_with_the_key_frame_before() {
    let film = open(&bytes("h264.mp4")).unwrap();
    let keys: Vec<usize> = (0..film.samples.len()).filter(|&at| film.samples[at].key).collect();
    assert_eq!(keys, [0, 6]);
    assert_eq!([0, 5, 6, 11].map(|at| film.key_before(at)), [0, 0, 6, 6]);
}

/// Data between headers are not read: a film with two gigabytes of other data before its frames.
#[test]
fn large_films_open_by_their_headers() {
    let film = bytes("h264.mp4");
    let data = film.windows(4).position(|kind| kind == b"mdat").unwrap() - 4;
    let gap = 2_000_000_000_u64;
    let mut opening = film::containers::Opening::new(film.len() as u64 + gap);
    let mut read = 0;
    let film = loop {
        match opening {
            film::containers::Opening::Done(result) => break result.unwrap(),
            film::containers::Opening::Needs(request) => {
                let range = request.range();
                read += range.end - range.start;
                // A box `free` with the gap as its content stands before `mdat`.
                let byte = |offset: u64| match offset.checked_sub(data as u64) {
                    None => film[offset as usize],
                    Some(within) if within < 8 => {
                        [&u32::try_from(gap).unwrap().to_be_bytes()[..], b"free"].concat()[within as usize]
                    }
                    Some(within) if within < gap => 0,
                    Some(_) => film[(offset - gap) as usize],
                };
                opening = request.supply(range.map(byte).collect());
            }
        }
    };
    assert_eq!(film.samples.len(), 12);
    assert!(read < 100_000, "{read} bytes");
}

#[test]
fn a_file_that_is_shorter_than_its_size_says_what_is_there() {
    let film = bytes("vp8.webm");
    let whole = open(&film).unwrap();
    let reading = open_of_size(&film[..2500], film.len() as u64);
    let cut = reading.result.unwrap();
    assert!(cut.samples.len() < whole.samples.len() && cut.samples[..] == whole.samples[..cut.samples.len()]);
    let words = cut.notices[0].words();
    assert!(words.english().contains(&format!("{} frames in 2 kB", cut.samples.len())), "{words:?}");
    assert!(reading.requests < 4 && reading.bytes < 20_000);
}

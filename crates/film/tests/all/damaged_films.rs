//! Files that are cut off, changed or no films: a film or an error with words, never a panic.

use crate::support::{bytes, open};
use film::containers::{FilmError, Notice};
use proptest::prelude::*;

const FILMS: [&str; 10] = [
    "h264.mp4",
    "fragments.mp4",
    "fragments-of-old.mp4",
    "trimmed.mp4",
    "hevc.mp4",
    "capture-rate.mp4",
    "vp9.webm",
    "live.webm",
    "mjpeg.avi",
    "mjpeg.mov",
];

/// Opens it, and checks what holds for every film.
fn check(file: &[u8]) {
    match open(file) {
        Ok(film) => {
            assert!(!film.samples.is_empty() && film.samples.len() <= film::containers::MOST_SAMPLES);
            for sample in &film.samples {
                assert!(sample.size > 0 && sample.offset + u64::from(sample.size) <= file.len() as u64);
            }
            assert!(film.timescale > 0 && film.pixel_aspect.iter().all(|&part| part > 0));
            let times = film.times();
            assert!(!times.is_empty() && times.iter().all(|time| time.is_finite()) && times.is_sorted());
            assert!(film.notices.iter().all(|notice| !notice.words().is_empty()));
        }
        Err(error) => assert!(
            !error.words().english().is_empty()
                && !error.words().text(catalogues::with(units::Language::Spanish)).is_empty()
        ),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn changed_films(
        film in prop::sample::select(&FILMS[..]),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut file = bytes(film);
        for (place, byte) in changes {
            let place = place.index(file.len());
            file[place] = byte;
        }
        if let Some(cut) = cut {
            file.truncate(cut.index(file.len()));
        }
        check(&file);
    }

    /// Headers hold most of what can go wrong.
    #[test]
    fn changed_headers(film in prop::sample::select(&FILMS[..]), place in 0_usize..3000, value in prop::sample::select(&[0_u32, 1, 2, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff][..])) {
        let mut file = bytes(film);
        // In MP4 without fragments the headers are at the end.
        let at = if film.ends_with(".mp4") || film.ends_with(".mov") { file.len().saturating_sub(3000).max(32) + place } else { place };
        if let Some(part) = file.get_mut(at..at + 4) {
            part.copy_from_slice(&value.to_be_bytes());
        }
        check(&file);
    }
}

#[test]
fn every_film_cut_anywhere() {
    for film in FILMS {
        let file = bytes(film);
        let step = (file.len() / 1500).max(1);
        for length in (0..file.len()).step_by(step) {
            check(&file[..length]);
        }
    }
}

/// A film with its headers in front loses only the frames that are not there; one with its headers behind is lost.
#[test]
fn what_is_there_of_a_film_is_read() {
    for (name, keep) in [("capture-rate.mp4", 0.97), ("fragments.mp4", 0.8), ("vp9.webm", 0.9), ("mjpeg.avi", 0.6)] {
        let file = bytes(name);
        let whole = open(&file).unwrap();
        let cut =
            open(&file[..(file.len() as f64 * keep) as usize]).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        assert_eq!(cut.samples, whole.samples[..cut.samples.len()], "{name}");
        assert!(cut.samples.len() < whole.samples.len(), "{name}");
        let [Notice::Truncated { present, .. }] = cut.notices[..] else { panic!("{name}: {:?}", cut.notices) };
        assert_eq!(present, cut.samples.len(), "{name}");
    }
    let file = bytes("h264.mp4");
    assert_eq!(open(&file[..1500]), Err(FilmError::Truncated { bytes: 1500 }));
}

#[test]
fn what_is_no_film_says_what_to_do() {
    let packets: Vec<u8> = [[0x47; 1].as_slice(), &[0; 187]].concat().repeat(3);
    for (file, error, word) in [
        (&b""[..], FilmError::Empty, "copy it again"),
        (b"t;x\n0;1\n", FilmError::NotAFilm, "MOV"),
        (b"GIF89a......", FilmError::Gif, "convert it"),
        (b"\xff\xd8\xff\xe0..JFIF", FilmError::Picture, "picture"),
        (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", FilmError::Picture, "picture"),
        (b"FLV\x01", FilmError::OtherFormat("FLV"), "ffmpeg"),
        (&packets, FilmError::OtherFormat("MPEG-TS"), "ffmpeg"),
    ] {
        assert_eq!(open(file), Err(error.clone()));
        assert!(error.words().english().contains(word), "{error:?}");
    }
    let hevc = FilmError::NoDecoder(open(&bytes("hevc.mp4")).unwrap().codec).words();
    assert!(hevc.english().contains("Settings > Camera > Formats") && hevc.english().contains("Most Compatible"));
    assert!(hevc.text(catalogues::with(units::Language::Spanish)).contains("Ajustes > Cámara > Formatos"));
}

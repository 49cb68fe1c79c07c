//! Films in the format of the MJPEG tools.

use film::Plane;
use film::y4m::{Fault, Reader};

/// Reads a film in pieces.
fn read(bytes: &[u8], piece: usize) -> (Reader, Result<Vec<Plane>, Fault>) {
    let mut reader = Reader::default();
    let mut planes = Vec::new();
    for mut part in bytes.chunks(piece) {
        loop {
            match reader.frame(&mut part) {
                Ok(Some(plane)) => planes.push(plane),
                Ok(None) => break,
                Err(fault) => return (reader, Err(fault)),
            }
        }
    }
    (reader, Ok(planes))
}

/// A film of two frames, 3 times 2 pixels large, with so many bytes of colour.
fn bytes(header: &str, colour: usize) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    for first in [10_u8, 20] {
        bytes.extend_from_slice(b"\nFRAME".get(usize::from(first > 10)..).unwrap_or_default());
        bytes.extend_from_slice(b" Ip\n".get(usize::from(first == 10) * 3..).unwrap_or_default());
        bytes.extend((0..6).map(|k| first + k));
        bytes.extend(std::iter::repeat_n(128, colour));
    }
    bytes
}

#[test]
fn grey_values_are_read_in_pieces_of_any_size() {
    let cases = [
        ("YUV4MPEG2 W3 H2 F30000:1001 Ip A1:1 C420jpeg XYSCSS=420JPEG", 4),
        ("YUV4MPEG2 W3 H2 F30000:1001", 4),
        ("YUV4MPEG2 H2 W3 F30000:1001 Cmono", 0),
        ("YUV4MPEG2 W3 H2 F30000:1001 C422", 8),
        ("YUV4MPEG2 W3 H2 F30000:1001 C444", 12),
    ];
    for (header, colour) in cases {
        let bytes = bytes(header, colour);
        for piece in [1, 2, 7, 1000] {
            let (reader, planes) = read(&bytes, piece);
            let planes = planes.expect("a film");
            let grey: Vec<&[u8]> = planes.iter().map(Plane::grey).collect();
            assert_eq!(grey, [[10, 11, 12, 13, 14, 15], [20, 21, 22, 23, 24, 25]], "{header}, pieces of {piece}");
            let header = reader.header().expect("a header");
            assert_eq!((header.width, header.height), (3, 2));
            assert!((header.rate.expect("a rate") - 29.970_03).abs() < 1e-6);
        }
    }
}

#[test]
fn what_is_no_such_film_is_refused() {
    let fault = |text: &str| read(text.as_bytes(), 5).1.err();
    assert_eq!(fault("RIFF....AVI \n"), Some(Fault::Signature));
    assert_eq!(fault(&"x".repeat(3000)), Some(Fault::Signature));
    for line in ["YUV4MPEG2 W3", "YUV4MPEG2 W0 H2", "YUV4MPEG2 W-3 H2", "YUV4MPEG2 W3 H2 F30", "YUV4MPEG2 W3 H2 F1:0"] {
        assert_eq!(fault(&format!("{line}\n")), Some(Fault::Header { line: line.to_owned() }));
    }
    let huge = "YUV4MPEG2 W4294967295 H4294967295";
    assert_eq!(fault(&format!("{huge}\n")), Some(Fault::Header { line: huge.to_owned() }));
    assert_eq!(fault("YUV4MPEG2 W3 H2 C420p10\n"), Some(Fault::Pixels { name: "420p10".to_owned() }));
    assert_eq!(fault("YUV4MPEG2 W3 H2 Cmono\nFRAME\n123456FREME\n"), Some(Fault::Frame { read: 1 }));
    assert_eq!(fault("YUV4MPEG2 W3 H2 F0:0\nFRAME\n123"), None);
}

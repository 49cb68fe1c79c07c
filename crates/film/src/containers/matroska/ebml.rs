//! Elements of Matroska files (RFC 8794).

use super::super::bytes::Bytes;

/// Header of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) id: u32,
    /// Size of the header in bytes.
    pub(super) length: u64,
    /// Size of the content in bytes; `None` if it was unknown when the header was written.
    pub(super) size: Option<u64>,
}

impl Header {
    /// Maximum size of a header in bytes.
    pub(super) const MOST: u64 = 12;

    /// Reads a header from the start of an element. `None` if bytes are missing or invalid.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let mut rest = Bytes(bytes);
        let id = u32::try_from(number(&mut rest, true)?.0).ok()?;
        let (size, unknown) = number(&mut rest, false)?;
        let length = (bytes.len() - rest.0.len()) as u64;
        Some(Self { id, length, size: (!unknown).then_some(size) })
    }
}

/// Reads an integer of variable length, with or without its length marker. The flag is true if all value bits are set,
/// which means an unknown size.
pub(super) fn number(bytes: &mut Bytes<'_>, with_marker: bool) -> Option<(u64, bool)> {
    let first = bytes.u8()?;
    let more = first.leading_zeros();
    if more > 7 {
        return None;
    }
    let mask = 0x7f_u8 >> more;
    let mut value = u64::from(if with_marker { first } else { first & mask });
    let mut ones = first & mask == mask;
    for _ in 0..more {
        let byte = bytes.u8()?;
        value = value << 8 | u64::from(byte);
        ones &= byte == 0xff;
    }
    Some((value, ones))
}

/// Iterator over identifier and content of the elements in `.0`. Ends at an incomplete element.
#[derive(Clone, Debug)]
pub(super) struct Elements<'a>(pub(super) &'a [u8]);

impl<'a> Iterator for Elements<'a> {
    type Item = (u32, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let header = Header::read(self.0)?;
        let (_, content) = self.0.split_at_checked(usize::try_from(header.length).ok()?)?;
        let (content, rest) = content.split_at_checked(usize::try_from(header.size?).ok()?)?;
        self.0 = rest;
        Some((header.id, content))
    }
}

/// Content of the first element with identifier `id`.
pub(super) fn find(content: &[u8], id: u32) -> Option<&[u8]> {
    Elements(content).find(|(other, _)| *other == id).map(|(_, content)| content)
}

/// Unsigned integer of at most eight bytes.
pub(super) fn unsigned(content: &[u8]) -> Option<u64> {
    (content.len() <= 8).then(|| content.iter().fold(0, |value, &byte| value << 8 | u64::from(byte)))
}

/// Floating-point number of four or eight bytes.
pub(super) fn float(content: &[u8]) -> Option<f64> {
    let mut bytes = Bytes(content);
    match content.len() {
        4 => bytes.u32().map(|bits| f32::from_bits(bits).into()),
        8 => bytes.u64().map(f64::from_bits),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers() {
        let header = |bytes: &[u8]| Header::read(bytes).map(|header| (header.id, header.length, header.size));
        assert_eq!(header(&[0xa3, 0x82]), Some((0xa3, 2, Some(2))));
        assert_eq!(header(&[0x1f, 0x43, 0xb6, 0x75, 0xff]), Some((0x1f43_b675, 5, None)), "one byte");
        assert_eq!(header(&[0xec, 1, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff]), Some((0xec, 9, None)), "eight bytes");
        assert_eq!(header(&[0x42, 0x86, 0x40, 0x7f]), Some((0x4286, 4, Some(127))));
        assert_eq!(header(&[0, 0x81]), None, "no number has more than eight bytes");
        assert_eq!(header(&[0x42]), None);
        assert_eq!(unsigned(&[1, 0]), Some(256));
        assert_eq!(float(&1.5_f32.to_be_bytes()), Some(1.5));
    }
}

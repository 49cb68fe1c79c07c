//! Records of a workbook stream (BIFF), and the texts in them.

use super::bytes::{double, word};
use crate::import;

/// Goes on with the record before it.
const CONTINUE: u16 = 0x003c;

/// A record: its kind and where its content is in the stream.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    pub kind: u16,
    pub start: usize,
    pub end: usize,
}

impl Record {
    /// The record whose header stands at `at`; `None` if it leaves the stream.
    pub fn at(stream: &[u8], at: usize) -> Option<Self> {
        let start = at.checked_add(4)?;
        let end = start + usize::from(word(stream, at + 2)?);
        (end <= stream.len()).then_some(Self { kind: word(stream, at)?, start, end })
    }

    /// Its content without what continues it.
    pub fn content(self, stream: &[u8]) -> &[u8] {
        stream.get(self.start..self.end).unwrap_or_default()
    }
}

/// The content of a record and of the records that continue it.
#[derive(Debug)]
pub(super) struct Content<'a> {
    stream: &'a [u8],
    at: usize,
    /// The end of the present record.
    end: usize,
    units: Vec<u16>,
}

impl<'a> Content<'a> {
    /// From the beginning of a record.
    pub fn of(stream: &'a [u8], record: Record) -> Self {
        Self { stream, at: record.start, end: record.end, units: Vec::new() }
    }

    /// Moves on to the record that continues the present one.
    fn next_piece(&mut self) -> Option<()> {
        let next = Record::at(self.stream, self.end).filter(|record| record.kind == CONTINUE)?;
        (self.at, self.end) = (next.start, next.end);
        Some(())
    }

    /// True if nothing follows.
    pub fn is_at_end(&mut self) -> bool {
        while self.at >= self.end {
            if self.next_piece().is_none() {
                return true;
            }
        }
        false
    }

    /// The next byte.
    pub fn byte(&mut self) -> Option<u8> {
        if self.is_at_end() {
            return None;
        }
        let byte = self.stream.get(self.at).copied()?;
        self.at += 1;
        Some(byte)
    }

    fn number(&mut self, bytes: u32) -> Option<u32> {
        (0..bytes).try_fold(0, |number, place| Some(number | u32::from(self.byte()?) << (8 * place)))
    }

    /// The next number of 16 bits.
    pub fn word(&mut self) -> Option<u16> {
        u16::try_from(self.number(2)?).ok()
    }

    /// Passes over bytes.
    pub fn skip(&mut self, mut count: usize) -> Option<()> {
        while count > 0 {
            if self.is_at_end() {
                return None;
            }
            let step = count.min(self.end - self.at);
            self.at += step;
            count -= step;
        }
        Some(())
    }

    /// Appends a text of BIFF8 with `count` characters: flags, perhaps the sizes of what follows, characters of one or two
    /// bytes, formatting and pronunciation. Where a record continues it, the flags stand again.
    pub fn text(&mut self, count: usize, out: &mut String) -> Option<()> {
        let flags = self.byte()?;
        let runs = if flags & 8 != 0 { usize::from(self.word()?) } else { 0 };
        let extra = if flags & 4 != 0 { self.number(4)? as usize } else { 0 };
        let mut wide = flags & 1 != 0;
        self.units.clear();
        while self.units.len() < count {
            if self.at >= self.end {
                self.next_piece()?;
                wide = self.byte()? & 1 != 0;
            }
            let width = if wide { 2 } else { 1 };
            let left = (count - self.units.len()).min((self.end - self.at) / width);
            let chunk = self.stream.get(self.at..self.at + left * width).filter(|_| left > 0 || self.at == self.end)?;
            if wide {
                self.units.extend(chunk.chunks_exact(2).filter_map(|pair| word(pair, 0)));
            } else {
                self.units.extend(chunk.iter().map(|byte| u16::from(*byte)));
            }
            self.at += left * width;
        }
        let characters = char::decode_utf16(self.units.iter().copied());
        out.extend(characters.map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)));
        self.skip(extra.saturating_add(4 * runs))
    }

    /// A text of BIFF5 with `count` bytes.
    pub fn bytes(&mut self, count: usize) -> Option<String> {
        let bytes: Option<Vec<u8>> = (0..count.min(self.stream.len())).map(|_| self.byte()).collect();
        Some(import::characters(&bytes?).into_owned())
    }
}

/// A number as 30 bits of an integer or of a floating-point number, perhaps a hundredth of it.
pub(super) fn rk(bytes: &[u8], at: usize) -> Option<f64> {
    let bits = double(bytes, at)?;
    let number = if bits & 2 != 0 { f64::from(bits as i32 >> 2) } else { f64::from_bits(u64::from(bits & !3) << 32) };
    Some(if bits & 1 != 0 { number / 100.0 } else { number })
}

//! Records of a workbook stream (BIFF), and the texts in them.

use crate::import;
use packed::bytes::{double, word};

/// Kind of a record that continues the one before it.
const CONTINUE: u16 = 0x003c;

/// Record: its kind and the range of its content in the stream.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    pub kind: u16,
    pub start: usize,
    pub end: usize,
}

impl Record {
    /// Record with its header at the offset `at`; `None` if it exceeds the stream.
    pub fn at(stream: &[u8], at: usize) -> Option<Self> {
        let start = at.checked_add(4)?;
        let end = start + usize::from(word(stream, at + 2)?);
        (end <= stream.len()).then_some(Self { kind: word(stream, at)?, start, end })
    }

    /// Content without that of continuing records.
    pub fn content(self, stream: &[u8]) -> &[u8] {
        stream.get(self.start..self.end).unwrap_or_default()
    }
}

/// Content of a record and of the records that continue it.
#[derive(Debug)]
pub(super) struct Content<'a> {
    stream: &'a [u8],
    at: usize,
    /// End of the present record.
    end: usize,
    units: Vec<u16>,
}

impl<'a> Content<'a> {
    /// Content from the begin of a record.
    pub fn of(stream: &'a [u8], record: Record) -> Self {
        Self { stream, at: record.start, end: record.end, units: Vec::new() }
    }

    /// Moves to the record that continues the present one; `None` without one.
    fn next_piece(&mut self) -> Option<()> {
        let next = Record::at(self.stream, self.end).filter(|record| record.kind == CONTINUE)?;
        (self.at, self.end) = (next.start, next.end);
        Some(())
    }

    /// True if no content is left.
    pub fn is_at_end(&mut self) -> bool {
        while self.at >= self.end {
            if self.next_piece().is_none() {
                return true;
            }
        }
        false
    }

    /// Next byte; `None` at the end.
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

    /// Next integer of 16 bits; `None` at the end.
    pub fn word(&mut self) -> Option<u16> {
        u16::try_from(self.number(2)?).ok()
    }

    /// Skips `count` bytes; `None` if there are not as many.
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

    /// Appends a text of BIFF8 with `count` characters. It consists of flags, optional sizes of formatting and phonetic
    /// data, characters of one or two bytes, and these data. The flags are repeated at the begin of a continuing record.
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

    /// Text of BIFF5 with `count` bytes.
    pub fn bytes(&mut self, count: usize) -> Option<String> {
        let bytes: Option<Vec<u8>> = (0..count.min(self.stream.len())).map(|_| self.byte()).collect();
        Some(import::characters(&bytes?).into_owned())
    }
}

/// Number stored as 30 bits of an integer or of a floating-point number, optionally divided by 100.
pub(super) fn rk(bytes: &[u8], at: usize) -> Option<f64> {
    let bits = double(bytes, at)?;
    let number = if bits & 2 != 0 { f64::from(bits as i32 >> 2) } else { f64::from_bits(u64::from(bits & !3) << 32) };
    Some(if bits & 1 != 0 { number / 100.0 } else { number })
}

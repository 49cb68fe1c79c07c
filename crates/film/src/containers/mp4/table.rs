//! Tables of a track: offset, size and time of each frame (ISO/IEC 14496-12, 8.6 and 8.7).

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::film::{Sample, Samples};
use super::super::limits::MOST_SAMPLES;
use super::boxes::{find, rows};

/// Iterator over run-length encoded values, as in `stts` and `ctts`. Repeats the last value after the last row.
struct Runs<'a> {
    rows: Bytes<'a>,
    left: u32,
    value: u32,
}

impl<'a> Runs<'a> {
    fn new(rows: &'a [u8]) -> Self {
        Self { rows: Bytes(rows), left: 0, value: 0 }
    }

    fn next(&mut self) -> u32 {
        while self.left == 0 {
            let Some((count, value)) = self.rows.u32().zip(self.rows.u32()) else { return self.value };
            (self.left, self.value) = (count, value);
        }
        self.left -= 1;
        self.value
    }
}

/// Frame sizes from `stsz` or the compact `stz2`.
struct Sizes<'a> {
    count: usize,
    /// Common size of all frames in bytes, or 0.
    all: u32,
    /// Bits per entry of the table.
    bits: usize,
    table: &'a [u8],
}

impl<'a> Sizes<'a> {
    fn read(tables: &'a [u8]) -> Result<Self, FilmError> {
        let read = || {
            let (compact, content) = find(tables, b"stsz")
                .map(|content| (false, content))
                .or(find(tables, b"stz2").map(|content| (true, content)))?;
            let mut bytes = Bytes(content);
            bytes.take(4)?;
            let first = bytes.u32()?;
            let count = usize::try_from(bytes.u32()?).ok()?;
            let (all, bits) = match (compact, first) {
                (false, 0) => (0, 32),
                (false, all) => (all, 0),
                (true, bits) => (0, usize::try_from(bits & 0xff).ok().filter(|bits| [4, 8, 16].contains(bits))?),
            };
            let table = bytes.take(count.checked_mul(bits)?.div_ceil(8))?;
            Some(Self { count, all, bits, table })
        };
        read().ok_or(FilmError::Damaged { part: "stsz" })
    }

    fn get(&self, at: usize) -> u32 {
        if self.bits == 0 {
            return self.all;
        }
        let mut bytes = Bytes(self.table.get(at * self.bits / 8..).unwrap_or_default());
        match self.bits {
            32 => bytes.u32(),
            16 => bytes.u16().map(u32::from),
            8 => bytes.u8().map(u32::from),
            _ => bytes.u8().map(|pair| u32::from(if at.is_multiple_of(2) { pair >> 4 } else { pair & 0xf })),
        }
        .unwrap_or(0)
    }
}

/// Number of frames listed in the content of `stbl`.
pub(super) fn count(tables: &[u8]) -> usize {
    Sizes::read(tables).map_or(0, |sizes| sizes.count)
}

/// Frames with composition times, and the decoding time after the last one. `file`: size of the file in bytes.
///
/// # Errors
///
/// [`FilmError::Damaged`] for a missing or invalid table, [`FilmError::TooLarge`] for more than [`MOST_SAMPLES`]
/// frames.
pub(super) fn samples(tables: &[u8], file: u64) -> Result<(Samples, i64), FilmError> {
    let sizes = Sizes::read(tables)?;
    if sizes.count > MOST_SAMPLES {
        return Err(FilmError::TooLarge);
    }
    let table = |kind: &[u8; 4], row, part| find(tables, kind).map(|content| rows(content, row, part)).transpose();
    let mut durations = Runs::new(table(b"stts", 8, "stts")?.ok_or(FilmError::Damaged { part: "stts" })?);
    let mut offsets = Runs::new(table(b"ctts", 8, "ctts")?.unwrap_or_default());
    let mut keys = table(b"stss", 4, "stss")?.map(Bytes);
    let mut groups = Bytes(table(b"stsc", 12, "stsc")?.unwrap_or_default());
    let (chunks, wide) = match table(b"stco", 4, "stco")? {
        Some(chunks) => (chunks, false),
        None => (table(b"co64", 8, "co64")?.unwrap_or_default(), true),
    };
    let (mut chunks, mut chunk, mut in_each) = (Bytes(chunks), 0_u32, 0_u32);
    let mut samples = Samples::default();
    let (mut decoding, mut number) = (0_i64, 0);
    while let Some(mut offset) = if wide { chunks.u64() } else { chunks.u32().map(u64::from) } {
        chunk = chunk.saturating_add(1);
        // Each row holds from the chunk whose number, from 1, is its first field.
        while Bytes(groups.0).u32().is_some_and(|first| first <= chunk) {
            let row = groups.take(12).unwrap_or_default();
            in_each = Bytes(row.get(4..).unwrap_or_default()).u32().unwrap_or(0);
        }
        for _ in 0..in_each {
            if number == sizes.count {
                return Ok((samples, decoding));
            }
            let size = sizes.get(number);
            number += 1;
            // Some writers put negative offsets into tables of version 0, which has none.
            let ticks = decoding + i64::from(offsets.next().cast_signed());
            let key = keys.as_mut().is_none_or(|keys| is_listed(keys, number));
            samples.add(Sample { offset, size, ticks, key, shown: true }, file);
            decoding += i64::from(durations.next());
            offset = offset.saturating_add(size.into());
        }
    }
    // The table of sizes has more frames than the chunks hold; the rest is missing.
    samples.lost += sizes.count - number;
    Ok((samples, decoding))
}

/// True if `number` (from 1) is in a sorted table. Removes smaller entries from the front.
fn is_listed(numbers: &mut Bytes<'_>, number: usize) -> bool {
    let next = |numbers: &Bytes<'_>| Bytes(numbers.0).u32().and_then(|next| usize::try_from(next).ok());
    while next(numbers).is_some_and(|next| next < number) {
        numbers.u32();
    }
    next(numbers) == Some(number)
}

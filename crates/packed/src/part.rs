//! File of an archive, or a text, as a stream of bytes. It never returns more than the directory states, and never more
//! than a bound between two tokens of its reader.

use crate::Defect;
use crate::checksum::Checksum;
use miniz_oxide::inflate::stream::{InflateState, inflate};
use miniz_oxide::{DataFormat, MZFlush, MZStatus};
use std::io::{self, BufRead, Read};
use std::ops::Range;
use std::rc::Rc;

/// Number of bytes expanded at once.
const CHUNK: usize = 32 << 10;
/// Greatest length of a tag or text of a workbook, in bytes: a cell holds 32767 characters.
const LONGEST_TOKEN: usize = 1 << 20;
/// Greatest length of a text of a project, in bytes. It may hold the values of all frames: 20 bytes for each of the 300,000
/// frames of its longest clip.
const LONGEST_ARRAY: usize = 16 << 20;

/// Stream of the expanded bytes.
pub struct Part {
    bytes: Rc<Vec<u8>>,
    /// Range of the bytes still packed.
    packed: Range<usize>,
    length: usize,
    /// State of the decompressor; `None` for stored bytes.
    inflate: Option<Box<InflateState>>,
    chunk: Vec<u8>,
    /// Number of bytes taken from the chunk.
    taken: usize,
    /// Number of bytes still to come.
    left: u64,
    checksum: Checksum,
    /// Stated checksum; `None` for a text.
    expected: Option<u32>,
    token: usize,
    longest: usize,
    ended: bool,
    refusal: Option<Defect>,
}

impl std::fmt::Debug for Part {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Part").field("packed", &self.packed).field("left", &self.left).finish_non_exhaustive()
    }
}

impl Part {
    /// Stream of a file of an archive. `packed`: its range in `bytes`; `expanded`: stated size, in bytes; `expected`: stated CRC-32.
    pub(crate) fn new(bytes: Rc<Vec<u8>>, packed: Range<usize>, deflated: bool, expanded: u64, expected: u32) -> Self {
        Self {
            bytes,
            length: packed.len(),
            packed,
            inflate: deflated.then(|| InflateState::new_boxed(DataFormat::Raw)),
            chunk: Vec::new(),
            taken: 0,
            left: expanded,
            checksum: Checksum::default(),
            expected: Some(expected),
            token: 0,
            longest: LONGEST_TOKEN,
            ended: false,
            refusal: None,
        }
    }

    /// Stream of a text, in which one token may hold the values of all frames.
    pub fn of_text(bytes: Vec<u8>) -> Self {
        let length = bytes.len();
        let part = Self::new(Rc::new(bytes), 0..length, false, length as u64, 0);
        Self { expected: None, longest: LONGEST_ARRAY, ..part }
    }

    /// Appends about `budget` bytes to `bytes`. Returns true at the end.
    ///
    /// # Errors
    /// The file contradicts the directory of the archive.
    pub fn expand(&mut self, budget: usize, bytes: &mut Vec<u8>) -> Result<bool, Defect> {
        let end = bytes.len().saturating_add(budget);
        while bytes.len() < end {
            // Plain bytes have no tokens.
            self.begin_token();
            let Ok(chunk) = self.fill_buf() else { return Err(self.refusal().unwrap_or(Defect::Damaged)) };
            let count = chunk.len();
            if count == 0 {
                return Ok(true);
            }
            bytes.extend_from_slice(chunk);
            self.consume(count);
        }
        Ok(false)
    }

    /// Begins the next token, for the bound on its length.
    pub fn begin_token(&mut self) {
        self.token = 0;
    }

    /// Progress, from 0 to 1.
    pub fn progress(&self) -> f64 {
        if self.length == 0 { 1.0 } else { 1.0 - self.packed.len() as f64 / self.length as f64 }
    }

    /// Reason why the stream ended early.
    pub fn refusal(&mut self) -> Option<Defect> {
        self.refusal.take()
    }

    fn refuse(&mut self, refusal: Defect) -> io::Error {
        self.refusal = Some(refusal);
        io::ErrorKind::InvalidData.into()
    }

    /// Expands the next chunk.
    fn refill(&mut self) -> io::Result<()> {
        self.chunk.clear();
        self.taken = 0;
        let input = self.bytes.get(self.packed.clone()).unwrap_or_default();
        let (consumed, ended) = match &mut self.inflate {
            None => {
                let count = input.len().min(CHUNK);
                self.chunk.extend_from_slice(input.get(..count).unwrap_or_default());
                (count, count == input.len())
            }
            Some(state) => {
                self.chunk.resize(CHUNK, 0);
                let result = inflate(state, input, &mut self.chunk, MZFlush::None);
                self.chunk.truncate(result.bytes_written);
                match result.status {
                    Ok(status) => (result.bytes_consumed, status == MZStatus::StreamEnd),
                    Err(_) => return Err(self.refuse(Defect::Damaged)),
                }
            }
        };
        self.packed.start += consumed;
        self.ended = ended;
        self.checksum.add(&self.chunk);
        match self.left.checked_sub(self.chunk.len() as u64) {
            Some(left) => self.left = left,
            // More than the directory states: the file is manipulated.
            None => return Err(self.refuse(Defect::Damaged)),
        }
        let changed = self.expected.is_some_and(|expected| self.checksum.value() != expected);
        if ended && (self.left > 0 || changed) {
            return Err(self.refuse(Defect::Damaged));
        }
        Ok(())
    }
}

impl Read for Part {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let available = self.fill_buf()?;
        let count = available.len().min(out.len());
        out[..count].copy_from_slice(&available[..count]);
        self.consume(count);
        Ok(count)
    }
}

impl BufRead for Part {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.token > self.longest {
            return Err(self.refuse(Defect::Damaged));
        }
        while self.taken == self.chunk.len() && !self.ended {
            self.refill()?;
        }
        Ok(self.chunk.get(self.taken..).unwrap_or_default())
    }

    fn consume(&mut self, count: usize) {
        self.taken = (self.taken + count).min(self.chunk.len());
        self.token += count;
    }
}

//! Compound files (MS-CFB): a file system of chained sectors that contains the stream of an old workbook. Chains are
//! bounded by the length of the file, and so is the allocated memory.

use packed::bytes::{double, word};

/// First bytes of a compound file.
pub(super) const MAGIC: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";
const HEADER: usize = 512;
/// Number of entries of the sector table (FAT) in the header.
const LISTED: usize = 109;
/// Greater sector numbers mean the end of a chain or an unused sector.
const LARGEST_SECTOR: u32 = 0xffff_fffa;
const ENTRY: usize = 128;
/// Upper bound of the entries of the directory; more occur only in damaged files.
const MOST_ENTRIES: usize = 10_000;
const NONE: u32 = u32::MAX;

/// Compound file.
#[derive(Debug)]
pub(super) struct CompoundFile<'a> {
    sectors: Sectors<'a>,
    /// Content of the small streams, which share one chain of sectors.
    small: Vec<u8>,
    small_table: Vec<u32>,
    small_size: usize,
    /// Size below which a stream is small, in bytes.
    cutoff: usize,
    directory: Vec<u8>,
}

/// Sectors, with the table that chains them.
#[derive(Debug)]
struct Sectors<'a> {
    /// Bytes of the file after the header.
    bytes: &'a [u8],
    /// Size of a sector, in bytes.
    size: usize,
    table: Vec<u32>,
}

impl<'a> CompoundFile<'a> {
    /// Reads the directory; `None` if the file is damaged.
    pub fn open(bytes: &'a [u8]) -> Option<Self> {
        let shift = |at| word(bytes, at).map(u32::from);
        let size = 1_usize << shift(30).filter(|shift| (7..=16).contains(shift))?;
        let small_size = 1_usize << shift(32).filter(|shift| (4..=12).contains(shift))?;
        let mut sectors = Sectors { bytes: bytes.get(size.max(HEADER)..)?, size, table: Vec::new() };
        sectors.table = sectors.read_table(bytes)?;
        let directory = sectors.chain(double(bytes, 48)?)?;
        let small_table = match double(bytes, 60)? {
            first if first < LARGEST_SECTOR => numbers(&sectors.chain(first)?),
            _ => Vec::new(),
        };
        let mut file = Self {
            sectors,
            small: Vec::new(),
            small_table,
            small_size,
            cutoff: double(bytes, 56)? as usize,
            directory,
        };
        // The first entry is the root; its content holds the small streams.
        let root = double(file.directory.get(..ENTRY)?, 116)?;
        if root < LARGEST_SECTOR && !file.small_table.is_empty() {
            file.small = file.sectors.chain(root)?;
        }
        Some(file)
    }

    /// Content of a stream directly below the root; `None` if there is none of this name, or it is damaged.
    pub fn stream(&self, name: &str) -> Option<Vec<u8>> {
        let entry = self.find(name)?;
        let (first, length) = (double(entry, 116)?, double(entry, 120)? as usize);
        let mut content = if length >= self.cutoff {
            self.sectors.chain(first)?
        } else {
            chain(&self.small, self.small_size, &self.small_table, first)?
        };
        content.truncate(length);
        Some(content)
    }

    /// True if there is a stream of this name directly below the root.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// Finds an entry directly below the root. The directory is a tree: each entry has siblings on its left and right.
    /// Embedded documents have streams of the same names at a deeper level.
    fn find(&self, name: &str) -> Option<&[u8]> {
        let entry = |number: u32| {
            let start = (number as usize).checked_mul(ENTRY)?;
            self.directory.get(start..start.checked_add(ENTRY)?)
        };
        let mut open = vec![double(entry(0)?, 76)?];
        let mut visited = 0;
        while let Some(number) = open.pop() {
            visited += 1;
            let Some(found) = entry(number).filter(|_| number != NONE) else { continue };
            if visited > MOST_ENTRIES {
                return None;
            }
            if found.get(66) == Some(&2) && is_called(found, name) {
                return Some(found);
            }
            open.extend([double(found, 68)?, double(found, 72)?].into_iter().filter(|next| *next != NONE));
        }
        None
    }
}

/// True if an entry of the directory has this ASCII name.
fn is_called(entry: &[u8], name: &str) -> bool {
    let length = word(entry, 64).map_or(0, usize::from).saturating_sub(2);
    let units = entry.get(..length.min(64)).unwrap_or_default().chunks_exact(2);
    units.map(|unit| unit.iter().fold(0, |unit, byte| unit >> 8 | u16::from(*byte) << 8)).eq(name.encode_utf16())
}

impl Sectors<'_> {
    /// Table of all sectors; the sectors of the table itself are listed in the header and in a chain after it.
    fn read_table(&self, bytes: &[u8]) -> Option<Vec<u32>> {
        let count = self.bytes.len().div_ceil(self.size);
        let mut listed: Vec<u32> = (0..LISTED).filter_map(|index| double(bytes, 76 + 4 * index)).collect();
        let mut next = double(bytes, 68)?;
        // Bounded, because a damaged chain may be circular.
        for _ in 0..count {
            let Some(list) = self.sector(next) else { break };
            let mut numbers = numbers(list);
            next = numbers.pop().unwrap_or(NONE);
            listed.extend(numbers);
            if listed.len() > count {
                break;
            }
        }
        let mut table = Vec::new();
        for list in listed.into_iter().filter_map(|number| self.sector(number)) {
            if table.len() >= count {
                break;
            }
            table.extend(numbers(list));
        }
        Some(table)
    }

    /// Content of a sector; the last one of a file may be truncated.
    fn sector(&self, number: u32) -> Option<&[u8]> {
        sector(self.bytes, self.size, number)
    }

    fn chain(&self, first: u32) -> Option<Vec<u8>> {
        chain(self.bytes, self.size, &self.table, first)
    }
}

fn sector(bytes: &[u8], size: usize, number: u32) -> Option<&[u8]> {
    let start = (number as usize).checked_mul(size)?;
    let rest = bytes.get(start..).filter(|rest| !rest.is_empty())?;
    Some(rest.get(..size).unwrap_or(rest))
}

/// Concatenated sectors of a chain; `None` if it leaves the file or is longer than it.
fn chain(bytes: &[u8], size: usize, table: &[u32], first: u32) -> Option<Vec<u8>> {
    let mut content = Vec::new();
    let mut number = first;
    while number < LARGEST_SECTOR {
        if content.len() > bytes.len() {
            return None;
        }
        content.extend_from_slice(sector(bytes, size, number)?);
        number = *table.get(number as usize)?;
    }
    Some(content)
}

fn numbers(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|four| four.iter().rev().fold(0, |number, byte| number << 8 | u32::from(*byte))).collect()
}

//! A WebAssembly module as streams of bytes of one kind each. Numbers of local variables resemble each other, and so do
//! operations, or the offsets of loads; as they alternate in a module, a compressor sees little of it. Taken apart, the
//! module becomes a sixth smaller when packed.
//!
//! One walk over the module, as its binary format has it (WebAssembly core specification, chapter 5), says of what kind the
//! next byte is; it depends on nothing but the bytes before. Taking apart and joining make the same walk. Whatever the bytes
//! are, each is therefore put back where it was: an instruction that the walk does not know costs room, and no more.

/// What a byte is, and in which stream it therefore stands.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Whatever stands outside of code and data.
    Frame,
    Data,
    /// The size of a function.
    Size,
    /// The types of local variables.
    Types,
    /// Instructions, with the alignments of what they load and the functions they call: both go with the instructions around.
    Instruction,
    /// The type of a block.
    Block,
    /// Where branches lead.
    Branch,
    /// The local variable that is read, and the one that is written.
    Read,
    Write,
    /// The offset of a load, and of a store.
    Load,
    Store,
    Integer,
    LongInteger,
    Float,
    /// Numbers of globals, tables, types and the like.
    Index,
}

const KINDS: usize = Kind::Index as usize + 1;
/// Before the streams stands how long each is, little-endian.
const HEAD: usize = KINDS * size_of::<u32>();

/// The streams of a module, one after the other; none if it is larger than a module can be.
#[must_use]
pub fn split(module: &[u8]) -> Option<Vec<u8>> {
    let mut streams: [Vec<u8>; KINDS] = Default::default();
    let mut bytes = module.iter().copied();
    let take = |kind: Kind| {
        let byte = bytes.next()?;
        streams[kind as usize].push(byte);
        Some(byte)
    };
    Walk { take, place: 0 }.module();
    let mut parts = Vec::with_capacity(HEAD + module.len());
    for stream in &streams {
        parts.extend(u32::try_from(stream.len()).ok()?.to_le_bytes());
    }
    parts.extend(streams.concat());
    Some(parts)
}

/// The module of which these are the streams; none if they are of none.
#[must_use]
pub fn join(parts: &[u8]) -> Option<Vec<u8>> {
    let (head, mut rest) = parts.split_at_checked(HEAD)?;
    let mut module = Vec::with_capacity(rest.len());
    let mut streams = [const { [].as_slice() }; KINDS];
    for (stream, size) in streams.iter_mut().zip(head.as_chunks().0) {
        (*stream, rest) = rest.split_at_checked(usize::try_from(u32::from_le_bytes(*size)).ok()?)?;
    }
    let take = |kind: Kind| {
        let (byte, left) = streams[kind as usize].split_first()?;
        streams[kind as usize] = left;
        module.push(*byte);
        Some(*byte)
    };
    Walk { take, place: 0 }.module();
    (module.len() == parts.len() - HEAD).then_some(module)
}

/// Goes through a module. Each of its steps ends with none where there are no more bytes, and takes one at least, so that it
/// does end.
struct Walk<F> {
    /// Takes the next byte, which is of this kind.
    take: F,
    /// How many bytes were taken.
    place: u32,
}

impl<F: FnMut(Kind) -> Option<u8>> Walk<F> {
    fn byte(&mut self, kind: Kind) -> Option<u8> {
        self.place = self.place.wrapping_add(1);
        (self.take)(kind)
    }

    /// A number in LEB128; of one that is longer than 32 bits, the lower ones.
    fn number(&mut self, kind: Kind) -> Option<u32> {
        let mut number = 0;
        let mut shift = 0;
        loop {
            let byte = self.byte(kind)?;
            number |= u32::from(byte & 0x7f).checked_shl(shift).unwrap_or(0);
            shift = (shift + 7).min(u32::BITS);
            if byte < 0x80 {
                return Some(number);
            }
        }
    }

    fn numbers(&mut self, kind: Kind, count: u32) -> Option<()> {
        (0..count).try_for_each(|_| self.number(kind).map(drop))
    }

    fn bytes(&mut self, kind: Kind, count: u32) -> Option<()> {
        (0..count).try_for_each(|_| self.byte(kind).map(drop))
    }

    fn module(&mut self) -> Option<()> {
        self.bytes(Kind::Frame, 8)?;
        loop {
            let section = self.byte(Kind::Frame)?;
            let size = self.number(Kind::Frame)?;
            match section {
                10 => {
                    for _ in 0..self.number(Kind::Frame)? {
                        self.function()?;
                    }
                }
                11 => self.bytes(Kind::Data, size)?,
                _ => self.bytes(Kind::Frame, size)?,
            }
        }
    }

    fn function(&mut self) -> Option<()> {
        let size = self.number(Kind::Size)?;
        let end = self.place.saturating_add(size);
        for _ in 0..self.number(Kind::Types)? {
            self.number(Kind::Types)?;
            self.byte(Kind::Types)?;
        }
        while self.place < end {
            self.instruction()?;
        }
        Some(())
    }

    fn instruction(&mut self) -> Option<()> {
        match self.byte(Kind::Instruction)? {
            // block, loop, if
            0x02..=0x04 => self.numbers(Kind::Block, 1),
            // br, br_if
            0x0c | 0x0d => self.numbers(Kind::Branch, 1),
            // br_table: how many, those, and the one for the rest
            0x0e => {
                let count = self.number(Kind::Branch)?;
                self.numbers(Kind::Branch, count)?;
                self.numbers(Kind::Branch, 1)
            }
            // call, return_call
            0x10 | 0x12 => self.numbers(Kind::Instruction, 1),
            // call_indirect, return_call_indirect
            0x11 | 0x13 => self.numbers(Kind::Index, 2),
            // select with types
            0x1c => {
                let count = self.number(Kind::Index)?;
                self.numbers(Kind::Index, count)
            }
            // local.get
            0x20 => self.numbers(Kind::Read, 1),
            // local.set, local.tee
            0x21 | 0x22 => self.numbers(Kind::Write, 1),
            // global.get, global.set, table.get, table.set, memory.size, memory.grow, ref.null, ref.func
            0x23..=0x26 | 0x3f | 0x40 | 0xd0 | 0xd2 => self.numbers(Kind::Index, 1),
            // loads
            0x28..=0x35 => {
                self.numbers(Kind::Instruction, 1)?;
                self.numbers(Kind::Load, 1)
            }
            // stores
            0x36..=0x3e => {
                self.numbers(Kind::Instruction, 1)?;
                self.numbers(Kind::Store, 1)
            }
            // i32.const, i64.const, f32.const, f64.const
            0x41 => self.numbers(Kind::Integer, 1),
            0x42 => self.numbers(Kind::LongInteger, 1),
            0x43 => self.bytes(Kind::Float, 4),
            0x44 => self.bytes(Kind::Float, 8),
            0xfc => match self.number(Kind::Instruction)? {
                // memory.init, memory.copy, table.init, table.copy
                8 | 10 | 12 | 14 => self.numbers(Kind::Index, 2),
                // data.drop, memory.fill, elem.drop, table.grow, table.size, table.fill
                9 | 11 | 13 | 15..=17 => self.numbers(Kind::Index, 1),
                // conversions that saturate
                _ => Some(()),
            },
            // arithmetic and comparisons
            _ => Some(()),
        }
    }
}

//! Generator of old workbooks (XLS): records in a stream, and the stream in a compound file.

/// Content of a cell.
#[derive(Clone, Debug)]
pub enum Cell {
    Number(f64),
    /// A number with a cell format by its number.
    Formatted(f64, u16),
    /// The bits of a compact number.
    Rk(u32),
    /// Several compact numbers side by side.
    Rks(Vec<u32>),
    Shared(u32),
    Label(&'static str),
    /// The stored result of a formula.
    Formula([u8; 8]),
    /// Stored text of a formula, in a record of its own.
    TextFormula(&'static str),
    /// A code, and 1 for an error.
    Code(u8, u8),
}

/// Number formats of the cells, by the index in [`Cell::Formatted`]: general, per cent, date, duration, and two formats
/// defined in the workbook.
const STYLES: [u16; 7] = [0, 9, 14, 46, 164, 165, 10];
const FORMATS: [(u16, &str); 2] = [(164, "yyyy-mm-dd hh:mm:ss.000"), (165, "0.0\"%\"")];

/// A cell with its row and column.
pub type Placed = (u16, u16, Cell);

/// A workbook.
#[derive(Clone, Debug, Default)]
pub struct OldWorkbook {
    /// Names, and cells with row and column.
    pub sheets: Vec<(&'static str, Vec<Placed>)>,
    /// Shared texts. Each may be split into pieces, each in its own record; true for two bytes per character.
    pub texts: Vec<Vec<(&'static str, bool)>>,
    pub from_1904: bool,
    /// BIFF5 instead of BIFF8.
    pub five: bool,
    pub encrypted: bool,
}

fn record(out: &mut Vec<u8>, kind: u16, content: &[u8]) {
    out.extend(kind.to_le_bytes());
    out.extend((content.len() as u16).to_le_bytes());
    out.extend(content);
}

fn words(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

impl OldWorkbook {
    /// Bytes of the stream, which are a file with or without [`compound`].
    pub fn stream(&self) -> Vec<u8> {
        let version = if self.five { 0x500 } else { 0x600 };
        let mut out = Vec::new();
        record(&mut out, 0x809, &words(&[version, 5, 0, 0, 0, 0, 0, 0]));
        if self.encrypted {
            record(&mut out, 0x2f, &[0; 6]);
        }
        record(&mut out, 0x22, &words(&[u16::from(self.from_1904)]));
        for (id, code) in FORMATS {
            let mut content = words(&[id]);
            content.extend(self.text(code, !self.five));
            record(&mut out, 0x41e, &content);
        }
        for style in STYLES {
            record(&mut out, 0xe0, &words(&[0, style, 0, 0, 0, 0, 0, 0, 0, 0]));
        }
        let mut places = Vec::new();
        for (name, _) in &self.sheets {
            places.push(out.len() + 4);
            let mut content = vec![0; 6];
            content.extend(self.text(name, false));
            record(&mut out, 0x85, &content);
        }
        if !self.five {
            self.shared(&mut out);
        }
        record(&mut out, 0x0a, &[]);
        for ((_, cells), place) in self.sheets.iter().zip(places) {
            let start = (out.len() as u32).to_le_bytes();
            out[place..place + 4].copy_from_slice(&start);
            record(&mut out, 0x809, &words(&[version, 0x10, 0, 0, 0, 0, 0, 0]));
            for (row, column, cell) in cells {
                self.cell(&mut out, *row, *column, cell);
            }
            record(&mut out, 0x0a, &[]);
        }
        out
    }

    /// The file.
    pub fn bytes(&self) -> Vec<u8> {
        compound(if self.five { "Book" } else { "Workbook" }, &self.stream())
    }

    /// A text with its length, in one byte or two.
    fn text(&self, text: &str, long: bool) -> Vec<u8> {
        let length = text.encode_utf16().count() as u16;
        let mut out = if long { words(&[length]) } else { vec![length as u8] };
        if self.five {
            out.extend(text.chars().map(|character| character as u32 as u8));
        } else {
            out.push(1);
            out.extend(words(&text.encode_utf16().collect::<Vec<_>>()));
        }
        out
    }

    fn shared(&self, out: &mut Vec<u8>) {
        let count = (self.texts.len() as u32).to_le_bytes();
        let mut content = [count, count].concat();
        let mut kind = 0xfc;
        for pieces in &self.texts {
            let length = pieces.iter().map(|(piece, _)| piece.encode_utf16().count()).sum::<usize>();
            content.extend((length as u16).to_le_bytes());
            for (index, (piece, wide)) in pieces.iter().enumerate() {
                if index > 0 {
                    record(out, kind, &content);
                    (kind, content) = (0x3c, Vec::new());
                }
                // The first piece says that two runs of formatting and five other bytes follow.
                let rich = pieces.len() > 1;
                content.push(u8::from(*wide) | if rich && index == 0 { 0x0c } else { 0 });
                if rich && index == 0 {
                    content.extend([2, 0, 5, 0, 0, 0]);
                }
                let units: Vec<u16> = piece.encode_utf16().collect();
                content.extend(if *wide { words(&units) } else { units.iter().map(|unit| *unit as u8).collect() });
                if rich && index == pieces.len() - 1 {
                    content.extend([7; 13]);
                }
            }
        }
        record(out, kind, &content);
    }

    fn cell(&self, out: &mut Vec<u8>, row: u16, column: u16, cell: &Cell) {
        let place = |style: u16| words(&[row, column, style]);
        match cell {
            Cell::Number(value) => record(out, 0x203, &[place(0), value.to_le_bytes().to_vec()].concat()),
            Cell::Formatted(value, style) => {
                record(out, 0x203, &[place(*style), value.to_le_bytes().to_vec()].concat());
            }
            Cell::Rk(bits) => record(out, 0x27e, &[place(0), bits.to_le_bytes().to_vec()].concat()),
            Cell::Rks(entries) => {
                let mut content = words(&[row, column]);
                for bits in entries {
                    content.extend(words(&[0]));
                    content.extend(bits.to_le_bytes());
                }
                content.extend(words(&[column + entries.len() as u16 - 1]));
                record(out, 0xbd, &content);
            }
            Cell::Shared(index) => record(out, 0xfd, &[place(0), index.to_le_bytes().to_vec()].concat()),
            Cell::Label(text) => record(out, 0x204, &[place(0), self.text(text, true)].concat()),
            Cell::Formula(result) => record(out, 6, &[place(0), result.to_vec(), vec![0; 8]].concat()),
            Cell::TextFormula(text) => {
                record(out, 6, &[place(0), vec![0, 0, 0, 0, 0, 0, 0xff, 0xff], vec![0; 8]].concat());
                record(out, 0x207, &self.text(text, true));
            }
            Cell::Code(code, error) => record(out, 0x205, &[place(0), vec![*code, *error]].concat()),
        }
    }
}

/// A compound file with one stream: a small one lies in the chain of small streams.
pub fn compound(name: &str, stream: &[u8]) -> Vec<u8> {
    const END: u32 = 0xffff_fffe;
    let is_small = stream.len() < 4096;
    let padded = |bytes: &[u8], to: usize| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(to), 0);
        bytes
    };
    let data = padded(stream, 512);
    let sectors = data.len() / 512;
    // Sectors: the directory, the table of small sectors, the stream, the table of sectors.
    let chain = |first: usize, count: usize| {
        (0..count).map(move |index| if index + 1 == count { END } else { (first + index + 1) as u32 })
    };
    let tables = (sectors + 2).div_ceil(127);
    let mut table: Vec<u32> = vec![END, END];
    table.extend(chain(2, sectors));
    table.extend(vec![0xffff_fffd; tables]);
    let mut small: Vec<u32> = if is_small { chain(0, stream.len().div_ceil(64)).collect() } else { Vec::new() };
    small.resize(128, u32::MAX);
    let bytes = |numbers: Vec<u32>| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let entry = |name: &str, kind: u8, child: u32, first: u32, size: usize| {
        let mut entry: Vec<u8> = name.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let length = entry.len() as u16 + 2;
        entry.resize(64, 0);
        entry.extend(length.to_le_bytes());
        entry.extend([kind, 1]);
        entry.extend(bytes(vec![u32::MAX, u32::MAX, child]));
        entry.resize(116, 0);
        entry.extend(bytes(vec![first, size as u32, 0]));
        entry
    };
    let root = entry("Root Entry", 5, 1, if is_small { 2 } else { END }, if is_small { data.len() } else { 0 });
    let own = entry(name, 2, u32::MAX, if is_small { 0 } else { 2 }, stream.len());
    let mut out = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1".to_vec();
    out.resize(24, 0);
    out.extend(words(&[0x3e, 3, 0xfffe, 9, 6]));
    out.resize(44, 0);
    out.extend(bytes(vec![tables as u32, 0, 0, 4096, if is_small { 1 } else { END }, 1, END, 0]));
    let mut listed: Vec<u32> = (0..tables).map(|index| (2 + sectors + index) as u32).collect();
    listed.resize(109, u32::MAX);
    out.extend(bytes(listed));
    out.extend(padded(&[root, own].concat(), 512));
    out.extend(bytes(small));
    out.extend(data);
    table.resize(128 * tables, u32::MAX);
    out.extend(bytes(table));
    out
}

//! Numbers of many runs side by side: a row for each quantity, with one number per lane.

/// Number of lanes in a block.
pub const WIDTH: usize = 8;

/// Numbers of neighbouring lanes, aligned for the widest registers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Block(pub [f64; WIDTH]);

impl Block {
    /// The number in all lanes.
    pub const fn of(value: f64) -> Self {
        Self([value; WIDTH])
    }

    /// Computes the number of each lane. `number` must read from local copies of blocks, not from behind references that could be
    /// those of the result: otherwise the numbers are not computed by SIMD.
    #[inline(always)]
    pub fn each(mut number: impl FnMut(usize) -> f64) -> Self {
        // `std::array::from_fn` is not always inlined, and is then compiled without the features. A loop is not always unrolled.
        Self([number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7)])
    }
}

/// Choice of lanes of a block: all bits of a lane are 1 or 0.
///
/// A comparison in place of the bits would be compiled to stores of single lanes, which take many times as long on some processors.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Mask([u64; WIDTH]);

impl Mask {
    /// No lane.
    pub const NONE: Self = Self([0; WIDTH]);

    /// The lanes in which `holds` is true.
    #[inline(always)]
    pub fn each(holds: impl Fn(usize) -> bool) -> Self {
        let bits = |lane: usize| u64::from(holds(lane)).wrapping_neg();
        Self([bits(0), bits(1), bits(2), bits(3), bits(4), bits(5), bits(6), bits(7)])
    }

    /// True if a lane is chosen.
    #[inline(always)]
    pub fn has(&self, lane: usize) -> bool {
        self.0[lane] != 0
    }

    /// Chooses a lane, or does not.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, chosen: bool) {
        self.0[lane] = u64::from(chosen).wrapping_neg();
    }

    /// The number of each lane from `chosen` if the lane is chosen, otherwise from `other`.
    #[inline(always)]
    pub fn choose(self, chosen: Block, other: Block) -> Block {
        Block::each(|lane| {
            let other = other.0[lane].to_bits();
            f64::from_bits(other ^ ((other ^ chosen.0[lane].to_bits()) & self.0[lane]))
        })
    }
}

/// Rows of equal length, each a list of blocks.
#[derive(Clone, Debug, Default)]
pub struct Grid {
    /// Number of blocks in a row.
    blocks: usize,
    data: Vec<Block>,
}

impl Grid {
    /// Rows of zeros.
    pub fn new(rows: usize, blocks: usize) -> Self {
        Self { blocks, data: vec![Block::of(0.0); rows * blocks] }
    }

    /// One row per number, which is in all lanes.
    pub fn of(numbers: &[f64], blocks: usize) -> Self {
        let data = numbers.iter().flat_map(|&number| std::iter::repeat_n(Block::of(number), blocks)).collect();
        Self { blocks, data }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.data.len() / self.blocks.max(1)
    }

    /// Number of blocks in a row.
    #[inline(always)]
    pub fn blocks(&self) -> usize {
        self.blocks
    }

    /// The blocks of a row.
    #[inline(always)]
    pub fn row(&self, row: usize) -> &[Block] {
        &self.data[row * self.blocks..][..self.blocks]
    }

    /// The blocks of a row.
    #[inline(always)]
    pub fn row_mut(&mut self, row: usize) -> &mut [Block] {
        &mut self.data[row * self.blocks..][..self.blocks]
    }

    /// The rows before `row`, and those from it on.
    #[inline(always)]
    pub fn split(&mut self, row: usize) -> (&mut [Block], &mut [Block]) {
        self.data.split_at_mut(row * self.blocks)
    }

    /// The number of a lane in a row.
    #[inline(always)]
    pub fn get(&self, row: usize, lane: usize) -> f64 {
        self.data[row * self.blocks + lane / WIDTH].0[lane % WIDTH]
    }

    /// Sets the number of a lane in a row.
    #[inline(always)]
    pub fn set(&mut self, row: usize, lane: usize, value: f64) {
        self.data[row * self.blocks + lane / WIDTH].0[lane % WIDTH] = value;
    }

    /// Sets the numbers of a lane in the first rows.
    pub fn set_lane(&mut self, lane: usize, values: &[f64]) {
        values.iter().enumerate().for_each(|(row, &value)| self.set(row, lane, value));
    }

    /// The numbers of a lane, one for each row.
    pub fn list(&self, lane: usize) -> Vec<f64> {
        (0..self.rows()).map(|row| self.get(row, lane)).collect()
    }

    /// True if all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.data.iter().flat_map(|block| &block.0).fold(true, |finite, number| finite & number.is_finite())
    }

    /// Sets a row to one number in all lanes.
    #[inline(always)]
    pub fn fill(&mut self, row: usize, value: f64) {
        self.row_mut(row).fill(Block::of(value));
    }
}

/// Computes a row from one other.
#[inline(always)]
pub fn one(to: &mut [Block], a: &[Block], operation: impl Fn(f64) -> f64) {
    for (to, a) in to.iter_mut().zip(a) {
        let a = *a;
        *to = Block::each(|lane| operation(a.0[lane]));
    }
}

/// Computes a row from two others.
#[inline(always)]
pub fn two(to: &mut [Block], a: &[Block], b: &[Block], operation: impl Fn(f64, f64) -> f64) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        let (a, b) = (*a, *b);
        *to = Block::each(|lane| operation(a.0[lane], b.0[lane]));
    }
}

/// Computes a row from three others.
#[inline(always)]
pub fn three(to: &mut [Block], [a, b, c]: [&[Block]; 3], operation: impl Fn(f64, f64, f64) -> f64) {
    for (((to, a), b), c) in to.iter_mut().zip(a).zip(b).zip(c) {
        let (a, b, c) = (*a, *b, *c);
        *to = Block::each(|lane| operation(a.0[lane], b.0[lane], c.0[lane]));
    }
}

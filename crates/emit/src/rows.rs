//! Lists in the order of the model, as the engine reads and writes them: rows, records, and what a window begins with. Where the code has
//! another order, positions and velocities alternate in the model.

use crate::lists::{LEAST, ranges};
use crate::sink::{BLOCK, Local, RECORD, ROW, Sink, Values};
use std::ops::Range;

/// States that follow one another in the model.
#[derive(Debug)]
pub(crate) enum Row {
    /// Consecutive states.
    Consecutive(Range<usize>),
    /// States each of which is followed by one of as many others, which begin at this one.
    Alternating(Range<usize>, usize),
}

/// The states for which a condition holds. `index`: index of each state in the model; `places`: place of each state of the model.
pub(crate) fn rows(index: &[usize], places: &[usize], condition: impl Fn(usize) -> bool) -> Vec<Row> {
    let mut left: Vec<bool> = (0..index.len()).map(&condition).collect();
    let mut rows = Vec::new();
    for range in ranges(index.len(), |a, b| left[a] && left[b] && index[a] + 2 == index[b]) {
        let Some(&other) = places.get(index[range.start] + 1) else { continue };
        let follow = |k: usize| places.get(index[k] + 1) == Some(&(other + k - range.start));
        if range.len() >= LEAST && other >= range.end && range.clone().all(|k| left[k] && follow(k)) {
            let others = other..other + range.len();
            if others.clone().all(|k| left[k]) {
                left[range.clone()].fill(false);
                left[others].fill(false);
                rows.push(Row::Alternating(range, other));
            }
        }
    }
    let consecutive = ranges(index.len(), |a, b| left[a] == left[b] && index[a] + 1 == index[b]);
    rows.extend(consecutive.into_iter().filter(|range| left[range.start]).map(Row::Consecutive));
    rows
}

/// Number from which places of the block are counted.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Origin {
    Block,
    /// The row of the step.
    Row,
    /// The record of the last step.
    Record,
}

/// Bytes of the first numbers of two pairs, and of the second ones.
const NUMBERS: [[u8; 16]; 2] = [
    [0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23],
    [8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31],
];

impl Sink<'_> {
    /// Stores a list from number `first` on in the order of the model. `index`: index of each state in the model.
    pub fn store_list(&mut self, rows: &[Row], index: &[usize], (origin, first): (Origin, usize), list: &[Local]) {
        for row in rows {
            match row {
                Row::Consecutive(range) => self.each_in(range.clone(), |sink, k| {
                    sink.address(origin);
                    sink.store_at(first + index[k], list[k]);
                }),
                Row::Alternating(range, other) => self.each_in(0..range.len(), |sink, k| {
                    let (lists, place) = ([list[range.start + k], list[other + k]], first + index[range.start + k]);
                    if sink.values() == Values::Numbers {
                        for (next, local) in lists.into_iter().enumerate() {
                            sink.address(origin);
                            sink.store_at(place + next, local);
                        }
                        return;
                    }
                    let woven = sink.woven(|sink, which| sink.get(lists[which]));
                    for (which, local) in woven.into_iter().enumerate() {
                        sink.alternating_address(origin);
                        sink.store_at(place + 2 * which, local);
                    }
                }),
            }
        }
    }

    /// A list with numbers of the block from `first` on, which are in the order of the model.
    pub fn load_list(&mut self, rows: &[Row], index: &[usize], first: usize) -> Vec<Local> {
        let list = self.list(index.len());
        for row in rows {
            match row {
                Row::Consecutive(range) => self.each_in(range.clone(), |sink, k| {
                    sink.get(Local::Place(first + index[k]));
                    sink.set(list[k]);
                }),
                Row::Alternating(range, other) => self.each_in(0..range.len(), |sink, k| {
                    let (lists, place) = ([list[range.start + k], list[other + k]], first + index[range.start + k]);
                    if sink.values() == Values::Numbers {
                        for (next, local) in lists.into_iter().enumerate() {
                            sink.get(Local::Place(place + next));
                            sink.set(local);
                        }
                        return;
                    }
                    let woven = sink.woven(|sink, which| {
                        sink.alternating_address(Origin::Block);
                        sink.load_at(place + 2 * which);
                    });
                    for (local, list) in woven.into_iter().zip(lists) {
                        sink.get(local);
                        sink.set(list);
                    }
                }),
            }
        }
        list
    }

    /// Local variables with the first numbers and with the second ones of two pairs, which `push` pushes.
    fn woven(&mut self, push: impl Fn(&mut Self, usize)) -> [Local; 2] {
        let pairs = [0, 1].map(|which| {
            let local = self.local();
            push(self, which);
            self.set(local);
            local
        });
        NUMBERS.map(|bytes| {
            let local = self.local();
            pairs.into_iter().for_each(|pair| self.get(pair));
            self.instructions().i8x16_shuffle(bytes);
            self.set(local);
            local
        })
    }

    /// Pushes the address of an origin, increased by the offset of the elements that a loop has reached.
    pub fn address(&mut self, origin: Origin) {
        let base = self.base;
        self.instructions().local_get(base);
        match origin {
            Origin::Block => {}
            Origin::Row => drop(self.instructions().local_get(ROW).i32_add()),
            Origin::Record => drop(self.instructions().local_get(RECORD).i32_add()),
        }
    }

    /// [`Sink::address`] with twice the offset, for two lists that alternate.
    fn alternating_address(&mut self, origin: Origin) {
        self.address(origin);
        let base = self.base;
        self.instructions().local_get(base).i32_add().local_get(BLOCK).i32_sub();
    }
}

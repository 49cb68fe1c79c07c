//! Lists in the order of the model, as the engine reads and writes them: rows, records, and what a window begins with. Where the code has
//! another order, positions and velocities alternate in the model.

use super::lists::LEAST;
use super::{BLOCK, Local, RECORD, ROW, Sink, Values};
use std::ops::Range;

/// States that follow one another in the model.
#[derive(Debug)]
pub(crate) enum Row {
    /// Consecutive states.
    Consecutive(Range<usize>),
    /// States each of which is followed by one of as many others, which begin at this one.
    Alternating(Range<usize>, usize),
}

/// The states for which a condition holds, in the order of the model. `places`: place of each state of the model.
pub(crate) fn rows(places: &[usize], condition: impl Fn(usize) -> bool) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut k = 0;
    while let Some(&place) = places.get(k) {
        // Number of elements at every `stride`-th state from `first` on whose places follow one another.
        let count = |first: usize, stride: usize| {
            let follow = |&(element, &place): &(usize, &usize)| place == places[first] + element && condition(place);
            places[first..].iter().step_by(stride).enumerate().take_while(follow).count()
        };
        let alternating = if k + 1 < places.len() { count(k, 2).min(count(k + 1, 2)) } else { 0 };
        if alternating >= LEAST {
            rows.push(Row::Alternating(place..place + alternating, places[k + 1]));
            k += 2 * alternating;
        } else {
            let consecutive = count(k, 1);
            if consecutive > 0 {
                rows.push(Row::Consecutive(place..place + consecutive));
            }
            k += consecutive.max(1);
        }
    }
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
    /// Does `step` for each state in the order of the model, for two at a time if they alternate: an element of each list.
    pub fn each_row(&mut self, rows: &[Row], mut step: impl FnMut(&mut Self, &[usize])) {
        for row in rows {
            match row {
                Row::Consecutive(range) => self.each_in(range.clone(), |sink, k| step(sink, &[k])),
                Row::Alternating(range, other) => {
                    self.each_in(0..range.len(), |sink, k| step(sink, &[range.start + k, other + k]));
                }
            }
        }
    }

    /// Stores lists in the order of the model, each from a number on. `index`: index of each state in the model.
    pub fn store_lists(&mut self, rows: &[Row], index: &[usize], origin: Origin, lists: &[(usize, &[Local])]) {
        self.each_row(rows, |sink, places| {
            for (first, list) in lists {
                let place = first + index[places[0]];
                match *places {
                    [one, other] if sink.values() == Values::Pairs => {
                        let woven = sink.woven(|sink, which| sink.get(list[[one, other][which]]));
                        for (which, local) in woven.into_iter().enumerate() {
                            sink.alternating_address(origin);
                            sink.store_at(place + 2 * which, local);
                        }
                    }
                    _ => places.iter().enumerate().for_each(|(next, &k)| {
                        sink.address(origin);
                        sink.store_at(place + next, list[k]);
                    }),
                }
            }
        });
    }

    /// A list with numbers of the block from `first` on, which are in the order of the model.
    pub fn load_list(&mut self, rows: &[Row], index: &[usize], first: usize) -> Vec<Local> {
        let list = self.list(index.len());
        self.each_row(rows, |sink, places| {
            let place = first + index[places[0]];
            match *places {
                [one, other] if sink.values() == Values::Pairs => {
                    let woven = sink.woven(|sink, which| {
                        sink.alternating_address(Origin::Block);
                        sink.load_at(place + 2 * which);
                    });
                    for (local, k) in woven.into_iter().zip([one, other]) {
                        sink.get(local);
                        sink.set(list[k]);
                    }
                }
                _ => places.iter().enumerate().for_each(|(next, &k)| {
                    sink.get(Local::Place(place + next));
                    sink.set(list[k]);
                }),
            }
        });
        list
    }

    /// Adds what [`Sink::each_row`] computes for its elements to a local variable, in the order of the model.
    pub fn add_in_turn(&mut self, sum: Local, values: &[Local]) {
        let is_loop = self.in_block() && self.values == Values::Pairs;
        for lane in if is_loop { 0..2 } else { 0..1 } {
            for &value in values {
                if is_loop {
                    self.values = Values::Numbers;
                }
                self.get(sum);
                self.get(value);
                if is_loop {
                    self.instructions().f64x2_extract_lane(lane);
                }
                self.add();
                self.set(sum);
            }
        }
        if is_loop {
            self.values = Values::Pairs;
        }
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

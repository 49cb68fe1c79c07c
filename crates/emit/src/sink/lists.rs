//! Lists of values, one for each state or register, and loops over them. Code with few operations keeps them in local variables and has
//! instructions for each element. Code with many keeps them in the block, and loops do two elements at a time in SIMD registers, which
//! changes no bits.

use super::{BLOCK, ELEMENT, Local, Sink, Values};
use std::ops::Range;

/// Minimum number of elements for a loop.
pub(crate) const LEAST: usize = 8;

/// Number of elements that a round of a loop does.
const ELEMENTS: usize = 4;

/// The longest ranges of 0 to `count` in which each element but the first one `follows` the one before: the second of two numbers the
/// first.
pub(crate) fn ranges(count: usize, follows: impl Fn(usize, usize) -> bool) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for k in 0..count {
        match ranges.last_mut() {
            Some(range) if follows(k - 1, k) => range.end = k + 1,
            _ => ranges.push(k..k + 1),
        }
    }
    ranges
}

impl Sink<'_> {
    /// A new list.
    pub fn list(&mut self, count: usize) -> Vec<Local> {
        let Some(first) = self.lists else { return self.locals(count) };
        self.lists = Some(first + count);
        (first..first + count).map(Local::Place).collect()
    }

    /// True if lists are in the block.
    pub fn in_block(&self) -> bool {
        self.lists.is_some()
    }

    /// Does `step` for each element. In the block `step` is called for the first element of a loop, whose places stand for all that follow:
    /// in each range all lists that it uses must have consecutive places.
    pub fn each(&mut self, ranges: &[Range<usize>], mut step: impl FnMut(&mut Self, usize)) {
        ranges.iter().for_each(|range| self.each_in(range.clone(), &mut step));
    }

    /// [`Sink::each`] for a single range.
    pub fn each_in(&mut self, mut range: Range<usize>, mut step: impl FnMut(&mut Self, usize)) {
        if self.in_block() && range.len() >= LEAST {
            let rounds = range.len() / ELEMENTS;
            self.values = Values::Pairs;
            self.repeat_elements(rounds, |sink| {
                (0..ELEMENTS).step_by(2).for_each(|k| sink.once(|sink| step(sink, range.start + k)));
            });
            range.start += rounds * ELEMENTS;
            if range.len() > 1 {
                self.once(|sink| step(sink, range.start));
                range.start += 2;
            }
            self.values = Values::Numbers;
        }
        range.for_each(|k| self.once(|sink| step(sink, k)));
    }

    /// Copies values in these ranges of two lists, each of which may also be local variables.
    pub fn copy(&mut self, ranges: &[Range<usize>], from: impl Fn(usize) -> Local, to: impl Fn(usize) -> Local) {
        for range in ranges {
            let copy = |sink: &mut Self, k: usize| {
                sink.get(from(k));
                sink.set(to(k));
            };
            let in_block = |local: Local| matches!(local, Local::Place(_));
            if in_block(from(range.start)) && in_block(to(range.start)) {
                self.each_in(range.clone(), copy);
            } else {
                range.clone().for_each(|k| copy(self, k));
            }
        }
    }

    /// Does `step`, whose local variables are free afterwards.
    pub fn once(&mut self, step: impl FnOnce(&mut Self)) {
        let used = self.used;
        step(self);
        self.used = used;
    }

    /// Repeats `step` with the places of the elements [`ELEMENTS`] further in each of `rounds` rounds.
    fn repeat_elements(&mut self, rounds: usize, step: impl FnOnce(&mut Self)) {
        let bytes = |rounds: usize| (8 * ELEMENTS * rounds) as i32;
        self.instructions().local_get(BLOCK).local_set(ELEMENT);
        self.begin_repeat();
        let again = self.label();
        self.base = ELEMENT;
        step(self);
        self.base = BLOCK;
        self.instructions().local_get(ELEMENT).i32_const(bytes(1)).i32_add().local_tee(ELEMENT);
        self.instructions().local_get(BLOCK).i32_const(bytes(rounds)).i32_add().i32_lt_u();
        self.branch_if(again);
        self.end();
    }

    /// Calls functions of [`Sink::routines`].
    pub fn call_routines(&mut self, routines: &Range<usize>) {
        let first = self.calls.imported.len() + 1 + self.calls.own.len();
        for routine in routines.clone() {
            self.instructions().local_get(BLOCK).call((first + routine) as u32);
        }
    }
}

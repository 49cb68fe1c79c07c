//! Any text as a hand-in; what is read is written again, its columns are compared, and its document is opened with its items.

#![no_main]

use class::verify::{Curve, Recomputation, copies};
use libfuzzer_sys::fuzz_target;
use saved::hand_in::HandIn;

fuzz_target!(|text: &str| {
    let Ok(hand_in) = HandIn::read(text) else { return };
    assert_eq!(HandIn::read(&hand_in.write()), Ok(hand_in.clone()));
    let curves: Vec<Curve> = (0..2).flat_map(|index| Curve::of(index, &hand_in)).collect();
    copies(&curves);
    if let Ok(recomputation) = Recomputation::begin(&hand_in.work) {
        recomputation.facts();
    }
});

//! Any file as a hand-in, also deflated or in a report; what is read is written again and carried by a page, its columns are compared, its
//! document is opened with its items, and the stated values are compared.

#![no_main]

use class::verify::{Curve, Recomputation, compare, copies};
use libfuzzer_sys::fuzz_target;
use saved::carried::carry;
use saved::hand_in::HandIn;
use units::Language;

fuzz_target!(|file: &[u8]| {
    let Ok(hand_in) = HandIn::open(file) else { return };
    let text = hand_in.write();
    let read = HandIn { page: Vec::new(), ..hand_in.clone() };
    assert_eq!(HandIn::read(&text), Ok(read));
    let page = format!("<html><body><h1>{}</h1><footer></footer></body></html>", hand_in.facts.len());
    let carried = HandIn::open(carry(&page, text.as_bytes(), Language::English).as_bytes());
    assert!(carried.is_ok_and(|carried| carried.facts == hand_in.facts && !carried.page.is_empty()));
    let curves: Vec<Curve> = (0..2).flat_map(|index| Curve::of(index, &hand_in)).collect();
    copies(&curves);
    if let Ok(recomputation) = Recomputation::begin(&hand_in.work) {
        let refused = recomputation.refused();
        let verdict = compare(&hand_in, &recomputation.facts(), refused, "0.1.0");
        verdict.lines(Language::Spanish);
    }
});

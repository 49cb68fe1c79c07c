//! Computing the values of a hand-in in slices, between which the page reacts.

use class::verify::Recomputation;
use view::browser;

/// Duration of a slice, in milliseconds.
const SLICE: f64 = 12.0;

/// Finishes a recomputation.
pub async fn finished(mut recomputation: Recomputation) -> Recomputation {
    let mut has_more = true;
    while has_more {
        browser::breathe().await;
        let end = js_sys::Date::now() + SLICE;
        while has_more && js_sys::Date::now() < end {
            has_more = recomputation.advance();
        }
    }
    recomputation
}

//! Long lists of rows.

use crate::browser;
use crate::views::*;

/// Number of rows that are built in one task: they take some milliseconds on a slow phone.
const PORTION: usize = 24;

/// A row for each item. The first ones are built at once, the others afterwards, in tasks of their own, so that the page answers
/// meanwhile.
pub fn in_portions<T: 'static>(items: Vec<T>, row: impl Fn(&T) -> View + Copy + 'static) -> View {
    let count = items.len().div_ceil(PORTION);
    let built = create_signal(1);
    let mut items = items.into_iter();
    let portions = each(0..count, |place| {
        let portion: Vec<T> = items.by_ref().take(PORTION).collect();
        if place == 0 {
            return each(&portion, row);
        }
        let is_due = memo(move || place < built.get());
        changing(move || if is_due.get() { each(&portion, row) } else { View::new() })
    });
    if count > 1 {
        wasm_bindgen_futures::spawn_local(async move {
            for due in 2..=count {
                browser::breathe().await;
                if !built.is_alive() {
                    return;
                }
                built.set(due);
            }
        });
    }
    portions
}

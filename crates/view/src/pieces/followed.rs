//! Values that change with time.

use crate::app::App;
use crate::pieces::sight::in_sight;
use crate::views::*;
use play::Play;

/// Signal with a value that changes with time, updated in the same frame as the curves. While the run plays it is
/// updated only if `element` is in sight.
pub fn followed<T: Clone + Default + PartialEq>(
    app: App,
    element: &web_sys::Element,
    mut read: impl FnMut(&mut Play) -> T + 'static,
) -> ReadSignal<T> {
    let seen = in_sight(element);
    let now = create_signal(T::default());
    effect(move || {
        app.changes.transport.track();
        app.changes.parameters.track();
        if !seen.get() && app.read(|play| play.time_line().is_playing()) {
            return;
        }
        app.changes.frame.track();
        let read = app.read(&mut read);
        if now.with_untracked(|now| *now != read) {
            now.set(read);
        }
    });
    *now
}

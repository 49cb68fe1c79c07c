//! The logo and the icons: one stroke width, one size, in the colour of the text.

use crate::views::*;
use sycamore_web::SvgGlobalAttributes;

fn icon(path: &'static str) -> SvgSvg {
    svg()
        .class("glyph")
        .viewBox("0 0 24 24")
        .width("20")
        .height("20")
        .attr("aria-hidden", "true")
        .attr("focusable", "false")
        .child(tags::path().d(path))
}

macro_rules! icons {
    ($($(#[$comment:meta])* $name:ident: $path:literal;)*) => {
        $($(#[$comment])* pub fn $name() -> SvgSvg { icon($path) })*
    };
}

icons! {
    /// A triangle.
    play: "M8 5.5v13l10.5-6.5z";
    /// Two bars.
    pause: "M9 6v12M15 6v12";
    /// To the left, up to a bar.
    step_back: "M16 6.5v11L8.5 12zM7 6.5v11";
    /// To the right, up to a bar.
    step_forward: "M8 6.5v11l7.5-5.5zM17 6.5v11";
    /// An arrow that runs back around.
    reset: "M5 5.5V10h4.5M5.6 10A7 7 0 1 1 5 13";
    /// An arrow that turns back to the left.
    undo: "M9 5L5 9l4 4M5 9h9a5 5 0 0 1 0 10h-3";
    /// An arrow that turns back to the right.
    redo: "M15 5l4 4-4 4M19 9h-9a5 5 0 0 0 0 10h3";
    /// A plus.
    plus: "M12 6v12M6 12h12";
    /// A minus.
    minus: "M6 12h12";
    /// Four corners.
    fit: "M5 9.5V5h4.5M14.5 5H19v4.5M19 14.5V19h-4.5M9.5 19H5v-4.5";
    /// A stopwatch.
    stopwatch: "M12 21a7.5 7.5 0 1 0 0-15 7.5 7.5 0 0 0 0 15zM12 6V3M9.5 3h5M12 13.5V9.5M17.5 7.5l1.5-1.5";
    /// Squares in rows.
    grid: "M4 4h16v16H4zM4 9.3h16M4 14.7h16M9.3 4v16M14.7 4v16";
    /// Two sheets, one behind the other.
    copy: "M9 9h10v11H9zM6 15H5V4h10v2";
    /// A bin.
    bin: "M5 7h14M9.5 7V4.5h5V7M7 7l.8 12.5h8.4L17 7M10.3 10.5l.4 6M13.7 10.5l-.4 6";
    /// A sheet that rises above another one.
    forward: "M6 13h12v7H6zM12 10V3.5M9 6.5l3-3 3 3";
    /// A sheet that sinks below another one.
    backward: "M6 4h12v7H6zM12 14v6.5M9 17.5l3 3 3-3";
    /// A ruler with its marks.
    ruler: "M4 16L16 4l4 4L8 20zM8 12l2 2M11 9l2 2M14 6l2 2";
    /// Three dots.
    more: "M6 12h.01M12 12h.01M18 12h.01";
    /// Four corners that point outwards.
    full_screen: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5M4 4l6 6M20 4l-6 6M20 20l-6-6M4 20l6-6";
    /// An arrow that points upwards.
    up: "M12 19V5.5M6 11l6-6 6 6";
    /// An arrow that points downwards.
    down: "M12 5v13.5M6 13l6 6 6-6";
    /// A cross.
    cross: "M7 7l10 10M17 7L7 17";
    /// A loudspeaker with a wave.
    sound: "M5 9.8v4.4h3l4 3.3V6.5L8 9.8zM15.5 9.2a4 4 0 0 1 0 5.6M18 6.8a7.4 7.4 0 0 1 0 10.4";
    /// A loudspeaker, crossed out.
    mute: "M5 9.8v4.4h3l4 3.3V6.5L8 9.8zM16 9.8l4.4 4.4M20.4 9.8L16 14.2";
    /// Two links of a chain.
    link: "M10 14a3.6 3.6 0 0 0 5.1 0l3-3A3.6 3.6 0 0 0 13 5.9l-1 1M14 10a3.6 3.6 0 0 0-5.1 0l-3 3a3.6 3.6 0 0 0 5.1 5.1l1-1";
    /// A folder.
    folder: "M4 18V6h5.5l2 2.5H20V18z";
    /// Three books on a shelf, one of them leaning.
    books: "M5 19V5h3.5v14zM8.5 19V7.5H12V19zM13.2 8l3.3-.9 3 11-3.3.9z";
    /// A conical flask, partly filled.
    flask: "M9 4h6M10.2 4v5.5L5.6 18a1.6 1.6 0 0 0 1.4 2.4h10a1.6 1.6 0 0 0 1.4-2.4L13.8 9.5V4M8 14.5h8";
    /// A keyboard.
    keyboard: "M3.5 7h17v10h-17zM7 10.2h.01M10.3 10.2h.01M13.6 10.2h.01M17 10.2h.01M8.5 13.8h7";
    /// A disc, half of it filled.
    theme: "M12 4.5a7.5 7.5 0 1 0 0 15zM12 4.5a7.5 7.5 0 0 1 0 15";
    /// A strip of film.
    film: "M4.5 5.5h15v13h-15zM8.5 5.5v13M15.5 5.5v13M4.5 9.8h4M4.5 14.2h4M15.5 9.8h4M15.5 14.2h4";
    /// A camera that films.
    camera: "M4 8h10.5v8H4zM14.5 11l5.5-3v8l-5.5-3z";
    /// A triangle with an exclamation mark.
    doubt: "M12 5l8 14H4zM12 10.5v4M12 16.8h.01";
    /// Sheets in a pile.
    pile: "M12 4l8.5 4.5L12 13 3.5 8.5zM4.5 12.5L12 16.5l7.5-4M4.5 16.5l7.5 4 7.5-4";
    /// A flag on its pole.
    keep: "M7 20V5h10l-2.5 3.8L17 12.5H7";
}

/// The logo: a tube with a meniscus.
pub fn mark() -> SvgSvg {
    svg()
        .class("mark")
        .viewBox("0 0 32 32")
        .width("32")
        .height("32")
        .attr("aria-hidden", "true")
        .attr("focusable", "false")
        .child(path().class("mark-liquid").d("M8 12q8 8.5 16 0v9a8 8 0 0 1-16 0z"))
        .child(path().class("mark-glass").d("M8 4v17a8 8 0 0 0 16 0V4"))
}

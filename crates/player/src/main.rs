//! Page of a single simulation, which `meniscus export` fills with a bundle and with the source beside it. It plays the
//! program and saves answers, each as three lines (`play::Answer::lines`).
//!
//! `site.rs` has the links of a page that belongs to a site. `course.rs` is the page's side of a course package; `hand_in.rs`
//! makes a hand-in. What the address asks for (`play::Embedding`) reaches the views by `view::Host::embedding`: parts that
//! are hidden, and values that are locked. `height.rs` tells the page around it how high it is; `embedded.css` then makes no
//! size depend on the window.
//!
//! This is also the page with which the laboratory opens: `laboratory.rs` shows scene, plots and parameters, while the
//! laboratory's module is loaded. Then the player gives a `Handed` (the exact recipe of the run and of kept runs, and what
//! the views show) and ends: listeners, frames, reactive root.
//!
//! - **Invariant:** no parser of the language, and no library for JSON. The page cannot open another document than that of
//!   its bundle.

mod answers;
mod class;
mod course;
mod hand_in;
mod height;
mod laboratory;
mod page;
mod simulation;
mod site;
mod source;
mod surrounding;
mod words;

fn main() {
    match view::page::opening::Opening::of_page() {
        Some(opening) => laboratory::open(opening),
        None => page::start(),
    }
}

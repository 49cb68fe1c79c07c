//! Page of a single simulation: it runs the program stored in the page and contains no parser of the language.

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

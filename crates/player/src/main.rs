//! Page of a single simulation: it runs the program stored in the page and contains no parser of the language.

mod answers;
mod course;
mod hand_in;
mod height;
mod laboratory;
mod page;
mod simulation;
mod site;
mod source;
mod words;

fn main() {
    page::start();
}

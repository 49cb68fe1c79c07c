//! Page of a single simulation: it runs the program stored in the page and contains no parser of the language.

mod answers;
mod height;
mod page;
mod simulation;
mod site;
mod source;

fn main() {
    page::start();
}

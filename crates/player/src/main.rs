//! The page of one simulation: it plays the program that stands in it, and holds no parser of the language.

mod answers;
mod height;
mod page;
mod simulation;
mod site;
mod source;

fn main() {
    page::start();
}

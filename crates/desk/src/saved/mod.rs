//! What is kept for the next visit: items in one format, how a desk is turned into them and back, and which of them a page
//! writes and removes.

mod answers;
mod earlier;
mod films;
mod fits;
mod format;
mod item;
mod number;
mod place;
mod project;
mod records;
mod shelf;
mod tracks;

pub use item::Item;
pub use shelf::{Change, Left, Shelf};

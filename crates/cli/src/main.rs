//! The `meniscus` command line.
fn main() {}

//! Embeds the pages in the program; without them, its `serve` and `export` report that they are missing.

mod pages;

fn main() {
    pages::embed(&[("MENISCUS_PAGE", "meniscus.html"), ("MENISCUS_PLAYER", "player.html")]);
}

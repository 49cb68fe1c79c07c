//! Puts the pages into the program where `cargo xtask page` has built them. A build without them works too; its `serve` and
//! `export` say what is missing.

use std::path::Path;

/// The pages, by the variables that name their files.
const PAGES: [(&str, &str); 2] = [("MENISCUS_PAGE", "meniscus.html"), ("MENISCUS_PLAYER", "player.html")];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(page_inside)");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..").join("target").join("page");
    let pages = PAGES.map(|(variable, name)| (variable, directory.join(name)));
    if pages.iter().all(|(_, page)| page.is_file()) {
        println!("cargo::rustc-cfg=page_inside");
        for (variable, page) in pages {
            println!("cargo::rustc-env={variable}={}", page.display());
            println!("cargo::rerun-if-changed={}", page.display());
        }
    } else {
        // Cargo takes a missing path for a changed one and would build the program again each time; a directory that
        // exists changes when the page appears in it. Where it cannot be made, the only loss is that time.
        let _ = std::fs::create_dir_all(&directory);
        println!("cargo::rerun-if-changed={}", directory.display());
    }
}

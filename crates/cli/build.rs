//! Embeds the pages in the program if `cargo xtask page` has built them. A build without them works; its `serve` and
//! `export` then report that the pages are missing.

use std::path::Path;

/// Environment variable and file name of each page.
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
        // Cargo treats a missing path as changed and would rebuild the program each time. An existing directory changes
        // when the page appears in it. If the directory cannot be created, only build time is lost.
        let _ = std::fs::create_dir_all(&directory);
        println!("cargo::rerun-if-changed={}", directory.display());
    }
}

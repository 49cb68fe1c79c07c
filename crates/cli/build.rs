//! Puts the page into the program where `cargo xtask page` has built it. A build without it works too; its `serve` and
//! `export` say what is missing.

use std::path::Path;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(page_inside)");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..").join("target").join("page");
    let page = directory.join("meniscus.html");
    if page.is_file() {
        println!("cargo::rustc-cfg=page_inside");
        println!("cargo::rustc-env=MENISCUS_PAGE={}", page.display());
        println!("cargo::rerun-if-changed={}", page.display());
    } else {
        // Cargo takes a missing path for a changed one and would build the program again each time; a directory that
        // exists changes when the page appears in it. Where it cannot be made, the only loss is that time.
        let _ = std::fs::create_dir_all(&directory);
        println!("cargo::rerun-if-changed={}", directory.display());
    }
}

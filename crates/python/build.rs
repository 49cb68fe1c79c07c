//! Embeds the player if `cargo xtask page` has built it, and asks the linker to keep one copy of functions with the same code, a tenth
//! of the library.

use std::path::Path;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(page_inside)");
    println!("cargo::rerun-if-changed=build.rs");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..").join("target").join("page");
    let player = folder.join("player.html");
    if player.is_file() {
        println!("cargo::rustc-cfg=page_inside");
        println!("cargo::rustc-env=MENISCUS_PLAYER={}", player.display());
        println!("cargo::rerun-if-changed={}", player.display());
    } else {
        // A missing path would have the package built each time; an existing folder changes when the page appears in it. If it
        // cannot be created, only build time is lost.
        let _ = std::fs::create_dir_all(&folder);
        println!("cargo::rerun-if-changed={}", folder.display());
    }
    // Rust brings a linker that can for this target alone.
    if std::env::var("TARGET").is_ok_and(|target| target == "x86_64-unknown-linux-gnu") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,--icf=all");
    }
}

//! Embeds the pages that `cargo xtask page` has built; without them, `serve`, `export` and `build` report that they are missing. Writes
//! the guide of the language.

mod guide;

use std::path::Path;

/// Environment variables with the paths of the pages, and their file names.
const PAGES: [(&str, &str); 2] = [("MENISCUS_PAGE", "meniscus.html"), ("MENISCUS_PLAYER", "player.html")];

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..");
    write_guide(&root.join("docs").join("language.md"));
    println!("cargo::rustc-check-cfg=cfg(page_inside)");
    let directory = root.join("target").join("page");
    if PAGES.iter().all(|(_, name)| directory.join(name).is_file()) {
        println!("cargo::rustc-cfg=page_inside");
        for (variable, name) in PAGES {
            let page = directory.join(name);
            println!("cargo::rustc-env={variable}={}", page.display());
            println!("cargo::rerun-if-changed={}", page.display());
        }
    } else {
        // Cargo treats a missing path as changed and would build each time. An existing directory changes when the page appears in
        // it. If the directory cannot be created, only build time is lost.
        let _ = std::fs::create_dir_all(&directory);
        println!("cargo::rerun-if-changed={}", directory.display());
    }
}

/// Writes the guide of the language from the reference to `OUT_DIR/guide.md`.
fn write_guide(reference: &Path) {
    println!("cargo::rerun-if-changed={}", reference.display());
    let written = std::fs::read_to_string(reference).and_then(|page| {
        let directory = std::env::var_os("OUT_DIR").unwrap_or_default();
        std::fs::write(Path::new(&directory).join("guide.md"), guide::guide(&page))
    });
    if let Err(error) = written {
        println!("cargo::error={}: {error}", reference.display());
    }
}

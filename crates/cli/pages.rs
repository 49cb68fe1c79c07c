//! Part of build scripts: pages that are embedded if `cargo xtask page` has built them.

use std::path::Path;

/// Sets an environment variable to the path of each page, and `page_inside`, if all of them are there: pairs of variable and file
/// name. A build without them works.
pub fn embed(pages: &[(&str, &str)]) {
    println!("cargo::rustc-check-cfg=cfg(page_inside)");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..").join("target").join("page");
    if pages.iter().all(|(_, name)| directory.join(name).is_file()) {
        println!("cargo::rustc-cfg=page_inside");
        for (variable, name) in pages {
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

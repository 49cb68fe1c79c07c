//! `cargo xtask release`: everything of a version that is published, in one folder.
//!
//! | file | made by |
//! |---|---|
//! | `meniscus.html`, `site.tar.gz` | `page.rs`, `meniscus build` |
//! | `documentation.tar.gz`, `element.tgz` | `docs`, `element.rs`: the npm package, as `npm publish` takes it |
//! | `meniscus-TARGET.tar.gz` | cargo, or cargo-zigbuild for another system |
//! | `meniscus-class-amd64.tar` | `image.rs`, for Linux |
//! | wheel, source distribution | maturin |
//! | `third-party.txt`, `sbom.json` | `components.rs`, from the lock files |
//! | `install.sh`, `install.ps1`, `meniscus.rb`, `compose.yml`, `meniscus-class.service` | the files of `packaging`, with addresses and sums |
//! | `notes.md`, `SHA256SUMS` | `CHANGELOG.md`, the files |

mod archive;
mod components;
mod image;
mod program;
mod ready;
mod sums;
mod version;

use crate::steps::{self, run, step};
use crate::{docs, element, page, python};
use anyhow::{Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Writes the files of this version into a folder. With a target, only program and wheel for it.
pub fn make(output: &str, target: Option<&str>) -> Result<()> {
    let notes = ready::notes(&steps::root())?;
    // Paths are those of the caller, and the tools run in the folder of the workspace.
    let output = std::path::absolute(output)?;
    fs::create_dir_all(&output)?;
    let page = step("the page", page::build)?;
    let third = output.join("third-party.txt");
    step("third-party licences", || components::write(&third, &output.join("sbom.json")))?;
    let host = program::host()?;
    let made = target.unwrap_or(&host);
    let program = step("the program", || program::packed(made, &third, &output))?;
    if made.contains("linux") {
        step("the image of the class server", || image::write(&program, made, &output))?;
    }
    step("the wheel", || python::release(made, &output))?;
    if target.is_none() {
        fs::copy(page, output.join("meniscus.html"))?;
        step("the site", || site(&program, &output))?;
        step("the documentation", || packed(&docs::build()?, &output.join("documentation.tar.gz")))?;
        step("the npm package", || npm_package(&output))?;
        step("the source distribution", || python::source(&output))?;
        fs::write(output.join("notes.md"), notes)?;
    }
    sums::write(&output)
}

/// Adds what depends on the files of all targets: sums, scripts of installation, Homebrew's formula.
pub fn finish(output: &str) -> Result<()> {
    sums::write(&std::path::absolute(output)?)
}

/// The site of all simulations.
fn site(program: &Path, output: &Path) -> Result<()> {
    let site = steps::target().join("release-site");
    if site.exists() {
        fs::remove_dir_all(&site)?;
    }
    run(Command::new(program).args(["build", "simulations", "--output"]).arg(&site).current_dir(steps::root()))?;
    packed(&site, &output.join("site.tar.gz"))
}

/// The package of the element, which npm wants in a folder of this name.
fn npm_package(output: &Path) -> Result<()> {
    let folder = steps::target().join("release-npm");
    let package = folder.join("package");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(&package)?;
    for name in files(&element::folder())? {
        fs::copy(element::folder().join(&name), package.join(&name))?;
    }
    packed(&folder, &output.join("element.tgz"))
}

/// Packs a folder.
fn packed(folder: &Path, archive: &Path) -> Result<()> {
    archive::write(folder, &files(folder)?, archive)
}

/// Paths of the files below a folder, from there, sorted.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut folders = vec![folder.to_owned()];
    let mut files = Vec::new();
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                files.push(path.strip_prefix(folder)?.to_owned());
            }
        }
    }
    files.sort();
    ensure!(!files.is_empty(), "{} is empty", folder.display());
    Ok(files)
}

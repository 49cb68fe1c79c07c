//! The program for one target.

use super::archive;
use crate::steps::{self, output, run};
use crate::{python, tools};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Profile of the program, in `Cargo.toml`.
const PROFILE: &str = "program";

/// Target of programs for this computer. On Linux the program is static, so that it runs on every distribution.
pub fn host() -> Result<String> {
    let about = output(&mut steps::program("rustc", &["-vV"]))?;
    let host = about.lines().find_map(|line| line.strip_prefix("host: ")).context("rustc names no host")?;
    Ok(host.replace("-linux-gnu", "-linux-musl"))
}

/// True if zig links for this target: another system, or a static program.
pub fn needs_zig(target: &str) -> bool {
    let own = if cfg!(target_os = "macos") { "apple" } else { std::env::consts::OS };
    target.contains("musl") || !target.contains(own)
}

/// Builds the program, packs it with the licences, and returns its path.
pub fn packed(target: &str, third_party: &Path, output: &Path) -> Result<PathBuf> {
    tools::rust_target(target)?;
    let words = ["--profile", PROFILE, "--locked", "--package", "meniscus", "--target", target];
    if needs_zig(target) {
        run(python::tool("cargo-zigbuild")?.arg("zigbuild").args(words).current_dir(steps::root()))?;
    } else {
        run(steps::cargo(&["build"]).args(words))?;
    }
    let name = if target.contains("windows") { "meniscus.exe" } else { "meniscus" };
    let program = steps::target().join(target).join(PROFILE).join(name);
    let folder = steps::target().join("release-program");
    fs::create_dir_all(&folder)?;
    let licence = steps::root().join("LICENSE");
    let files = [(name, &program), ("LICENSE", &licence), ("third-party.txt", &third_party.to_owned())];
    for (name, path) in files {
        fs::copy(path, folder.join(name)).with_context(|| format!("cannot copy {}", path.display()))?;
    }
    let names = files.map(|(name, _)| PathBuf::from(name));
    archive::write(&folder, &names, &output.join(format!("meniscus-{target}.tar.gz")))?;
    Ok(program)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zig_links_for_other_systems_and_static_programs() {
        let own = if cfg!(target_os = "macos") {
            "aarch64-apple-darwin".into()
        } else {
            format!("x86_64-{}", std::env::consts::OS)
        };
        assert!(!needs_zig(&own), "{own}");
        assert!(needs_zig("x86_64-unknown-linux-musl"));
        assert!(cfg!(windows) || needs_zig("x86_64-pc-windows-gnu"));
    }
}

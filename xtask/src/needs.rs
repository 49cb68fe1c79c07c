//! Programs that a command needs beside Rust. They are looked for before it begins, so that everything that is missing is named at
//! once, with the command that installs it.

use crate::{steps, tools};
use anyhow::{Context, Result, bail};
use std::process::Command;

/// Something that has to be installed.
pub struct Need {
    name: &'static str,
    purpose: &'static str,
    is_there: fn() -> bool,
    /// Packages for each of [`MANAGERS`], separated by spaces; empty where there is none.
    packages: [&'static str; 5],
}

/// Package managers: the program in `PATH`, and the words before the names of packages.
const MANAGERS: [(&str, &str); 5] = [
    ("apt-get", "apt-get install --yes --no-install-recommends"),
    ("dnf", "dnf install"),
    ("pacman", "pacman -S --needed"),
    ("brew", "brew install"),
    ("winget", "winget install --exact"),
];

const WASM: Need = Need {
    name: "Rust's standard library for WebAssembly",
    purpose: "the page is made of it",
    // rustup installs it when it is needed.
    is_there: || tools::find("rustup").is_some() || tools::has_rust_target(tools::TARGET),
    packages: [
        "libstd-rust-dev-wasm32",
        "rust-std-static-wasm32-unknown-unknown",
        "rust-wasm",
        "rustup",
        "Rustlang.Rustup",
    ],
};
const NODE: Need = Need {
    name: "Node 20 or later, with npm",
    purpose: "it drives the browsers of the tests and minifies scripts",
    is_there: || tools::find("npm").is_some() && tools::node().is_ok(),
    packages: ["nodejs npm", "nodejs npm", "nodejs npm", "node", "OpenJS.NodeJS.LTS"],
};
const CHROMIUM: Need = Need {
    name: "Chromium, Chrome or Edge",
    purpose: "the tests of the page; CHROME can name its path",
    is_there: || tools::CHROMIUM.is_there(),
    packages: ["chromium-headless-shell fonts-dejavu-core", "chromium", "chromium", "google-chrome", "Google.Chrome"],
};
const FIREFOX: Need = Need {
    name: "Firefox",
    purpose: "the tests of the page; FIREFOX can name its path",
    is_there: || tools::FIREFOX.is_there(),
    packages: ["firefox-esr fonts-dejavu-core", "firefox", "firefox", "firefox", "Mozilla.Firefox"],
};
/// WebKitGTK exists on Linux alone.
const WEBKIT: Need = Need {
    name: "WebKitGTK's WebDriver, Xvfb and dbus-run-session",
    purpose: "the main path of the page as Safari has it; WEBKIT can name the path of WebKitWebDriver",
    is_there: || !cfg!(target_os = "linux") || tools::WEBKIT.is_there(),
    packages: [
        // The decoders are those of its films.
        "webkit2gtk-driver xvfb dbus gstreamer1.0-plugins-base gstreamer1.0-plugins-good gstreamer1.0-plugins-bad gstreamer1.0-libav \
         fonts-dejavu-core",
        "webkit2gtk4.1 xorg-x11-server-Xvfb dbus-daemon",
        "webkit2gtk-4.1 xorg-server-xvfb dbus",
        "",
        "",
    ],
};
const POSTGRES: Need = Need {
    name: "Postgres",
    purpose: "the tests of the class server; POSTGRES_BIN can name the folder of its programs",
    is_there: || tools::postgres().is_ok(),
    packages: ["postgresql", "postgresql-server", "postgresql", "postgresql@17", "PostgreSQL.PostgreSQL.17"],
};

/// Needs of the page.
pub const PAGE: &[&Need] = &[&WASM];
/// Needs of all checks.
pub const CHECKS: &[&Need] = &[&WASM, &NODE, &CHROMIUM, &FIREFOX, &WEBKIT, &POSTGRES];

/// Looks for everything that a command needs. What is missing is installed by apt if this is root's session, as on a machine for
/// checks; otherwise the error names it all.
pub fn provide(needs: &[&Need]) -> Result<()> {
    let missing = || needs.iter().copied().filter(|need| !(need.is_there)()).collect::<Vec<_>>();
    let before = missing();
    if before.is_empty() {
        return Ok(());
    }
    let manager = MANAGERS.iter().position(|(program, _)| tools::find(program).is_some());
    if manager == Some(0) && is_root() {
        steps::run(Command::new("apt-get").arg("update"))?;
        let command = command(&before, 0).context("Debian has no package for it")?;
        let mut words = command.split(' ');
        let mut install = Command::new(words.next().unwrap_or_default());
        steps::run(install.args(words).env("DEBIAN_FRONTEND", "noninteractive"))?;
    }
    let after = missing();
    if after.is_empty() {
        return Ok(());
    }
    bail!(said(&after, manager))
}

/// Command that installs what is missing; `None` if the package manager has nothing of it.
fn command(missing: &[&Need], manager: usize) -> Option<String> {
    let mut packages: Vec<&str> = missing.iter().flat_map(|need| need.packages[manager].split_whitespace()).collect();
    packages.sort_unstable();
    packages.dedup();
    (!packages.is_empty()).then(|| format!("{} {}", MANAGERS[manager].1, packages.join(" ")))
}

/// Sentence about everything that is missing.
fn said(missing: &[&Need], manager: Option<usize>) -> String {
    let lines: String = missing.iter().map(|need| format!("\n  {}: {}", need.name, need.purpose)).collect();
    let how = manager.and_then(|manager| command(missing, manager));
    let how = how.map_or_else(|| "Install it, and try again.".to_owned(), |how| format!("This installs it: {how}"));
    format!("this is missing:{lines}\n{how}")
}

fn is_root() -> bool {
    cfg!(unix) && steps::output(Command::new("id").arg("-u")).is_ok_and(|user| user.trim() == "0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_missing_is_named_with_one_command() {
        let text = said(&[&CHROMIUM, &FIREFOX], Some(0));
        let expected = "this is missing:\n  Chromium, Chrome or Edge: the tests of the page; CHROME can name its path\n  \
                        Firefox: the tests of the page; FIREFOX can name its path\nThis installs it: apt-get install --yes \
                        --no-install-recommends chromium-headless-shell firefox-esr fonts-dejavu-core";
        assert_eq!(text, expected);
        assert!(said(&[&NODE], Some(4)).ends_with("winget install --exact OpenJS.NodeJS.LTS"));
        assert!(said(&[&WEBKIT], Some(3)).ends_with("Install it, and try again."));
        assert!(said(&[&NODE], None).ends_with("Install it, and try again."));
    }
}

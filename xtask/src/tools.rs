//! Tools that builds and tests need, found on the machine. `needs.rs` installs them or says how.

use crate::steps;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Target of WebAssembly builds.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// Installs the standard library for WebAssembly if it is missing.
pub fn wasm_target() -> Result<()> {
    rust_target(TARGET)
}

/// Installs the standard library for a target if it is missing.
pub fn rust_target(target: &str) -> Result<()> {
    if has_rust_target(target) {
        return Ok(());
    }
    steps::run(&mut steps::program("rustup", &["target", "add", target]))
        .with_context(|| format!("Rust lacks the target {target}; install it with `rustup target add {target}`"))
}

/// True if the standard library for a target is installed.
pub fn has_rust_target(target: &str) -> bool {
    let sysroot = steps::output(&mut steps::program("rustc", &["--print", "sysroot"]));
    sysroot.is_ok_and(|sysroot| Path::new(sysroot.trim()).join("lib").join("rustlib").join(target).is_dir())
}

/// Path of Node, at least version 20.
pub fn node() -> Result<PathBuf> {
    const HOW: &str = "the page's scripts and the tests in the browser need Node 20 or later: https://nodejs.org";
    let node = find("node").context(HOW)?;
    let version = steps::output(Command::new(&node).arg("--version"))?;
    let major = version.trim().trim_start_matches('v').split('.').next().and_then(|text| text.parse::<u32>().ok());
    match major {
        Some(major) if major >= 20 => Ok(node),
        _ => bail!("Node {} is too old; {HOW}", version.trim()),
    }
}

/// Path of Python, at least version 3.10.
pub fn python() -> Result<PathBuf> {
    const HOW: &str = "the tests of the Python package need Python 3.10 or later: https://www.python.org";
    let python = find("python3").or_else(|| find("python")).context(HOW)?;
    let is_new = ["-c", "import sys; sys.exit(sys.version_info < (3, 10))"];
    steps::run(Command::new(&python).args(is_new)).context(HOW)?;
    Ok(python)
}

/// Installs the packages of a folder with a `package-lock.json`, exactly as locked. Does nothing if they are already
/// installed. Scripts of packages are not run.
pub fn packages(directory: &Path) -> Result<()> {
    let lock = directory.join("package-lock.json");
    let lock = std::fs::read_to_string(&lock).with_context(|| format!("cannot read {}", lock.display()))?;
    let stamp = directory.join("node_modules").join(".installed-from");
    if std::fs::read_to_string(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    let npm = find("npm").context("npm is missing; it comes with Node: https://nodejs.org")?;
    let words = ["ci", "--ignore-scripts", "--no-fund", "--no-audit"];
    steps::run(Command::new(npm).args(words).current_dir(directory))?;
    std::fs::write(&stamp, lock).with_context(|| format!("cannot write {}", stamp.display()))
}

/// Command that checks licences and sources of dependencies by `deny.toml`. cargo-deny is installed below the target folder.
pub fn cargo_deny() -> Result<Command> {
    const VERSION: &str = "0.20.2";
    let root = steps::target().join("cargo-deny");
    let program = root.join("bin").join(format!("cargo-deny{}", std::env::consts::EXE_SUFFIX));
    if !program.is_file() {
        let words = ["install", "cargo-deny", "--locked", "--version", VERSION, "--root"];
        steps::run(steps::cargo(&words).arg(&root))?;
    }
    Ok(steps::program(program, &["check", "licenses", "bans", "sources"]))
}

/// A browser for the tests.
pub struct Browser {
    name: &'static str,
    /// Environment variable with its path.
    pub variable: &'static str,
    programs: &'static [&'static str],
    /// Usual paths. The first part may be the name of an environment variable with the folder of a user, as `%LOCALAPPDATA%`.
    places: &'static [&'static str],
    /// Further programs, in `PATH`.
    needs: &'static [&'static str],
}

pub const CHROMIUM: Browser = Browser {
    name: "Chromium or Chrome",
    variable: "CHROME",
    // Without windows first: the same browser without what is around a page takes a seventh less of the processor.
    programs: &[
        "chromium-headless-shell",
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
        "chrome",
        "microsoft-edge",
        "microsoft-edge-stable",
    ],
    places: &[
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
        "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
        "%HOME%/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        r"C:\Program Files\Google\Chrome\Application\chrome.exe",
        r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
        r"%LOCALAPPDATA%\Google\Chrome\Application\chrome.exe",
        r"%LOCALAPPDATA%\Chromium\Application\chrome.exe",
        r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
        "/snap/bin/chromium",
        "/var/lib/flatpak/exports/bin/org.chromium.Chromium",
        "/var/lib/flatpak/exports/bin/com.google.Chrome",
        "%HOME%/.local/share/flatpak/exports/bin/org.chromium.Chromium",
        "%HOME%/.local/share/flatpak/exports/bin/com.google.Chrome",
    ],
    needs: &[],
};

pub const FIREFOX: Browser = Browser {
    name: "Firefox",
    variable: "FIREFOX",
    programs: &["firefox-esr", "firefox"],
    places: &[
        "/Applications/Firefox.app/Contents/MacOS/firefox",
        r"C:\Program Files\Mozilla Firefox\firefox.exe",
        r"C:\Program Files (x86)\Mozilla Firefox\firefox.exe",
        r"%LOCALAPPDATA%\Mozilla Firefox\firefox.exe",
        "/snap/bin/firefox",
        "/var/lib/flatpak/exports/bin/org.mozilla.firefox",
        "%HOME%/.local/share/flatpak/exports/bin/org.mozilla.firefox",
    ],
    needs: &[],
};

/// WebKitGTK, by its WebDriver, with the virtual screen and the message bus that it runs in.
pub const WEBKIT: Browser = Browser {
    name: "WebKitGTK's WebDriver, Xvfb and dbus-run-session",
    variable: "WEBKIT",
    programs: &["WebKitWebDriver"],
    places: &[],
    needs: &["Xvfb", "dbus-run-session"],
};

impl Browser {
    /// Path of the browser: from the environment variable, else from `PATH` or a usual location.
    pub fn path(&self) -> Result<PathBuf> {
        let Self { name, variable, .. } = self;
        if let Some(path) = std::env::var_os(variable).map(PathBuf::from) {
            return if path.is_file() {
                Ok(path)
            } else {
                bail!("{variable} is {}, and there is no such file", path.display())
            };
        }
        self.installed()
            .with_context(|| format!("the browser tests need {name}: install it, or set {variable} to its path"))
    }

    /// True if a path is stated or the browser is installed.
    pub fn is_there(&self) -> bool {
        std::env::var_os(self.variable).is_some() || self.installed().is_some()
    }

    fn installed(&self) -> Option<PathBuf> {
        if self.needs.iter().any(|name| find(name).is_none()) {
            return None;
        }
        let in_path = self.programs.iter().find_map(|name| find(name));
        in_path.or_else(|| self.places.iter().filter_map(|place| place_of(place)).find(|path| path.is_file()))
    }
}

/// Path of a usual location; `None` if it begins with an environment variable that is not set.
fn place_of(place: &str) -> Option<PathBuf> {
    match place.strip_prefix('%').and_then(|rest| rest.split_once('%')) {
        Some((variable, rest)) => {
            Some(PathBuf::from(std::env::var_os(variable)?).join(rest.trim_start_matches(['/', '\\'])))
        }
        None => Some(PathBuf::from(place)),
    }
}

/// Environment variable with the folder of Postgres's programs.
pub const POSTGRES: &str = "POSTGRES_BIN";

/// Folder of Postgres's programs: from the environment variable, else where Debian has the newest version, or that of `initdb` in
/// `PATH`.
pub fn postgres() -> Result<PathBuf> {
    std::env::var_os(POSTGRES)
        .map(PathBuf::from)
        .or_else(installed_postgres)
        .with_context(|| format!("the tests of the class server need Postgres: install it, or set {POSTGRES}"))
}

/// Programs of Postgres that the tests start, which stand in one folder.
const POSTGRES_PROGRAMS: [&str; 4] = ["initdb", "pg_ctl", "pg_dump", "psql"];

fn installed_postgres() -> Option<PathBuf> {
    let is_whole = |folder: &PathBuf| POSTGRES_PROGRAMS.iter().all(|program| folder.join(program).is_file());
    let in_path = || find("initdb").and_then(|program| Some(program.parent()?.to_owned())).filter(is_whole);
    let versions = std::fs::read_dir("/usr/lib/postgresql").into_iter().flatten().flatten();
    let debian = versions.map(|version| version.path().join("bin")).filter(is_whole).max();
    debian.or_else(in_path)
}

/// Path of a program in `PATH`.
pub fn find(name: &str) -> Option<PathBuf> {
    let endings: &[&str] = if cfg!(windows) { &[".exe", ".cmd"] } else { &[""] };
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path)
        .flat_map(|directory| endings.iter().map(move |ending| directory.join(format!("{name}{ending}"))))
        .find(|candidate| candidate.is_file())
}

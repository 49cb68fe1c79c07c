//! The Python package: builds its wheel and tests it in an environment of its own.

use crate::page;
use crate::steps::{self, run};
use crate::{pyodide, tools, wheel};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Greatest size of the wheel in bytes. A quarter of it is the player.
const LARGEST: u64 = 3_000_000;

/// Builds the wheel, installs it with the packages of `requirements.txt`, and runs the tests.
pub fn test() -> Result<()> {
    tools::packages(&steps::root().join("tests").join("page"))?;
    pyodide::packages()?;
    let package = package();
    let (python, wheel) = built("environment", &package.join("requirements.txt"))?;
    let for_browsers = pyodide::wheel(&wheel)?;
    for wheel in [&wheel, &for_browsers] {
        let size = fs::metadata(wheel)?.len();
        println!("{}: {size} bytes", wheel.display());
        if size > LARGEST {
            bail!("the wheel is larger than {LARGEST} bytes");
        }
    }
    install(&python, &wheel)?;
    run(&mut steps::cargo(&["build", "--package", "meniscus"]))?;
    let program = steps::target().join("debug").join(format!("meniscus{}", std::env::consts::EXE_SUFFIX));
    // No file of a cache is written beside the tests.
    let tests = ["-B", "-m", "pytest", "--quiet", "-p", "no:cacheprovider"];
    let browser = tools::CHROMIUM.path()?;
    run(Command::new(&python)
        .args(tests)
        .current_dir(package)
        .env("MENISCUS", program)
        .env("PYODIDE_WHEEL", for_browsers)
        .env(tools::CHROMIUM.variable, browser))
}

/// Builds the wheel and times sweeps beside the same runs by numba and SciPy.
pub fn rivals() -> Result<()> {
    let folder = package().join("benches");
    let (python, wheel) = built("rivals", &folder.join("requirements.txt"))?;
    install(&python, &wheel)?;
    run(Command::new(&python).arg("-B").arg(folder.join("rivals.py")))
}

/// Folder of the package's sources.
fn package() -> PathBuf {
    steps::root().join("crates").join("python")
}

/// Builds the wheel with the maturin of an environment. Returns the environment's Python and the wheel.
fn built(environment: &str, requirements: &Path) -> Result<(PathBuf, PathBuf)> {
    // The wheel carries the player.
    if !steps::player().is_file() {
        page::build()?;
    }
    let folder = steps::target().join("python");
    let environment = self::environment(&folder.join(environment), requirements)?;
    let wheel = wheel(&program(&environment, "maturin"), &package(), &folder.join("wheel"))?;
    Ok((program(&environment, "python"), wheel))
}

/// Installs a wheel, whatever is installed of it.
fn install(python: &Path, wheel: &Path) -> Result<()> {
    let install = ["-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps"];
    run(Command::new(python).args(install).arg(wheel))
}

/// An environment with exactly these packages. One from the same list is used again.
fn environment(environment: &Path, requirements: &Path) -> Result<PathBuf> {
    let list = fs::read_to_string(requirements).with_context(|| format!("cannot read {}", requirements.display()))?;
    let stamp = environment.join("installed-from");
    if fs::read_to_string(&stamp).is_ok_and(|installed| installed == list) {
        return Ok(environment.to_owned());
    }
    run(Command::new(tools::python()?).args(["-m", "venv", "--clear"]).arg(environment))?;
    let install = ["-m", "pip", "install", "--quiet", "--requirement"];
    run(Command::new(program(environment, "python")).args(install).arg(requirements))?;
    fs::write(&stamp, list)?;
    Ok(environment.to_owned())
}

/// A program of an environment.
fn program(environment: &Path, name: &str) -> PathBuf {
    environment.join(if cfg!(windows) { "Scripts" } else { "bin" }).join(name)
}

/// Builds the wheel into a folder, which then holds nothing else, and packs it as small as possible.
fn wheel(maturin: &Path, package: &Path, folder: &Path) -> Result<PathBuf> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    run(Command::new(maturin).args(["build", "--out"]).arg(folder).current_dir(package))?;
    let wheel = fs::read_dir(folder)?.next().context("maturin has built no wheel")??.path();
    let packed = wheel::files(&fs::read(&wheel)?).and_then(|files| wheel::archive(&files));
    fs::write(&wheel, packed.with_context(|| format!("cannot repack {}", wheel.display()))?)?;
    Ok(wheel)
}

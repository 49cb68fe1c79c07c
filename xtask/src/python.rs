//! The Python package: builds its wheel and tests it in an environment of its own.

use crate::page;
use crate::steps::{self, run};
use crate::{pyodide, tools, wheel};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Greatest size of the wheel in bytes. A fifth of it is the player, a twelfth the gallery.
const LARGEST: u64 = 3_600_000;

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

/// Builds the wheel for a target of programs into a folder. On Linux it is for glibc 2.28 (2018) and later.
pub fn release(target: &str, output: &Path) -> Result<()> {
    let target = target.replace("-linux-musl", "-linux-gnu");
    tools::rust_target(&target)?;
    let mut maturin = tool("maturin")?;
    maturin.args(["build", "--locked", "--target", &target]);
    if target.contains("linux") {
        maturin.args(["--zig", "--compatibility", "manylinux_2_28"]);
    }
    let wheel = wheel(&mut maturin, &steps::target().join("python").join("release"))?;
    fs::copy(&wheel, output.join(wheel.file_name().context("a wheel has a name")?))?;
    Ok(())
}

/// Writes the source distribution into a folder. It has player and gallery, so that Rust alone is needed.
pub fn source(output: &Path) -> Result<()> {
    ship()?;
    run(tool("maturin")?.args(["sdist", "--out"]).arg(output).current_dir(package()))
}

/// Command of a program from the environment of releases, with the others in `PATH`.
pub fn tool(name: &str) -> Result<Command> {
    let list = steps::root().join("xtask").join("src").join("release").join("tools.txt");
    let environment = environment(&steps::target().join("release-tools"), &list)?;
    let program = program(&environment, name);
    let folder = program.parent().map(Path::to_owned).unwrap_or_default();
    let others = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(folder).chain(std::env::split_paths(&others)))?;
    let mut command = Command::new(program);
    command.env("PATH", path);
    Ok(command)
}

/// Copies player and gallery into the package, from where wheel and source distribution take them.
fn ship() -> Result<()> {
    // Wheel and source distribution carry the player.
    if !steps::player().is_file() {
        page::build()?;
    }
    let shipped = package().join("python").join("meniscus").join("shipped");
    if shipped.exists() {
        fs::remove_dir_all(&shipped)?;
    }
    for folder in ["", "theories"] {
        let from = steps::root().join("simulations").join(folder);
        let to = shipped.join("simulations").join(folder);
        fs::create_dir_all(&to)?;
        for entry in fs::read_dir(&from)? {
            let path = entry?.path();
            if let Some(name) = path.file_name().filter(|_| path.extension().is_some_and(|ending| ending == "md")) {
                fs::copy(&path, to.join(name))?;
            }
        }
    }
    fs::copy(steps::player(), shipped.join("player.html"))?;
    Ok(())
}

/// Folder of the package's sources.
fn package() -> PathBuf {
    steps::root().join("crates").join("python")
}

/// Builds the wheel with the maturin of an environment. Returns the environment's Python and the wheel.
fn built(environment: &str, requirements: &Path) -> Result<(PathBuf, PathBuf)> {
    let folder = steps::target().join("python");
    let environment = self::environment(&folder.join(environment), requirements)?;
    let wheel = wheel(Command::new(program(&environment, "maturin")).arg("build"), &folder.join("wheel"))?;
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
fn wheel(maturin: &mut Command, folder: &Path) -> Result<PathBuf> {
    ship()?;
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    run(maturin.arg("--out").arg(folder).current_dir(package()))?;
    let wheel = fs::read_dir(folder)?.next().context("maturin has built no wheel")??.path();
    let packed = wheel::files(&fs::read(&wheel)?).and_then(|files| wheel::archive(&files));
    fs::write(&wheel, packed.with_context(|| format!("cannot repack {}", wheel.display()))?)?;
    Ok(wheel)
}

//! Builds the page and runs all checks: `cargo xtask help`.

mod bench;
mod checks;
mod docs;
mod editor;
mod element;
mod golden;
mod needs;
mod order;
mod page;
mod pyodide;
mod python;
mod ratios;
mod release;
mod steps;
mod texts;
mod tools;
mod wasm;
mod weight;
mod wheel;

use anyhow::{Result, bail};
use std::process::ExitCode;

const HELP: &str = "\
cargo xtask lab     build the page and open the laboratory in the browser; `lab DOC` builds the program, too, and serves DOC
cargo xtask page    build the pages: target/page/meniscus.html, and the player that exported pages are made of
cargo xtask docs    build the documentation as a site, target/page/docs, with the page that was built last
cargo xtask test    run every check: format, lints, tests, golden runs, the page in browsers; `test full`
                    also the long ones: the class server under load and killed, the Python package
cargo xtask python  build the Python package, target/python/wheel, and the one for Pyodide, and test both
cargo xtask release --output DIST [--target TARGET]
                    write the files of this version into a folder: page, site, program, wheel, source distribution, licences, sums;
                    with a target, program and wheel for it; `release sums DIST` adds what depends on the files of all targets
cargo xtask editor  bundle the editor of the laboratory again, after a change of crates/lab/editor
cargo xtask texts   bring the catalogues of the languages up to date with the texts of the code
cargo xtask bench   measure steps per second, the page's size, and how fast it draws and opens, and name the ratios that are
                    a fifth below those of xtask/ratios.txt; `bench commit` writes that file; `bench emitted` measures
                    emitted code alone, in a minute; `bench python` builds the Python package and times its sweeps beside
                    numba and SciPy
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match perform(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("\nxtask: {failure:#}");
            ExitCode::FAILURE
        }
    }
}

fn perform(arguments: &[String]) -> Result<()> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["lab", document @ ..] => lab(document),
        ["page"] => needs::provide(needs::PAGE)
            .and_then(|()| steps::step("the page", page::build))
            .map(|page| println!("{}", page.display())),
        ["docs"] => steps::step("the documentation", docs::build).map(|site| println!("{}", site.display())),
        ["test"] => checks::all(),
        ["test", "full"] => checks::full(),
        ["python"] => steps::step("the Python package", python::test),
        ["release", "--output", output] => release::make(output, None),
        ["release", "--output", output, "--target", target] => release::make(output, Some(target)),
        ["release", "sums", output] => release::finish(output),
        ["editor"] => editor::renew(),
        ["texts"] => texts::update(&steps::root()),
        ["bench"] => bench::all(false),
        ["bench", "commit"] => bench::all(true),
        ["bench", "emitted"] => bench::emitted(),
        ["bench", "python"] => steps::step("sweeps in Python beside numba and SciPy", python::rivals),
        [] | ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(())
        }
        _ => bail!("there is no `cargo xtask {}`\n\n{HELP}", words.join(" ")),
    }
}

/// Opens a fresh build of the laboratory from its file, which needs no server. With arguments, `meniscus serve` is
/// started with them.
fn lab(arguments: &[&str]) -> Result<()> {
    needs::provide(needs::PAGE)?;
    let page = steps::step("the page", page::build)?;
    if arguments.is_empty() {
        println!("The laboratory is the file {}", page.display());
        if webbrowser::open(&page.to_string_lossy()).is_err() {
            println!("No browser could be opened; open the file yourself");
        }
        return Ok(());
    }
    // The debug build is sufficient to serve the page.
    steps::step("the program", || steps::run(&mut steps::cargo(&["build", "--package", "meniscus"])))?;
    let program = steps::target().join("debug").join(format!("meniscus{}", std::env::consts::EXE_SUFFIX));
    // The program runs in the directory of the caller, because paths in `arguments` are relative to it.
    steps::run(std::process::Command::new(program).arg("serve").args(arguments))
}

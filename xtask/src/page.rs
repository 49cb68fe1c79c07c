//! Builds the laboratory into one HTML file: template, styles, JavaScript glue, and the WebAssembly module as base64 of
//! gzip. Nothing is fetched when the file is opened, so that it works from a disk, from any host and inside a frame.

use base64::Engine as _;
use flate2::{Compression, write::GzEncoder};
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";
/// The version that Cargo.toml pins both to; the glue and the module must come from the same one.
const BINDGEN: &str = "wasm-bindgen";

/// Where the page is written.
pub fn output(root: &Path) -> PathBuf {
    root.join("target/page/meniscus.html")
}

/// Builds the page and writes it to [`output`].
///
/// # Errors
/// What went wrong, in words for the terminal.
pub fn build(root: &Path) -> Result<PathBuf, String> {
    let module = compile(root)?;
    let bound = bind(&module)?;
    let page = assemble(root, &bound)?;
    let path = output(root);
    write_whole(&path, page.as_bytes())?;
    report(&path, &page, &bound);
    Ok(path)
}

/// The JavaScript glue and the module that belongs to it.
struct Bound {
    glue: String,
    module: Vec<u8>,
}

/// Compiles the crate `lab` for WebAssembly.
fn compile(root: &Path) -> Result<PathBuf, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    require_target()?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let status = Command::new(cargo)
        .current_dir(root)
        .args(["build", "--package", "lab", "--bin", "lab", "--profile", "page", "--target", TARGET])
        .arg("--target-dir")
        .arg(&target)
        // Views are type-erased: their types otherwise nest without end and make the module a third larger.
        .env("RUSTFLAGS", "--cfg=erase_components")
        .status()
        .map_err(|error| format!("cargo could not be started: {error}"))?;
    if !status.success() {
        return Err("the laboratory did not compile".to_owned());
    }
    Ok(target.join(TARGET).join("page/lab.wasm"))
}

/// Sees to it that the compiler has WebAssembly's standard library.
fn require_target() -> Result<(), String> {
    let sysroot = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    if let Ok(answer) = sysroot
        && Path::new(String::from_utf8_lossy(&answer.stdout).trim()).is_dir()
    {
        return Ok(());
    }
    eprintln!("Adding the target {TARGET} ...");
    match Command::new("rustup").args(["target", "add", TARGET]).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("`rustup target add {TARGET}` failed; see its message above")),
        Err(_) => Err(format!(
            "the compiler has no standard library for {TARGET} and there is no rustup to add it; \
             install Rust from https://rustup.rs, or that target from your distribution"
        )),
    }
}

/// Makes the glue. `no-modules`, because an inline script can be a classic one only if it is to run from `file://`
/// in every browser without a request.
fn bind(module: &Path) -> Result<Bound, String> {
    let directory = module.with_extension("bound");
    wasm_bindgen_cli_support::Bindgen::new()
        .input_path(module)
        .out_name("lab")
        .no_modules(true)
        .and_then(|bindgen| bindgen.typescript(false).remove_name_section(true).remove_producers_section(true).generate(&directory))
        .map_err(|error| format!("{BINDGEN} failed: {error:#}"))?;
    let glue = read(&directory.join("lab.js"))?;
    let path = directory.join("lab_bg.wasm");
    let module = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(Bound { glue, module })
}

/// Puts the parts into the template's places.
fn assemble(root: &Path, bound: &Bound) -> Result<String, String> {
    let source = root.join("crates/lab/page");
    let style = read(&source.join("style.css"))?;
    let boot = read(&source.join("boot.js"))?;
    let module = base64::engine::general_purpose::STANDARD.encode(gzip(&bound.module)?);
    let mut page = read(&source.join("index.html"))?;
    for (marker, text) in [
        ("<!--style-->", format!("<style>\n{style}</style>")),
        ("<!--glue-->", format!("<script>\n{}\n</script>", bound.glue.replace("</script", "<\\/script"))),
        ("<!--module-->", format!("<script type=\"application/octet-stream\" id=\"module\">{module}</script>")),
        ("<!--boot-->", format!("<script>\n{boot}</script>")),
    ] {
        if page.matches(marker).count() != 1 {
            return Err(format!("crates/lab/page/index.html must contain {marker} once"));
        }
        page = page.replace(marker, &text);
    }
    Ok(page)
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// Writes beside the place and renames, so that no half-written page is ever there.
fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let directory = path.parent().ok_or("the page has no directory")?;
    let fresh = path.with_extension("html.new");
    fs::create_dir_all(directory)
        .and_then(|()| fs::write(&fresh, bytes))
        .and_then(|()| fs::rename(&fresh, path))
        .map_err(|error| format!("{}: {error}", path.display()))
}

/// gzip at its best level, without a time stamp: the same module gives the same page.
pub fn gzip(bytes: &[u8]) -> Result<Vec<u8>, String> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).map_err(|error| format!("gzip: {error}"))
}

fn report(path: &Path, page: &str, bound: &Bound) {
    let kilobytes = |bytes: usize| format!("{:.1} kB", bytes as f64 / 1000.0);
    let compressed = |bytes: &[u8]| gzip(bytes).map_or_else(|error| error, |bytes| kilobytes(bytes.len()));
    println!("{}", path.display());
    println!("  page    {:>10}, gzipped {:>9}", kilobytes(page.len()), compressed(page.as_bytes()));
    println!("  module  {:>10}, gzipped {:>9}", kilobytes(bound.module.len()), compressed(&bound.module));
    println!("  glue    {:>10}, gzipped {:>9}", kilobytes(bound.glue.len()), compressed(bound.glue.as_bytes()));
}

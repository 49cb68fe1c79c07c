//! Builds the laboratory into one HTML file: template, styles, JavaScript glue, and the WebAssembly module as base64 of
//! its streams, gzipped, beside the small module that joins them. Nothing is fetched when the file is opened, so that it
//! works from a disk, from any host and inside a frame.

use crate::wasm::{self, Host};
use crate::{order, pack, steps};
use anyhow::{Context, Result, bail};
use base64::Engine as _;
use document::page::{self, Source};
use flate2::{Compression, write::GzEncoder};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// The document that the laboratory opens with.
const FIRST: &str = "utube.md";

/// The directories, below `simulations`, whose documents the laboratory can open without a file.
const LIBRARY: [&str; 2] = ["theories", ""];

/// A WebAssembly module and the JavaScript around it.
struct Part {
    glue: String,
    module: Vec<u8>,
}

/// Builds the page and returns where it is.
pub fn build() -> Result<PathBuf> {
    let mut laboratory = part("lab", "wasm_bindgen")?;
    laboratory.module = order::by_likeness(&laboratory.module)?;
    let unpacker = part("unpack", "unpacker")?;
    let packed = pack::pack(&laboratory.module)?;
    let page = assemble(&laboratory.glue, &packed, &unpacker)?;
    let path = steps::page();
    write_whole(&path, page.as_bytes()).with_context(|| format!("cannot write {}", path.display()))?;
    let kilobytes = |bytes: usize| bytes as f64 / 1000.0;
    for (name, bytes) in [
        ("page", page.as_bytes()),
        ("glue", laboratory.glue.as_bytes()),
        ("unpacker", &unpacker.module),
        ("its glue", unpacker.glue.as_bytes()),
    ] {
        println!("{name:10}{:8.1} kB, gzipped {:6.1} kB", kilobytes(bytes.len()), kilobytes(gzip(bytes)?.len()));
    }
    println!("module    {:8.1} kB, packed  {:6.1} kB", kilobytes(laboratory.module.len()), kilobytes(packed.len()));
    Ok(path)
}

/// Builds a package of the workspace for the page, where its JavaScript defines a name.
fn part(package: &str, name: &'static str) -> Result<Part> {
    let directory = steps::target().join("page").join("parts");
    wasm::bind(&wasm::build(package)?, Host::Page(name), &directory)?;
    let module = directory.join(format!("{package}_bg.wasm"));
    let module = std::fs::read(&module).with_context(|| format!("cannot read {}", module.display()))?;
    Ok(Part { glue: read(&directory.join(format!("{package}.js")))?, module })
}

/// Puts the parts into the template's places.
fn assemble(glue: &str, packed: &[u8], unpacker: &Part) -> Result<String> {
    let source = steps::root().join("crates").join("lab").join("page");
    let base64 = |bytes: &[u8]| base64::engine::general_purpose::STANDARD.encode(bytes);
    let font = source.join("math.woff2");
    let font = std::fs::read(&font).with_context(|| format!("cannot read {}", font.display()))?;
    let style = read(&source.join("style.css"))?.replace("/*math-font*/", &base64(&font));
    let style = style + &read(&source.join("narrow.css"))? + &read(&source.join("print.css"))?;
    let boot = read(&source.join("boot.js"))?.replace("/*unpacker*/", unpacker.glue.trim_end());
    let data = |id: &str, bytes: &[u8]| {
        format!("<script type=\"application/octet-stream\" id=\"{id}\">{}</script>", base64(bytes))
    };
    let mut html = read(&source.join("index.html"))?;
    let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">", page::POLICY);
    for (marker, text) in [
        ("<!--policy-->", policy),
        ("<!--style-->", format!("<style>\n{style}</style>")),
        ("<!--glue-->", script(glue)),
        ("<!--module-->", data("module", packed)),
        ("<!--unpacker-->", data("unpacker", &gzip(&unpacker.module)?)),
        ("<!--library-->", format!("<script type=\"application/json\" id=\"library\">{}</script>", library()?)),
        ("<!--boot-->", script(&boot)),
    ] {
        if html.matches(marker).count() != 1 {
            bail!("crates/lab/page/index.html must contain {marker} once");
        }
        html = html.replace(marker, &text);
    }
    // Its place stays empty: `meniscus export` puts documents there. Without any, the first of the library opens.
    if html.matches(page::MARKER).count() != 1 {
        bail!("crates/lab/page/index.html must contain {} once", page::MARKER);
    }
    Ok(html)
}

/// JavaScript as an element, which no text inside can close.
fn script(text: &str) -> String {
    format!("<script>\n{}\n</script>", text.trim_end().replace("</script", "<\\/script"))
}

/// All documents that ship, each named by its path below `simulations`; first what the laboratory opens with.
fn library() -> Result<String> {
    let mut sources = Vec::new();
    for directory in LIBRARY {
        let path = steps::root().join("simulations").join(directory);
        let entries = std::fs::read_dir(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let mut names = Vec::new();
        for entry in entries {
            names.push(entry?.file_name().to_string_lossy().into_owned());
        }
        names.retain(|name| name.ends_with(".md"));
        names.sort();
        for name in names {
            let text = read(&path.join(&name))?;
            sources.push(Source { name: format!("{directory}/{name}").trim_start_matches('/').to_owned(), text });
        }
    }
    sources.sort_by_key(|source| source.name != FIRST);
    Ok(page::write_list(&sources))
}

fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

/// Writes beside the place and renames, so that no half-written page is ever there.
fn write_whole(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(directory) = path.parent() {
        std::fs::create_dir_all(directory)?;
    }
    let fresh = path.with_extension("html.new");
    std::fs::write(&fresh, bytes)?;
    std::fs::rename(&fresh, path)
}

/// gzip as servers send it, at its usual level, and without a time stamp: the same module gives the same page. Higher levels
/// gain nothing on what is packed already; this library's even lose.
pub fn gzip(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    encoder.finish()
}

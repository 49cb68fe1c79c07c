//! Builds the laboratory and the player as one HTML file each: template, styles, JavaScript glue, and the WebAssembly
//! module, gzipped and in base64. Nothing is fetched when the file is opened, so it works from a disk, from any host
//! and inside a frame.

use crate::wasm::{self, Host};
use crate::{editor, steps};
use anyhow::{Context, Result, bail};
use base64::Engine as _;
use document::page::{self, Source};
use flate2::{Compression, write::GzEncoder};
use std::io::Write as _;
use std::num::NonZeroU64;
use std::path::{Path, PathBuf};

/// Document with which the laboratory opens.
const FIRST: &str = "tube.md";

/// Folders below `simulations` whose documents are included in the laboratory.
const LIBRARY: [&str; 2] = ["theories", ""];

/// Number of iterations of zopfli; more do not make the page smaller.
const SEARCHES: NonZeroU64 = NonZeroU64::MIN.saturating_add(14);

/// A page to be built.
struct Kind {
    /// Name of its package.
    package: &'static str,
    /// Style sheets below `crates`, in their order.
    styles: &'static [&'static str],
    /// True for the laboratory, which includes the shipped documents, the editor, and the player.
    is_laboratory: bool,
    /// Output path.
    path: fn() -> PathBuf,
}

/// The two pages: the player, which `meniscus export` and the laboratory fill with a simulation, and the laboratory,
/// which includes the player.
const KINDS: [Kind; 2] = [
    Kind {
        package: "player",
        styles: &[
            "view/page/style.css",
            "view/page/stage.css",
            "view/page/panel.css",
            "view/page/narrow.css",
            "player/page/embedded.css",
            "view/page/print.css",
        ],
        is_laboratory: false,
        path: steps::player,
    },
    Kind {
        package: "lab",
        styles: &[
            "view/page/style.css",
            "view/page/stage.css",
            "view/page/panel.css",
            "lab/page/measure.css",
            "lab/page/film.css",
            "lab/page/library.css",
            "lab/page/write.css",
            "lab/page/drawing.css",
            "lab/page/publish.css",
            "lab/page/class.css",
            "view/page/narrow.css",
            "view/page/print.css",
        ],
        is_laboratory: true,
        path: steps::page,
    },
];

/// Builds the pages and returns the path of the laboratory.
pub fn build() -> Result<PathBuf> {
    for (kind, module) in KINDS.iter().zip(wasm::build(KINDS.map(|kind| kind.package).as_slice())?) {
        let directory = steps::target().join("page").join("parts");
        wasm::bind(&module, Host::Page("wasm_bindgen"), &directory)?;
        let glue = editor::minified(&directory.join(format!("{}.js", kind.package)))?;
        let module = directory.join(format!("{}_bg.wasm", kind.package));
        let module = std::fs::read(&module).with_context(|| format!("cannot read {}", module.display()))?;
        let packed = pack(zopfli::Format::Gzip, &module)?;
        let (mut editor, mut player) = (String::new(), String::new());
        if kind.is_laboratory {
            (editor, player) = (editor::bundle()?, read(&steps::player())?);
        }
        let styles = kind
            .styles
            .iter()
            .map(|name| read(&steps::root().join("crates").join(name)))
            .collect::<Result<String>>()?;
        let style = directory.join(format!("{}.css", kind.package));
        std::fs::write(&style, styles).with_context(|| format!("cannot write {}", style.display()))?;
        let page = assemble(
            kind,
            &editor::minified(&style)?,
            &glue,
            &packed,
            [(page::EDITOR, &editor), (page::PLAYER, &player)],
        )?;
        let path = (kind.path)();
        write_whole(&path, page.as_bytes()).with_context(|| format!("cannot write {}", path.display()))?;
        println!("{}", kind.package);
        for (name, bytes, sent) in [
            ("page", page.len(), gzip(page.as_bytes())?.len()),
            ("glue", glue.len(), gzip(glue.as_bytes())?.len()),
            ("module", module.len(), packed.len()),
            ("editor", editor.len(), gzip(editor.as_bytes())?.len()),
            ("player", player.len(), gzip(player.as_bytes())?.len()),
        ] {
            println!("  {name:10}{:8.1} kB, gzipped {:6.1} kB", bytes as f64 / 1000.0, sent as f64 / 1000.0);
        }
    }
    Ok(steps::page())
}

/// Compresses a part of the page with zopfli. The browser inflates it.
fn pack(format: zopfli::Format, part: &[u8]) -> Result<Vec<u8>> {
    let mut packed = Vec::new();
    let options = zopfli::Options { iteration_count: SEARCHES, ..zopfli::Options::default() };
    zopfli::compress(options, format, part, &mut packed)?;
    Ok(packed)
}

/// Inserts the parts into the template.
///
/// `lazy`: parts of the laboratory that are inflated on first use, each with the opening tag of its element.
fn assemble(kind: &Kind, style: &str, glue: &str, packed: &[u8], lazy: [(&str, &String); 2]) -> Result<String> {
    let source = steps::root().join("crates").join("view").join("page");
    let base64 = |bytes: &[u8]| base64::engine::general_purpose::STANDARD.encode(bytes);
    let font = source.join("math.woff2");
    let font = std::fs::read(&font).with_context(|| format!("cannot read {}", font.display()))?;
    let style = style.replace("/*math-font*/", &base64(&font));
    let boot = editor::minified(&source.join("boot.js"))?;
    let module = format!("<script type=\"application/octet-stream\" id=\"module\">{}</script>", base64(packed));
    let (mut carried, mut deflated) = (String::new(), String::new());
    if kind.is_laboratory {
        carried = format!("<script type=\"application/json\" id=\"library\">{}</script>", library()?);
        for (tag, text) in lazy {
            // Raw deflate, as for texts in links.
            deflated += &format!("{tag}{}</script>", base64(&pack(zopfli::Format::Deflate, text.as_bytes())?));
        }
    }
    let mut html = read(&source.join("index.html"))?;
    let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">", page::POLICY);
    for (marker, text) in [
        ("<!--policy-->", policy),
        ("<!--style-->", format!("<style>\n{style}</style>")),
        ("<!--glue-->", script(glue)),
        ("<!--module-->", module),
        ("<!--library-->", carried),
        ("<!--boot-->", script(&boot)),
        ("<!--later-->", deflated),
    ] {
        if html.matches(marker).count() != 1 {
            bail!("crates/view/page/index.html must contain {marker} once");
        }
        html = html.replace(marker, &text);
    }
    // The marker stays in the page: `meniscus export` puts documents and the simulation there. Without them, the
    // laboratory opens the first document of its library.
    if html.matches(page::MARKER).count() != 1 {
        bail!("crates/view/page/index.html must contain {} once", page::MARKER);
    }
    Ok(html)
}

/// Script element with this JavaScript. Closing tags in the text are escaped.
fn script(text: &str) -> String {
    format!("<script>\n{}\n</script>", text.trim_end().replace("</script", "<\\/script"))
}

/// JSON list of the shipped documents, named by their path below `simulations`. The document with which the laboratory
/// opens is first.
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

/// Writes a temporary file and renames it, so that the page is never incomplete.
fn write_whole(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(directory) = path.parent() {
        std::fs::create_dir_all(directory)?;
    }
    let fresh = path.with_extension("html.new");
    std::fs::write(&fresh, bytes)?;
    std::fs::rename(&fresh, path)
}

/// Compresses with gzip at the default level of servers and without a time stamp: the same page gives the same size.
pub fn gzip(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    encoder.finish()
}

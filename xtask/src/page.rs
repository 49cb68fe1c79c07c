//! Builds the laboratory and the player as one HTML file each: template, styles, JavaScript glue, and the WebAssembly
//! module, gzipped and in base64. Nothing is fetched when the file is opened, so it works from a disk, from any host
//! and inside a frame.
//!
//! The laboratory opens with the player, whose parts come first. Its own module, the documents, the editor and the template
//! for published pages follow, so that a browser shows the simulation before it has received them.
//!
//! A page, with its WebAssembly and its documents, is a single HTML file that makes no request. The module is gzipped, and
//! the browser inflates it; esbuild minifies scripts and styles. Documents in a page are encoded (`document::page::embed`) so
//! that no text can close their element. The elements of the laboratory's page, in this order:
//!
//! | element | contents | used |
//! |---|---|---|
//! | `style`, `#bundle` | styles of the player, compiled opening document | before the first picture |
//! | scripts, `#module` | `opening.js`, `boot.js`, the player's module with its script | before the first picture |
//! | `#laboratory`, `style`, `#laboratory-glue`, `#library` | the laboratory's module and script, documents | in an idle page, or on request |
//! | `#editor`, `#player` | editor, template of published pages without its module | on request |
//! | `#sample-film` | film of a U-tube (`simulations/films`) | on request |
//!
//! `boot.js` starts the player (`player/src/laboratory.rs`); tabs and buttons of the laboratory wait (`aria-busy`), and using
//! one asks for it. In a site the elements are files of their own, and the player's module is the one of all its pages.

use crate::wasm::{self, Host};
use crate::{editor, element, order, steps};
use anyhow::{Context, Result, anyhow, bail, ensure};
use base64::Engine as _;
use document::page::{self, Source};
use flate2::{Compression, write::GzEncoder};
use program::{Program, bundle};
use std::io::Write as _;
use std::num::NonZeroU64;
use std::path::{Path, PathBuf};
use units::{Catalogue, Language};

/// Document with which the laboratory opens.
const FIRST: &str = "tube.md";

/// Folders below `simulations` whose documents are included in the laboratory.
const LIBRARY: [&str; 2] = ["theories", ""];

/// Marker of the template for what follows the player.
const LATER: &str = "<!--later-->";

/// Beginning of the element of the views, which gets the number of shipped documents: the player shows it before they arrive.
const PLACE: &str = "<div id=\"lab\"";

/// Most bytes, gzipped, that a visitor of the laboratory receives before the first picture. A build with more fails. The aim is 600 kB.
const MOST_BEFORE_PICTURE: usize = 607_000;

/// Number of iterations of zopfli; more do not make the page smaller.
const SEARCHES: NonZeroU64 = NonZeroU64::MIN.saturating_add(14);

/// Greatest size of the scripts of the element beside the player, gzipped, in bytes.
const LARGEST_ELEMENT: usize = 4_000;

/// A page to be built.
struct Kind {
    /// Name of its package.
    package: &'static str,
    /// Global name of its JavaScript.
    global: &'static str,
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
        global: "wasm_bindgen",
        styles: &[
            "view/page/style.css",
            "view/page/stage.css",
            "view/page/panel.css",
            "view/page/reading.css",
            "view/page/narrow.css",
            "player/page/embedded.css",
            "view/page/print.css",
        ],
        is_laboratory: false,
        path: steps::player,
    },
    Kind {
        package: "lab",
        global: "laboratory",
        styles: &["view/page/style.css", "view/page/stage.css", "view/page/panel.css", "view/page/narrow.css"],
        is_laboratory: true,
        path: steps::page,
    },
];

/// Style sheets of the laboratory below `crates`, which follow the player. That for narrow windows stands after them once more,
/// because it overrules them.
const LATER_STYLES: [&str; 10] = [
    "view/page/reading.css",
    "lab/page/measure.css",
    "lab/page/film.css",
    "lab/page/library.css",
    "lab/page/write.css",
    "lab/page/drawing.css",
    "lab/page/publish.css",
    "lab/page/class.css",
    "view/page/narrow.css",
    "view/page/print.css",
];

/// Parts of a page that its module needs.
struct Bound {
    /// JavaScript of the module.
    glue: String,
    /// The module, gzipped.
    packed: Vec<u8>,
    /// Its texts in each language but English: packed catalogues, gzipped.
    texts: Vec<(Language, Vec<u8>)>,
}

/// Builds the pages and returns the path of the laboratory.
pub fn build() -> Result<PathBuf> {
    if !editor::minifies() {
        println!("Without Node, scripts and styles are not minified: the page is larger and does the same.");
    }
    wasm::build()?;
    let bound = KINDS.iter().map(|kind| bound(kind, &wasm::module(kind.package))).collect::<Result<Vec<_>>>()?;
    let [player, laboratory] = bound.as_slice() else { bail!("there are two pages") };
    let mut bare = String::new();
    for kind in KINDS {
        let mut page = assemble(&kind, player)?;
        if kind.is_laboratory {
            page = with_laboratory(&page, laboratory, &bare)?;
        } else {
            bare.clone_from(&page);
        }
        let path = (kind.path)();
        write_whole(&path, page.as_bytes()).with_context(|| format!("cannot write {}", path.display()))?;
        print_sizes(&kind, &page)?;
    }
    package(player, laboratory)?;
    let page = steps::page();
    let first = gzip(before_picture(&read(&page)?).as_bytes())?.len();
    ensure_small("what precedes the first picture of the laboratory", first, MOST_BEFORE_PICTURE)?;
    Ok(page)
}

/// Fails if a part has more bytes, gzipped, than it may have. Without Node nothing is minified and nothing fails.
pub fn ensure_small(part: &str, size: usize, most: usize) -> Result<()> {
    ensure!(
        size <= most || !editor::minifies(),
        "{part} has {size} bytes, gzipped, more than {most}: let something load later"
    );
    Ok(())
}

/// Writes the npm package of the element, which is made of the same parts.
fn package(player: &Bound, laboratory: &Bound) -> Result<()> {
    let source = steps::root().join("crates").join("view").join("page");
    let html = read(&source.join("index.html"))?;
    let first = html.split_once("<script>").and_then(|(_, rest)| rest.split_once("</script>"));
    let (first_script, _) = first.context("crates/view/page/index.html has no script")?;
    let boot = editor::minified(&source.join("boot.js"))?;
    let style = style(KINDS[0].package, KINDS[0].styles)? + &font(&source)?;
    let texts: Vec<(&str, &[u8])> =
        player.texts.iter().map(|(language, packed)| (language.tag(), packed.as_slice())).collect();
    let own = element::write(&element::Parts {
        scripts: &[&player.glue, &boot, "textsArrived();\n"],
        first_script,
        style: &style,
        module: &player.packed,
        texts: &texts,
        laboratory: (&laboratory.glue, &laboratory.packed),
    })?;
    let size = gzip(own.as_bytes())?.len();
    println!("the element: {size} bytes gzipped");
    ensure_small("the element", size, LARGEST_ELEMENT)
}

/// Generates the JavaScript of a module, and compresses the module in the order of functions that suits this.
fn bound(kind: &Kind, module: &Path) -> Result<Bound> {
    let directory = steps::target().join("page").join("parts");
    wasm::bind(module, Host::Page(kind.global), &directory)?;
    let glue = editor::minified(&directory.join(format!("{}.js", kind.package)))?;
    let module = directory.join(format!("{}_bg.wasm", kind.package));
    let module = std::fs::read(&module).with_context(|| format!("cannot read {}", module.display()))?;
    let packed = pack(zopfli::Format::Gzip, &order::reordered(&module)?)?;
    Ok(Bound { glue, packed, texts: texts(&module)? })
}

/// The texts of a module in each language but English: of those catalogue entries whose English text the module contains.
fn texts(module: &[u8]) -> Result<Vec<(Language, Vec<u8>)>> {
    let module = String::from_utf8_lossy(module);
    let mut all = Vec::new();
    for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
        let texts = catalogues::texts(language);
        let own = texts.iter().filter(|(english, _)| module.contains(english.as_str()));
        let packed = Catalogue::pack(own.map(|(english, text)| (english.as_str(), text.as_str())));
        let packed = packed.map_err(|same| anyhow!("{same:?} have the same hash: reword one of them"))?;
        all.push((language, pack(zopfli::Format::Gzip, &packed)?));
    }
    Ok(all)
}

/// Elements with texts. `tag`: beginning of the opening tag.
fn text_elements(tag: &str, texts: &[(Language, Vec<u8>)]) -> String {
    texts.iter().map(|(language, packed)| format!("{tag}{}\">{}</script>", language.tag(), encoded(packed))).collect()
}

/// Compresses a part of the page with zopfli. The browser inflates it.
fn pack(format: zopfli::Format, part: &[u8]) -> Result<Vec<u8>> {
    let mut packed = Vec::new();
    let options = zopfli::Options { iteration_count: SEARCHES, ..zopfli::Options::default() };
    zopfli::compress(options, format, part, &mut packed)?;
    Ok(packed)
}

fn encoded(bytes: &[u8]) -> String {
    base64::engine::general_purpose::STANDARD.encode(bytes)
}

/// Inserts styles, scripts and the player's module into the template.
fn assemble(kind: &Kind, player: &Bound) -> Result<String> {
    let crates = steps::root().join("crates");
    let source = crates.join("view").join("page");
    let font = font(&source)?;
    let style = style(kind.package, kind.styles)?;
    let opening = crates.join("lab").join("page").join("opening.js");
    let opening = if kind.is_laboratory { editor::minified(&opening)? } else { String::new() };
    let boot = opening + &editor::minified(&source.join("boot.js"))?;
    let html = read(&source.join("index.html"))?;
    // Comments of its script stay here.
    let mut html: String = html.split_inclusive('\n').filter(|line| !line.starts_with("// ")).collect();
    let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">", page::POLICY);
    let later = if kind.is_laboratory { LATER } else { "" };
    for (marker, text) in [
        ("<!--policy-->", policy),
        ("<!--style-->", format!("<style>\n{style}</style>")),
        ("<!--glue-->", script(&player.glue)),
        ("<!--module-->", format!("{}{}</script>", page::MODULE, encoded(&player.packed))),
        ("<!--boot-->", script(&boot)),
        ("<!--texts-->", text_elements(page::TEXTS, &player.texts) + &script("textsArrived();")),
        ("<!--font-->", format!("<style>\n{font}</style>")),
        (LATER, later.to_owned()),
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

/// Style with the font of equations, from the folder `source`.
fn font(source: &Path) -> Result<String> {
    let font = source.join("math.woff2");
    let font = std::fs::read(&font).with_context(|| format!("cannot read {}", font.display()))?;
    Ok(style("math-font", &["view/page/math-font.css"])?.replace("/*math-font*/", &encoded(&font)))
}

/// Minified style sheets below `crates`; `name` is that of a temporary file.
fn style(name: &str, sheets: &[&str]) -> Result<String> {
    let crates = steps::root().join("crates");
    let sheets = sheets.iter().map(|name| read(&crates.join(name))).collect::<Result<String>>()?;
    let file = steps::target().join("page").join("parts").join(name).with_extension("css");
    std::fs::write(&file, sheets).with_context(|| format!("cannot write {}", file.display()))?;
    editor::minified(&file)
}

/// Inserts what follows the player in the laboratory, and the simulation with which it opens.
fn with_laboratory(page: &str, laboratory: &Bound, player: &str) -> Result<String> {
    let template = page::without_parts(player).context("the player has no module")?;
    let library = library()?;
    let mut later = text_elements(page::LABORATORY_TEXTS, &laboratory.texts);
    later += &format!("{}{}</script>", page::LABORATORY, encoded(&laboratory.packed));
    later += &format!("<style>\n{}</style>", style("later", &LATER_STYLES)?);
    let library_of_page = format!("{}{}</script>", page::LIBRARY, page::write_list(&library));
    for (tag, text) in [(page::GLUE, &laboratory.glue), (page::EDITOR, &editor::bundle()?), (page::PLAYER, &template)] {
        // Raw deflate, as for texts in links.
        later += &format!("{tag}{}</script>", encoded(&pack(zopfli::Format::Deflate, text.as_bytes())?));
        if tag == page::GLUE {
            later += &library_of_page;
        }
    }
    let film = steps::root().join("simulations").join("films").join("tube.mp4");
    let film = std::fs::read(&film).with_context(|| format!("cannot read {}", film.display()))?;
    later += &format!("{}{}</script>", page::FILM, encoded(&film));
    let (name, program) = first(&library)?;
    let bundle = bundle::write(&program).map_err(|error| anyhow!("{name} cannot be bundled: {error:?}"))?;
    let page = page::opening(page, &name, &pack(zopfli::Format::Gzip, &bundle)?).context("the page has no marker")?;
    let is_simulation =
        |file: &&Source| !file.name.starts_with("theories/") && document::translates(&file.text).is_none();
    let count = library.iter().filter(is_simulation).count();
    let page = page.replacen(PLACE, &format!("{PLACE} data-simulations=\"{count}\""), 1);
    Ok(page.replace(LATER, &later))
}

/// Name and program of the document with which the laboratory opens.
fn first(library: &[Source]) -> Result<(String, Program)> {
    let [home, others @ ..] = library else { bail!("the library is empty") };
    let is_own = |other: &&Source| document::translates(&other.text).as_deref() == Some(&home.name);
    let translations: Vec<&str> = others.iter().filter(is_own).map(|other| other.text.as_str()).collect();
    let document = document::open(&home.text, &translations).sound();
    let document = document.with_context(|| format!("{} has errors", home.name))?;
    Ok((home.name.clone(), document.program))
}

/// Start of a page that a browser must receive before the first picture in English. In another language, its texts follow.
pub fn before_picture(page: &str) -> &str {
    page.split_once(page::TEXTS).map_or(page, |(first, _)| first)
}

/// Prints the elements of a page with what a visitor receives before the first picture and in all.
fn print_sizes(kind: &Kind, page: &str) -> Result<()> {
    let row = |name: &str, part: &str| -> Result<()> {
        let sent = gzip(part.as_bytes())?.len() as f64 / 1000.0;
        println!("  {name:26}{:8.1} kB, gzipped {sent:7.1} kB", part.len() as f64 / 1000.0);
        Ok(())
    };
    println!("{}", kind.package);
    for element in page.split("<style>").flat_map(|part| part.split("<script")).skip(1) {
        let tag = element.split_once('>').map_or("", |(tag, _)| tag);
        let name = tag.split_once("id=\"").and_then(|(_, rest)| rest.split_once('"'));
        row(name.map_or("style or script", |(name, _)| name), element)?;
    }
    row("before the first picture", before_picture(page))?;
    row("page", page)
}

/// Script element with this JavaScript. Closing tags in the text are escaped.
fn script(text: &str) -> String {
    format!("<script>\n{}\n</script>", text.trim_end().replace("</script", "<\\/script"))
}

/// The shipped documents, named by their path below `simulations`. The document with which the laboratory
/// opens is first.
fn library() -> Result<Vec<Source>> {
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
    Ok(sources)
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

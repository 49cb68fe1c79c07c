//! Builds the npm package of the element `<meniscus-simulation>` from the parts of the pages: `target/page/npm`.
//!
//! | file | contents | loaded |
//! |---|---|---|
//! | `meniscus.js`, `meniscus.d.ts` | the element and its types (`crates/player/element`) | first |
//! | `player.bin`, `player.js`, `player.css`, `frame.js` | the player: module, scripts, styles | with the first simulation in sight |
//! | `texts-LANGUAGE.bin` | its texts | in that language |
//! | `compiler.js`, `laboratory.bin` | the laboratory's module in a worker | to compile a text |

use crate::{editor, steps};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};

/// Place of the page of a frame in the script of the element.
const PLACE: &str = "\"<!--player-->\"";
/// Place of the elements with texts in the page of a frame.
const TEXTS: &str = "<!--texts-->";

/// Parts of the pages that the package contains.
pub struct Parts<'a> {
    /// Scripts of the player, in their order.
    pub scripts: &'a [&'a str],
    /// First script of each page.
    pub first_script: &'a str,
    pub style: &'a str,
    /// Module of the player, gzipped.
    pub module: &'a [u8],
    /// Texts of the player in each language but English: its tag, and a packed catalogue, gzipped.
    pub texts: &'a [(&'static str, &'a [u8])],
    /// Script and module, gzipped, of the laboratory.
    pub laboratory: (&'a str, &'a [u8]),
}

/// Folder of the package.
pub fn folder() -> PathBuf {
    steps::page().with_file_name("npm")
}

/// Writes the package. Returns what a page loads for the element beside the player.
///
/// # Errors
/// A file cannot be read or written.
pub fn write(parts: &Parts<'_>) -> Result<String> {
    let (source, folder) = (steps::root().join("crates/player/element"), folder());
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(&folder)?;
    let script = |name: &str| editor::minified(&source.join(name));
    let save = |name: &str, content: &[u8]| {
        fs::write(folder.join(name), content).with_context(|| format!("cannot write {name} of the npm package"))
    };
    let element = script("meniscus.js")?;
    ensure!(element.contains(PLACE), "crates/player/element/meniscus.js must contain {PLACE}");
    let element = element.replace(PLACE, &serde_json::to_string(&frame(&source, parts)?)?);
    let first = script("frame.js")?;
    save("meniscus.js", element.as_bytes())?;
    save("frame.js", [first.trim_end(), "\n", parts.first_script].concat().as_bytes())?;
    save("player.js", parts.scripts.concat().as_bytes())?;
    save("player.css", parts.style.as_bytes())?;
    save("player.bin", parts.module)?;
    for (tag, texts) in parts.texts {
        save(&format!("texts-{tag}.bin"), texts)?;
    }
    let (glue, module) = parts.laboratory;
    save("compiler.js", [glue, &script("compiler.js")?].concat().as_bytes())?;
    save("laboratory.bin", module)?;
    save("meniscus.d.ts", &fs::read(source.join("meniscus.d.ts"))?)?;
    save("README.md", &fs::read(steps::root().join("docs/element.md"))?)?;
    save("LICENSE", &fs::read(steps::root().join("LICENSE"))?)?;
    save("package.json", &description(&source)?)?;
    Ok(element + &first)
}

/// The page of a frame, whose addresses begin with `@/`.
fn frame(source: &Path, parts: &Parts<'_>) -> Result<String> {
    let frame = fs::read_to_string(source.join("frame.html"))?;
    let text = |(tag, _): &(&str, &[u8])| {
        format!(
            "<script type=\"application/octet-stream\" id=\"texts-{tag}\" data-file=\"@/texts-{tag}.bin\"></script>"
        )
    };
    ensure!(frame.contains(TEXTS), "crates/player/element/frame.html must contain {TEXTS}");
    Ok(frame.replace(TEXTS, &parts.texts.iter().map(text).collect::<String>()))
}

/// `package.json` with the version of this workspace.
fn description(source: &Path) -> Result<Vec<u8>> {
    let mut description: serde_json::Value = serde_json::from_slice(&fs::read(source.join("package.json"))?)?;
    description["version"] = env!("CARGO_PKG_VERSION").into();
    Ok([serde_json::to_string_pretty(&description)?.as_bytes(), b"\n"].concat())
}

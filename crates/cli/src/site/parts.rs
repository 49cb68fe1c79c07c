//! Splits a single-file page: its styles, scripts and module become files that pages share.

use super::files::Files;
use super::names::{FROM_DISK, WORKER};
use crate::failure::Failure;
use crate::page;
use base64::Engine as _;
use document::page::{EDITOR, FILM, GLUE, LABORATORY, LABORATORY_TEXTS, MODULE, PLAYER, POLICY, TEXTS};
use flate2::read::DeflateDecoder;
use std::io::Read as _;

/// Placeholder for the relative path from a page to the top of the site. No document can contain it where it is
/// replaced.
pub const ROOT: &str = "<!--root-->";
/// Placeholder in the head for the links of a page.
pub const LINKS: &str = "<!--links-->";

/// Content security policy of the site's pages: only files of the site are loaded, and no inline script runs.
pub const SITE_POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
                               img-src data: blob:; font-src data:; connect-src 'self'; worker-src 'self' data:; \
                               base-uri 'none'; form-action 'none'";

/// Script that registers the service worker and requests the module.
const BEGIN: &str = include_str!("begin.js");

/// A page whose parts are files of the site.
#[derive(Debug)]
pub struct Parts {
    /// The page, with the placeholders [`ROOT`] and [`LINKS`].
    pub html: String,
    /// Path of its styles.
    pub style: String,
    /// Path of the script with which every page of the site begins.
    first_script: String,
}

impl Parts {
    /// Splits the page and adds its parts to `files` with names that begin with `name`.
    pub fn of(whole: &str, name: &str, files: &mut Files) -> Result<Self, Failure> {
        let (mut html, mut rest) = (String::new(), whole);
        let (mut styles, mut scripts, mut module) = (String::new(), Vec::new(), None);
        while let Some(at) = rest.find("<style>").into_iter().chain(rest.find("<script")).min() {
            html.push_str(&rest[..at]);
            rest = &rest[at..];
            let closing = if rest.starts_with("<style>") { "</style>" } else { "</script>" };
            let tag = rest.find('>').map_or("", |end| &rest[..=end]);
            let content = between(rest, tag, closing).ok_or_else(page::no_place)?;
            let end = tag.len() + content.len() + closing.len();
            match tag {
                "<style>" => {
                    if styles.is_empty() {
                        html.push_str(HEAD);
                    }
                    styles.push_str(content.trim_start());
                }
                "<script>" if scripts.is_empty() => {
                    html.push_str(FIRST_SCRIPT);
                    scripts.push(content);
                }
                "<script>" => scripts.push(content),
                MODULE => module = Some(content),
                _ if tag == LABORATORY
                    || tag == FILM
                    || tag.starts_with(TEXTS)
                    || tag.starts_with(LABORATORY_TEXTS) =>
                {
                    let id = between(tag, "id=\"", "\"").unwrap_or_default();
                    let attributes = packed(id, id, content, files)?.attributes("file");
                    html.push_str(&tag.replace('>', &format!("{attributes}></script>")));
                }
                GLUE => {
                    let script = files.share("laboratory", "js", inflated(content).ok_or_else(page::no_place)?);
                    html.push_str(&GLUE.replace('>', &format!(" data-script=\"{ROOT}{script}\"></script>")));
                }
                EDITOR => {
                    let script = files.share("editor", "js", inflated(content).ok_or_else(page::no_place)?);
                    html.push_str(&EDITOR.replace('>', &format!(" data-script=\"{ROOT}{script}\"></script>")));
                }
                // The player is embedded by a script, because pages opened from a disk cannot load other files.
                PLAYER => {
                    let script = format!("document.getElementById(\"player\").textContent = \"{content}\";\n");
                    let script = files.share("publish", "js", script);
                    html.push_str(&PLAYER.replace('>', &format!(" data-script=\"{ROOT}{script}\"></script>")));
                }
                _ => html.push_str(&rest[..end]),
            }
            rest = &rest[end..];
        }
        html.push_str(rest);
        let (Some((first, scripts)), Some(text)) = (scripts.split_first(), module) else {
            return Err(page::no_place().into());
        };
        let style = files.share(name, "css", styles);
        let first_script = files.share("site", "js", [first.trim_start(), BEGIN].concat());
        let script = files.share(name, "js", scripts.concat().trim_start());
        // The laboratory opens with the player, too.
        let module = packed("player", "module", text, files)?.attributes("module");
        let head = format!(
            "<link rel=\"stylesheet\" href=\"{ROOT}{style}\">\n\
             <script defer src=\"{ROOT}{script}\"></script>\n{LINKS}"
        );
        let html = html.replace(POLICY, SITE_POLICY).replace(HEAD, &head);
        let html = html.replace(FIRST_SCRIPT, &begin(&first_script, ROOT, &module));
        Ok(Self { html, style, first_script })
    }

    /// Element of the first script, for a page at the top of the site that plays no simulation.
    pub fn begin(&self) -> String {
        begin(&self.first_script, "", "")
    }
}

/// Element of the script with which every page begins. `root`: relative path to the top of the site.
fn begin(first_script: &str, root: &str, module: &str) -> String {
    format!("<script src=\"{root}{first_script}\" data-worker=\"{root}{}\"{module}></script>", WORKER)
}

/// Paths of a module: its bytes, and the script that puts them into the page as text.
struct Packed {
    bytes: String,
    text: String,
}

impl Packed {
    /// Attributes with the paths; that of the bytes is `data-` and this name.
    fn attributes(&self, name: &str) -> String {
        format!(" data-{name}=\"{ROOT}{}\" data-text=\"{ROOT}{}\"", self.bytes, self.text)
    }
}

/// Adds the files of a module, which stands in the element `id` of a single-file page. It stays gzipped and is inflated by the
/// page, because hosts differ in whether they compress modules.
fn packed(name: &str, id: &str, text: &str, files: &mut Files) -> Result<Packed, Failure> {
    let bytes = base64::engine::general_purpose::STANDARD.decode(text).map_err(|_| page::no_place())?;
    let script = format!("document.getElementById(\"{id}\").textContent = \"{text}\";\n");
    Ok(Packed { bytes: files.share(name, "bin", bytes), text: files.share(name, &FROM_DISK[1..], script) })
}

const HEAD: &str = "<!--head-->";
const FIRST_SCRIPT: &str = "<!--first-script-->";

/// Decodes a script that is embedded deflated and in base64.
fn inflated(text: &str) -> Option<String> {
    let bytes = base64::engine::general_purpose::STANDARD.decode(text).ok()?;
    let mut script = String::new();
    DeflateDecoder::new(bytes.as_slice()).read_to_string(&mut script).ok()?;
    Some(script)
}

/// Text between `before` and the next `after`; `None` if either is missing.
pub fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    let rest = &text[text.find(before)? + before.len()..];
    rest.find(after).map(|end| &rest[..end])
}

#[cfg(test)]
mod tests {
    use super::*;
    use document::page::LIBRARY;

    #[test]
    fn a_page_is_taken_apart_and_put_together_by_its_addresses() {
        let whole = format!(
            "<head><meta content=\"{POLICY}\"><style>\nb {{}}</style><script>\n1;\n</script></head>\
             <body><!--documents--><script>\n2;\n</script>{MODULE}AAEC</script><script>\n3;\n</script>\
             {TEXTS}es\">AAEE</script><style>\ni {{}}</style>{LABORATORY}AAED</script>{GLUE}M7EGAA==</script>{LIBRARY}[]</script>{EDITOR}M7EGAA==</script>\
             {PLAYER}AAAA</script>{FILM}AAEF</script></body>"
        );
        let mut files = Files::default();
        let parts = Parts::of(&whole, "page", &mut files).expect("a page");
        let named = |start: &str, ending: &str| {
            let is_named = |path: &str| path.starts_with(&format!("assets/{start}-")) && path.ends_with(ending);
            files.iter().find(|(path, _)| is_named(path)).expect("a file")
        };
        assert_eq!(named("page", ".css").1, b"b {}i {}");
        assert_eq!(parts.html.matches("rel=\"stylesheet\"").count(), 1);
        assert_eq!(named("player", ".bin").1, [0, 1, 2]);
        let (script, content) = named("page", ".js");
        assert_eq!(content, b"2;\n\n3;\n");
        assert!(parts.html.contains(&format!("<script defer src=\"{ROOT}{script}\"></script>")), "{}", parts.html);
        assert!(parts.html.contains(SITE_POLICY) && !parts.html.contains("AAE"), "{}", parts.html);
        // The laboratory is loaded after the player.
        let (module, bytes) = named("laboratory", ".bin");
        assert_eq!(bytes, [0, 1, 3]);
        let text = named("laboratory", FROM_DISK).0;
        let laboratory = format!("id=\"laboratory\" data-file=\"{ROOT}{module}\" data-text=\"{ROOT}{text}\"></script>");
        assert!(parts.html.contains(&laboratory), "{}", parts.html);
        // The texts of each language are a file, which is loaded when the language is chosen.
        let (texts, bytes) = named("texts-es", ".bin");
        assert_eq!(bytes, [0, 1, 4]);
        assert!(parts.html.contains(&format!("id=\"texts-es\" data-file=\"{ROOT}{texts}\"")), "{}", parts.html);
        // The editor is a separate script, which the laboratory loads on demand.
        let editor = named("editor", ".js");
        assert_eq!(editor.1, b"4;");
        let lazy = format!("id=\"editor\" data-script=\"{ROOT}{}\"></script>", editor.0);
        let (publish, text) = named("publish", ".js");
        assert_eq!(text, b"document.getElementById(\"player\").textContent = \"AAAA\";\n");
        let player = format!("id=\"player\" data-script=\"{ROOT}{publish}\"></script>");
        assert!(parts.html.contains(&player) && parts.html.contains(&lazy), "{}", parts.html);
        // The sample film is a file, which the laboratory fetches on demand.
        let (film, bytes) = named("sample-film", ".bin");
        assert_eq!(bytes, [0, 1, 5]);
        assert!(parts.html.contains(&format!("id=\"sample-film\" data-file=\"{ROOT}{film}\"")), "{}", parts.html);
        assert!(parts.html.contains(&format!("{LIBRARY}[]</script>")), "{}", parts.html);
    }
}

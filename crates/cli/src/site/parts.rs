//! Splits a single-file page: its styles, scripts and module become files that pages share.

use super::files::Files;
use super::names::{FROM_DISK, WORKER};
use crate::failure::Failure;
use crate::page;
use base64::Engine as _;
use document::page::{EDITOR, PLAYER, POLICY};
use flate2::read::DeflateDecoder;
use std::io::Read as _;

/// Placeholder for the relative path from a page to the top of the site. No document can contain it where it is
/// replaced.
pub const ROOT: &str = "<!--root-->";
/// Placeholder in the head for the links of a page.
pub const LINKS: &str = "<!--links-->";
/// Start tag of the element with the documents of the laboratory.
pub const LIBRARY: &str = "<script type=\"application/json\" id=\"library\">";

/// Content security policy of the site's pages: only files of the site are loaded, and no inline script runs.
pub const SITE_POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
                               img-src data: blob:; font-src data:; connect-src 'self'; worker-src 'self'; \
                               base-uri 'none'; form-action 'none'";

const MODULE: &str = "<script type=\"application/octet-stream\" id=\"module\">";
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
                    styles.push_str(content.trim_start());
                    html.push_str(HEAD);
                }
                "<script>" if scripts.is_empty() => {
                    html.push_str(FIRST_SCRIPT);
                    scripts.push(content);
                }
                "<script>" => scripts.push(content),
                MODULE => module = Some(content),
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
            return Err(page::no_place());
        };
        let bytes = base64::engine::general_purpose::STANDARD.decode(text).map_err(|_| page::no_place())?;
        let style = files.share(name, "css", styles);
        let first_script = files.share("site", "js", [first.trim_start(), BEGIN].concat());
        let script = files.share(name, "js", scripts.concat().trim_start());
        // The module is already gzipped and is inflated by the page, because hosts differ in whether they compress
        // modules.
        let module = files.share(name, "bin", bytes);
        let from_disk = format!("document.getElementById(\"module\").textContent = \"{text}\";\n");
        let from_disk = files.share(name, &FROM_DISK[1..], from_disk);
        let head = format!(
            "<link rel=\"stylesheet\" href=\"{ROOT}{style}\">\n\
             <script defer src=\"{ROOT}{script}\"></script>\n{LINKS}"
        );
        let html = html.replace(POLICY, SITE_POLICY).replace(HEAD, &head);
        let module = format!(" data-module=\"{ROOT}{module}\" data-text=\"{ROOT}{from_disk}\"");
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

    #[test]
    fn a_page_is_taken_apart_and_put_together_by_its_addresses() {
        let whole = format!(
            "<head><meta content=\"{POLICY}\"><style>\nb {{}}</style><script>\n1;\n</script></head>\
             <body><!--documents-->{LIBRARY}[]</script><script>\n2;\n</script>{MODULE}AAEC</script><script>\n3;\n</script>\
             {EDITOR}M7EGAA==</script>{PLAYER}AAAA</script></body>"
        );
        let mut files = Files::default();
        let parts = Parts::of(&whole, "page", &mut files).expect("a page");
        let named = |ending: &str| files.iter().find(|(path, _)| path.ends_with(ending)).expect("a file");
        assert_eq!(named(".css").1, b"b {}");
        assert_eq!(named(".bin").1, [0, 1, 2]);
        let (script, content) = files
            .iter()
            .find(|(path, _)| path.starts_with("assets/page-") && path.ends_with(".js") && !path.ends_with(FROM_DISK))
            .expect("a script");
        assert_eq!(content, b"2;\n\n3;\n");
        assert!(parts.html.contains(&format!("<script defer src=\"{ROOT}{script}\"></script>")), "{}", parts.html);
        assert!(parts.html.contains(SITE_POLICY) && !parts.html.contains("AAEC"), "{}", parts.html);
        // The editor is a separate script, which the laboratory loads on demand.
        let editor = files.iter().find(|(path, _)| path.starts_with("assets/editor-")).expect("the editor");
        assert_eq!(editor.1, b"4;");
        let lazy = format!("id=\"editor\" data-script=\"{ROOT}{}\"></script>", editor.0);
        let (publish, text) = files.iter().find(|(path, _)| path.starts_with("assets/publish-")).expect("the player");
        assert_eq!(text, b"document.getElementById(\"player\").textContent = \"AAAA\";\n");
        let player = format!("id=\"player\" data-script=\"{ROOT}{publish}\"></script>");
        assert!(parts.html.ends_with(&format!("{player}</body>")) && parts.html.contains(&lazy), "{}", parts.html);
        assert!(
            parts.html.contains(&format!("<body><!--documents-->{LIBRARY}[]</script><script type")),
            "{}",
            parts.html
        );
    }
}

//! Course packages: the page of a document with the manifest of a learning platform, as a ZIP archive.
//!
//! | kind | manifest | script in the page |
//! |---|---|---|
//! | SCORM 1.2, 2004 | `imsmanifest.xml` | `scorm.js`, `course.js` |
//! | cmi5 | `cmi5.xml` | `policy.js`, `cmi5.js`, `course.js` |
//! | web | none | none |
//!
//! `course.js` is common: it asks the page for its state and stores it. The script before it defines `platform`, which talks to
//! one kind of platform. `policy.js` lets the page of a cmi5 package ask the addresses of its launch; no other page asks anyone.
//!
//! The scripts ask the page for its state (`player/src/course.rs`).

mod manifest;

use analysis::spreadsheet::Archive;
use document::page::POLICY;
use program::Program;

/// Kind of a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// SCORM 1.2.
    Scorm12,
    /// SCORM 2004, 4th edition.
    Scorm2004,
    /// cmi5, for platforms with a store for xAPI statements.
    Cmi5,
    /// The page alone, for platforms and editors that show a folder of files.
    Web,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Scorm12, Self::Scorm2004, Self::Cmi5, Self::Web];

    /// Name in commands and file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scorm12 => "scorm12",
            Self::Scorm2004 => "scorm2004",
            Self::Cmi5 => "cmi5",
            Self::Web => "web",
        }
    }

    /// Name and text of the manifest; `None` if there is none.
    fn manifest(self, program: &Program) -> Option<(&'static str, String)> {
        match self {
            Self::Scorm12 => Some(("imsmanifest.xml", manifest::scorm12(program))),
            Self::Scorm2004 => Some(("imsmanifest.xml", manifest::scorm2004(program))),
            Self::Cmi5 => Some(("cmi5.xml", manifest::cmi5(program))),
            Self::Web => None,
        }
    }

    /// The page with the scripts of this kind at the end of its head.
    fn page(self, page: &str) -> String {
        let platform = match self {
            Self::Scorm12 | Self::Scorm2004 => include_str!("scorm.js"),
            Self::Cmi5 => include_str!("cmi5.js"),
            Self::Web => return page.to_owned(),
        };
        let code = [platform, include_str!("course.js")].map(without_comments).concat();
        // In one block, so that the names of the scripts are not those of the page.
        let script = format!("<script>\n{{\nconst kind = \"{}\";\n{code}}}\n</script>\n", self.name());
        let page = page.replacen("</head>", &(script + "</head>"), 1);
        if self != Self::Cmi5 {
            return page;
        }
        // The address of the store is known at the launch only.
        let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">");
        let own = without_comments(include_str!("policy.js"));
        page.replacen(&policy, &format!("<script>\n{{\nconst policy = \"{POLICY}\";\n{own}}}\n</script>"), 1)
    }
}

/// Package of a page made by `document::page::played` for this program, as the bytes of a ZIP archive.
pub fn package(kind: Kind, page: &str, program: &Program) -> Vec<u8> {
    let mut archive = Archive::default();
    if let Some((name, text)) = kind.manifest(program) {
        archive.add(name, text.as_bytes());
    }
    archive.add("index.html", kind.page(page).as_bytes());
    archive.finish()
}

/// A script without lines of comment and without indentation.
fn without_comments(script: &str) -> String {
    let lines = script.lines().map(str::trim_start).filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

//! A project: one file with a document, its translations, its state, and the data measured with it.
//!
//! ```json
//! {"meniscus project":1,
//!  "documents":[{"name":"spring.md","text":"…"},{"name":"spring.es.md","text":"…"}],
//!  "state":"1&p=k:20",
//!  "items":[{"name":"4f1c…","item":{"meniscus":3,"since":1763812800000,"item":{"record":{}}}}]}
//! ```
//!
//! Unknown fields are ignored. The items are those of the laboratory's storage and are not interpreted here.

use document::page::Source;
use handed::parts::{self, PROJECT_VERSION};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::value::RawValue;
use units::{Words, words};

/// Maximum size of a project, in bytes: 50 MiB of records and their descriptions.
pub const LONGEST_PROJECT: usize = 64 << 20;

/// Maximum numbers of documents and items.
const MOST_DOCUMENTS: usize = 100;
const MOST_ITEMS: usize = 10_000;

/// Extension of project files.
pub const PROJECT_ENDING: &str = ".meniscus";

/// Content of a project.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Project {
    /// The document and its translations.
    pub documents: Vec<Source>,
    /// State of the simulation in the form of a link; may be empty.
    pub state: String,
    /// Records, fits, film analyses and answers: pairs of a name and a JSON text.
    pub items: Vec<(String, String)>,
}

/// Reason why a file cannot be read as a project.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectError {
    /// Longer than [`LONGEST_PROJECT`], or too many parts.
    TooLarge,
    /// Written by a later version of the program.
    LaterVersion,
    /// Damaged, or not a project.
    Unreadable,
}

impl ProjectError {
    /// Description for the user.
    pub fn words(self) -> Words {
        match self {
            Self::TooLarge => words("is too large for a project"),
            Self::LaterVersion => words("was made by a later version of Meniscus; open it with that version"),
            Self::Unreadable => words("is damaged or no project of Meniscus; save the project again"),
        }
    }
}

#[derive(Deserialize)]
struct Written {
    #[serde(default)]
    documents: Vec<Source>,
    #[serde(default)]
    state: String,
    #[serde(default)]
    items: Vec<WrittenItem>,
}

#[derive(Deserialize)]
struct WrittenItem {
    name: String,
    item: Box<RawValue>,
}

#[derive(Deserialize)]
struct Version {
    #[serde(rename = "meniscus project")]
    version: u32,
}

impl Project {
    /// Content of the file. Items that are not JSON are left out.
    pub fn write(&self) -> String {
        let items = self.named_items().into_iter().map(|(_, item)| item);
        parts::project(&self.documents_text(), &handed::json::text(&self.state), items)
    }

    /// The documents in JSON.
    pub(crate) fn documents_text(&self) -> String {
        parts::documents(self.documents.iter().map(|Source { name, text }| (name.as_str(), text.as_str())))
    }

    /// Names of the items, and the items with their names in JSON. Items that are not JSON are left out.
    pub(crate) fn named_items(&self) -> Vec<(String, String)> {
        let is_json = |(_, text): &&(String, String)| serde_json::from_str::<IgnoredAny>(text).is_ok();
        let item = |(name, text): &(String, String)| (name.clone(), parts::named_item(name, text));
        self.items.iter().filter(is_json).map(item).collect()
    }

    /// Reads the content of a file.
    ///
    /// # Errors
    /// If the text is not a project, or is too large.
    pub fn read(text: &str) -> Result<Self, ProjectError> {
        if text.len() > LONGEST_PROJECT {
            return Err(ProjectError::TooLarge);
        }
        let Version { version } = serde_json::from_str(text).map_err(|_| ProjectError::Unreadable)?;
        if version > PROJECT_VERSION {
            return Err(ProjectError::LaterVersion);
        }
        let Written { documents, state, items } = serde_json::from_str(text).map_err(|_| ProjectError::Unreadable)?;
        if documents.len() > MOST_DOCUMENTS || items.len() > MOST_ITEMS {
            return Err(ProjectError::TooLarge);
        }
        if documents.is_empty() {
            return Err(ProjectError::Unreadable);
        }
        let items = items.into_iter().map(|WrittenItem { name, item }| (name, item.get().to_owned())).collect();
        Ok(Self { documents, state, items })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn project() -> Project {
        let source = |name: &str, text: &str| Source { name: name.to_owned(), text: text.to_owned() };
        Project {
            documents: vec![source("a.md", "---\n\"é\u{0}\\ </script>"), source("a.es.md", "")],
            state: "1&p=b:2".to_owned(),
            items: vec![("r".to_owned(), "{\"meniscus\":3,\"x\":[1.10,-0.0]}".to_owned())],
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        assert_eq!(Project::read(&project().write()), Ok(project()));
        let damaged = Project { items: vec![("r".to_owned(), "{".to_owned())], ..project() };
        assert_eq!(Project::read(&damaged.write()), Ok(Project { items: Vec::new(), ..project() }));
    }

    #[test]
    fn other_files_are_refused_with_the_reason() {
        let one = "\"documents\":[{\"name\":\"a\",\"text\":\"b\"}]";
        let many = vec!["{\"name\":\"a\",\"text\":\"\"}"; 101].join(",");
        let cases = [
            ("", Err(ProjectError::Unreadable)),
            ("[]", Err(ProjectError::Unreadable)),
            (&format!("{{{one}}}"), Err(ProjectError::Unreadable)),
            ("{\"meniscus project\":1}", Err(ProjectError::Unreadable)),
            (&format!("{{\"meniscus project\":2,{one}}}"), Err(ProjectError::LaterVersion)),
            ("{\"meniscus project\":9,\"documents\":7}", Err(ProjectError::LaterVersion)),
            (&format!("{{\"meniscus project\":1,\"documents\":[{many}]}}"), Err(ProjectError::TooLarge)),
            (
                &format!("{{\"meniscus project\":1,\"new\":{},{one}}}", "[".repeat(10_000)),
                Err(ProjectError::Unreadable),
            ),
            (&format!("{{\"meniscus project\":1,\"new\":[1],{one}}}"), Ok(1)),
        ];
        for (text, expected) in cases {
            assert_eq!(Project::read(text).map(|project| project.documents.len()), expected, "{text:.80}");
        }
        assert_eq!(Project::read(&" ".repeat(LONGEST_PROJECT + 1)), Err(ProjectError::TooLarge));
    }

    #[test]
    fn a_project_that_is_cut_off_anywhere_is_refused() {
        let whole = project().write();
        for end in whole.char_indices().map(|(end, _)| end) {
            assert_eq!(Project::read(&whole[..end]), Err(ProjectError::Unreadable), "{end}");
        }
    }
}

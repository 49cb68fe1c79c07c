//! Embedding of a page in another page: options in its address, and the HTML of the frame.
//!
//! | field of the query | value |
//! |---|---|
//! | `language` | language of the page, such as `es` |
//! | `hide` | parts to be left out, separated by commas: see [`PagePart`] |
//! | `lock` | parameters, presets and initial values cannot be changed |
//! | `height` | `content`: the page is as high as its content and reports this height to its parent |
//!
//! Other fields are ignored. The state stays in the fragment, as in every link.

use units::Language;
use units::markup::escaped;

/// A part of the page that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PagePart {
    /// Header with title, buttons and languages.
    Head,
    /// The drawing.
    Scene,
    /// The plots.
    Plots,
    /// Parameters and presets, initial values and method.
    Parameters,
    /// Values and the recorded run.
    Values,
    /// The questions.
    Activities,
    /// Prose and equations.
    Text,
}

impl PagePart {
    /// All parts, in the order of the page.
    pub const ALL: [Self; 7] =
        [Self::Head, Self::Scene, Self::Plots, Self::Parameters, Self::Values, Self::Activities, Self::Text];

    /// Name in addresses.
    pub fn name(self) -> &'static str {
        match self {
            Self::Head => "head",
            Self::Scene => "scene",
            Self::Plots => "plots",
            Self::Parameters => "parameters",
            Self::Values => "values",
            Self::Activities => "activities",
            Self::Text => "text",
        }
    }
}

/// Options in the address of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Embedding {
    /// Language of the page; `None` if not specified.
    pub language: Option<Language>,
    /// Parts that are left out.
    pub hidden: Vec<PagePart>,
    /// True if parameters, presets and initial values cannot be changed.
    pub locked: bool,
    /// True if the page is as high as its content and reports this height to its parent.
    pub follows_content: bool,
}

impl Embedding {
    /// Parses the query of an address, with or without `?`. Unknown fields are ignored.
    pub fn read(query: &str) -> Self {
        let mut read = Self::default();
        for field in query.trim_start_matches('?').split('&') {
            match field.split_once('=').unwrap_or((field, "")) {
                ("language", tag) => read.language = Language::ALL.into_iter().find(|language| language.tag() == tag),
                ("hide", names) => {
                    // Browsers and platforms may encode the commas.
                    let names = names.replace("%2C", ",").replace("%2c", ",");
                    let is_named = |part: &PagePart| names.split(',').any(|name| name == part.name());
                    read.hidden = PagePart::ALL.into_iter().filter(is_named).collect();
                }
                // Moodle and others append `=` to a field without a value.
                ("lock", "" | "1" | "true") => read.locked = true,
                ("height", "content") => read.follows_content = true,
                _ => {}
            }
        }
        read
    }

    /// The query with `?`; empty without options.
    pub fn write(&self) -> String {
        let mut fields = Vec::new();
        if let Some(language) = self.language {
            fields.push(format!("language={}", language.tag()));
        }
        if !self.hidden.is_empty() {
            let names: Vec<&str> = self.hidden.iter().map(|part| part.name()).collect();
            fields.push(format!("hide={}", names.join(",")));
        }
        if self.locked {
            fields.push("lock".to_owned());
        }
        if self.follows_content {
            fields.push("height=content".to_owned());
        }
        if fields.is_empty() { String::new() } else { format!("?{}", fields.join("&")) }
    }

    /// True if a part is left out.
    pub fn hides(&self, part: PagePart) -> bool {
        self.hidden.contains(&part)
    }

    /// HTML of a frame that shows the page at `address` (without query and fragment) in this state ([`Play::share`],
    /// may be empty). Width and height are lengths for the attributes of `iframe`: `100%` or a number of pixels.
    ///
    /// If the height follows the content, a script for the surrounding page is appended.
    ///
    /// [`Play::share`]: crate::Play::share
    pub fn frame(&self, address: &str, state: &str, title: &str, [width, height]: [&str; 2]) -> String {
        let hash = if state.is_empty() { "" } else { "#" };
        let source = format!("{address}{}{hash}{state}", self.write());
        let [source, title, width, height] = [&source, title, width, height].map(escaped);
        let frame = format!(
            "<iframe src=\"{source}\" title=\"{title}\" width=\"{width}\" height=\"{height}\" style=\"border: 0\" \
             loading=\"lazy\" allow=\"fullscreen; clipboard-write\"></iframe>"
        );
        if self.follows_content { format!("{frame}\n{FOLLOWER}") } else { frame }
    }
}

/// Sets the height of a frame to the height reported by its page. Affects only the frame that sent the message.
const FOLLOWER: &str = "<script>addEventListener(\"message\", ({ source, data }) => {
  const frame = [...document.querySelectorAll(\"iframe\")].find((frame) => frame.contentWindow === source);
  if (frame && data?.meniscus) frame.style.height = `${data.meniscus.height}px`;
});</script>";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let all = Embedding {
            language: Some(Language::Spanish),
            hidden: vec![PagePart::Plots, PagePart::Text],
            locked: true,
            follows_content: true,
        };
        assert_eq!(all.write(), "?language=es&hide=plots,text&lock&height=content");
        assert_eq!(Embedding::default().write(), "");
        for part in PagePart::ALL {
            let one = Embedding { hidden: vec![part], ..Embedding::default() };
            assert_eq!(Embedding::read(&one.write()), one);
        }
        assert_eq!(Embedding::read(&all.write()), all);
    }

    #[test]
    fn platforms_may_write_a_query_in_other_ways() {
        let cases = [
            ("", Embedding::default()),
            ("?id=7&language=xx&hide=&height=300&lock=0", Embedding::default()),
            ("?lock=&id=7", Embedding { locked: true, ..Embedding::default() }),
            (
                "hide=text%2Cplots,nothing,text",
                Embedding { hidden: vec![PagePart::Plots, PagePart::Text], ..Embedding::default() },
            ),
        ];
        for (query, expected) in cases {
            assert_eq!(Embedding::read(query), expected, "{query}");
        }
    }

    #[test]
    fn a_frame_is_html_that_no_text_can_leave() {
        let embedding = Embedding { locked: true, ..Embedding::default() };
        let frame = embedding.frame("a.html", "1&p=b:2", "\"><script>", ["100%", "600"]);
        assert_eq!(
            frame,
            "<iframe src=\"a.html?lock#1&amp;p=b:2\" title=\"&quot;&gt;&lt;script&gt;\" width=\"100%\" height=\"600\" \
             style=\"border: 0\" loading=\"lazy\" allow=\"fullscreen; clipboard-write\"></iframe>"
        );
        let follows = Embedding { follows_content: true, ..Embedding::default() };
        assert!(follows.frame("a", "", "", ["1", "1"]).contains("a?height=content\" "));
        assert_eq!(follows.frame("a", "", "", ["1", "1"]).matches("<script>").count(), 1);
    }
}

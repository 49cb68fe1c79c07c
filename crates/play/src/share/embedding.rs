//! Options in the address of a page, for pages inside other pages and for links of a teacher, and the HTML of a frame.
//!
//! | field of the query | value |
//! |---|---|
//! | `language` | language of the page, such as `es` |
//! | `hide` | parts to be left out, separated by commas: see [`PagePart`] |
//! | `lock` | parameters, presets and initial values cannot be changed |
//! | `everything` | the laboratory opens with what teachers and authors need; `everything=no`: without it |
//! | `height` | `content`: the page is as high as its content and reports this height to its parent |
//!
//! Other fields are ignored. The state stays in the fragment, as in every link.
//!
//! Player and laboratory read the same options.

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
    /// Records, cycles and fits, in the laboratory.
    Measure,
    /// Prose and equations.
    Text,
}

impl PagePart {
    /// All parts, in the order of the page.
    pub const ALL: [Self; 8] = [
        Self::Head,
        Self::Scene,
        Self::Plots,
        Self::Parameters,
        Self::Values,
        Self::Activities,
        Self::Measure,
        Self::Text,
    ];

    /// Name in addresses.
    pub fn name(self) -> &'static str {
        match self {
            Self::Head => "head",
            Self::Scene => "scene",
            Self::Plots => "plots",
            Self::Parameters => "parameters",
            Self::Values => "values",
            Self::Activities => "activities",
            Self::Measure => "measure",
            Self::Text => "text",
        }
    }
}

/// Names of the fields of a query that are options.
const FIELDS: [&str; 5] = ["language", "hide", "lock", "everything", "height"];

/// Options in the address of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Embedding {
    /// Language of the page; `None` if not specified.
    pub language: Option<Language>,
    /// Parts that are left out.
    pub hidden: Vec<PagePart>,
    /// True if parameters, presets and initial values cannot be changed.
    pub locked: bool,
    /// State of the switch *Everything* in the laboratory; `None` if not specified.
    pub everything: Option<bool>,
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
                ("everything", "" | "1" | "true") => read.everything = Some(true),
                ("everything", "no") => read.everything = Some(false),
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
        if let Some(on) = self.everything {
            fields.push(if on { "everything" } else { "everything=no" }.to_owned());
        }
        if self.follows_content {
            fields.push("height=content".to_owned());
        }
        if fields.is_empty() { String::new() } else { format!("?{}", fields.join("&")) }
    }

    /// An address with these options instead of its own. Other fields of its query stay behind them.
    pub fn in_address(&self, address: &str) -> String {
        let (page, fragment) = address.find('#').map_or((address, ""), |place| address.split_at(place));
        let (page, query) = page.split_once('?').unwrap_or((page, ""));
        let is_own = |field: &&str| FIELDS.contains(&field.split('=').next().unwrap_or_default());
        let others = query.split('&').filter(|field| !field.is_empty() && !is_own(field));
        let own = self.write();
        let fields: Vec<&str> =
            own.trim_start_matches('?').split('&').filter(|field| !field.is_empty()).chain(others).collect();
        let mark = if fields.is_empty() { "" } else { "?" };
        format!("{page}{mark}{}{fragment}", fields.join("&"))
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
            language: Some(catalogues::with(Language::Spanish)),
            hidden: vec![PagePart::Plots, PagePart::Text],
            locked: true,
            everything: Some(false),
            follows_content: true,
        };
        assert_eq!(all.write(), "?language=es&hide=plots,text&lock&everything=no&height=content");
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
            ("?everything=&id=7", Embedding { everything: Some(true), ..Embedding::default() }),
            ("?everything=perhaps", Embedding::default()),
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
    fn options_replace_those_of_an_address_and_leave_the_rest() {
        let on = Embedding { everything: Some(true), ..Embedding::default() };
        let cases = [
            ("file:///a.html", "file:///a.html?everything", "file:///a.html"),
            ("a.html#1&d=b.md&p=c:1", "a.html?everything#1&d=b.md&p=c:1", "a.html#1&d=b.md&p=c:1"),
            ("a.html?id=7&lock&everything=no&hide=text#1", "a.html?everything&id=7#1", "a.html?id=7#1"),
            ("a.html?#", "a.html?everything#", "a.html#"),
        ];
        for (address, with, without) in cases {
            assert_eq!(on.in_address(address), with, "{address}");
            assert_eq!(on.in_address(with), with, "{address}");
            assert_eq!(Embedding::default().in_address(address), without, "{address}");
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

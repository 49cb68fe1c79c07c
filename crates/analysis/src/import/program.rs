//! Programs whose own files are no text, and the place where they export text.

use units::Language;

/// Program of a school laboratory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// Logger Pro of Vernier, `.cmbl`: XML.
    LoggerPro,
    /// CASSY Lab 2 of LD Didactic, `.labx`: XML.
    CassyLab,
    /// Capstone of PASCO, `.cap`: an archive of `main.xml` and a folder of binary data.
    Capstone,
}

impl Program {
    /// Program whose XML begins with this text.
    pub(super) fn of_xml(start: &str) -> Option<Self> {
        let lower = start.to_lowercase();
        if lower.contains("<datacolumn") || lower.contains("<dataset>") {
            return Some(Self::LoggerPro);
        }
        lower.contains("cassy").then_some(Self::CassyLab)
    }

    /// Name of the program.
    pub fn name(self) -> &'static str {
        match self {
            Self::LoggerPro => "Logger Pro",
            Self::CassyLab => "CASSY Lab",
            Self::Capstone => "PASCO Capstone",
        }
    }

    /// Place where the program exports text.
    pub fn export(self, language: Language) -> &'static str {
        match self {
            Self::LoggerPro => language.say("in Logger Pro, File > Export As > Text writes the table as text"),
            Self::CassyLab => language.say(
                "in CASSY Lab, save the measurement with the file type `*.txt`, or copy the table into a text file",
            ),
            Self::Capstone => language.say("in Capstone, File > Export Data writes the table as text"),
        }
    }
}

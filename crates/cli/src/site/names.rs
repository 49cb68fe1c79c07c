//! Names of the files of a site.

/// Page of the laboratory.
pub const LABORATORY: &str = "laboratory.html";
/// Index page of the simulations.
pub const INDEX: &str = "index.html";
/// Guide of the language.
pub const GUIDE: &str = "guide.md";
/// List of the contents of the site, for language models.
pub const LLMS: &str = "llms.txt";
/// Service worker. It is at the top of the site because it only serves paths below it.
pub const WORKER: &str = "sw.js";
/// Suffix of the text version of a module, which pages opened from a disk load.
pub const FROM_DISK: &str = ".text.js";

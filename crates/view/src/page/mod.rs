//! The page around stage and panel: header, messages, keys, and what applies to the whole page.
//!
//! `everything.rs` has the switch of the laboratory that adds what teachers and authors need (`App::everything`); the
//! exported page shows all that it has. `messages.rs` is the line of messages: `Prominence` decides what it shows.
//! `projector.rs` shows the stage alone. `shell.rs` is what every page has around its content. `welcome.rs` draws the line of
//! the opening document. What is printed is built by `panel/worksheet.rs`.

pub mod class;
pub mod everything;
pub mod handing;
pub mod header;
pub mod keys;
pub mod message;
pub mod messages;
pub mod opening;
pub mod projector;
pub mod shell;
pub mod texts;
pub mod theme;
pub mod welcome;

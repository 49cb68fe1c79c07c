//! The page around stage and panel: header, messages, keys, and what applies to the whole page.

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

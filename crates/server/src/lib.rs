//! The class server: students join with a code, their hand-ins are stored durably part by part, and the teacher follows them live.
//!
//! | module | content |
//! |---|---|
//! | [`store`] | the log of events in a file or a database: group commit, erasing, backups |
//! | [`class`] | classes, seats and their tokens in memory |
//! | [`fold`] | hand-ins as a fold over the events of a seat |
//! | [`http`] | routes for students and teacher, guards and limits |
//! | [`pages`] | pages of the students and the teacher |
//! | [`listen`] | connections, also with TLS |
//!
//! Everything that is shown is a fold over an append-only log. A part of a hand-in is acknowledged when it is on disk, and sending
//! it again adds nothing.
//!
//! The server is axum over hyper, SQLite or Postgres, and rustls. [`http`] gives each seat and each network its part of
//! streams, joins and memory for large bodies (`http/limits.rs`). Pages without the server contain none of it.
//!
//! - **Invariant:** no physics. What is shown is a fold over the log, whatever the order of arrival and however often a part
//!   was sent.
//! - **Invariant:** no cookie, and no token in an address: tokens stand in `Authorization`, the store has their hashes. No
//!   network address is stored or logged.
//! - **Invariant:** what one server has answered holds on every server before the same store from then on. No text contains
//!   the password of a database.

pub mod class;
pub mod codes;
pub mod export;
pub mod fold;
pub mod http;
pub mod listen;
pub mod pages;
mod private;
pub mod pseudonyms;
pub mod qr;
pub mod store;
mod texts;
mod time;

pub use private::write_private_files;
pub use store::{Fault, Store};
pub use time::now;

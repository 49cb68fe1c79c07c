//! What the Python packages ask of `runner`, independent of how Python reaches it.
//!
//! `open` opens a document, `call` fulfils a request (`run`, `sweep`, `fit`, `rank`, ..). A request is a name, a text of
//! JSON, read by `serde` into types such as `settings::Asked`, and arrays of numbers; so is its reply. The JSON is that of
//! the Python sources in `crates/python/python/meniscus`, which alone write requests and read replies. A value of a setting
//! is a text that reads back as the same bits. A document keeps what its last sweep was prepared with, by the text of that
//! part of the request. `Host` gives files, the player, signals, and in a browser a compiler of emitted code. Errors are
//! replies with the name of a Python exception.
//!
//! - **Invariant:** numbers of tables never become text.

mod arguments;
mod calls;
mod diagnostic;
mod fault;
mod fitting;
mod host;
mod opened;
mod prepared;
mod ranking;
mod reply;
mod runs;
mod settings;
mod sweeps;
mod table;

pub use calls::call;
pub use host::Host;
pub use opened::{Opened, open};
pub use reply::{Buffer, Reply};

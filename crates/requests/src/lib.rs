//! What the Python packages ask of `runner`, independent of how Python reaches it: a request is a name, a text of JSON and arrays
//! of numbers, and so is its reply. Numbers of tables never become text. The JSON is that of the Python sources in
//! `crates/python/python/meniscus`, which alone write requests and read replies.

mod arguments;
mod calls;
mod diagnostic;
mod fault;
mod fitting;
mod host;
mod keywords;
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

//! Routes of the server.
//!
//! | path | for | content |
//! |---|---|---|
//! | `/`, `/d/NAME`, `/stored` | everyone | list of the documents, a document, *What is stored* |
//! | `/health` | programs that watch the server | the store can be read |
//! | `/api/join` | everyone | a code for a token |
//! | `/api/state`, `/api/stream`, `/api/events`, `/api/mine`, `/api/erase`, `/api/others`, `/api/file/NAME` | students | settings, hand-ins, own data |
//! | `/api/survey` | students, without their seat | answers to surveys |
//! | `/teacher`, `/api/teacher/..` | the teacher | dashboard, settings, events, hand-ins |
//!
//! Tokens stand in the header `Authorization`; there are no cookies, so that no other page can act for a student or teacher. A proxy
//! may log paths and queries beside network addresses: none has a seat, a code, or the number of something stored.

mod answer;
mod gate;
mod guard;
mod health;
mod holders;
mod limits;
mod log;
mod mine;
mod routes;
mod state;
mod stream;
mod student;
mod tally;
mod teacher;

pub use answer::LARGEST;
pub use log::Log;
pub use state::{Peer, Place, Server};

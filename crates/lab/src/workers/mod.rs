//! Long work beside the page: workers that run the page's own module, so that the page stays responsive. Where a browser
//! refuses workers, the page computes in slices.
//!
//! Fits, the hand-ins of a class and the runs of plots over a parameter are computed beside the page, by at most two workers
//! each. `opening.js` starts a worker from a `data:` address with the script of the laboratory and posts it the compiled
//! module; `main` sees that it has no window and serves (`served.rs`). `pool.rs` sends each worker one `Order` at a time as
//! bytes of postcard's format and collects the answers, which begin with the number of their order. To cancel is to end the
//! worker, except for runs of plots: a slider makes them stale many times a second, so the worker makes them in slices
//! (`sweeping.rs`) and receives `Order::Stop` or the next batch between them.
//!
//! Where a browser refuses workers, `InProcess` computes fits in slices, `Collection::advance` the hand-ins, and
//! `Plots::work_beside` the runs, which it also does until the workers are ready. Batches of runs are handed out in frames
//! only: in a hidden page the workers finish their batches and wait.
//!
//! An order that is a text is a document to be compiled (`compiling.rs`): pages with the player alone begin such a worker.

mod answer;
mod compiling;
mod fits;
mod order;
mod pool;
mod served;
mod sweeping;
mod sweeps;

pub use fits::FitWorkers;
pub use order::Order;
pub use pool::{Heard, Pool};
pub use served::{is_worker, serve};
pub use sweeps::SweepPool;

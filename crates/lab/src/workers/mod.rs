//! Long work beside the page: workers that run the page's own module, so that the page stays responsive. Where a browser
//! refuses workers, the page computes in slices.

mod answer;
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

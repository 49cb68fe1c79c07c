//! Workers for plots over a parameter.

use super::order::Order;
use super::pool::{Heard, Pool};
use play::{SweepNews, SweepWork, SweepWorkers};

/// Computes runs of plots over a parameter in workers. They are started when the first plot needs them, and wait for the next
/// one.
#[derive(Default)]
pub struct SweepPool {
    pool: Pool,
    /// True if a worker has stopped because of a fault: the page computes from then on.
    is_lost: bool,
}

impl SweepPool {
    /// Sets what is to be done when there is news.
    pub fn wake_by(&mut self, wake: impl Fn() + 'static) {
        self.pool.wake_by(wake);
    }
}

impl SweepWorkers for SweepPool {
    fn count(&mut self) -> usize {
        if self.is_lost {
            return 0;
        }
        self.pool.start_all();
        // The runs are shared equally, so all workers begin together.
        if self.pool.is_ready() { self.pool.count() } else { 0 }
    }

    fn begin(&mut self, work: SweepWork) -> u32 {
        self.pool.begin(&Order::Sweep(Box::new(work)))
    }

    fn news(&mut self) -> Vec<(u32, SweepNews)> {
        let mut all = Vec::new();
        for (number, heard) in self.pool.hear() {
            let news = match heard {
                Heard::Answer(bytes) => postcard::from_bytes(&bytes).unwrap_or(SweepNews::Lost),
                Heard::Stopped | Heard::Refused => SweepNews::Lost,
            };
            match news {
                SweepNews::Taken { is_last: true, .. } => self.pool.finish(number),
                SweepNews::Taken { is_last: false, .. } => {}
                SweepNews::Lost => self.is_lost = true,
            }
            all.push((number, news));
        }
        if self.is_lost {
            self.pool.end();
        }
        all
    }

    fn keep(&mut self, wanted: &[u32]) {
        self.pool.stop_others(wanted);
    }
}

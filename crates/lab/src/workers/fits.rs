//! Workers for fits.

use super::order::Order;
use super::pool::{Heard, Pool};
use desk::{FitNews, FitWork, InProcess, NothingFound, Workers};

/// Computes the fits of a desk in workers, or here if the browser has none.
#[derive(Default)]
pub struct FitWorkers {
    pool: Pool,
    here: Option<InProcess>,
}

impl FitWorkers {
    /// Sets what is to be done when there is news.
    pub fn wake_by(&mut self, wake: impl Fn() + 'static) {
        self.pool.wake_by(wake);
    }

    /// True if the page itself computes, so that it has to be asked again and again.
    pub fn is_here(&self) -> bool {
        self.here.is_some()
    }

    fn read(&mut self, number: u32, heard: Heard) -> FitNews {
        let news = match heard {
            Heard::Answer(bytes) => postcard::from_bytes(&bytes).unwrap_or(FitNews::Found(Err(NothingFound::NoCurve))),
            Heard::Stopped => FitNews::Found(Err(NothingFound::NoCurve)),
            Heard::Refused => FitNews::Lost,
        };
        if matches!(news, FitNews::Found(_)) {
            self.pool.finish(number);
        }
        news
    }
}

impl Workers for FitWorkers {
    fn count(&self) -> usize {
        if self.here.is_some() { 1 } else { self.pool.count() }
    }

    fn begin(&mut self, work: FitWork) -> u32 {
        match &mut self.here {
            Some(here) => here.begin(work),
            None => self.pool.begin(&Order::Fit(Box::new(work))),
        }
    }

    fn news(&mut self) -> Vec<(u32, FitNews)> {
        if let Some(here) = &mut self.here {
            return here.news();
        }
        let heard = self.pool.hear();
        let news = heard.into_iter().map(|(number, heard)| (number, self.read(number, heard))).collect();
        if self.pool.is_refused() {
            self.here = Some(InProcess::after(self.pool.ordered()));
        }
        news
    }

    fn keep(&mut self, wanted: &[u32]) {
        match &mut self.here {
            Some(here) => here.keep(wanted),
            None => self.pool.keep(wanted),
        }
    }
}

//! Workers that compute the hand-ins of a class.

use crate::workers::{Heard, Order, Pool};
use class::collection::{Collection, Computed, WorkOrder};

/// Number of hand-ins in an order: a worker goes on while the page is busy.
const TOGETHER: usize = 4;

/// Computes hand-ins beside the page.
#[derive(Default)]
pub struct Computing {
    pool: Pool,
    /// The orders with the indices of their hand-ins.
    orders: Vec<(u32, Vec<usize>)>,
}

impl Computing {
    /// Sets what is to be done when something has been computed.
    pub fn wake_by(&mut self, wake: impl Fn() + 'static) {
        self.pool.wake_by(wake);
    }

    /// Gives what has been computed to the collection, and orders as many further hand-ins as there are workers. Returns true
    /// while something is ordered. If the browser has no workers, nothing is.
    pub fn exchange(&mut self, collection: &mut Collection) -> bool {
        for (number, heard) in self.pool.hear() {
            let Some(place) = self.orders.iter().position(|(order, _)| *order == number) else { continue };
            let (_, indices) = self.orders.swap_remove(place);
            self.pool.finish(number);
            match heard {
                Heard::Answer(bytes) => {
                    let computed: Vec<Option<Computed>> = postcard::from_bytes(&bytes).unwrap_or_default();
                    let mut computed = computed.into_iter();
                    indices.into_iter().for_each(|index| match computed.next() {
                        Some(one) => collection.deliver(index, one),
                        None => collection.fail(index),
                    });
                }
                Heard::Stopped => indices.into_iter().for_each(|index| collection.fail(index)),
                Heard::Refused => indices.into_iter().for_each(|index| collection.take_back(index)),
            }
        }
        while !self.pool.is_refused() && self.pool.free() > 0 {
            let (indices, orders): (Vec<usize>, Vec<WorkOrder>) =
                std::iter::from_fn(|| collection.order()).take(TOGETHER).unzip();
            if indices.is_empty() {
                break;
            }
            self.orders.push((self.pool.begin(&Order::HandIns(orders)), indices));
        }
        !self.orders.is_empty()
    }

    /// Ends all computations.
    pub fn end(&mut self) {
        self.orders.clear();
        self.pool.end();
    }
}

//! Limit of wrong codes for each address. Right codes never count: a whole school may have one address.
//!
//! After [`FREE`] wrong codes within a minute the codes of this address are tried one after the other, each after a pause, so that
//! guessing a code of thirty bits takes years. Right codes pass with that pause.

use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::sleep;

/// Wrong codes of an address that have no consequence.
const FREE: u32 = 20;
/// Time after which wrong codes are forgotten.
const FORGET: Duration = Duration::from_secs(60);
/// Pause before each code of an address with too many wrong ones.
const PAUSE: Duration = Duration::from_millis(100);
/// Number of codes of such an address that wait at most.
const WAITING: usize = 32;
/// Number of addresses that are remembered at most.
const ADDRESSES: usize = 10_000;

#[derive(Debug)]
struct Wrong {
    count: u32,
    since: Instant,
    waiting: Arc<Semaphore>,
    turn: Arc<Semaphore>,
}

/// Addresses with wrong codes.
#[derive(Debug, Default)]
pub struct Gate(Mutex<HashMap<IpAddr, Wrong>>);

/// Permission to try a code. The next one of a limited address waits until it is dropped.
#[derive(Debug)]
pub struct Pass {
    is_limited: bool,
    _turn: Option<(OwnedSemaphorePermit, OwnedSemaphorePermit)>,
}

impl Pass {
    /// True if the address has sent too many wrong codes.
    pub fn is_limited(&self) -> bool {
        self.is_limited
    }
}

impl Gate {
    /// Waits until a code of this address may be tried; `None` if too many wait already.
    pub async fn enter(&self, address: IpAddr) -> Option<Pass> {
        let Some((waiting, turn)) = self.limits(address) else {
            return Some(Pass { is_limited: false, _turn: None });
        };
        let place = waiting.try_acquire_owned().ok()?;
        let turn = turn.acquire_owned().await.ok()?;
        sleep(PAUSE).await;
        Some(Pass { is_limited: true, _turn: Some((place, turn)) })
    }

    fn limits(&self, address: IpAddr) -> Option<(Arc<Semaphore>, Arc<Semaphore>)> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let wrong = all.get(&address)?;
        if wrong.since.elapsed() > FORGET {
            all.remove(&address);
            return None;
        }
        (wrong.count >= FREE).then(|| (wrong.waiting.clone(), wrong.turn.clone()))
    }

    /// Counts a wrong code.
    pub fn count_wrong(&self, address: IpAddr) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if all.len() >= ADDRESSES {
            all.retain(|_, wrong| wrong.since.elapsed() <= FORGET);
        }
        if all.len() >= ADDRESSES && !all.contains_key(&address) {
            return;
        }
        let semaphore = |permits| Arc::new(Semaphore::new(permits));
        let new = || Wrong { count: 0, since: Instant::now(), waiting: semaphore(WAITING), turn: semaphore(1) };
        let wrong = all.entry(address).or_insert_with(new);
        wrong.count = wrong.count.saturating_add(1);
        wrong.since = Instant::now();
    }
}

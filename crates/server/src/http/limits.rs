//! Room that clients share. Each seat and each network has a part of its own, so that nobody takes the room of all.

use std::collections::HashMap;
use std::hash::Hash;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::timeout;

/// Sum of the large bodies that are in memory at the same time, in KiB.
const BODIES: usize = 96 << 10;
/// Part of it that one network has, in KiB: a school with one address in front of it hands in.
const BODIES_OF_NETWORK: usize = BODIES / 2;
/// Large bodies that a seat sends at the same time.
const BODIES_OF_SEAT: usize = 2;
/// Maximum time for which a body waits for room.
const WAITS: Duration = Duration::from_secs(10);

/// Streams of a seat at the same time, one for each tab.
const STREAMS_OF_SEAT: usize = 3;
/// Streams of a class's teachers at the same time.
const STREAMS_OF_TEACHER: usize = 16;
/// Streams of a network at the same time: a school with 2,000 students has one address.
const STREAMS_OF_NETWORK: usize = 2400;

/// Devices of a network that join within [`JOINS_COUNT`].
const JOINS: u32 = 2500;
/// Time after which joins are forgotten.
const JOINS_COUNT: Duration = Duration::from_secs(3600);
/// Number of networks that are remembered at most.
const NETWORKS: usize = 10_000;

/// Identifier of a class and number of a seat; seat 0 is the teacher's.
pub type Seat = (String, u32);

/// An address as far as it distinguishes clients: one customer has all IPv6 addresses with the same first 64 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Network(pub IpAddr);

impl From<IpAddr> for Network {
    fn from(address: IpAddr) -> Self {
        Self(match address.to_canonical() {
            IpAddr::V6(address) => Ipv6Addr::from_bits(address.to_bits() >> 64 << 64).into(),
            address => address,
        })
    }
}

/// Semaphores by client. Those without permits outside are forgotten.
#[derive(Debug)]
struct Shares<K>(Mutex<HashMap<K, Weak<Semaphore>>>);

impl<K> Default for Shares<K> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash> Shares<K> {
    /// Part of a client, with `most` permits while nobody holds one.
    fn part(&self, client: K, most: usize) -> Arc<Semaphore> {
        let mut held = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(own) = held.get(&client).and_then(Weak::upgrade) {
            return own;
        }
        if held.len() == held.capacity() {
            held.retain(|_, own| own.strong_count() > 0);
            let used = held.len();
            held.shrink_to(2 * used);
        }
        let own = Arc::new(Semaphore::new(most));
        held.insert(client, Arc::downgrade(&own));
        own
    }
}

/// Limits of all clients.
#[derive(Debug)]
pub struct Limits {
    bodies: Arc<Semaphore>,
    bodies_of_network: Shares<Network>,
    bodies_of_seat: Shares<Seat>,
    streams_of_seat: Shares<Seat>,
    streams_of_network: Shares<Network>,
    joins: Mutex<HashMap<Network, (u32, Instant)>>,
}

/// Place of a stream, which is given back when this is dropped.
#[derive(Debug)]
pub struct StreamPlace {
    _permits: [OwnedSemaphorePermit; 2],
}

/// Room of a body, which is given back when this is dropped.
#[derive(Debug)]
pub struct BodyRoom {
    parts: [Arc<Semaphore>; 2],
    permits: Vec<OwnedSemaphorePermit>,
    kib: usize,
    _place: Option<OwnedSemaphorePermit>,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            bodies: Arc::new(Semaphore::new(BODIES)),
            bodies_of_network: Shares::default(),
            bodies_of_seat: Shares::default(),
            streams_of_seat: Shares::default(),
            streams_of_network: Shares::default(),
            joins: Mutex::default(),
        }
    }
}

impl Limits {
    /// A place for a stream; `None` if the seat or the network has as many as it may.
    pub fn stream(&self, seat: Seat, network: Network) -> Option<StreamPlace> {
        let most = if seat.1 == 0 { STREAMS_OF_TEACHER } else { STREAMS_OF_SEAT };
        let seat = self.streams_of_seat.part(seat, most).try_acquire_owned().ok()?;
        let network = self.streams_of_network.part(network, STREAMS_OF_NETWORK).try_acquire_owned().ok()?;
        Some(StreamPlace { _permits: [seat, network] })
    }

    /// Room for a large body, empty at first; `None` if the seat sends as many as it may. Answers to a survey have no seat.
    pub fn body(&self, seat: Option<Seat>, network: Network) -> Option<BodyRoom> {
        let place = match seat {
            Some(seat) => Some(self.bodies_of_seat.part(seat, BODIES_OF_SEAT).try_acquire_owned().ok()?),
            None => None,
        };
        let parts = [self.bodies_of_network.part(network, BODIES_OF_NETWORK), self.bodies.clone()];
        Some(BodyRoom { parts, permits: Vec::new(), kib: 0, _place: place })
    }

    /// Counts a device that joins; false if too many of its network have joined.
    pub fn join(&self, network: Network) -> bool {
        let mut joins = self.joins.lock().unwrap_or_else(PoisonError::into_inner);
        if joins.len() >= NETWORKS || joins.get(&network).is_some_and(|(_, since)| since.elapsed() > JOINS_COUNT) {
            joins.retain(|_, (_, since)| since.elapsed() <= JOINS_COUNT);
        }
        if joins.len() >= NETWORKS && !joins.contains_key(&network) {
            return false;
        }
        let (count, _) = joins.entry(network).or_insert_with(|| (0, Instant::now()));
        let has_room = *count < JOINS;
        *count += u32::from(has_room);
        has_room
    }

    /// Takes back a join that did not happen.
    pub fn unjoin(&self, network: Network) {
        let mut joins = self.joins.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((count, _)) = joins.get_mut(&network) {
            *count = count.saturating_sub(1);
            if *count == 0 {
                joins.remove(&network);
            }
        }
    }
}

impl BodyRoom {
    /// Takes room for the bytes that have arrived so far. `None` if there is none for some time.
    pub async fn grow(&mut self, bytes: usize) -> Option<()> {
        let kib = bytes.div_ceil(1024);
        let more = u32::try_from(kib.saturating_sub(self.kib)).ok()?;
        for (place, part) in self.parts.iter().enumerate() {
            let new = timeout(WAITS, part.clone().acquire_many_owned(more)).await.ok()?.ok()?;
            match self.permits.get_mut(place) {
                Some(permit) => permit.merge(new),
                None => self.permits.push(new),
            }
        }
        self.kib = self.kib.max(kib);
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn network(text: &str) -> Network {
        Network::from(text.parse::<IpAddr>().unwrap())
    }

    #[test]
    fn addresses_of_one_customer_are_one_network() {
        assert_eq!(network("2001:db8::1"), network("2001:db8::ffff:2"));
        assert_ne!(network("2001:db8::1"), network("2001:db8:0:1::1"));
        assert_eq!(network("::ffff:192.0.2.1"), network("192.0.2.1"));
        assert_ne!(network("192.0.2.1"), network("192.0.2.2"));
    }

    #[test]
    fn a_network_has_a_number_of_joins_of_its_own() {
        let limits = Limits::default();
        let [one, other] = ["192.0.2.1", "192.0.2.2"].map(network);
        assert!((0..JOINS).all(|_| limits.join(one)));
        assert!(!limits.join(one));
        assert!(limits.join(other));
        limits.unjoin(one);
        assert!(limits.join(one) && !limits.join(one));
    }

    #[test]
    fn a_network_has_a_number_of_streams_of_its_own() {
        let limits = Limits::default();
        let [one, other] = ["192.0.2.1", "192.0.2.2"].map(network);
        let seat = |seat| ("class".to_owned(), seat);
        let held: Vec<_> = (1..).map_while(|number| limits.stream(seat(number), one)).collect();
        assert_eq!(held.len(), STREAMS_OF_NETWORK);
        assert!(limits.stream(seat(1), other).is_some());
        drop(held);
        assert!(limits.stream(seat(1), one).is_some());
        // Nothing is kept of those that have ended.
        let remembered = |shares: &Shares<Seat>| shares.0.lock().unwrap().capacity();
        (0..100_000).for_each(|number| drop(limits.stream(seat(number), one)));
        assert!(remembered(&limits.streams_of_seat) < 10_000, "{}", remembered(&limits.streams_of_seat));
    }

    #[tokio::test(start_paused = true)]
    async fn bodies_of_a_network_leave_room_for_others() {
        let limits = Limits::default();
        let [one, other] = ["192.0.2.1", "192.0.2.2"].map(network);
        let seat = |seat| Some(("class".to_owned(), seat));
        // A body without bytes takes nothing.
        let idle: Vec<_> = (1..=1000).map(|number| limits.body(seat(number), one).unwrap()).collect();
        let mut large = Vec::new();
        for number in 1..=7 {
            let mut body = limits.body(seat(number), one).unwrap();
            large.push((body.grow(8 << 20).await, body));
        }
        let served: Vec<bool> = large.iter().map(|(has_room, _)| has_room.is_some()).collect();
        assert_eq!(served, [true, true, true, true, true, true, false]);
        assert!(limits.body(seat(1), one).is_none(), "a third body of a seat");
        assert!(limits.body(seat(2000), other).unwrap().grow(8 << 20).await.is_some());
        assert!(limits.body(None, other).unwrap().grow(1 << 20).await.is_some());
        drop((idle, large));
        assert!(limits.body(seat(1), one).unwrap().grow(8 << 20).await.is_some());
    }
}

//! Room of seats and classes: what each may store.

use super::{Class, Classes, locked};
use crate::store::{Fault, NewEvent, Outcome, ROW};
use serde::Serialize;
use std::sync::Arc;

/// Maximum size of what a seat stores, in bytes.
const MOST_OF_SEAT: u64 = 64 << 20;

/// Room of a class, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ClassRoom {
    /// Bytes stored.
    pub used: u64,
    /// Maximum number of bytes.
    pub most: u64,
    /// True if something was refused for lack of room and nothing was erased since.
    pub full: bool,
}

impl Class {
    /// Takes room for bytes of a seat; seat 0 has what belongs to no seat.
    fn take_room(&self, seat: u32, bytes: u64, most: u64) -> Result<(), Fault> {
        let mut state = locked(&self.state);
        if seat > 0 && state.sizes.get(&seat).copied().unwrap_or(0) + bytes > MOST_OF_SEAT {
            return Err(Fault::SeatFull);
        }
        if state.sizes.values().sum::<u64>() + bytes > most {
            let was_full = std::mem::replace(&mut state.is_full, true);
            drop(state);
            if !was_full {
                // The teacher is told.
                self.tell_of_seats();
            }
            return Err(Fault::ClassFull);
        }
        *state.sizes.entry(seat).or_default() += bytes;
        Ok(())
    }

    /// Gives room back that was not used.
    fn give_room_back(&self, seat: u32, bytes: u64) {
        let mut state = locked(&self.state);
        if let Some(size) = state.sizes.get_mut(&seat) {
            *size = size.saturating_sub(bytes);
            if *size == 0 {
                state.sizes.remove(&seat);
            }
        }
    }
}

impl Classes {
    /// These classes with another maximum size of what each of them stores, in bytes.
    pub fn with_room(self, most: u64) -> Self {
        Self { room: most, ..self }
    }

    /// Room of a class.
    pub fn room(&self, class: &Class) -> ClassRoom {
        let state = locked(&class.state);
        ClassRoom { used: state.sizes.values().sum(), most: self.room, full: state.is_full }
    }

    /// Stores events of a seat as [`Store::append`](crate::Store::append) does, within the room of seat and class.
    ///
    /// # Errors
    /// Seat or class has no more room; as in the store.
    pub async fn append(
        &self,
        class: &Arc<Class>,
        seat: u32,
        at: u64,
        events: Vec<NewEvent>,
    ) -> Result<Outcome, Fault> {
        let bytes = events.iter().map(|event| event.body.len() as u64 + ROW).sum();
        let work = self.store.clone();
        let id = class.id().to_owned();
        self.within_room(class, seat, bytes, async move {
            let outcome = work.append(id, seat, at, events).await?;
            Ok((outcome, outcome.added > 0))
        })
        .await
    }

    /// Stores the answers of one person to a survey as [`Store::add_sheet`](crate::Store::add_sheet) does, within the room of the class.
    ///
    /// # Errors
    /// The class has no more room; as in the store.
    pub async fn add_sheet(&self, class: &Arc<Class>, id: [u8; 16], body: String) -> Result<(), Fault> {
        let bytes = body.len() as u64 + ROW;
        let (store, of) = (self.store.clone(), class.id().to_owned());
        self.within_room(class, 0, bytes, async move { Ok(((), store.add_sheet(of, id, body).await?)) }).await
    }

    /// Takes room, and gives it back if the work has failed or, as its second result says, has stored nothing. The work is done to its
    /// end, also if the connection of the student is lost meanwhile.
    async fn within_room<T: Send + 'static>(
        &self,
        class: &Arc<Class>,
        seat: u32,
        bytes: u64,
        work: impl Future<Output = Result<(T, bool), Fault>> + Send + 'static,
    ) -> Result<T, Fault> {
        class.take_room(seat, bytes, self.room)?;
        let class = class.clone();
        let task = tokio::spawn(async move {
            let done = work.await;
            if !matches!(done, Ok((_, true))) {
                class.give_room_back(seat, bytes);
            }
            done.map(|(result, _)| result)
        });
        task.await.map_err(|_| Fault::Ending)?
    }
}

//! Changes of other servers before the same store.

use super::{Class, Classes, Holder, locked};
use crate::store::{Fault, News};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::Ordering;

impl Classes {
    /// Learns what other servers have changed until the call. Of calls at the same time, one asks the store for all.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn catch_up(&self) -> Result<(), Fault> {
        let place = self.asked.fetch_add(1, Ordering::AcqRel) + 1;
        let mut known = self.known.lock().await;
        if known.1 >= place {
            return Ok(());
        }
        // These calls have begun before the store is asked.
        let asked = self.asked.load(Ordering::Acquire);
        let news = self.store.news(known.0).await?;
        let cursor = news.cursor;
        self.learn(news).await?;
        *known = (cursor, asked);
        Ok(())
    }

    async fn learn(&self, news: News) -> Result<(), Fault> {
        let News { classes, teachers, erased, seats, tokens, latest, settings, .. } = news;
        let mut gone: BTreeMap<String, BTreeSet<u32>> = BTreeMap::new();
        for (class, seat) in erased {
            gone.entry(class).or_default().insert(seat);
        }
        if !gone.is_empty() {
            self.forget(|of, own| gone.get(of.id()).is_some_and(|seats| seats.contains(&0) || seats.contains(&own)));
        }
        for row in classes {
            match self.find(&row.class) {
                Some(class) => *locked(&class.code) = row.code,
                None => drop(self.read(row).await?),
            }
        }
        for (class, seat) in seats {
            let Some(class) = self.find(&class) else { continue };
            locked(&self.keys).insert(seat.key, (class.clone(), seat.seat));
            let approved = seat.approved;
            let former = locked(&class.state).seats.insert(seat.seat, seat);
            if former.is_some_and(|former| former.approved != approved) {
                // Students who wait follow the settings.
                class.settings.send_modify(|_| {});
            }
            class.tell_of_seats();
        }
        for class in teachers.iter().filter_map(|class| self.find(class)) {
            let own = tokens.iter().filter(|(_, of, seat)| of == class.id() && *seat == 0);
            self.keep_teachers(&class, &own.map(|(hash, ..)| *hash).collect::<Vec<_>>());
        }
        for (hash, class, seat) in tokens {
            let Some(class) = self.find(&class) else { continue };
            locked(&self.tokens).insert(hash, class.holder(seat));
        }
        for class in settings.iter().filter_map(|class| self.find(class)) {
            let (settings, number) = self.stored_settings(class.id()).await?;
            class.take_settings(settings, number);
        }
        for (class, number) in latest {
            if let Some(class) = self.find(&class) {
                class.tell(number);
            }
        }
        Ok(())
    }

    /// Forgets seats with their tokens and keys. Seat 0 is asked for the class itself.
    pub(super) fn forget(&self, is_gone: impl Fn(&Class, u32) -> bool) {
        locked(&self.tokens).retain(|_, holder| match holder {
            Holder::Student(class, seat) => !is_gone(class, *seat),
            Holder::Teacher(class) | Holder::Survey(class) => !is_gone(class, 0),
        });
        locked(&self.keys).retain(|_, (class, seat)| !is_gone(class, *seat));
        locked(&self.classes).retain(|class| {
            let is_over = is_gone(class, 0);
            let has_fewer = {
                let mut state = locked(&class.state);
                let before = state.seats.len();
                state.seats.retain(|seat, _| !is_gone(class, *seat));
                state.sizes.retain(|seat, _| !is_gone(class, *seat));
                state.seats.len() < before
            };
            if is_over || has_fewer {
                locked(&class.state).is_full = false;
                class.tell_of_seats();
                // Streams of these seats end.
                class.settings.send_modify(|_| {});
            }
            !is_over
        });
    }

    /// Work beside the requests: learns at once what other servers change, for those who follow.
    pub async fn follow(&self) {
        loop {
            self.store.changed().await;
            // The next request or change tries again.
            let _ = self.catch_up().await;
        }
    }
}

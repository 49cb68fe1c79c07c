//! Classes in memory: settings, seats and tokens. The store has the same; a start of the server reads it, and changes of other
//! servers before the same store are read before each request ([`Classes::catch_up`]).

mod learning;
mod room;
mod settings;

pub use room::ClassRoom;
pub use settings::Settings;

use crate::codes::{self, Hash};
use crate::pseudonyms::pseudonym;
use crate::store::{ClassRow, Cursor, Fault, NewSeat, SeatRow, Store};
use crate::time::DAY;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::atomic::AtomicU64;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::watch;
use units::Language;

/// Kind of the teacher's events with settings.
pub const SETTINGS: &str = "settings";

/// Maximum size of what a class stores if nothing else is said, in bytes.
pub const MOST_OF_CLASS: u64 = 4 << 30;

/// Maximum number of seats of a class.
pub const MOST_SEATS: u32 = 10_000;

/// Holder of a token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Holder {
    /// The teacher of a class.
    Teacher(Arc<Class>),
    /// A student.
    Student(Arc<Class>, u32),
    /// Any student of a class, for the answers to surveys.
    Survey(Arc<Class>),
}

/// Seat and token of a student who has joined.
#[derive(Clone, Debug, Serialize)]
pub struct Joined {
    /// Token of this device.
    pub token: String,
    /// Number of the seat.
    pub seat: u32,
    /// Pseudonym of the seat.
    pub pseudonym: String,
    /// Key with which another device takes the same seat; empty for such a device.
    pub key: String,
    /// Token for answers to surveys, the same for all students of the class.
    pub survey: String,
    /// False while the student waits for the teacher.
    pub approved: bool,
}

/// Reason for the refusal of a join.
#[derive(Debug)]
pub enum NotJoined {
    /// There is no such code.
    Wrong,
    /// The class is closed.
    Closed,
    /// The class has as many seats as it may, or the teacher gives no more.
    Full,
    /// The store did not do it.
    Store(Fault),
}

impl From<Fault> for NotJoined {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::SeatFull => Self::Full,
            // Class or seat was erased meanwhile.
            Fault::Missing => Self::Wrong,
            fault => Self::Store(fault),
        }
    }
}

/// A class.
#[derive(Debug)]
pub struct Class {
    /// Row of the store, without the code, which the teacher can change.
    row: ClassRow,
    /// Present code.
    code: Mutex<String>,
    state: Mutex<State>,
    settings: watch::Sender<Settings>,
    /// Order of arrival of the settings.
    set: Mutex<u64>,
    /// Order of arrival of the latest event.
    latest: watch::Sender<u64>,
}

#[derive(Debug, Default)]
struct State {
    seats: BTreeMap<u32, SeatRow>,
    /// Bytes that each seat has stored, as far as this server knows: each server counts what passes through it. Seat 0 has the settings
    /// and the answers to surveys.
    sizes: BTreeMap<u32, u64>,
    /// Something was refused for lack of room of the class, and nothing was erased since.
    is_full: bool,
}

impl PartialEq for Class {
    fn eq(&self, other: &Self) -> bool {
        self.row.class == other.row.class
    }
}

impl Eq for Class {}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // Nothing in here panics while it holds a lock.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Class {
    /// Identifier.
    pub fn id(&self) -> &str {
        &self.row.class
    }

    /// Code with which students join.
    pub fn code(&self) -> String {
        locked(&self.code).clone()
    }

    /// Title.
    pub fn title(&self) -> &str {
        &self.row.title
    }

    /// End of the class, in milliseconds since 1970.
    pub fn expires(&self) -> u64 {
        self.row.expires
    }

    /// Present settings.
    pub fn settings(&self) -> Settings {
        self.settings.borrow().clone()
    }

    /// Takes settings unless there are later ones.
    fn take_settings(&self, settings: Settings, number: u64) {
        let mut set = locked(&self.set);
        if number > *set {
            *set = number;
            self.settings.send_replace(settings);
        }
    }

    /// Follows the settings.
    pub fn follow_settings(&self) -> watch::Receiver<Settings> {
        self.settings.subscribe()
    }

    /// Follows the order of arrival of the latest event.
    pub fn follow_events(&self) -> watch::Receiver<u64> {
        self.latest.subscribe()
    }

    /// Tells those who follow that there are events up to this number.
    pub fn tell(&self, number: u64) {
        self.latest.send_if_modified(|latest| {
            let is_later = number > *latest;
            *latest = number.max(*latest);
            is_later
        });
    }

    /// Tells those who follow that seats have changed.
    fn tell_of_seats(&self) {
        self.latest.send_modify(|_| {});
    }

    /// Holder of a token of this seat; seat 0 is the teacher's.
    fn holder(self: &Arc<Self>, seat: u32) -> Holder {
        match seat {
            0 => Holder::Teacher(self.clone()),
            seat => Holder::Student(self.clone(), seat),
        }
    }

    /// Seats in their order.
    pub fn seats(&self) -> Vec<SeatRow> {
        locked(&self.state).seats.values().cloned().collect()
    }

    /// A seat.
    pub fn seat(&self, seat: u32) -> Option<SeatRow> {
        locked(&self.state).seats.get(&seat).cloned()
    }
}

/// All classes of a store.
#[derive(Debug)]
pub struct Classes {
    store: Store,
    /// Maximum size of what each class stores, in bytes.
    room: u64,
    /// Language of new pseudonyms.
    language: Language,
    /// Place in the changes of other servers, and the number of requests before which they are known.
    known: tokio::sync::Mutex<(Cursor, u64)>,
    /// Number of requests.
    asked: AtomicU64,
    classes: Mutex<Vec<Arc<Class>>>,
    tokens: Mutex<HashMap<Hash, Holder>>,
    /// Keys of seats.
    keys: Mutex<HashMap<Hash, (Arc<Class>, u32)>>,
}

fn new_class(title: &str, days: u32, now: u64) -> Result<ClassRow, Fault> {
    let [id, code] = [codes::code(12), codes::code(codes::CLASS_CODE)].map(|code| code.ok_or(Fault::Ending));
    Ok(ClassRow {
        class: id?,
        code: code?,
        title: title.to_owned(),
        survey: codes::token().ok_or(Fault::Ending)?,
        created: now,
        expires: now + u64::from(days) * DAY,
    })
}

impl Classes {
    /// Reads all classes of a store; those whose time is over are erased before.
    ///
    /// # Errors
    /// The store cannot be read or written.
    pub async fn open(store: Store, language: Language, now: u64) -> Result<Self, Fault> {
        store.erase_expired(now).await?;
        let classes = Self {
            store: store.clone(),
            room: MOST_OF_CLASS,
            language,
            known: tokio::sync::Mutex::new((store.cursor().await?, 0)),
            asked: AtomicU64::new(0),
            classes: Mutex::default(),
            tokens: Mutex::default(),
            keys: Mutex::default(),
        };
        for row in store.classes().await? {
            classes.read(row).await?;
        }
        Ok(classes)
    }

    fn find(&self, class: &str) -> Option<Arc<Class>> {
        locked(&self.classes).iter().find(|own| own.id() == class).cloned()
    }

    async fn stored_settings(&self, class: &str) -> Result<(Settings, u64), Fault> {
        let event = self.store.latest_of_teacher(class.to_owned(), SETTINGS).await?;
        let number = event.as_ref().map_or(0, |event| event.number);
        Ok((event.and_then(|event| serde_json::from_str(&event.body).ok()).unwrap_or_default(), number))
    }

    /// The store.
    pub fn store(&self) -> &Store {
        &self.store
    }

    /// The latest class; `None` if there is none.
    pub fn latest(&self) -> Option<Arc<Class>> {
        locked(&self.classes).first().cloned()
    }

    /// The latest class. If the store has none, begins one, even if several servers ask at the same time.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn latest_or_begin(&self, title: &str, days: u32, now: u64) -> Result<Arc<Class>, Fault> {
        if let Some(class) = self.latest() {
            return Ok(class);
        }
        self.store.add_class(new_class(title, days, now)?, true).await?;
        for row in self.store.classes().await? {
            self.read(row).await?;
        }
        self.latest().ok_or(Fault::Missing)
    }

    /// Begins a new class, which is kept for this number of days.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn begin(&self, title: &str, days: u32, now: u64) -> Result<Arc<Class>, Fault> {
        let row = new_class(title, days, now)?;
        self.store.add_class(row.clone(), false).await?;
        self.read(row).await
    }

    /// Reads a class into memory, unless another task has done so meanwhile.
    async fn read(&self, mut row: ClassRow) -> Result<Arc<Class>, Fault> {
        let id = row.class.clone();
        let (settings, set) = self.stored_settings(&id).await?;
        let seats = self.store.seats(id.clone()).await?;
        let sizes = self.store.sizes(id.clone()).await?.into_iter().collect();
        let survey = codes::hash(&row.survey);
        let keys: Vec<(Hash, u32)> = seats.iter().map(|seat| (seat.key, seat.seat)).collect();
        let seats = seats.into_iter().map(|seat| (seat.seat, seat)).collect();
        let class = Arc::new(Class {
            code: Mutex::new(std::mem::take(&mut row.code)),
            row,
            state: Mutex::new(State { seats, sizes, is_full: false }),
            settings: watch::channel(settings).0,
            set: Mutex::new(set),
            latest: watch::channel(self.store.last_number().await?).0,
        });
        let stored = self.store.tokens(id).await?;
        let mut classes = locked(&self.classes);
        if let Some(known) = classes.iter().find(|known| ***known == *class) {
            return Ok(known.clone());
        }
        locked(&self.keys).extend(keys.into_iter().map(|(key, seat)| (key, (class.clone(), seat))));
        locked(&self.tokens).insert(survey, Holder::Survey(class.clone()));
        locked(&self.tokens).extend(stored.into_iter().map(|(hash, seat)| (hash, class.holder(seat))));
        // Students of earlier classes are told that there is another one.
        classes.iter().for_each(|earlier| earlier.settings.send_modify(|_| {}));
        classes.push(class.clone());
        classes.sort_by_key(|class| std::cmp::Reverse(class.row.created));
        Ok(class)
    }

    /// Holder of a token.
    ///
    /// # Errors
    /// The store cannot be read.
    pub async fn holder(&self, token: &str) -> Result<Option<Holder>, Fault> {
        self.catch_up().await?;
        Ok(locked(&self.tokens).get(&codes::hash(token)).cloned())
    }

    /// Joins with the code of a class, or with the key of a seat. A closed class gives no new seats; a seat takes another device.
    ///
    /// # Errors
    /// The code is wrong, the class gives no seat, or the store cannot be written.
    pub async fn join(&self, typed: &str, now: u64) -> Result<Joined, NotJoined> {
        self.catch_up().await?;
        let code = codes::normal(typed);
        let token = codes::token().ok_or(Fault::Ending)?;
        let hash = codes::hash(&token);
        let taken = locked(&self.keys).get(&codes::hash(&code)).cloned();
        let found = locked(&self.classes).iter().find(|class| *locked(&class.code) == code).cloned();
        let (class, seat, key) = match (taken, found) {
            (Some((class, seat)), _) => {
                let seat = class.seat(seat).ok_or(Fault::Missing)?;
                self.store.add_token(class.id().to_owned(), seat.seat, hash).await?;
                (class, seat, String::new())
            }
            (None, Some(class)) => {
                let settings = class.settings();
                if !settings.accepts(now) {
                    return Err(NotJoined::Closed);
                }
                if !settings.joining {
                    return Err(NotJoined::Full);
                }
                let key = codes::code(codes::SEAT_KEY).ok_or(Fault::Ending)?;
                let seat = self.new_seat(&class, codes::hash(&key));
                let seat = self.store.add_seat(class.id().to_owned(), seat, hash, MOST_SEATS).await?;
                locked(&class.state).seats.insert(seat.seat, seat.clone());
                locked(&self.keys).insert(seat.key, (class.clone(), seat.seat));
                (class, seat, key)
            }
            (None, None) => return Err(NotJoined::Wrong),
        };
        locked(&self.tokens).insert(hash, Holder::Student(class.clone(), seat.seat));
        class.tell_of_seats();
        let survey = class.row.survey.clone();
        let SeatRow { seat, pseudonym, approved, .. } = seat;
        Ok(Joined { token, seat, pseudonym, key, survey, approved })
    }

    fn new_seat(&self, class: &Class, key: Hash) -> NewSeat {
        let pseudonym = pseudonym(NewSeat::NUMBER, key[0], self.language);
        NewSeat { pseudonym, key, approved: !class.settings().approve }
    }

    /// A one-time link for the teacher: the secret part.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn link(&self, class: &Class) -> Result<String, Fault> {
        let link = codes::token().ok_or(Fault::Ending)?;
        self.store.add_link(class.id().to_owned(), codes::hash(&link)).await?;
        Ok(link)
    }

    /// Exchanges a one-time link for a token of the teacher. `None` if it was used, or never existed.
    ///
    /// # Errors
    /// The store cannot be written; the link can be used again then.
    pub async fn exchange(&self, link: &str) -> Result<Option<String>, Fault> {
        let token = codes::token().ok_or(Fault::Ending)?;
        let hash = codes::hash(&token);
        let Some(class) = self.store.exchange(codes::hash(link), hash).await? else { return Ok(None) };
        if self.find(&class).is_none() {
            self.catch_up().await?;
        }
        let Some(class) = self.find(&class) else { return Ok(None) };
        locked(&self.tokens).insert(hash, Holder::Teacher(class));
        Ok(Some(token))
    }

    /// Changes the settings of a class.
    ///
    /// # Errors
    /// The store cannot be written; the former settings stay.
    pub async fn set(&self, class: &Class, settings: Settings, now: u64) -> Result<(), Fault> {
        let body = serde_json::to_string(&settings).unwrap_or_default();
        let number = self.store.append_of_teacher(class.id().to_owned(), now, SETTINGS, body).await?;
        class.take_settings(settings, number);
        class.tell(number);
        Ok(())
    }

    /// Lets a student in.
    ///
    /// # Errors
    /// There is no such seat, or the store cannot be written.
    pub async fn approve(&self, class: &Class, seat: u32) -> Result<(), Fault> {
        if class.seat(seat).is_none() {
            return Err(Fault::Missing);
        }
        self.store.approve(class.id().to_owned(), seat).await?;
        if let Some(seat) = locked(&class.state).seats.get_mut(&seat) {
            seat.approved = true;
        }
        // Students who wait follow the settings.
        class.settings.send_modify(|_| {});
        class.tell_of_seats();
        Ok(())
    }

    /// Erases a seat with everything that it has sent, and its tokens.
    ///
    /// # Errors
    /// There is no such seat, or the store cannot be written.
    pub async fn erase(&self, class: &Class, seat: u32) -> Result<(), Fault> {
        // From here on the store takes nothing of this seat. Its tokens stay until it is erased, so that one can try again.
        self.store.erase_seats(class.id().to_owned(), vec![seat]).await?;
        self.forget(|of, own| *of == *class && own == seat);
        Ok(())
    }

    /// Erases the seats that have handed in nothing. Pages that do so meanwhile keep their work and join again.
    ///
    /// # Errors
    /// The store cannot be read or written.
    pub async fn erase_unused(&self, class: &Class) -> Result<(), Fault> {
        self.catch_up().await?;
        let used: BTreeSet<u32> =
            self.store.sizes(class.id().to_owned()).await?.into_iter().map(|(seat, _)| seat).collect();
        let unused: BTreeSet<u32> = {
            let state = locked(&class.state);
            state.seats.keys().filter(|seat| !used.contains(seat) && !state.sizes.contains_key(seat)).copied().collect()
        };
        self.store.erase_seats(class.id().to_owned(), unused.iter().copied().collect()).await?;
        self.forget(|of, own| *of == *class && unused.contains(&own));
        Ok(())
    }

    /// Gives a class another code. The former one opens nothing from then on; seats and their devices stay.
    ///
    /// # Errors
    /// The store cannot be written; the former code stays.
    pub async fn renew_code(&self, class: &Class) -> Result<(), Fault> {
        let code = codes::code(codes::CLASS_CODE).ok_or(Fault::Ending)?;
        self.store.set_code(class.id().to_owned(), code.clone()).await?;
        *locked(&class.code) = code;
        Ok(())
    }

    /// Revokes the tokens of all devices of the teacher of a class but one, and the links that nobody has used.
    ///
    /// # Errors
    /// The store cannot be written; the tokens stay.
    pub async fn revoke_teachers(&self, class: &Class, own: Hash) -> Result<(), Fault> {
        self.store.revoke_teachers(class.id().to_owned(), own).await?;
        self.keep_teachers(class, &[own]);
        Ok(())
    }

    /// Forgets the tokens of the teacher of a class but these.
    fn keep_teachers(&self, class: &Class, kept: &[Hash]) {
        locked(&self.tokens).retain(|hash, holder| match holder {
            Holder::Teacher(of) => **of != *class || kept.contains(hash),
            Holder::Student(..) | Holder::Survey(_) => true,
        });
        // Streams of these devices end.
        class.tell_of_seats();
    }

    /// True if somebody holds the token of this hash.
    pub fn is_known(&self, token: &Hash) -> bool {
        locked(&self.tokens).contains_key(token)
    }

    /// Erases the classes whose time is over.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn erase_expired(&self, now: u64) -> Result<(), Fault> {
        let over = self.store.erase_expired(now).await?;
        self.forget(|class, _| over.iter().any(|id| id == class.id()));
        Ok(())
    }
}

//! Classes in memory: settings, seats and tokens. The store has the same; a start of the server reads it.

use crate::codes::{self, Hash};
use crate::pseudonyms::pseudonym;
use crate::store::{ClassRow, Fault, SeatRow, Store};
use crate::time::DAY;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::watch;
use units::Language;

/// Kind of the teacher's events with settings.
pub const SETTINGS: &str = "settings";

/// Maximum size of what a seat stores, in bytes.
const MOST_OF_SEAT: u64 = 64 << 20;

/// Maximum number of seats of a class.
pub const MOST_SEATS: u32 = 10_000;

/// Settings of the teacher. The latest event of the teacher counts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Hand-ins are accepted.
    pub open: bool,
    /// The pages of the students are covered.
    pub paused: bool,
    /// Document at which the class works; `None` if each student chooses.
    pub pace: Option<String>,
    /// Time at which the class closes, by the server's clock, in milliseconds since 1970.
    pub closes: Option<u64>,
    /// Students who join from now on wait until the teacher lets them in.
    pub approve: bool,
    /// Students see how many have answered each question, and how many of them rightly.
    pub results: bool,
    /// Students see the answers of others to a question that they have answered themselves.
    pub others: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { open: true, paused: false, pace: None, closes: None, approve: false, results: false, others: false }
    }
}

impl Settings {
    /// True if hand-ins are accepted at this time.
    pub fn accepts(&self, now: u64) -> bool {
        self.open && self.closes.is_none_or(|closes| now < closes)
    }
}

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

/// A class.
#[derive(Debug)]
pub struct Class {
    row: ClassRow,
    language: Language,
    state: Mutex<State>,
    settings: watch::Sender<Settings>,
    /// Order of arrival of the latest event.
    latest: watch::Sender<u64>,
}

#[derive(Debug, Default)]
struct State {
    seats: BTreeMap<u32, SeatRow>,
    last_seat: u32,
    /// Bytes that each seat has stored.
    sizes: BTreeMap<u32, u64>,
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
    pub fn code(&self) -> &str {
        &self.row.code
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

    /// True if a seat has room for this number of bytes.
    pub fn has_room(&self, seat: u32, bytes: u64) -> bool {
        locked(&self.state).sizes.get(&seat).copied().unwrap_or(0) + bytes <= MOST_OF_SEAT
    }

    /// Notes that a seat has stored this number of bytes.
    pub fn note_size(&self, seat: u32, bytes: u64) {
        *locked(&self.state).sizes.entry(seat).or_default() += bytes;
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
    classes: Mutex<Vec<Arc<Class>>>,
    tokens: Mutex<HashMap<Hash, Holder>>,
    /// Keys of seats.
    keys: Mutex<HashMap<Hash, (Arc<Class>, u32)>>,
    /// Hashes of the one-time links of teachers.
    links: Mutex<HashMap<Hash, Arc<Class>>>,
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
            classes: Mutex::default(),
            tokens: Mutex::default(),
            keys: Mutex::default(),
            links: Mutex::default(),
        };
        for row in store.classes().await? {
            classes.read(row, language).await?;
        }
        Ok(classes)
    }

    /// The store.
    pub fn store(&self) -> &Store {
        &self.store
    }

    /// The latest class; `None` if there is none.
    pub fn latest(&self) -> Option<Arc<Class>> {
        locked(&self.classes).first().cloned()
    }

    /// Begins a new class, which is kept for this number of days.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn begin(&self, title: &str, days: u32, language: Language, now: u64) -> Result<Arc<Class>, Fault> {
        let [id, code] = [codes::code(12), codes::code(codes::CLASS_CODE)].map(|code| code.ok_or(Fault::Ending));
        let row = ClassRow {
            class: id?,
            code: code?,
            title: title.to_owned(),
            survey: codes::token().ok_or(Fault::Ending)?,
            created: now,
            expires: now + u64::from(days) * DAY,
        };
        self.store.add_class(row.clone()).await?;
        self.read(row, language).await
    }

    async fn read(&self, row: ClassRow, language: Language) -> Result<Arc<Class>, Fault> {
        let id = row.class.clone();
        let settings = self.store.latest_of_teacher(id.clone(), SETTINGS).await?;
        let settings = settings.and_then(|event| serde_json::from_str(&event.body).ok()).unwrap_or_default();
        let last_seat = self.store.last_seat(id.clone()).await?;
        let seats = self.store.seats(id.clone()).await?;
        let sizes = self.store.sizes(id.clone()).await?.into_iter().collect();
        let survey = codes::hash(&row.survey);
        let keys: Vec<(Hash, u32)> = seats.iter().map(|seat| (seat.key, seat.seat)).collect();
        let seats = seats.into_iter().map(|seat| (seat.seat, seat)).collect();
        let class = Arc::new(Class {
            row,
            language,
            state: Mutex::new(State { seats, last_seat, sizes }),
            settings: watch::channel(settings).0,
            latest: watch::channel(self.store.last_number().await?).0,
        });
        locked(&self.keys).extend(keys.into_iter().map(|(key, seat)| (key, (class.clone(), seat))));
        locked(&self.tokens).insert(survey, Holder::Survey(class.clone()));
        let stored = self.store.tokens(id).await?;
        let holder = |seat| match seat {
            0 => Holder::Teacher(class.clone()),
            seat => Holder::Student(class.clone(), seat),
        };
        locked(&self.tokens).extend(stored.into_iter().map(|(hash, seat)| (hash, holder(seat))));
        let mut classes = locked(&self.classes);
        classes.push(class.clone());
        classes.sort_by_key(|class| std::cmp::Reverse(class.row.created));
        Ok(class)
    }

    /// Holder of a token.
    pub fn holder(&self, token: &str) -> Option<Holder> {
        locked(&self.tokens).get(&codes::hash(token)).cloned()
    }

    /// Joins with the code of a class, or with the key of a seat. `None` if the code is wrong.
    ///
    /// # Errors
    /// The store cannot be written, or the class is full.
    pub async fn join(&self, typed: &str) -> Result<Option<Joined>, Fault> {
        let code = codes::normal(typed);
        let token = codes::token().ok_or(Fault::Ending)?;
        let hash = codes::hash(&token);
        let taken = locked(&self.keys).get(&codes::hash(&code)).cloned();
        let found = locked(&self.classes).iter().find(|class| class.row.code == code).cloned();
        let (class, seat, key) = match (taken, found) {
            (Some((class, seat)), _) => {
                let seat = class.seat(seat).ok_or(Fault::Missing)?;
                self.store.add_token(class.id().to_owned(), seat.seat, hash).await?;
                (class, seat, String::new())
            }
            (None, Some(class)) => {
                let key = codes::code(codes::SEAT_KEY).ok_or(Fault::Ending)?;
                let seat = self.new_seat(&class, codes::hash(&key))?;
                self.store.add_seat(class.id().to_owned(), seat.clone(), hash).await?;
                locked(&class.state).seats.insert(seat.seat, seat.clone());
                locked(&self.keys).insert(seat.key, (class.clone(), seat.seat));
                (class, seat, key)
            }
            (None, None) => return Ok(None),
        };
        locked(&self.tokens).insert(hash, Holder::Student(class.clone(), seat.seat));
        class.tell_of_seats();
        let survey = class.row.survey.clone();
        let SeatRow { seat, pseudonym, approved, .. } = seat;
        Ok(Some(Joined { token, seat, pseudonym, key, survey, approved }))
    }

    fn new_seat(&self, class: &Class, key: Hash) -> Result<SeatRow, Fault> {
        let approved = !class.settings().approve;
        let mut state = locked(&class.state);
        if state.last_seat >= MOST_SEATS {
            return Err(Fault::SeatFull);
        }
        state.last_seat += 1;
        let seat = state.last_seat;
        Ok(SeatRow { seat, pseudonym: pseudonym(seat, key[0], class.language), key, approved })
    }

    /// A one-time link for the teacher: the secret part.
    pub fn link(&self, class: &Arc<Class>) -> Option<String> {
        let link = codes::token()?;
        locked(&self.links).insert(codes::hash(&link), class.clone());
        Some(link)
    }

    /// Exchanges a one-time link for a token of the teacher. `None` if it was used, or never existed.
    ///
    /// # Errors
    /// The store cannot be written; the link can be used again then.
    pub async fn exchange(&self, link: &str) -> Result<Option<String>, Fault> {
        let hash = codes::hash(link);
        let Some(class) = locked(&self.links).remove(&hash) else { return Ok(None) };
        let token = codes::token().ok_or(Fault::Ending)?;
        if let Err(fault) = self.store.add_token(class.id().to_owned(), 0, codes::hash(&token)).await {
            locked(&self.links).insert(hash, class);
            return Err(fault);
        }
        locked(&self.tokens).insert(codes::hash(&token), Holder::Teacher(class));
        Ok(Some(token))
    }

    /// Changes the settings of a class.
    ///
    /// # Errors
    /// The store cannot be written; the former settings stay.
    pub async fn set(&self, class: &Class, settings: Settings, now: u64) -> Result<(), Fault> {
        let body = serde_json::to_string(&settings).unwrap_or_default();
        let number = self.store.append_of_teacher(class.id().to_owned(), now, SETTINGS, body).await?;
        class.settings.send_replace(settings);
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
        self.store.erase_seat(class.id().to_owned(), seat).await?;
        locked(&self.tokens)
            .retain(|_, holder| !matches!(holder, Holder::Student(of, own) if **of == *class && *own == seat));
        locked(&self.keys).retain(|_, (of, own)| !(**of == *class && *own == seat));
        locked(&class.state).seats.remove(&seat);
        class.tell_of_seats();
        Ok(())
    }

    /// Erases the classes whose time is over.
    ///
    /// # Errors
    /// The store cannot be written.
    pub async fn erase_expired(&self, now: u64) -> Result<(), Fault> {
        let over = self.store.erase_expired(now).await?;
        let is_over = |class: &Class| over.iter().any(|id| id == class.id());
        locked(&self.classes).retain(|class| !is_over(class));
        locked(&self.keys).retain(|_, (class, _)| !is_over(class));
        locked(&self.tokens).retain(|_, holder| match holder {
            Holder::Teacher(class) | Holder::Student(class, _) | Holder::Survey(class) => !is_over(class),
        });
        Ok(())
    }
}

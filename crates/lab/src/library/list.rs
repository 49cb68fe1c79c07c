//! Dialog of the library: cards of the documents with moving pictures, and a search.

use crate::app::App;
use crate::library::courses::{COURSES, Course, Level, place_of};
use crate::library::pictures::Pictures;
use crate::library::search::{Found, Search};
use crate::library::{Entry, entries, find};
use crate::write::kept;
use crate::{documents::opening, library::own as library_own};
use document::Card;
use play::{Link, Subject};
use view::views::*;
use view::{browser, views};
use web_sys::{Element, HtmlDialogElement, HtmlElement, KeyboardEvent, MouseEvent};

/// Id of the search field.
const SEARCH: &str = "library-search";

/// Opens the entry with this file name. Returns false if there is none.
pub fn open(app: App, file: &str) -> bool {
    let Some(files) = find(file) else { return false };
    opening::open_sources(app, files);
    true
}

/// Opens the library.
pub fn choose(app: App) {
    app.library_asked_for.set(true);
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>("library-list") {
        let _ = dialog.show_modal();
    }
    // On a touch screen, the focus would open the keyboard, which hides the cards.
    if browser::matches("(hover: hover)") {
        browser::focus(SEARCH);
    }
}

/// The library as a dialog. Its cards exist only while it is open, because pictures need memory.
pub fn dialog(app: App) -> HtmlDialog {
    let words = app.words();
    views::dialog("library-list", "library-title", words.library, words.close)
        .when(events::close, move |_| app.library_asked_for.set(false))
        .child(changing(move || if app.library_asked_for.get() { contents(app) } else { View::new() }))
}

/// An entry with its card.
struct Item {
    number: usize,
    entry: Entry,
    card: Card,
    /// Document written in this browser; `None` for one contained in the page.
    own: Option<kept::Document>,
}

fn contents(app: App) -> View {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let own = kept::documents(language).into_iter().map(|own| (Entry { files: own.kept.files() }, Some(own)));
    let mut carried = entries();
    // In the order of the cards, which arrow keys follow: by course, then what stands in none.
    units::order::sort_by_key(&mut carried, |entry| {
        let place = place_of(entry.file()).map(|(course, place, _)| (course, place));
        (entry.is_theory(), place.is_none(), place)
    });
    let all = own.chain(carried.into_iter().map(|entry| (entry, None)));
    let item = |(number, (entry, own)): (usize, (Entry, _))| Item { number, card: entry.card(language), entry, own };
    let items: Vec<Item> = all.enumerate().map(item).collect();
    let search = Search::over(items.iter().map(|item| &item.entry));
    let pictures = Pictures::new(language);
    let (typing, scrolling) = (pictures.clone(), pictures.clone());
    let found = search.found();
    let theories: Vec<bool> = items.iter().map(|item| item.entry.is_theory()).collect();
    let count = theories.iter().filter(|is_theory| !**is_theory).count();
    let tools = div()
        .class("library-tools")
        .when(events::keydown, move |event| from_search(&event, found))
        .when(events::input, move |_| typing.wait())
        .child(field(app, &search))
        .child(p().role("status").class("note").child(text(move || {
            let shown = |theory: bool| {
                let of_kind = |(shown, is_theory): &(&bool, &bool)| **shown && **is_theory == theory;
                found.with(|found| found.iter().zip(&theories).filter(of_kind).count())
            };
            let and_theories = match shown(true) {
                0 => String::new(),
                some => format!(" · {}: {some}", words.library_and_theories),
            };
            format!("{}: {} / {count}{and_theories}", words.library_found, shown(false))
        })))
        .child(chips(app, &search));
    let (own, carried): (Vec<Item>, Vec<Item>) = items.into_iter().partition(|item| item.own.is_some());
    let (theories, simulations): (Vec<Item>, Vec<Item>) = carried.into_iter().partition(|item| item.entry.is_theory());
    let mut by_course: Vec<Vec<Item>> = COURSES.iter().map(|_| Vec::new()).collect();
    let mut others = Vec::new();
    for item in simulations {
        let course = place_of(item.entry.file()).and_then(|(course, ..)| by_course.get_mut(course));
        course.unwrap_or(&mut others).push(item);
    }
    let tongue = app.language.get_untracked();
    let course = |(course, items): (&Course, Vec<Item>)| {
        let [title, text] = [&course.title, &course.note].map(|words| words.text(tongue).into_owned());
        group(app, title, text, items, found, &pictures)
    };
    let groups = div()
        .class("library-groups")
        .when(events::keydown, move |event| among_cards(&event, found))
        .when(events::scroll, move |_| scrolling.wait())
        .child(group(app, words.library_own.to_owned(), String::new(), own, found, &pictures))
        .each(COURSES.iter().zip(by_course), course)
        .child(group(app, words.library_simulations.to_owned(), String::new(), others, found, &pictures))
        .child(group(app, words.library_theories.to_owned(), String::new(), theories, found, &pictures))
        .child(note(words.library_intro));
    View::from((tools, groups))
}

/// The search field.
fn field(app: App, search: &Search) -> HtmlDiv {
    let words = app.words();
    let typed = search.typed;
    let input = input()
        .r#type("search")
        .id(SEARCH)
        .autocomplete("off")
        .attr("spellcheck", "false")
        .attr("enterkeyhint", "search")
        .when(events::input, move |event| typed.set(value_of(&event)));
    div().class("library-field").child(label().r#for(SEARCH).child(words.library_search)).child(input)
}

/// Buttons of the levels. At most one limits the documents shown.
fn chips(app: App, search: &Search) -> HtmlDiv {
    let words = app.words();
    let chosen = search.level;
    let chip = |(level, name): (Option<Level>, String)| {
        button()
            .class("chip")
            .attr("aria-pressed", move || (chosen.get() == level).to_string())
            .when(events::click, move |_| chosen.set(level))
            .child(name)
    };
    let language = app.language.get_untracked();
    let levels = Level::ALL.map(|level| (Some(level), level.words().text(language).into_owned()));
    let all = (None, words.library_all_levels.to_owned());
    div()
        .class("chips")
        .role("group")
        .attr("aria-label", words.library_levels)
        .each([all].into_iter().chain(levels), chip)
}

/// Cards below a title and what is `said` of them; hidden while none is found.
fn group(
    app: App,
    title: String,
    said: String,
    items: Vec<Item>,
    found: ReadSignal<Found>,
    pictures: &Pictures,
) -> HtmlSection {
    let numbers: Vec<usize> = items.iter().map(|item| item.number).collect();
    let is_empty = move || found.with(|found| !numbers.iter().any(|number| is_found(found, *number)));
    section()
        .hidden(is_empty)
        .child(h3().child(title).child(span().class("note").child(said)))
        .child(ul().class("cards").each(items, |item| card(app, item, found, pictures)))
}

fn is_found(found: &Found, number: usize) -> bool {
    found.get(number).copied().unwrap_or(false)
}

fn card(app: App, item: Item, found: ReadSignal<Found>, pictures: &Pictures) -> HtmlLi {
    let Item { number, entry, card, own } = item;
    let (into, out) = ((pictures.clone(), pictures.clone()), (pictures.clone(), pictures.clone()));
    let lang = (card.language != app.language.get_untracked().tag()).then(|| card.language.clone());
    let (title, file, pictures) = (card.title.clone(), entry.file().to_owned(), pictures.clone());
    let face = move |lead: View, below: View| face(app, &pictures, number, (&entry, &card), lead, below);
    let content = match own {
        Some(own) => library_own::card(app, own, link_id(number), face, move |own| {
            leave_for(app, || opening::open_kept(app, own.kept.clone()));
        }),
        None => face(link(app, number, title, file).into(), View::new()),
    };
    li().hidden(move || found.with(|found| !is_found(found, number)))
        .attr("lang", lang)
        .when(events::mouseenter, move |_| into.0.attend(number))
        .when(events::mouseleave, move |_| out.0.leave(number))
        .when(events::focusin, move |_| into.1.attend(number))
        .when(events::focusout, move |_| out.1.leave(number))
        .child(content)
}

/// Content of a card: picture, link (`lead`), summary, and further content below.
fn face(app: App, pictures: &Pictures, number: usize, (entry, card): (&Entry, &Card), lead: View, below: View) -> View {
    let mut place = div().class("library-picture").attr("aria-hidden", "true");
    pictures.add(number, entry.files.clone(), &place.node::<Element>());
    let topics = (!card.topics.is_empty()).then(|| p().class("library-topics").child(card.topics.join(" · ")));
    let level = place_of(entry.file()).map(|(_, _, level)| level_line(level, app));
    View::from((
        place,
        h4().child(lead),
        p().id(summary_id(number)).inner_html(card.summary.clone()),
        topics.map_or_else(View::new, View::from),
        level.map_or_else(View::new, View::from),
        below,
    ))
}

/// Level as dots and a word.
fn level_line(level: Level, app: App) -> HtmlP {
    let reached = Level::ALL.iter().position(|other| *other == level).unwrap_or_default();
    let dots: String = (0..Level::ALL.len()).map(|place| if place <= reached { '●' } else { '○' }).collect();
    let name = level.words().text(app.language.get_untracked()).into_owned();
    p().class("library-level").child(span().attr("aria-hidden", "true").child(dots)).child(name)
}

/// Link to a document of the page.
fn link(app: App, number: usize, title: String, file: String) -> HtmlA {
    let address = browser::address(&Link { subject: Subject::Library(file.clone()), state: String::new() }.write());
    let follow = move |event: MouseEvent| {
        // With a modifier key, the browser opens another tab or window.
        if !(event.ctrl_key() || event.meta_key() || event.shift_key() || event.alt_key()) {
            event.prevent_default();
            leave_for(app, || {
                open(app, &file);
            });
        }
    };
    a().id(link_id(number))
        .class("entry")
        .href(address)
        .attr("aria-describedby", summary_id(number))
        .when(events::click, follow)
        .child(title)
}

/// Closes the library and opens a document.
fn leave_for(app: App, open: impl FnOnce()) {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>("library-list") {
        dialog.close();
    }
    app.library_asked_for.set(false);
    open();
    browser::focus_later("browse".to_owned());
}

fn summary_id(number: usize) -> String {
    format!("about-{number}")
}

fn link_id(number: usize) -> String {
    format!("entry-{number}")
}

/// Moves the focus from the search to the first card.
fn from_search(event: &KeyboardEvent, found: ReadSignal<Found>) {
    let key = event.key();
    if key == "ArrowDown" || (key == "Enter" && browser::focused() == SEARCH) {
        let first = found.with(|found| found.iter().position(|shown| *shown));
        if let Some(first) = first {
            event.prevent_default();
            browser::focus(&link_id(first));
        }
    }
}

/// Arrow keys move the focus between cards by their positions on the screen.
fn among_cards(event: &KeyboardEvent, found: ReadSignal<Found>) {
    let Some(present) = browser::focused().strip_prefix("entry-").and_then(|number| number.parse::<usize>().ok())
    else {
        return;
    };
    if event.ctrl_key() || event.meta_key() || event.shift_key() || event.alt_key() {
        return;
    }
    let shown: Vec<usize> = found.with(|found| (0..found.len()).filter(|number| is_found(found, *number)).collect());
    let next = match event.key().as_str() {
        "ArrowRight" => shown.iter().copied().find(|number| *number > present),
        "ArrowLeft" => shown.iter().copied().rev().find(|number| *number < present),
        "Home" => shown.first().copied(),
        "End" => shown.last().copied(),
        "ArrowDown" => beside(present, &shown, 1.0),
        "ArrowUp" => {
            let above = beside(present, &shown, -1.0);
            if above.is_none() {
                browser::focus(SEARCH);
            }
            above
        }
        _ => return,
    };
    event.prevent_default();
    if let Some(next) = next {
        browser::focus(&link_id(next));
    }
}

/// Nearest card in the next row (`down` = 1) or in the previous one (-1).
fn beside(present: usize, shown: &[usize], down: f64) -> Option<usize> {
    let place = |number: usize| {
        let link: HtmlElement = browser::by_id(&link_id(number))?;
        let bounds = link.get_bounding_client_rect();
        Some((bounds.left(), bounds.top()))
    };
    let (left, top) = place(present)?;
    let candidates = shown.iter().filter_map(|number| {
        let (x, y) = place(*number)?;
        let rows = (y - top) * down;
        (rows > 1.0).then_some((rows, (x - left).abs(), *number))
    });
    let order = |one: &(f64, f64, usize), other: &(f64, f64, usize)| (one.0, one.1).partial_cmp(&(other.0, other.1));
    candidates.min_by(|one, other| order(one, other).unwrap_or(std::cmp::Ordering::Equal)).map(|(_, _, number)| number)
}

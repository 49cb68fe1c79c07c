//! Link of a teacher: the laboratory with chosen tabs, hidden values and fixed controls.

use super::options::Options;
use super::words;
use crate::app::App;
use crate::documents::links;
use play::PagePart;
use view::views::*;

/// Section of the dialog: the options, and the link with them.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let options = Options::new(app, "lesson");
    let plain = create_signal(String::new());
    let remark = create_signal(None::<String>);
    wasm_bindgen_futures::spawn_local(async move {
        let (link, said) = links::present(app).await;
        // The dialog may have been closed meanwhile.
        if plain.is_alive() {
            let local = links::is_local(&link).then(|| app.words().link_local.to_owned());
            remark.set(said.or(local));
            plain.set(link);
        }
    });
    let link = memo(move || options.chosen.with(|chosen| plain.with(|plain| chosen.in_address(plain))));
    let remark = changing(move || remark.get_clone().map_or_else(View::new, |remark| note(remark).into()));
    View::from((
        note(words.lesson_intro),
        div().class("fields").child(reader(app, options)).child(options.language()),
        // Without the header nobody could open a file or change the language.
        options.parts(PagePart::ALL.into_iter().filter(|part| *part != PagePart::Head)),
        options.locked(),
        options.result(link, words.lesson_address, words.lesson_copy),
        remark,
    ))
}

/// Choice of the state of the switch *Everything*.
fn reader(app: App, options: Options) -> HtmlLabel {
    let words = words::of(app);
    let choose = move |event| {
        options.chosen.update(|chosen| {
            chosen.everything = match value_of(&event).as_str() {
                "on" => Some(true),
                "off" => Some(false),
                _ => None,
            };
        });
    };
    let states = [("", words.lesson_as_left), ("off", words.lesson_student), ("on", words.lesson_everything)];
    let select = select()
        .id("lesson-everything")
        .when(events::change, choose)
        .each(states, |(value, name)| option().value(value).child(name));
    label().class("field").child(span().child(words.lesson_tabs)).child(select)
}

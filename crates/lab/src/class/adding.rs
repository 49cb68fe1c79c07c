//! Hand-ins that are chosen or dropped, also as folders.

use super::folder::files_in;
use super::{survey, window, words};
use crate::app::App;
use crate::verifying::reading::read;
use desk::saved::hand_in::{HAND_IN_ENDING, HandInError};
use desk::saved::survey::SHEET_ENDING;
use view::views::*;
use web_sys::{File, FileSystemEntry, HtmlInputElement};

/// True if a file is a hand-in, by the ending of its name.
pub fn is_hand_in(file: &File) -> bool {
    file.name().to_lowercase().ends_with(HAND_IN_ENDING)
}

/// Reads hand-ins into the dashboard, which opens, and computes them.
pub async fn add(app: App, files: Vec<File>) {
    window::open(app);
    for file in files {
        let content = read(&file).await.unwrap_or(Err(HandInError::Damaged));
        app.class.add(&file.name(), content);
        app.class.show_sometimes();
    }
    app.class.show();
    app.class.compute();
}

/// Reads the hand-ins of dropped folders; a message if there are none.
pub async fn add_of_folders(app: App, folders: Vec<FileSystemEntry>) {
    let files = files_in(folders).await;
    choose(app, files).await;
}

/// Adds the hand-ins and the answers to surveys among files; a message if there are none.
async fn choose(app: App, files: Vec<File>) {
    let (sheets, mut files): (Vec<File>, Vec<File>) = files.into_iter().partition(survey::is_sheet);
    let has_sheets = !sheets.is_empty();
    if has_sheets {
        window::open(app);
        survey::add(app, sheets).await;
    }
    files.retain(is_hand_in);
    if !files.is_empty() {
        return add(app, files).await;
    }
    if has_sheets {
        return;
    }
    let why = words::of(app).no_hand_in;
    if !app.class.refuse(why) {
        app.complain(why.to_owned());
    }
}

/// Button that lets the user choose files, or a folder.
pub fn choice(app: App, id: &'static str, label: &'static str, is_folder: bool) -> View {
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        let list = chosen.files();
        let all = list.iter().flat_map(|files| (0..files.length()).filter_map(|index| files.get(index)));
        let files: Vec<File> = all.collect();
        chosen.set_value("");
        wasm_bindgen_futures::spawn_local(choose(app, files));
    };
    let input = input
        .id(format!("{id}-files"))
        .hidden(true)
        .multiple(true)
        .attr("aria-label", label)
        .attr("webkitdirectory", is_folder.then_some(""))
        .when(events::change, read);
    let input = if is_folder { input } else { input.accept([HAND_IN_ENDING, SHEET_ENDING].join(",")) };
    View::from((button().class("quiet").id(id).when(events::click, move |_| node.click()).child(label), input))
}

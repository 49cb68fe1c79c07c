//! Export of the recorded run and the records as a workbook.

use crate::app::App;
use view::browser;
use view::views::*;

/// Button that saves the workbook.
pub fn workbook_button(app: App) -> HtmlButton {
    let save = move |_| {
        let kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
        let workbook = app.read_desk(|desk| desk::workbook(desk));
        browser::save_bytes(&format!("{}.xlsx", app.host().stem()), kind, &workbook);
    };
    button().class("quiet").id("save-xlsx").when(events::click, save).child(app.words().save_xlsx)
}

//! A report of a class as a page and as a workbook. The sections are also those of the dashboard in the laboratory.

mod against;
mod answers;
mod figures;
mod hand_ins;
mod progress;
mod quantities;
mod workbook;

pub use against::against;
pub use answers::{questions, stuck};
pub use figures::{Look, MOST_CURVES, curves, histogram, residuals, results, scale};
pub use hand_ins::{copied_text, hand_ins, state_lines, state_text};
pub use progress::{count_text, progress_text};
pub use quantities::{far_text, pooled, quantity, result_text};
pub use workbook::workbook;

use crate::against::Against;
use crate::collection::Collection;
use crate::verify::meaning;
use figure::Palette;
use report::Page;
use units::{Language, say};

/// Maximum number of quantities whose curves are drawn in a report.
const MOST_GROUPS: usize = 12;

/// A report of all groups as one self-contained HTML page. `asked`: quantities against a parameter. `date` stands at
/// its end; an empty date is left out.
pub fn html(collection: &Collection, asked: &[Against], language: Language, date: &str) -> String {
    let title = language.say("Results of a class");
    let look = Look { width: 700.0, height: 300.0, palette: &Palette::LIGHT, language };
    let mut page = Page::default();
    page.raw("<header>\n");
    page.element("p class=\"kicker\"", language.say("Class"));
    page.element("h1", title);
    page.element("p class=\"meta\"", &count_text(collection, language));
    page.raw("</header>\n");
    curves_section(&mut page, collection, look);
    let quantities = collection.quantities();
    if !quantities.is_empty() {
        page.heading(language.say("Fitted quantities"));
        for one in &quantities {
            page.raw(&quantity(one, collection, usize::MAX, look));
        }
    }
    if !asked.is_empty() {
        page.heading(language.say("Results against a parameter"));
        asked.iter().for_each(|one| page.raw(&against(one, collection, usize::MAX, look)));
    }
    let questions = questions(&collection.questions(), language);
    if !questions.is_empty() {
        page.heading(language.say("Answers"));
        page.raw(&questions);
    }
    page.heading(language.say("Stuck"));
    page.raw(&stuck(collection, &quantities, language));
    page.heading(language.say("Hand-ins"));
    page.raw(&hand_ins(collection, language));
    page.element("p class=\"note\"", &meaning().text(language));
    report::footer(&mut page, language, program::VERSION_AND_BITS, date);
    report::page_of(title, language.tag(), program::VERSION_AND_BITS, &page.out)
}

fn curves_section(page: &mut Page, collection: &Collection, look: Look) {
    let language = look.language;
    let groups = collection.curve_groups();
    if groups.is_empty() {
        return;
    }
    page.heading(language.say("Measured curves"));
    for group in groups.iter().take(MOST_GROUPS) {
        page.raw("<figure>\n");
        page.raw(&curves(collection, group, &group.members, &[], look));
        page.raw(&residuals(collection, group, &group.members, look).unwrap_or_default());
        page.element("figcaption", &curves_caption(collection, group, language));
        page.raw("</figure>\n");
    }
    if groups.len() > MOST_GROUPS {
        let rest = groups.len() - MOST_GROUPS;
        let text = language.say("Further quantities are not drawn: ");
        page.element("p class=\"note\"", &format!("{text}{rest}."));
    }
}

/// Caption of the curves of a quantity: their number, the theory that is drawn, and what is left out.
pub fn curves_caption(collection: &Collection, group: &crate::collection::CurveGroup, language: Language) -> String {
    let count = group.members.len();
    let mut text = say!(language, "{count} measured curves.");
    if let Some((member, fit)) = collection.typical_fit(group) {
        let sender = collection.sender(member.hand_in);
        let theory = &fit.theory;
        text += &say!(
            language,
            " The bold curve is the fit of {theory} by {sender}, whose residuals have the median size. Below, the \
                 residuals of each group's fit."
        );
    }
    if count > MOST_CURVES {
        text += &say!(language, " The first {MOST_CURVES} are drawn.");
    }
    text
}

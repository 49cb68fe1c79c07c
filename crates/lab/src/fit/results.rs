//! Results of fits: comparison, details of one fit, and export.

use super::{Fitting, report};
use crate::app::App;
use crate::documents::opening;
use desk::{ExportKind, FitDetail, FitView, Imprint};
use document::page::Source;
use view::browser;
use view::page::everything;
use view::panel::tabs;
use view::pieces::symbols::name_and_symbol;
use view::views::*;
use wasm_bindgen::JsValue;

/// Id of the list of the fits.
pub const RESULTS: &str = "fit-results";

/// The fits, and the id of the one whose details are shown: the chosen one, otherwise the best if they were ranked, otherwise
/// the last.
pub fn shown(app: App) -> ReadSignal<(Vec<FitView>, Option<u32>)> {
    let Fitting { chosen, ranked, .. } = app.fit;
    memo(move || {
        app.fits.track();
        let fits = app.read_desk(|desk| desk.fits().list());
        let last = fits.iter().map(|fit| fit.id).max();
        let best = fits.first().map(|fit| fit.id).filter(|_| ranked.get());
        let shown = chosen.get().filter(|id| fits.iter().any(|fit| fit.id == *id)).or(best).or(last);
        (fits, shown)
    })
}

/// Comparison of the fits and details of one of them. While fits are running, unchanged content keeps its place.
pub fn view(app: App) -> View {
    let listed = shown(app);
    // The result of a fit never changes.
    let detailed = memo(move || listed.with(|(fits, shown)| (*shown, fits.len() > 1)));
    let any = memo(move || listed.with(|(fits, _)| !fits.is_empty()));
    let rows = move || {
        let (fits, shown) = listed.get_clone();
        // If several theories were fitted, the row of the open one is marked.
        let several = fits.iter().any(|fit| fit.theory != fits[0].theory);
        each(fits, |fit| row(app, fit, (shown, several), app.fit.chosen))
    };
    let detail = move || match detailed.get() {
        (Some(id), several) => detail(app, id, several),
        (None, _) => View::new(),
    };
    let results = move || View::from((changing(detail), table(app, changing(rows))));
    changing(move || if any.get() { results() } else { note(app.words().fit_no_numbers).into() })
}

fn table(app: App, rows: View) -> HtmlDiv {
    let words = app.words();
    let heads = [words.fit_theory_head, words.fit_rmse, "ΔAICc", words.fit_weight];
    let head = tr().each(heads, column_head);
    table_in("table fits", words.fit_results, Some(head), tbody().child(rows)).id(RESULTS)
}

fn row(app: App, fit: FitView, (shown, several): (Option<u32>, bool), chosen: Signal<Option<u32>>) -> HtmlTr {
    let words = app.words();
    let (id, selected) = (fit.id, shown == Some(fit.id));
    let records = fit.records.join(" + ");
    let name = format!("{}, {records}", fit.theory);
    let (points, varied) = fit.counts;
    let parameters = if varied == 1 { words.fit_parameter } else { words.fit_parameters };
    let mut remarks = vec![records, format!("{points} {}, {varied} {parameters}", words.fit_points)];
    if several && fit.applicable {
        remarks.insert(0, words.fit_open_theory.to_owned());
    }
    if !fit.predicted.is_empty() {
        remarks.push(format!("{}: {}", words.fit_predicted, fit.predicted));
    }
    if !fit.tied.is_empty() {
        remarks.push(fit.tied);
    }
    let cells = [fit.rmse, fit.difference, fit.weight];
    // A theory that is not open can be opened with the fitted values.
    let apply = if fit.applicable { words.fit_apply } else { words.fit_open };
    let remove = format!("{}: {name}", words.fit_remove);
    let apply_name = format!("{apply}: {name}");
    let applicable = fit.applicable;
    let choose = move |_| {
        chosen.set(Some(id));
        browser::focus_later(format!("fit-{id}"));
    };
    let use_it = move |_| {
        if !applicable {
            let texts = app.read_desk(|desk| desk.fits().texts(id));
            opening::change_theory(app, texts.into_iter().map(|(name, text)| Source { name, text }).collect());
        }
        app.act_on_desk(|desk| desk.apply_fit(id));
        app.tab.set(tabs::MEASURE);
    };
    let forget = move |_| {
        app.act_on_desk(|desk| desk.change_fits(|fits, data| fits.remove(data.play(), id)));
        browser::focus("fit");
    };
    let pick = button()
        .class("pick")
        .id(format!("fit-{id}"))
        .attr("aria-pressed", selected.to_string())
        .when(events::click, choose)
        .child(fit.theory);
    let apply = button()
        .class("quiet")
        .id(format!("apply-fit-{id}"))
        .attr("aria-label", apply_name)
        .when(events::click, use_it)
        .child(apply);
    let remove = cross(remove).id(format!("remove-fit-{id}")).when(events::click, forget);
    let first = row_head(pick)
        .child(span().class("note").child(remarks.join(" · ")))
        .child(div().class("actions").child(apply).child(remove));
    tr().attr("aria-current", selected.then_some("true")).child(first).each(cells, |cell| td().child(cell))
}

/// Export buttons for a fit and, with `several`, for all fits.
fn exports(app: App, id: u32, several: bool) -> HtmlDiv {
    let words = app.words();
    let kinds = [(ExportKind::Report, words.save_report), (ExportKind::Workbook, "XLSX"), (ExportKind::Csv, "CSV")];
    let save = move |kind: ExportKind, all: bool| {
        let (language, now) = (app.language.get_untracked().tag(), js_sys::Date::new_0());
        let date = String::from(now.to_locale_date_string(language, &JsValue::UNDEFINED));
        let math_font = if kind == ExportKind::Report { math_font() } else { String::new() };
        let imprint = Imprint { date: &date, math_font: &math_font };
        let export = app.read_desk(|desk| {
            if all { desk.fits().export_ranking(id, kind, imprint) } else { desk.fits().export(id, kind, imprint) }
        });
        if let Some(file) = export {
            if kind == ExportKind::Report {
                return report::save(app, id, all, file);
            }
            browser::save_bytes(&file.name, file.kind, &file.bytes);
        }
    };
    let one = |name: String, kind: ExportKind, all: bool| {
        let place = format!("export-{kind:?}-{all}");
        button().class("quiet").id(place).when(events::click, move |_| save(kind, all)).child(name)
    };
    let exports = div().class("intake").each(kinds, |(kind, name)| one(name.to_owned(), kind, false));
    let all = kinds.into_iter().filter(|_| several);
    exports.each(all, |(kind, name)| one(format!("{}: {name}", words.fit_all), kind, true))
}

/// Mathematical font of this page, in base64; empty in a site, whose style sheets are files. It stands in the first style sheet
/// of the body. The address in the style sheet may be quoted or unquoted.
fn math_font() -> String {
    const BEFORE: &str = "font/woff2;base64,";
    let sheet = document().query_selector("body > style").ok().flatten().and_then(|sheet| sheet.text_content());
    let font = sheet.as_deref().and_then(|sheet| sheet.split_once(BEFORE)?.1.split_once(['"', ')']));
    font.map(|(font, _)| font.to_owned()).unwrap_or_default()
}

/// Rows of the estimates, grouped by record if there are several.
fn estimates(app: App, detail: &FitDetail) -> HtmlTbody {
    let words = app.words();
    let several = detail.estimates.iter().any(|one| !one.record.is_empty());
    let mut group = None;
    tbody().each(&detail.estimates, |one| {
        let begins = several && group != Some(&one.record);
        group = Some(&one.record);
        let name = if one.record.is_empty() { words.fit_all_records.to_owned() } else { one.record.clone() };
        let head = tr().class("group").child(th().scope("colgroup").colspan("4").child(name));
        let row = tr()
            .class(one.derived.then_some("derived"))
            .child(row_head(name_and_symbol(&one.label, &one.name)))
            .child(td().class("value").child(one.value.clone()))
            .child(td().class("unit").child(one.unit.clone()))
            .child(td().class("note").child(one.remark.clone()));
        if begins { View::from((head, row)) } else { row.into() }
    })
}

fn detail(app: App, id: u32, several: bool) -> View {
    let words = app.words();
    let Some(detail) = app.read_desk(|desk| desk.fits().detail(id)) else { return View::new() };
    let statistics: Vec<String> = detail.statistics.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let estimates = table_in("estimates", words.fit_varied, None, estimates(app, &detail));
    let statistics = move || {
        details()
            .class("options")
            .child(summary().child(words.fit_statistics))
            .child(ul().class("statistics").each(&statistics, |line| li().child(line.clone())))
            .child(note(words.fit_errors))
            .into()
    };
    div()
        .class("detail")
        .child(h4().child(detail.theory))
        .maybe(detail.doubt.map(|why| p().class("doubt").child(why)))
        .child(estimates)
        .child(div().class("verdicts").each(detail.sentences, |sentence| p().child(sentence)))
        .child(everything::only(app.page, Box::new(statistics)))
        .child(exports(app, id, several))
        .into()
}

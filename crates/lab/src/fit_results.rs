//! What has come of fits: side by side, one of them in detail, and the files that can be saved of them.

use crate::app::App;
use crate::controls::symbol;
use crate::{browser, icons, opening};
use document::page::Source;
use leptos::prelude::*;
use session::{ExportKind, FitDetail, FitView, Imprint};
use wasm_bindgen::JsValue;

/// The fits side by side, and one of them in detail: `chosen`, or the best if they were `ranked`, or the last.
pub fn view(app: App, chosen: RwSignal<Option<u32>>, ranked: RwSignal<bool>) -> impl IntoView {
    let words = app.words();
    move || {
        app.changes.fits.track();
        let fits = app.read(|session| session.fits());
        if fits.is_empty() {
            return ().into_any();
        }
        let several = fits.len() > 1;
        let last = fits.iter().map(|fit| fit.id).max();
        let best = fits.first().map(|fit| fit.id).filter(|_| ranked.get());
        let shown = chosen.get().filter(|id| fits.iter().any(|fit| fit.id == *id)).or(best).or(last);
        let heads =
            [words.fit_theory_head, words.fit_counts, words.fit_rmse, words.fit_predicted, "ΔAICc", words.fit_weight];
        let heads: Vec<AnyView> =
            heads.into_iter().map(|head| view! { <th scope="col">{head}</th> }.into_any()).collect();
        let rows: Vec<AnyView> = fits.into_iter().map(|fit| row(app, fit, shown, chosen)).collect();
        view! {
            <div class="table fits" tabindex="0" role="region" aria-label=words.fit_results>
                <table>
                    <caption class="visually-hidden">{words.fit_results}</caption>
                    <thead><tr>{heads}<th scope="col"><span class="visually-hidden">{words.fit_actions}</span></th></tr></thead>
                    <tbody>{rows}</tbody>
                </table>
            </div>
            {shown.map(|id| detail(app, id, several))}
        }
        .into_any()
    }
}

fn row(app: App, fit: FitView, shown: Option<u32>, chosen: RwSignal<Option<u32>>) -> AnyView {
    let words = app.words();
    let (id, selected) = (fit.id, shown == Some(fit.id));
    let records = fit.records.join(" + ");
    let name = format!("{}, {records}", fit.theory);
    let counts = format!("{} / {}", fit.counts.0, fit.counts.1);
    let cells = [counts, fit.rmse, fit.predicted, fit.difference, fit.weight];
    let cells: Vec<AnyView> = cells.into_iter().map(|cell| view! { <td>{cell}</td> }.into_any()).collect();
    // A theory that is not open can be opened and shown with what was found.
    let apply = if fit.applicable { words.fit_apply } else { words.fit_open };
    let remove = format!("{}: {name}", words.fit_remove);
    let apply_name = format!("{apply}: {name}");
    let applicable = fit.applicable;
    view! {
        <tr aria-current=selected.then_some("true")>
            <th scope="row">
                <button type="button" class="pick" id=format!("fit-{id}") aria-pressed=selected.to_string() on:click=move |_| {
                    chosen.set(Some(id));
                    browser::focus_later(format!("fit-{id}"));
                }>{fit.theory}</button>
                <span class="note">{records}</span>
            </th>
            {cells}
            <td><div class="actions">
                <button type="button" class="quiet" aria-label=apply_name on:click=move |_| {
                    if !applicable {
                        let texts = app.read(|session| session.fit_texts(id));
                        opening::open_sources(app, texts.into_iter().map(|(name, text)| Source { name, text }).collect());
                    }
                    app.act(|session| session.apply_fit(id));
                    app.tab.set(app.measurements_tab.get_untracked());
                }>{apply}</button>
                <button type="button" class="icon small" title=remove.clone() aria-label=remove on:click=move |_| {
                    app.act(|session| session.remove_fit(id));
                    browser::focus("fit");
                }>{icons::cross()}</button>
            </div></td>
        </tr>
    }
    .into_any()
}

/// The files that can be saved of a fit, and of all fits of the same values.
fn exports(app: App, id: u32, several: bool) -> Vec<AnyView> {
    let words = app.words();
    let kinds = [(ExportKind::Report, words.save_report), (ExportKind::Workbook, "XLSX"), (ExportKind::Csv, "CSV")];
    let button = |name: String, kind: ExportKind, all: bool| {
        view! {
            <button type="button" class="quiet" on:click=move |_| {
                let date = String::from(js_sys::Date::new_0().to_locale_date_string(app.language.get_untracked().tag(), &JsValue::UNDEFINED));
                let math_font = if kind == ExportKind::Report { math_font() } else { String::new() };
                let imprint = Imprint { date: &date, math_font: &math_font };
                let export = app.read(|session| if all { session.export_ranking(id, kind, imprint) } else { session.export_fit(id, kind, imprint) });
                if let Some(file) = export {
                    browser::save_bytes(&file.name, file.kind, &file.bytes);
                }
            }>{name}</button>
        }
        .into_any()
    };
    let own = kinds.into_iter().map(|(kind, name)| button(name.to_owned(), kind, false));
    let all = kinds.into_iter().map(|(kind, name)| button(format!("{}: {name}", words.fit_all), kind, true));
    own.chain(all.filter(|_| several)).collect()
}

/// The mathematical font of this page, in base64; empty where its style sheet has none.
fn math_font() -> String {
    const BEFORE: &str = "font/woff2;base64,";
    let sheet = document().query_selector("head style").ok().flatten().and_then(|sheet| sheet.text_content());
    let font = sheet.as_deref().and_then(|sheet| sheet.split_once(BEFORE)?.1.split_once('"'));
    font.map(|(font, _)| font.to_owned()).unwrap_or_default()
}

/// The rows of what was found, under the name of the record where there are several.
fn estimates(app: App, detail: &FitDetail) -> Vec<AnyView> {
    let words = app.words();
    let several = detail.estimates.iter().any(|one| !one.record.is_empty());
    let mut rows = Vec::new();
    let mut group = None;
    for one in &detail.estimates {
        if several && group != Some(&one.record) {
            group = Some(&one.record);
            let name = if one.record.is_empty() { words.fit_all_records.to_owned() } else { one.record.clone() };
            rows.push(view! { <tr class="group"><th scope="colgroup" colspan="4">{name}</th></tr> }.into_any());
        }
        rows.push(
            view! {
                <tr class=one.derived.then_some("derived")>
                    <th scope="row">{one.label.clone()}" "{symbol(&one.name)}</th>
                    <td class="value">{one.value.clone()}</td>
                    <td class="unit">{one.unit.clone()}</td>
                    <td class="note">{one.remark.clone()}</td>
                </tr>
            }
            .into_any(),
        );
    }
    rows
}

fn detail(app: App, id: u32, several: bool) -> AnyView {
    let words = app.words();
    let Some(detail) = app.read(|session| session.fit_detail(id)) else { return ().into_any() };
    let rows = estimates(app, &detail);
    let sentences: Vec<AnyView> =
        detail.sentences.iter().map(|sentence| view! { <p>{sentence.clone()}</p> }.into_any()).collect();
    let statistics: Vec<String> = detail.statistics.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    view! {
        <div class="detail">
            <h4>{detail.theory.clone()}</h4>
            <div class="verdicts">{sentences}</div>
            <div class="estimates" tabindex="0" role="region" aria-label=words.fit_varied>
                <table><caption class="visually-hidden">{words.fit_varied}</caption><tbody>{rows}</tbody></table>
            </div>
            <p class="note">{statistics.join(" · ")}</p>
            <p class="note">{words.fit_errors}</p>
            <div class="intake">{exports(app, id, several)}</div>
        </div>
    }
    .into_any()
}

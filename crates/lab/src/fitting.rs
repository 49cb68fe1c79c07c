//! Fits in the page: what is varied, the work in slices between frames, the results side by side.

use crate::app::App;
use crate::controls::symbol;
use crate::{browser, icons, library};
use leptos::prelude::*;
use session::{ExportKind, FitProgress, FitView, Session};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};

/// A slice of work takes so many milliseconds: half a frame.
const SLICE: f64 = 8.0;

/// The part of the tab that fits; nothing while there is no record.
pub fn view(app: App) -> impl IntoView {
    let progress = RwSignal::new(None::<FitProgress>);
    let chosen = RwSignal::new(None::<u32>);
    move || {
        app.changes.records.track();
        let records: Vec<(u32, String)> =
            app.read(|session| session.records()).into_iter().map(|record| (record.id, record.name)).collect();
        if records.is_empty() {
            return ().into_any();
        }
        card(app, records, progress, chosen)
    }
}

fn card(
    app: App,
    records: Vec<(u32, String)>,
    progress: RwSignal<Option<FitProgress>>,
    chosen: RwSignal<Option<u32>>,
) -> AnyView {
    let words = app.words();
    let refusal = RwSignal::new(None::<String>);
    let last = records.last().map_or(0, |(id, _)| *id);
    let known = |id: &u32| records.iter().any(|(record, _)| record == id);
    let record = app.fit_record.get_untracked().filter(known).unwrap_or(last);
    app.fit_record.set(Some(record));
    let options: Vec<AnyView> = records
        .into_iter()
        .map(|(id, name)| view! { <option value=id.to_string() selected=id == record>{name}</option> }.into_any())
        .collect();
    let begin = move |rank: bool| {
        let record = app.fit_record.get_untracked().unwrap_or_default();
        refusal.set(app.attempt(|session| {
            if !rank {
                return session.begin_fit(record);
            }
            let theories = library::theories();
            let theories = theories.into_iter().filter_map(|entry| Some((entry.file().to_owned(), entry.open()?)));
            session.begin_ranking(record, theories.collect())
        }));
        progress.set(app.read(|session| session.fit_progress()));
        chosen.set(None);
        work(app, progress);
    };
    let choices: Vec<AnyView> = app
        .read(|session| session.fit_choices())
        .into_iter()
        .map(|choice| {
            let index = choice.index;
            let symbol = (!choice.name.is_empty()).then(|| symbol(&choice.name));
            view! {
                <label class="switch">
                    <input type="checkbox" id=format!("vary-{index}") prop:checked=choice.varied
                        on:change=move |event| {
                            let varied = event_target_checked(&event);
                            app.act(|session| session.vary(index, varied));
                        } />
                    <span>{choice.label}</span>{symbol}
                </label>
            }
            .into_any()
        })
        .collect();
    let [from, until] = app.read(|session| session.fit_window());
    let ends = [(words.fit_from, from), (words.fit_until, until)];
    let unit = app.read(|session| session.measurement_units("")[1].clone());
    let ends: Vec<AnyView> = ends
        .into_iter()
        .enumerate()
        .map(|(end, (label, value))| {
            let id = format!("fit-end-{end}");
            view! {
                <span class="quantity">
                    <label for=id.clone()>{label}</label>
                    <input type="text" class="number" id=id autocomplete="off" spellcheck="false" prop:value=value
                        on:change=move |event| {
                            let typed = event_target_value(&event);
                            refusal.set(app.attempt(|session| session.set_fit_window(end, &typed)));
                        } />
                    <span class="unit">{unit.clone()}</span>
                </span>
            }
            .into_any()
        })
        .collect();
    view! {
        <section class="fitting card" aria-labelledby="fitting-title">
            <div class="record-head">
                <h3 id="fitting-title">{words.fit_title}</h3>
                <select id="fit-record" aria-label=words.fit_record on:change=move |event| {
                    app.fit_record.set(event_target_value(&event).parse().ok());
                }>{options}</select>
                <button type="button" class="quiet outlined" id="fit-theory" aria-haspopup="dialog" on:click=move |_| library::choose(app)>{words.fit_theory}</button>
            </div>
            <p class="note">{words.fit_intro}</p>
            <fieldset class="choices"><legend>{words.fit_vary}</legend>{choices}</fieldset>
            <div class="ends" role="group" aria-label=words.fit_part>{ends}</div>
            <div class="intake">
                <button type="button" class="primary" id="fit" aria-disabled=move || progress.with(Option::is_some).to_string() on:click=move |_| begin(false)>{words.fit_begin}</button>
                <button type="button" class="quiet" id="rank" title=words.fit_rank_title aria-disabled=move || progress.with(Option::is_some).to_string() on:click=move |_| begin(true)>{words.fit_rank}</button>
                {move || progress.with(Option::is_some).then(|| running(app, progress))}
            </div>
            <p class="refusal" role="alert">{move || refusal.get()}</p>
            {results(app, chosen)}
        </section>
    }
    .into_any()
}

/// The bar and the way out, while a fit is being made.
fn running(app: App, progress: RwSignal<Option<FitProgress>>) -> AnyView {
    let words = app.words();
    let finished = move || progress.with(|now| now.as_ref().map_or((0, 1), |now| now.finished));
    let told = move || {
        progress.with(|now| {
            let FitProgress { theory, trials, finished, .. } = now.clone()?;
            let place = if finished.1 > 1 { format!("{}/{}: ", finished.0 + 1, finished.1) } else { String::new() };
            Some(format!("{place}{theory}, {trials} {}", words.fit_trials))
        })
    };
    view! {
        <progress aria-label=words.fit_title max=move || finished().1.to_string()
            value=move || { let (done, all) = finished(); (all > 1).then(|| done.to_string()) }></progress>
        <span class="note">{told}</span>
        <button type="button" class="quiet" id="cancel-fit" on:click=move |_| {
            app.act(Session::cancel_fit);
            progress.set(None);
            browser::focus("fit");
        }>{words.fit_cancel}</button>
    }
    .into_any()
}

/// Works on the fit for a slice, then lets the page breathe.
fn work(app: App, progress: RwSignal<Option<FitProgress>>) {
    let step = Closure::once_into_js(move || {
        let end = js_sys::Date::now() + SLICE;
        let more = app.read(|session| {
            let mut more = session.advance_fit();
            while more && js_sys::Date::now() < end {
                more = session.advance_fit();
            }
            more
        });
        progress.set(app.read(|session| session.fit_progress()));
        app.publish(false, false);
        if more {
            work(app, progress);
        } else {
            crate::frame::wake(app);
        }
    });
    let _ = window().set_timeout_with_callback(step.unchecked_ref());
}

/// The fits side by side, and one of them in detail.
fn results(app: App, chosen: RwSignal<Option<u32>>) -> impl IntoView {
    let words = app.words();
    move || {
        app.changes.fits.track();
        let fits = app.read(|session| session.fits());
        if fits.is_empty() {
            return ().into_any();
        }
        let several = fits.len() > 1;
        let last = fits.iter().map(|fit| fit.id).max();
        let best =
            fits.first().map(|fit| fit.id).filter(|_| fits.iter().filter(|fit| !fit.file.is_empty()).count() > 1);
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
    let (id, file, selected) = (fit.id, fit.file.clone(), shown == Some(fit.id));
    let name = format!("{}, {}", fit.theory, fit.record);
    let counts = format!("{} / {}", fit.counts.0, fit.counts.1);
    let cells = [counts, fit.rmse, fit.predicted, fit.difference, fit.weight];
    let cells: Vec<AnyView> = cells.into_iter().map(|cell| view! { <td>{cell}</td> }.into_any()).collect();
    // A theory of the library can be opened and shown with what was found.
    let apply = if fit.applicable { words.fit_apply } else { words.fit_open };
    let can = fit.applicable || !file.is_empty();
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
                <span class="note">{fit.record}</span>
            </th>
            {cells}
            <td><div class="actions">
                {can.then(|| view! {
                    <button type="button" class="quiet" aria-label=apply_name on:click=move |_| {
                        if applicable || library::open(app, &file) {
                            app.act(|session| session.apply_fit(id));
                            app.tab.set(app.measurements_tab.get_untracked());
                        }
                    }>{apply}</button>
                }.into_any())}
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
                let export = app.read(|session| if all { session.export_ranking(id, kind, &date) } else { session.export_fit(id, kind, &date) });
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

fn detail(app: App, id: u32, several: bool) -> AnyView {
    let words = app.words();
    let Some(detail) = app.read(|session| session.fit_detail(id)) else { return ().into_any() };
    let rows: Vec<AnyView> = detail
        .estimates
        .iter()
        .map(|one| {
            view! {
                <tr class=one.derived.then_some("derived")>
                    <th scope="row">{one.label.clone()}" "{symbol(&one.name)}</th>
                    <td class="value">{one.value.clone()}</td>
                    <td class="unit">{one.unit.clone()}</td>
                    <td class="note">{one.remark.clone()}</td>
                </tr>
            }
            .into_any()
        })
        .collect();
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

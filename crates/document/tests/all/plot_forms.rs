//! Plots, controls and values in forms: text and form agree, other bytes are unchanged, and edits can be undone.

use crate::editing::edit::documents;
use crate::editing::form::inverse;
use document::edit::{
    Edit, EditError, NewPlot, Obstacle, add_group, add_plot, apply, exchange_plots, exchange_statements, remove_plot,
    remove_statement, set_hidden, set_label, set_plot,
};
use document::form::{Place, PlotCell, PlotPart, plots, shown};
use document::{open, read};
use model::Severity;
use proptest::prelude::*;

const SPRING: &str = "---\ntitle: A mass\n---\n\n```model\nsize N = 3\nparameter k = 20 [N/m] # soft\nparameter m = 1 [kg]   \"Mass\"\n\
switch on_air = off \"Air\"\nm*x'' = -k*x\nx(0) = 1 [m] \"Place\"\nx'(0) = 0\nE = m*x'^2/2 in [J] \"Energy\"\nF = -k*x\n\
when x < 0 [m] as passage { }\n```\n\n\
```plots\n\"Place\":  x, x' against t # first\n\"Phases\": x' against x, equal axes\n\"Two\":    x against t,\n          F against t\n\
\"Values\": histogram x\n\"At\":     points x' against t at passage\n```\n";

fn set(text: &str, number: usize, kind: PlotCell, value: &str) -> Result<String, EditError> {
    set_plot(&read(text), number, kind, value).map(|edits| apply(text, &edits).unwrap())
}

fn errors(text: &str) -> usize {
    open(text, &[]).diagnostics.iter().filter(|(_, found)| found.severity == Severity::Error).count()
}

fn cells(part: &PlotPart) -> Vec<(PlotCell, &str)> {
    part.cells.iter().map(|(kind, text, _)| (*kind, text.as_str())).collect()
}

#[test]
fn plots_are_read_as_cells() {
    use PlotCell::{Across, Curves, Equal, Kind, Title};
    let all = plots(&read(SPRING));
    let expected: [&[(PlotCell, &str)]; 5] = [
        &[(Title, "Place"), (Kind, ""), (Curves, "x, x'"), (Across, "t"), (Equal, "")],
        &[(Title, "Phases"), (Kind, ""), (Curves, "x'"), (Across, "x"), (Equal, "equal axes")],
        &[(Title, "Two"), (Kind, ""), (Curves, "x against t,\n          F against t"), (Equal, "")],
        &[(Title, "Values"), (Kind, "histogram"), (Curves, "x")],
        &[(Title, "At"), (Kind, "points"), (Curves, "x'"), (Across, "t at passage"), (Equal, "")],
    ];
    assert_eq!(all.iter().map(cells).collect::<Vec<_>>(), expected);
    // Every plot of the gallery has a title and curves.
    for text in documents() {
        assert!(plots(&read(&text)).iter().all(|plot| plot.cells.len() >= 3), "{text}");
    }
}

/// Words of the grammar in titles, labels and names, and cells with errors.
#[test]
fn words_of_the_grammar_may_stand_in_titles_and_labels() {
    use PlotCell::{Across, Curves, Equal, Kind, Title};
    for (line, kind, curves, across) in [
        ("\"From x at t, against all\": x \"against, from\" against t", "", "x \"against, from\"", "t"),
        ("\"A\": at against at every 1 [s]", "", "at", "at every 1 [s]"),
        ("\"A\": points every against every every 1 [s]", "points", "every", "every every 1 [s]"),
        ("\"A\": sum(x[i] for i in 1..N) against t", "", "sum(x[i] for i in 1..N)", "t"),
        ("\"A\": x + against t", "", "x +", "t"),
        ("\"A\": x, against t", "", "x,", "t"),
        ("\"A\": against t", "", "", "t"),
        ("\"A\": x in [m against t", "", "x in [m against t", ""),
        ("\"A\": # note\n x against t", "", "x", "t"),
    ] {
        let text = format!("```plots\n{line}\n```\n");
        let all = plots(&read(&text));
        let title = line.split('"').nth(1).unwrap();
        let expected = [(Title, title), (Kind, kind), (Curves, curves), (Across, across), (Equal, "")];
        assert_eq!(all.iter().map(cells).collect::<Vec<_>>(), [expected], "{line}");
    }
}

#[test]
fn a_cell_of_a_plot_changes_its_place_alone() {
    use PlotCell::{Across, Curves, Equal, Kind, Text, Title};
    for (number, kind, value, old, new) in [
        (0, Title, "Height", "\"Place\":  x,", "\"Height\": x,"),
        (1, Title, "Phase", "\"Phases\": x'", "\"Phase\":  x'"),
        (0, Curves, "x", "x, x' against", "x against"),
        (0, Across, "x", "x' against t #", "x' against x #"),
        (0, Across, "", "x, x' against t #", "x, x' #"),
        (0, Equal, "equal axes", "against t #", "against t, equal axes #"),
        (1, Equal, "", "against x, equal axes", "against x"),
        (0, Kind, "points", "x, x' against t #", "points x, x' against t every 1 [s] #"),
        (0, Kind, "histogram", "x, x' against t #", "histogram x #"),
        (2, Kind, "histogram", "x against t,\n          F against t", "histogram x"),
        (3, Kind, "", "histogram x", "x against t"),
        (4, Kind, "", "points x' against t at passage", "x' against t"),
        (3, Text, "\"V\": x against t", "\"Values\": histogram x", "\"V\": x against t"),
    ] {
        assert_eq!(set(SPRING, number, kind, value).unwrap(), SPRING.replacen(old, new, 1), "{kind:?} {value}");
        if !(kind == Across && value.is_empty()) {
            assert_eq!(errors(&set(SPRING, number, kind, value).unwrap()), 0, "{kind:?} {value}");
        }
    }
    // Emptied and entered again.
    let empty = set(SPRING, 0, Across, "").unwrap();
    assert_eq!(set(&empty, 0, Across, "t").unwrap(), SPRING);
    let empty = set(SPRING, 1, Curves, "").unwrap();
    assert_eq!(set(&empty, 1, Curves, "x'").unwrap(), SPRING);
    let mark = |mark: &str| Obstacle::Mark(mark.to_owned());
    for (number, kind, value, obstacle) in [
        (0, Title, "a\": b", mark("\"")),
        (0, Curves, "x against t, x", mark("against")),
        (0, Curves, "x\n\"B\": x", Obstacle::LineEnd),
        (0, Across, "t, equal axes", mark("equal axes")),
        (0, Across, "t # so", mark("#")),
        (0, Kind, "lines", Obstacle::Other),
        (0, Equal, "x against t", Obstacle::Other),
        (0, Text, "", Obstacle::Empty),
    ] {
        assert_eq!(set(SPRING, number, kind, value), Err(EditError::NotOneCell(obstacle)), "{kind:?} {value}");
    }
    assert_eq!(set(SPRING, 0, Text, "```\n```plots"), Err(EditError::ChangesOthers));
    assert_eq!(set(SPRING, 3, Across, "t"), Err(EditError::UnknownCell));
    assert_eq!(set(SPRING, 9, Title, "t"), Err(EditError::UnknownCell));
}

#[test]
fn plots_are_added_moved_and_removed() {
    let new = |title: &str, curves: &str, across: &str| NewPlot {
        title: title.to_owned(),
        curves: curves.to_owned(),
        across: across.to_owned(),
    };
    let added = apply(SPRING, &[add_plot(&read(SPRING), &new("Energy", "E", "t")).unwrap()]).unwrap();
    assert_eq!(added, SPRING.replace("at passage\n", "at passage\n\"Energy\": E against t\n"));
    assert_eq!(apply(&added, &[remove_plot(&read(&added), 5).unwrap()]).unwrap(), SPRING);
    let moved = apply(SPRING, &exchange_plots(&read(SPRING), 1, 2).unwrap()).unwrap();
    assert!(moved.contains(
        "# first\n\"Two\":    x against t,\n          F against t\n\"Phases\": x' against x, equal axes\n\"Values\""
    ));
    assert_eq!(apply(&moved, &exchange_plots(&read(&moved), 1, 2).unwrap()).unwrap(), SPRING);
    let mark = |mark: &str| Obstacle::Mark(mark.to_owned());
    for (refused, obstacle) in [
        (new("a\"b", "E", "t"), mark("\"")),
        (new("", "E", "t"), Obstacle::Empty),
        (new("A", "", "t"), Obstacle::Empty),
        (new("A", "E", ""), Obstacle::Empty),
        (new("A", "E", "t, equal axes"), mark("equal axes")),
    ] {
        assert_eq!(add_plot(&read(SPRING), &refused), Err(EditError::NotOneCell(obstacle)), "{refused:?}");
    }
    let plain = "---\ntitle: A\n---\nWords.\n\n```model\ny' = 1 [m/s]\ny(0) = 0\n```\n";
    let first = apply(plain, &[add_plot(&read(plain), &new("Way", "y", "t")).unwrap()]).unwrap();
    assert_eq!(first, format!("{plain}\n```plots\n\"Way\": y against t\n```\n"));
    let removed = apply(&first, &[remove_plot(&read(&first), 0).unwrap()]).unwrap();
    assert_eq!(removed, format!("{plain}\n"));
}

#[test]
fn controls_and_values_have_an_order_a_label_and_can_be_hidden() {
    use Place::{Computed, Parameter, Size, Unknown};
    let outline = read(SPRING);
    let all = shown(&outline);
    let seen: Vec<_> = all.iter().map(|one| (one.place, one.name.as_str(), one.label.as_str())).collect();
    let expected = [
        (Size, "N", ""),
        (Parameter, "k", ""),
        (Parameter, "m", "Mass"),
        (Parameter, "on_air", "Air"),
        (Unknown, "x", "Place"),
        (Unknown, "x'", ""),
        (Computed, "E", "Energy"),
        (Computed, "F", ""),
    ];
    assert_eq!(seen, expected);
    let number = |name: &str| all.iter().find(|one| one.name == name).unwrap().number;
    let moved = apply(SPRING, &exchange_statements(&outline, number("k"), number("m")).unwrap()).unwrap();
    let swapped = "parameter m = 1 [kg]   \"Mass\"\nparameter k = 20 [N/m] # soft\n";
    assert_eq!(moved, SPRING.replace("parameter k = 20 [N/m] # soft\nparameter m = 1 [kg]   \"Mass\"\n", swapped));
    let hide = |text: &str, number, hidden| apply(text, &set_hidden(&read(text), number, hidden).unwrap()).unwrap();
    let hidden = hide(SPRING, number("E"), true);
    assert_eq!(hidden, SPRING.replace("\nE =", "\nhidden E ="));
    assert_eq!(hide(&hidden, number("E"), false), SPRING);
    let hidden = hide(SPRING, number("x"), true);
    assert_eq!(
        document::form::read(&read(&hidden)).parts[number("x")].cell(document::form::CellKind::Name).unwrap().text,
        "x(0)"
    );
    let label =
        |name: &str, text: &str| set_label(&outline, number(name), text).map(|edits| apply(SPRING, &edits).unwrap());
    assert_eq!(label("F", "Force").unwrap(), SPRING.replace("F = -k*x\n", "F = -k*x \"Force\"\n"));
    assert_eq!(label("k", "Stiffness").unwrap(), SPRING.replace("[N/m] #", "[N/m] \"Stiffness\" #"));
    assert_eq!(label("E", "").unwrap(), SPRING.replace("[J] \"Energy\"", "[J]"));
    assert_eq!(label("m", "Weight").unwrap(), SPRING.replace("Mass", "Weight"));
    assert_eq!(label("F", "a\"b"), Err(EditError::NotOneCell(Obstacle::Mark("\"".to_owned()))));
    assert_eq!(set_hidden(&outline, number("k"), true), Err(EditError::UnknownCell));
}

#[test]
fn groups_of_controls_are_begun_named_moved_and_removed() {
    let names = |text: &str| -> Vec<String> {
        let controls = shown(&read(text)).into_iter().filter(|one| one.place == Place::Parameter);
        controls.map(|one| if one.is_group { format!("[{}]", one.label) } else { one.name }).collect()
    };
    let begin = |text: &str, name: &str| add_group(&read(text), name).map(|edits| apply(text, &edits).unwrap());
    let first = begin(SPRING, "Spring").unwrap();
    assert_eq!(first, SPRING.replace("parameter k", "group \"Spring\"\nparameter k"));
    let second = begin(&first, " Air ").unwrap();
    assert_eq!(names(&second), ["[Spring]", "k", "m", "[Air]", "on_air"]);
    let groups: Vec<Option<String>> =
        open(&second, &[]).document.unwrap().program.model.parameters.iter().map(|one| one.group.clone()).collect();
    assert_eq!(groups, ["Spring", "Spring", "Air"].map(|name| Some(name.to_owned())));
    let of = |number: usize| shown(&read(&second)).iter().filter(|one| one.is_group).nth(number).unwrap().number;
    let (spring, air) = (of(0), of(1));
    let moved = apply(&second, &exchange_statements(&read(&second), air, air - 1).unwrap()).unwrap();
    assert_eq!(names(&moved), ["[Spring]", "k", "[Air]", "m", "on_air"]);
    let named = apply(&second, &set_label(&read(&second), air, "Atmosphere").unwrap()).unwrap();
    assert_eq!(named, second.replace("\"Air\"\nswitch", "\"Atmosphere\"\nswitch"));
    assert_eq!(set_label(&read(&second), air, " "), Err(EditError::NotOneCell(Obstacle::Empty)));
    let removed = apply(&second, &[remove_statement(&read(&second), spring).unwrap()]).unwrap();
    assert_eq!(names(&removed), ["k", "m", "[Air]", "on_air"]);
    assert_eq!(begin(SPRING, "a\"b"), Err(EditError::NotOneCell(Obstacle::Mark("\"".to_owned()))));
    assert_eq!(begin("```model\nx' = 1 [1/s]\nx(0) = 0\n```\n", "A"), Err(EditError::UnknownCell));
}

#[derive(Clone, Debug)]
enum Asked {
    Set(usize, usize, String),
    Add(String),
    Remove(usize),
    Move(usize),
    MoveStatement(usize),
    Hide(usize),
    Label(usize, String),
    Group(String),
}

fn asked() -> impl Strategy<Value = Asked> {
    let text = || {
        prop_oneof![
            "[a-z]'?(, [a-z])?",
            "(points|histogram|equal axes|)",
            "[a-z]{1,3} (against|every|at|in) [a-z]",
            "[A-Za-zé ]{0,9}",
            "[^\\t]{0,8}",
            "(```|#|\"|:|,|\\(|against|\n)",
        ]
    };
    prop_oneof![
        6 => (any::<usize>(), any::<usize>(), text()).prop_map(|(plot, cell, text)| Asked::Set(plot, cell, text)),
        1 => text().prop_map(Asked::Add),
        1 => any::<usize>().prop_map(Asked::Remove),
        2 => any::<usize>().prop_map(Asked::Move),
        2 => any::<usize>().prop_map(Asked::MoveStatement),
        1 => any::<usize>().prop_map(Asked::Hide),
        1 => (any::<usize>(), text()).prop_map(|(one, text)| Asked::Label(one, text)),
        1 => text().prop_map(Asked::Group),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    /// Arbitrary sequences of edits of the plots, controls and values of the gallery.
    #[test]
    fn text_and_plots_agree(which in any::<prop::sample::Index>(), wishes in prop::collection::vec(asked(), 1..12)) {
        let all = documents();
        let original = all[which.index(all.len())].clone();
        let mut text = original.clone();
        let mut undo: Vec<Vec<Edit>> = Vec::new();
        for wish in wishes {
            let outline = read(&text);
            let before = plots(&outline);
            let values = shown(&outline);
            let edits = match &wish {
                Asked::Set(plot, cell, value) if !before.is_empty() => {
                    let number = plot % before.len();
                    let kinds: Vec<PlotCell> = before[number].cells.iter().map(|(kind, ..)| *kind).collect();
                    let kind = if kinds.is_empty() { PlotCell::Text } else { kinds[cell % kinds.len()] };
                    let edits = set_plot(&outline, number, kind, value);
                    if let Ok(edits) = &edits {
                        let after_text = apply(&text, edits).unwrap();
                        let after = plots(&read(&after_text));
                        prop_assert_eq!(after.len(), before.len());
                        prop_assert_eq!(after[number].cell(kind).unwrap().0, value.trim());
                        for (other, part) in after.iter().enumerate().filter(|(other, _)| *other != number) {
                            prop_assert_eq!(&part.whole, &before[other].whole);
                        }
                    }
                    edits
                }
                Asked::Add(text) => {
                    let plot = NewPlot { title: "New".to_owned(), curves: text.clone(), across: "t".to_owned() };
                    add_plot(&outline, &plot).map(|edit| vec![edit])
                }
                Asked::Remove(plot) if !before.is_empty() => remove_plot(&outline, plot % before.len()).map(|edit| vec![edit]),
                Asked::Move(plot) if before.len() > 1 => {
                    let number = plot % (before.len() - 1);
                    exchange_plots(&outline, number, number + 1)
                }
                Asked::MoveStatement(one) if values.len() > 1 => {
                    let number = one % (values.len() - 1);
                    exchange_statements(&outline, values[number].number, values[number + 1].number)
                }
                Asked::Hide(one) if !values.is_empty() => {
                    let value = &values[one % values.len()];
                    set_hidden(&outline, value.number, !value.is_hidden)
                }
                Asked::Label(one, label) if !values.is_empty() => {
                    let value = &values[one % values.len()];
                    let edits = set_label(&outline, value.number, label);
                    if let Ok(edits) = &edits {
                        let after = apply(&text, edits).unwrap();
                        let named = shown(&read(&after));
                        let own = named.iter().find(|one| one.number == value.number).unwrap();
                        prop_assert_eq!(&own.label, label.trim());
                    }
                    edits
                }
                Asked::Group(name) => add_group(&outline, name),
                _ => Ok(Vec::new()),
            };
            let Ok(edits) = edits else { continue };
            let back = inverse(&text, &edits);
            text = apply(&text, &edits).unwrap();
            undo.push(back);
        }
        while let Some(edits) = undo.pop() {
            text = apply(&text, &edits).unwrap();
        }
        prop_assert_eq!(text, original);
    }
}

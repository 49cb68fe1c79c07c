//! A renamed document computes bit-identical results, or the new name is refused.

use super::edit::documents;
use document::edit::{EditError, apply, rename, rename_with};
use document::{Opened, open, read};
use engine::{Run, Setup};
use model::Severity;
use std::collections::BTreeSet;
use units::split_mix::SplitMix64;

/// Names used for all kinds of quantities and all local names of [`text`].
const NAMES: [&str; 14] = ["a", "b", "c", "d", "g", "i", "j", "k", "q", "u", "at", "from", "x", "y"];

/// A document with every construct that declares a local name. `global`: names of quantities; `local`: names of arguments,
/// indices and `let`.
fn text(global: [&str; 5], local: [&str; 5]) -> String {
    let [p, w, f, y, n] = global;
    let [argument, second, index, summed, kept] = local;
    format!(
        "---\nuntil: 2\nstep: 0.25\n---\n{{{p}}} and {{{w}}}\n\n```model\nindependent T\nparameter {p} = 2 in 0..9\nsize {n} = 2 in 1..4\n\
         function {f}({argument}, {second}) = {p}*{argument} + {second}\n{w} = {p} + sum({p}*{summed} for {summed} in 1..3) + {f}({p}, 3)\n\
         {y}[{index}]' = {p}*{index} - {w}/7 for {index} in 1..{n}\n{y}[{index}](0) = {p} + {index} for {index} in 1..{n}\n\
         when T > 1 {{ let {kept} = {p}/4, {y}[1] = {kept} + {w} }}\n```\n\n```plots\n\"A\": {w}, {y}[1] against T\n\"B\": {p} + {w} at 1 against {p} in 1..3\n```\n\n\
         ```presets\n\"C\": {p} = 3\n```\n\n```check\n\"D\": {w} > {p}/2 always\n```\n"
    )
}

/// Bits of the states of a run, and the default values; `None` if the document does not run.
fn bits(opened: &Opened) -> Option<Vec<u64>> {
    let program = &opened.document.as_ref()?.program;
    let mut run = Run::start(&program.model, Setup::of(program)).ok()?;
    let mut bits = Vec::new();
    for _ in 0..12 {
        run.advance_within(1_000_000).ok()?;
        bits.extend(run.state().iter().chain(run.parameters()).map(|value| value.to_bits()));
    }
    Some(bits)
}

fn errors(opened: &Opened) -> usize {
    opened.diagnostics.iter().filter(|(_, found)| found.severity == Severity::Error).count()
}

#[test]
fn a_new_name_changes_no_bits() {
    let mut random = SplitMix64::new(5);
    let mut pick = |most: usize| (random.bits() % most as u64) as usize;
    let (mut sound, mut renamed, mut refused) = (0, 0, 0);
    for _ in 0..60 {
        let mut names = NAMES.to_vec();
        let global = [(); 5].map(|()| names.remove(pick(names.len())));
        let local = [(); 5].map(|()| NAMES[pick(NAMES.len())]);
        let before = text(global, local);
        let opened = open(&before, &[]);
        let Some(expected) = bits(&opened) else { continue };
        sound += 1;
        for old in global {
            let place = before.find(&format!(" {old} ")).map_or_else(|| before.find(old), |at| Some(at + 1)).unwrap();
            let Ok(edits) = rename(&read(&before), place, names[pick(names.len())]) else {
                refused += 1;
                continue;
            };
            renamed += 1;
            let after = apply(&before, &edits).unwrap();
            let opened_again = open(&after, &[]);
            assert!(errors(&opened_again) <= errors(&opened), "{before}");
            assert_eq!(bits(&opened_again), Some(expected.clone()), "{before}");
        }
    }
    assert!(sound > 15 && renamed > 30 && refused > 10, "{sound} {renamed} {refused}");
}

/// Renames the first occurrence of `written` in a document with this model.
fn renamed(model: &str, written: &str, new: &str) -> Result<String, EditError> {
    let text = format!("```model\nindependent T\nx' = -x\nx(0) = 1\n{model}\n```\n");
    let place = text.find(written).unwrap() + written.len();
    rename(&read(&text), place, new).map(|edits| apply(&text, &edits).unwrap())
}

#[test]
fn a_local_name_is_not_captured() {
    for (model, written, new) in [
        ("parameter k = 2\nfunction f(a) = k*a\ny = f(3)", "parameter k", "a"),
        ("parameter k = 2\nfunction f(a) = k*x\ny = f(3)", "parameter k", "a"),
        ("parameter k = 2\ny = sum(k*i for i in 1..3)", "parameter k", "i"),
        ("parameter k = 2\ny[i] = k*i for i in 1..3", "parameter k", "i"),
        ("size N = 1\ny[i] = N*i for i in 1..N", "size N", "i"),
        ("parameter k = 2\nwhen T > 1 { let u = 3, x = u*k }", "parameter k", "u"),
        ("parameter k = 2\nfunction f(a) = 2*a\nfunction g(a) = f(a) + k\ny = g(3)", "parameter k", "a"),
        // Also in a model with errors.
        ("parameter k = 2\nfunction f(a) = k*a\ny = f(3) + unknown", "parameter k", "a"),
    ] {
        let refused =
            EditError::Captured { old: written.split(' ').next_back().unwrap().to_owned(), new: new.to_owned() };
        assert_eq!(renamed(model, written, new), Err(refused), "{model}");
    }
    // The braces of a formula contain no expressions.
    let text = "$$\\sqrt{k}$$ and $\\frac{k}{2}$ of {k}.\n\n```model\nparameter k = 2\n```\n";
    let edits = rename(&read(text), text.find("= 2").unwrap() - 1, "a").unwrap();
    assert_eq!(apply(text, &edits).unwrap(), text.replace("{k}.", "{a}.").replace("parameter k", "parameter a"));
    // Here the local name hides no quantity.
    let good = renamed("parameter k = 2\nfunction f(a) = 2*a\ny = f(k)", "parameter k", "a").unwrap();
    assert!(good.contains("parameter a = 2\nfunction f(a) = 2*a\ny = f(a)"), "{good}");
    // A local name equal to that of the quantity is renamed as well.
    let good = renamed("parameter k = 2\nfunction f(k) = 2*k\ny = f(k)", "parameter k", "a").unwrap();
    assert!(good.contains("parameter a = 2\nfunction f(a) = 2*a\ny = f(a)"), "{good}");
    let drawn = "random seed = 1 in 1..9\ndiscrete n = 0\nwhen T > 1 { n = uniform(0, 1) }";
    assert_eq!(renamed(drawn, "discrete n", "m"), Err(EditError::ComputesOthers("m".to_owned())));
}

/// Both spellings of a name are the same name.
#[test]
fn a_name_in_greek_letters_is_renamed() {
    for written in ["parameter ω₀", "y = omega_0"] {
        let good = renamed("parameter ω₀ = 2\ny = omega_0 + ω_0", written, "w").unwrap();
        assert!(good.contains("parameter w = 2\ny = w + w"), "{good}");
    }
}

/// Renaming the quantities of real documents.
#[test]
fn real_documents_are_renamed() {
    let mut refused = BTreeSet::new();
    let mut count = 0;
    for (number, text) in
        documents().iter().enumerate().filter(|(_, text)| text.len() < 8_000 || text.contains("\\rho"))
    {
        let outline = read(text);
        let places: Vec<usize> = text.match_indices("\nparameter ").map(|(at, word)| at + word.len() + 1).collect();
        let Some(&place) = places.get(number % places.len().max(1)) else { continue };
        count += 1;
        if let Err(error) = rename_with(&outline, place, "fresh_name", &[]) {
            refused.insert(format!("{}: {error}", text.lines().nth(1).unwrap_or_default()));
        }
    }
    assert!(count > 10 && refused.is_empty(), "{count} {refused:#?}");
}

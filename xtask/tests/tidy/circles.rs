//! Check for circular dependencies between the files of a crate. Without circles a file can be understood from itself
//! and the files below it.

use crate::texts::root;
use crate::uses::{Uses, uses};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;

/// Heading in ARCHITECTURE.md of the list of permitted arrows that close a circle. Each entry begins with the two
/// files, as in "- `crates/a/src/b.rs` uses `crates/a/src/c.rs`:", followed by the reason.
const HEADING: &str = "### Files that use each other";

/// Arrow from a file to a file that it uses.
type Arrow = (String, String);

/// Arrows permitted in ARCHITECTURE.md.
fn excepted(text: &str) -> BTreeSet<Arrow> {
    let list = text.split_once(HEADING).map_or("", |(_, after)| after);
    let list = list.split("\n#").next().unwrap_or_default();
    let arrow = |entry: &str| {
        let (from, rest) = entry.trim_start().strip_prefix('`')?.split_once("` uses `")?;
        let (to, reason) = rest.split_once("`:")?;
        (!reason.trim().is_empty()).then(|| (from.to_owned(), to.to_owned()))
    };
    list.split("\n- ")
        .skip(1)
        .map(|entry| arrow(entry).unwrap_or_else(|| panic!("not \"`file` uses `file`: reason\": {entry}")))
        .collect()
}

/// Files in a circle with `from`: each uses the other, directly or through further files.
fn circle_of(from: &str, uses: &Uses) -> BTreeSet<String> {
    let reached_from = |start: &str| {
        let mut reached = BTreeSet::new();
        let mut open = vec![start.to_owned()];
        while let Some(file) = open.pop() {
            let next = uses.keys().filter(|(user, _)| *user == file).map(|(_, used)| used);
            open.extend(next.filter(|&used| reached.insert(used.clone())).cloned().collect::<Vec<_>>());
        }
        reached
    };
    reached_from(from).into_iter().filter(|file| reached_from(file).contains(from)).collect()
}

/// All circles, each as the set of its files.
fn circles(uses: &Uses) -> BTreeSet<BTreeSet<String>> {
    uses.keys().map(|(file, _)| circle_of(file, uses)).filter(|circle| circle.len() > 1).collect()
}

/// Error message about a circle, with the names that its files use of each other.
fn message(circle: &BTreeSet<String>, uses: &Uses) -> String {
    let mut text = format!("{} files use each other in a circle:\n", circle.len());
    for ((from, to), names) in uses.iter().filter(|((from, to), _)| circle.contains(from) && circle.contains(to)) {
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        let _ = writeln!(text, "  {from} uses {} of {to}", names.join(", "));
    }
    text
}

#[test]
fn no_circles_between_files() {
    let root = root();
    let read = |path: &str| fs::read_to_string(root.join(path)).ok();
    let crates =
        fs::read_dir(root.join("crates")).expect("a directory").map(|entry| entry.expect("an entry").file_name());
    let mut all = Uses::new();
    for directory in crates.map(|name| format!("crates/{}", name.to_string_lossy())).chain(["xtask".to_owned()]) {
        let files = ["lib", "main"].map(|name| format!("{directory}/src/{name}.rs"));
        for file in files.iter().filter(|file| root.join(file).exists()) {
            all.append(&mut uses(file, &read));
        }
    }

    let excepted = excepted(&read("ARCHITECTURE.md").expect("a text"));
    for (from, to) in &excepted {
        let needed = all.contains_key(&(from.clone(), to.clone())) && circle_of(from, &all).contains(to);
        assert!(needed, "ARCHITECTURE.md excepts a circle that no longer exists: remove \"`{from}` uses `{to}`\"");
    }
    all.retain(|arrow, _| !excepted.contains(arrow));
    let found: String = circles(&all).iter().map(|circle| message(circle, &all)).collect();
    assert!(
        found.is_empty(),
        "{found}Move what these files share to the lowest of them or to a file of its own. If a circle is honest, write one of \
         its arrows with the reason under \"{HEADING}\" in ARCHITECTURE.md."
    );
}

/// Uses in a sample crate whose file `src/folder/c.rs` has the text `c`.
fn small(c: &'static str) -> Uses {
    let read = move |path: &str| {
        let text = match path {
            "src/lib.rs" => "mod a; mod folder; pub use a::A; pub use folder::C; fn sum() -> usize { a::one() }",
            "src/a.rs" => "use crate::folder; pub struct A; pub fn one() -> usize { folder::two() }",
            "src/folder/mod.rs" => "mod b; mod c; pub use b::*; pub use c::{C, three};",
            "src/folder/b.rs" => "pub fn two() -> usize { super::three() }",
            "src/folder/c.rs" => c,
            _ => return None,
        };
        Some(text.to_owned())
    };
    uses("src/lib.rs", &read)
}

/// Cases: text of the file `c`, and the files of the circle that it closes.
#[test]
fn uses_are_found_in_imports_paths_and_macros() {
    let through_a = "src/a.rs src/folder/b.rs src/folder/c.rs";
    let through_b = "src/folder/b.rs src/folder/c.rs";
    for (text, circle) in [
        ("pub struct C; pub fn three() -> usize { 3 }", ""),
        ("pub struct C; pub fn three() -> usize { crate::a::one() }", through_a),
        ("use crate::A; pub struct C(A);", through_a),
        ("pub struct C; pub fn three() -> Vec<crate::A> { vec![] }", through_a),
        ("pub struct C; pub fn three() { println!(\"{:?}\", vec![crate::A]) }", through_a),
        ("pub struct C; pub fn three() -> usize { use super::two; two() }", through_b),
        ("use super::b as other; pub struct C; pub fn three() -> usize { other::two() }", through_b),
        // A re-export, a visibility and a unit test are not uses.
        ("pub use crate::A; pub struct C; pub(in crate::folder) fn three() {}", ""),
        ("pub struct C; #[cfg(test)] mod tests { use crate::A; } #[cfg(test)] fn test(_: crate::A) {}", ""),
    ] {
        let found = circles(&small(text));
        let files: Vec<String> = found.into_iter().flatten().collect();
        assert_eq!(files.join(" "), circle, "{text}");
    }
}

#[test]
fn a_circle_is_reported_with_its_names() {
    let uses = small("use crate::A; pub struct C(A); pub fn three() -> usize { crate::a::one() }");
    let found: String = circles(&uses).iter().map(|circle| message(circle, &uses)).collect();
    assert_eq!(
        found,
        "3 files use each other in a circle:\n  \
         src/a.rs uses `two` of src/folder/b.rs\n  \
         src/folder/b.rs uses `three` of src/folder/c.rs\n  \
         src/folder/c.rs uses `A`, `one` of src/a.rs\n"
    );
}

#[test]
fn exceptions_are_read_with_their_reasons() {
    let text = format!(
        "# Title\n\n- other\n\n{HEADING}\n\nText.\n\n- `a.rs` uses `b.rs`: a\n  reason.\n- `c.rs` uses `d.rs`: too.\n\n## Next\n\n- x\n"
    );
    let arrow = |from: &str, to: &str| (from.to_owned(), to.to_owned());
    assert_eq!(excepted(&text), BTreeSet::from([arrow("a.rs", "b.rs"), arrow("c.rs", "d.rs")]));
}

//! Formatting: keeps the meaning and all comments, and is idempotent.

use crate::arbitrary::document_text;
use document::{BlockKind, Formatted, format, read};
use program::bundle;
use proptest::prelude::*;
use std::path::{Path, PathBuf};

/// All documents of Meniscus, including translations.
fn texts() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = ["../simulations", "../simulations/theories", "document/templates/en", "document/templates/es"];
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(root.join(folder)).unwrap());
    let files = files.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|end| end == "md"));
    files.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

fn formatted(text: &str) -> String {
    let Formatted { edits, .. } = format(&read(text));
    document::edit::apply(text, &edits).unwrap()
}

/// Program of a document; `None` for a translation.
fn compiled(text: &str) -> Option<Vec<u8>> {
    document::open(text, &[]).document.map(|document| bundle::write(&document.program).unwrap())
}

/// All comments of models, in text order.
fn comments(text: &str) -> Vec<String> {
    let outline = read(text);
    let models = outline.blocks().iter().filter(|block| block.kind == BlockKind::Model);
    let lines = models.flat_map(|block| text[block.content.range()].lines());
    lines.filter_map(|line| Some(line.split_once('#')?.1.trim().to_owned())).collect()
}

#[test]
fn documents_mean_the_same_in_their_layout() {
    for (path, text) in texts() {
        let once = formatted(&text);
        assert_eq!(once, text, "{}: what comes with Meniscus is in the layout", path.display());
        assert_eq!(formatted(&once), once, "{}: a second time", path.display());
        assert!(compiled(&once) == compiled(&text), "{}: the program", path.display());
        assert_eq!(comments(&once), comments(&text), "{}: comments", path.display());
        assert_eq!(format(&read(&text)).left, [], "{}: left as it is", path.display());
    }
}

/// Different numbers of blanks, as authors write them: none where they are optional, or several.
#[test]
fn careless_blanks_mean_the_same() {
    const TIGHT: &[(&str, &str)] = &[(" = ", "="), (" + ", "+"), (", ", ",")];
    const WIDE: &[(&str, &str)] = &[(" + ", "  +   "), ("*", " * "), (" = ", "=  "), ("(", "( ")];
    for (path, text) in texts() {
        let expected = compiled(&text);
        for replacements in [TIGHT, WIDE] {
            let mut careless = text.clone();
            for block in read(&text).blocks().iter().rev().filter(|block| block.kind == BlockKind::Model) {
                // Labels and comments are texts.
                let content = text[block.content.range()].lines().map(|line| {
                    let (code, rest) = line.split_at(line.find(['"', '#']).unwrap_or(line.len()));
                    let code = replacements.iter().fold(code.to_owned(), |code, (from, to)| code.replace(from, to));
                    format!("{code}{rest}\n")
                });
                careless.replace_range(block.content.range(), &content.collect::<String>());
            }
            let once = formatted(&careless);
            assert_eq!(formatted(&once), once, "{}: a second time, {replacements:?}", path.display());
            assert!(compiled(&once) == expected, "{}: the program, {replacements:?}", path.display());
        }
    }
}

#[test]
fn a_layout_is_settled() {
    let text = "---\ntitle :A spring  \n\nstep:0.1 [s]\n---\n\nA mass.  \nIt swings. \n\n~~~  model \n\n\n\
                parameter k=4[N/m]in 1 .. 9 \"Stiffness\"\nparameter mass = 100 [ g ] # light\n\n\n\
                  mass*x''=-k * x+0*k\nx(0)=1 [cm]\nx'( 0 )=0\nwhen x>2 [m]{\nx'=- x',stop\n}\n~~~\n\n\
                ```plots\n\"Swing\":x,x+1 [m]  against t\n```";
    let expected = "---\ntitle: A spring\nstep: 0.1 [s]\n---\n\nA mass.  \nIt swings.\n\n```model\n\
                parameter k    = 4   [N/m] in 1..9  \"Stiffness\"\nparameter mass = 100 [g] # light\n\n\
                mass*x'' = -k*x + 0*k\nx(0)  = 1 [cm]\nx'(0) = 0\nwhen x > 2 [m] {\n    x' = -x', stop\n}\n```\n\n\
                ```plots\n\"Swing\": x, x + 1 [m] against t\n```\n";
    assert_eq!(formatted(text), expected);
}

/// Columns depend on the tokens and not on the blanks between them.
#[test]
fn columns_of_neighbouring_lines() {
    let cases = [
        // Names, units, ranges, steps and labels of parameters; definitions are a group of their own.
        (
            "parameter k=4[N/m]in 1..10 step 2\"Stiffness\"\nparameter mu_0=0.25 in 0..1\"Friction\"\nT=k*x^2/2 in[J]\"Energy\"\n",
            "parameter k    = 4 [N/m] in 1..10 step 2  \"Stiffness\"\nparameter mu_0 = 0.25    in 0..1          \"Friction\"\n\
             T = k*x^2/2 in [J]  \"Energy\"\n",
        ),
        // A blank line ends a group; a comment and continuation lines of a statement do not.
        (
            "a = 1\n# between\nbcd = (2 +\n    3)\ne = 4\n\nfgh = 5\ni = 6\n",
            "a   = 1\n# between\nbcd = (2 +\n    3)\ne   = 4\n\nfgh = 5\ni   = 6\n",
        ),
        // An equation of motion is not aligned, nor the `in` of a family.
        (
            "m*x'' = -k*x\nx[i](0) = 1 for i in 1..3\ny(0) = 0 in [cm]\n",
            "m*x'' = -k*x\nx[i](0) = 1 for i in 1..3\ny(0)    = 0 in [cm]\n",
        ),
        // A line that is much longer than the others does not move them.
        (
            "a = 1 \"One\"\nb = 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11 + 12 + 13 + 14 \"Many\"\nc = 10 \"Ten\"\n",
            "a = 1   \"One\"\nb = 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11 + 12 + 13 + 14  \"Many\"\nc = 10  \"Ten\"\n",
        ),
    ];
    for (text, expected) in cases {
        let whole = |model: &str| format!("```model\n{model}```\n");
        assert_eq!(formatted(&whole(text)), whole(expected));
        assert_eq!(formatted(&whole(expected)), whole(expected));
    }
    assert_eq!(
        formatted("```presets\n\"Moon\": g = 1.62\n\"Mercury\":g = 3.7\n```\n"),
        "```presets\n\"Moon\":    g = 1.62\n\"Mercury\": g = 3.7\n```\n"
    );
}

#[test]
fn a_block_with_errors_stays() {
    let text = "```model\nx=(1\n```\n\n```plots\n\"x\":y  against t\n```\n";
    let found = format(&read(text));
    assert_eq!(found.left.iter().map(|head| &text[head.range()]).collect::<Vec<_>>(), ["```model"]);
    assert_eq!(formatted(text), "```model\nx=(1\n```\n\n```plots\n\"x\": y against t\n```\n");
}

/// Structure of a text: kinds of blocks and keys of the front matter.
fn structure(text: &str) -> (Vec<BlockKind>, Vec<(String, String)>) {
    let outline = read(text);
    let kinds = outline.blocks().iter().map(|block| block.kind).filter(|kind| *kind != BlockKind::Prose);
    let entries = outline.front_matter().entries.iter();
    (kinds.collect(), entries.map(|entry| (entry.key.clone(), entry.value.text.clone())).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_reaches_its_layout_in_one_step(text in document_text()) {
        let once = formatted(&text);
        prop_assert_eq!(structure(&once), structure(&text));
        prop_assert_eq!(formatted(&once), once);
    }

    #[test]
    fn any_model_means_the_same_in_its_layout(statements in "[xyk0-9 .'=+*/(),#\\n\"\\[\\]{}-]{0,80}") {
        let text = format!("```model\nparameter k = 1\nx' = -k*x\nx(0) = 1\n{statements}\n```\n");
        let once = formatted(&text);
        prop_assert_eq!(compiled(&once), compiled(&text));
        prop_assert_eq!(formatted(&once), once);
    }
}

//! Opening never panics, for any text, and all places lie in the text.

use proptest::prelude::*;

/// Fragments of documents, so that arbitrary texts get beyond the first line.
fn fragment() -> impl Strategy<Value = String> {
    prop_oneof![
        "\\PC{0,12}",
        "[ -~\n]{0,12}",
        proptest::sample::select(vec![
            "---\n",
            "title: x\n",
            "language: es\n",
            "step: 0.05 [s]\n",
            "step: 1 [kg]\n",
            "until: -1\n",
            "tolerance: 1 %\n",
            "translates: a.md\n",
            "\n```model\n",
            "\n```scene\n",
            "\n```plots\n",
            "\n```presets\n",
            "\n```question\n",
            "\n```check\n",
            "\n```survey\n",
            "scale \"é\": 5 steps from \"a\" to \"b\"\n",
            "role \"R\": \"a\", \"b\"\n",
            " steps from ",
            "\"Kept\": m within 1e-6 of 2*b always\n",
            "\"Still\": y < 2 [m] at end\n",
            "\"Step\": halving the step changes y by less than 1 %\n",
            " at 5 [s]",
            " of ",
            "\n```translations\n",
            "\n```\n",
            "\n~~~~\n",
            "parameter b = 50 [kg/s] in 0..100 \"Damping\"\n",
            "y'' = -9.8 [m/s^2]\n",
            "y(0) = 1 [m] \"Height\"\n",
            "y'(0) = 0\n",
            "m = 2*b\n",
            "when y < 0 [m] { y' = -y' }\n",
            "\"Title\": y, y' against t\n",
            "\"A\": b = 2 [kg/s]\n",
            "group \"G\"\n",
            "answer: 2*b within 2 %\n",
            "set: b = 1 [kg/s]\n",
            "hint: é\n",
            "within",
            "against",
            "<svg viewBox='0 0 1 1'>",
            "</svg>",
            "<g drag='y' drag-up='1 [m]'>",
            "</g>",
            "<text>{y:.2}",
            "</text>",
            "<frame x='-2..2 [m]' y='-1..y(0)'>",
            "</frame>",
            "<circle at='(y, 2*y)' r='3px' drag='y' visible='y > 0'/>",
            "<path d='M (0, y) L 2*(y, 0) Z' fill='{if y > 0 [m] then \"liquid\" else \"é\"}'/>",
            "<g at='1e-3*(y, 0) + (y, 0)' turn='y'>",
            "(",
            ")",
            ",",
            "..",
            "<style>.a { fill: red }",
            "</style>",
            "{y}",
            "{",
            "}",
            "{{",
            "&lt;",
            "&",
            "\"",
            "'",
            "\"Damping\" = \"é\"\n",
            "# H\n",
            "$x^2$",
            "$$\\frac{1}{2}$$",
            "| a | b |\n|--|--|\n| 1 | 2 |\n",
            "[a](b)",
            "![a](b)",
            "<b>",
            "> ",
            "- ",
            "\r\n",
            "\u{feff}",
        ])
        .prop_map(str::to_owned),
    ]
}

/// Texts that look like parts of documents.
pub fn document_text() -> impl Strategy<Value = String> {
    proptest::collection::vec(fragment(), 0..40).prop_map(|fragments| fragments.concat())
}

fn check(source: &str, translation: &str) {
    let opened = document::open(source, &[translation]);
    for (file, diagnostic) in &opened.diagnostics {
        let text = [source, translation][*file];
        for label in &diagnostic.labels {
            assert!(text.get(label.span.range()).is_some(), "{diagnostic:?}");
        }
    }
    if let Some(document) = &opened.document {
        for language in ["en", "es"] {
            let html: String = (document.program.sections(language).iter())
                .flat_map(|section| &section.blocks)
                .map(|block| match block {
                    program::Block::Html(html) => html.clone(),
                    program::Block::Question(index) => document.program.question_text(language, *index).prompt.clone(),
                })
                .collect();
            assert!(!html.contains("<b>") && !html.contains("<script"), "{html}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn opening_any_text_is_safe(source in document_text(), translation in document_text()) {
        check(&source, &translation);
    }

    #[test]
    fn opening_a_model_with_anything_after_it_is_safe(rest in document_text(), translation in document_text()) {
        let model = "```model\nparameter b = 50 [kg/s]\ny'' = -9.8 [m/s^2]\ny(0) = 1 [m] \"Height\"\ny'(0) = 0\n```\n";
        check(&format!("{model}{rest}"), &format!("---\nlanguage: es\n---\n{translation}"));
    }

    #[test]
    fn scenes_of_anything_are_safe(rest in document_text()) {
        let model = "```model\ny'' = -9.8 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0\n```\n";
        check(&format!("{model}```scene\n<svg>{rest}"), "");
    }

    #[test]
    fn reading_any_page_is_safe(page in "\\PC*") {
        let _ = document::page::read(&page);
        let _ = document::page::read(&format!("<script type=\"application/json\" id=\"documents\">{page}</script>"));
    }
}

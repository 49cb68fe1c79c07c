//! Whole documents: the opened document and its diagnostics.

use document::Document;
use program::{Block, Tolerance};

const MODEL: &str = "```model\nparameter h = 2 [m] in 0..9 \"Height\"\ny'' = -9.8 [m/s^2]\ny(0) = h \"Place\"\ny'(0) = 0\nmood = if y > 0 then \"high\" else \"low\"\n```\n";

/// The document, and `FILE: MESSAGE` for each diagnostic.
fn open(source: &str, translations: &[&str]) -> (Option<Document>, Vec<String>) {
    let opened = document::open(source, translations);
    let findings = opened.diagnostics.iter().map(|(file, d)| format!("{file}: {}", d.message.english())).collect();
    (opened.document, findings)
}

fn good(source: &str, translations: &[&str]) -> Document {
    let (document, findings) = open(source, translations);
    assert_eq!(findings, [""; 0]);
    document.expect("a document without findings")
}

#[test]
fn several_model_blocks_are_one_model() {
    let document = good("A\n\n```model\nm = 2*k\n```\n\nB\n\n```model\nk = 3 [kg] \"Mass\"\n```\n", &[]);
    let model = &document.program.model;
    assert_eq!(model.quantities.iter().map(|quantity| quantity.name.as_str()).collect::<Vec<_>>(), ["m", "k"]);
    assert_eq!(model.quantities[0].value.unit.text, "kg");
}

#[test]
fn settings_are_in_si() {
    let front = "---\ntitle: T\nlanguage: es\nmethod: euler\nstep: 50 [ms]\nuntil: 2 [min]\nspeed: 3 [s]\ntolerance: 1e-9\n---\n";
    let document = good(&format!("{front}{MODEL}"), &[]);
    assert_eq!(
        (document.program.step, document.program.until, document.program.tolerance),
        (Some(0.05), Some(120.0), Some(1e-9))
    );
    assert_eq!(
        document.program.speed.as_ref().map(|speed| (speed.per_second, speed.unit.text.as_str())),
        Some((3.0, "s"))
    );
    assert_eq!(document.program.method, Some(program::Method::Euler));
    assert_eq!((document.program.title.as_str(), document.program.language.as_str()), ("T", "es"));
    // Bare numbers are in the unit of the independent variable.
    let document = good("---\nstep: 5\n---\n```model\nindependent x in [cm]\nA' = -2 [1/m]*A\nA(0) = 1\n```\n", &[]);
    assert_eq!(document.program.step, Some(0.05));
}

#[test]
fn settings_out_of_place() {
    let front = "---\nlanguage: my tongue\nstep: -1\nuntil: 5 [kg]\nspeed: 0 [d]\ntolerance: 0.5\n---\n";
    assert_eq!(
        open(&format!("{front}{MODEL}"), &[]).1,
        [
            "0: `my tongue` is not a language",
            "0: `step` must be a positive number",
            "0: `until` has the wrong dimension",
            "0: `speed` must be a positive number",
            "0: the tolerance is too large",
        ]
    );
}

#[test]
fn without_a_model_there_is_no_document() {
    let (document, findings) = open("# Only prose\n", &[]);
    assert!(document.is_none());
    assert_eq!(findings, ["0: the document has no model"]);
    let (document, findings) = open("```model\ny = 2 [m] + 1 [s]\n```\n", &[]);
    assert!(document.is_none());
    assert_eq!(findings.len(), 1, "{findings:?}");
}

#[test]
fn a_faulty_part_is_left_out_and_the_rest_stays() {
    let source = format!(
        "{MODEL}```plots\n\"A\": y against t\n\"B\": z against t\n```\n```presets\n\"P\": h = 1 [m], q = 2\n```\n```question\nQ\nanswer: z within 1 %\n```\n```question\nR\nanswer: h within 1 [cm]\n```\n"
    );
    let (document, findings) = open(&source, &[]);
    assert_eq!(findings, ["0: `z` is not known", "0: `q` is not a parameter of the model", "0: `z` is not known"]);
    let document = document.expect("the model is good");
    assert_eq!(document.program.plots.len(), 1);
    assert_eq!(document.program.presets[0].values.len(), 1);
    assert_eq!(document.program.questions.len(), 1);
    assert_eq!(document.program.questions[0].number().unwrap().tolerance, Tolerance::Absolute(0.01));
    assert_eq!(document.program.question_text("en", 0).prompt, "<p>R</p>\n");
}

#[test]
fn an_unclosed_block_spoils_nothing_after_it() {
    let source = format!("{}```plots\n\"A\": y against t\n```\nThe end.\n", MODEL.trim_end().trim_end_matches('`'));
    let (document, findings) = open(&source, &[]);
    assert_eq!(findings, ["0: the `model` block is not closed"]);
    assert_eq!(document.expect("the model is good").program.plots.len(), 1);
}

#[test]
fn questions_stand_where_they_were_written() {
    let source = format!(
        "{MODEL}# A\n\nText\n\n```question\nWhy?\nhint: *Think.*\nanswer: 2*h within 2 %\n```\n\nMore\n\n# B\n"
    );
    let document = good(&source, &[]);
    let [a, b] = document.program.sections("en") else { panic!("two sections") };
    assert_eq!((a.id.as_str(), a.level, b.title.as_str()), ("doc-a", 1, "B"));
    assert_eq!(
        a.blocks,
        [Block::Html("<p>Text</p>\n".into()), Block::Question(0), Block::Html("<p>More</p>\n".into())]
    );
    assert_eq!(document.program.question_text("en", 0).hint.as_deref(), Some("<p><em>Think.</em></p>\n"));
}

const BASE: &str = "# One\n\n```scene\n<svg viewBox='0 0 9 9'><text>now {y in [cm]} high</text><text>t</text></svg>\n```\n```plots\n\"Fall\": y against t\n```\n```question\nWhy?\nanswer: h within 2 %\n```\n```question\nHow?\nanswer: 2*h within 2 %\n```\n";

#[test]
fn a_translation_keeps_one_model() {
    let translation = "---\nlanguage: es\ntitle: Uno\ntranslates: base.md\n---\n# Uno\n\n```translations\n\"Height\" = \"Altura\"\n\"Place\" = \"Lugar\"\n\"high\" = \"alto\"\n\"low\" = \"bajo\"\n\"Fall\" = \"Caída\"\n\"now {y in [cm]} high\" = \"a {y in [cm]} de altura\"\n```\n\n```question\n¿Por qué?\n```\n```question\n¿Cómo?\nhint: Así.\n```\n";
    let document = good(&format!("{MODEL}{BASE}"), &[translation]);
    assert_eq!(document.program.languages().collect::<Vec<_>>(), ["en", "es"]);
    assert_eq!(document.program.text("es", "Height"), "Altura");
    assert_eq!(document.program.text("es", "alone"), "alone");
    assert_eq!(document.program.text("de", "Height"), "Height");
    assert_eq!(document.program.edition("es").title, "Uno");
    assert_eq!(document.program.question_text("es", 1).prompt, "<p>¿Cómo?</p>\n");
    assert_eq!(document.program.question_text("de", 1).prompt, "<p>How?</p>\n");
    let scene = format!("{:?}", document.program.scene("es").map(|scene| &scene.root));
    assert!(scene.contains("\"a \"") && scene.contains("\" de altura\"") && !scene.contains("high"), "{scene}");
}

#[test]
fn what_is_wrong_with_a_translation() {
    let translation = "---\nlanguage: es\nstep: 1\n---\n```model\nx = 1\n```\n```translations\n\"Heigth\" = \"Altura\"\n\"Place\" = \"Lugar\"\n\"Place\" = \"Sitio\"\n\"Fall\" \"Caída\"\n\"now {y in [cm]} high\" = \"a {y} de altura\"\n```\n```question\n¿Por qué?\nanswer: 3\n```\n";
    let (document, findings) = open(&format!("{MODEL}{BASE}"), &[translation]);
    assert_eq!(
        findings,
        [
            "1: question 2 has no translation",
            "1: 4 texts have no translation",
            "1: `step` in a translation means nothing",
            "1: a translation has no `model` of its own",
            "1: the document has no text \"Heigth\"",
            "1: \"Place\" is translated twice",
            "1: a translation is a text, `=` and a text",
            "1: the translation must contain the same `{expressions}` as the original",
            "1: `answer:` in a translation means nothing",
        ]
    );
    assert_eq!(document.expect("the model is good").program.languages().count(), 2);
    let (_, findings) = open(MODEL, &["", "---\nlanguage: en\n---\n"]);
    assert_eq!(findings, ["1: the translation does not say its language", "2: the document exists in `en` already"]);
    let (_, findings) = open("---\ntranslates: base.md\n---\n", &[]);
    assert_eq!(findings, ["0: this is a translation, which has no model of its own"]);
}

/// Place of each question, and its text for the reader of a translation.
#[test]
fn what_a_translation_lacks_of_questions_is_shown_in_the_language_of_the_document() {
    let question = |text: &str| format!("```question\n{text}\nanswer: h within 2 %\n```\n");
    let why = question("Why?\nhint: Look.\nexplanation: So.");
    let source = format!("{MODEL}Text\n\n# One\n\n{why}\n# Two\n\n{}{}", question("How?"), question("When?"));
    let asked = |translation: &str| {
        let (document, findings) = open(&source, &[&format!("---\nlanguage: es\n---\n{translation}")]);
        let program = document.unwrap().program;
        let mut shown = String::new();
        for section in program.sections("es") {
            shown += &format!("[{} {}]", section.id, section.title);
            for block in &section.blocks {
                let Block::Question(number) = block else { continue };
                let text = program.question_text("es", *number);
                for part in [Some(&text.prompt), text.hint.as_ref(), text.explanation.as_ref()].into_iter().flatten() {
                    shown += &format!(" {}", part.trim().trim_start_matches("<p>").trim_end_matches("</p>"));
                }
            }
        }
        let about: Vec<String> = findings.into_iter().filter(|found| found.contains("question")).collect();
        (shown, about.join("; "))
    };
    for (translation, shown, findings) in [
        (
            "Texto\n\n# Uno\n\n```question\n¿Por qué?\n```\n# Dos\n\n```question\n¿Cómo?\n```\n",
            "[doc ][doc-uno Uno] ¿Por qué? Look. So.[doc-dos Dos] ¿Cómo? When?",
            "1: 3 texts of questions have no translation",
        ),
        (
            "Texto\n\n# Uno\n\n```question\n¿Por qué?\nhint: Mira.\nexplanation: Así.\n```\n",
            "[doc ][doc-uno Uno] ¿Por qué? Mira. Así.[doc-two Two] How? When?",
            "1: 2 texts of questions have no translation",
        ),
        (
            "Texto\n\n# Two\n\n```question\nhint: Mira.\nexplanation: Así.\n```\n# Two\n\n```question\n¿Cómo?\n```\n```question\n¿Cuándo?\n```\n",
            "[doc ][doc-two Two] Why? Mira. Así.[doc-two-2 Two] ¿Cómo? ¿Cuándo?",
            "1: question 1 has no translation",
        ),
        // Without the text before the first heading, the numbers of the sections differ.
        (
            "# Uno\n\n```question\n¿Por qué?\nhint: Mira.\nexplanation: Así.\n```\n",
            "[doc-uno Uno] ¿Por qué? Mira. Así.[doc-two Two] How? When?",
            "1: 2 texts of questions have no translation",
        ),
        ("", "[doc-one One] Why? Look. So.[doc-two Two] How? When?", "1: 3 texts of questions have no translation"),
    ] {
        assert_eq!(asked(translation), (shown.to_owned(), findings.to_owned()));
    }
}

#[test]
fn sizes_are_bounded() {
    let (document, findings) = open(&"é".repeat(600_000), &[]);
    assert!(document.is_none());
    assert_eq!(findings, ["0: a document cannot be longer than 1048576 bytes; this one has 1200000"]);
    // Of too many diagnostics, the warnings are dropped first.
    let source = format!("{MODEL}{}", "[a](b)\n\n<b>\n\n".repeat(300));
    let opened = document::open(&source, &[]);
    // A hundred diagnostics, and one about the number of the others.
    assert_eq!(opened.diagnostics.len(), 101);
    assert_eq!(opened.diagnostics.last().map(|(_, diagnostic)| diagnostic.code), Some("more-findings"));
    assert!(opened.has_errors());
    // Names that stand for larger and larger expressions.
    let doubling: String = (1..60).map(|k| format!("a_{k} = a_{} + a_{}\n", k - 1, k - 1)).collect();
    let (_, findings) = open(&format!("{MODEL}```scene\na_0 = y\n{doubling}<svg viewBox='0 0 1 1'/>\n```\n"), &[]);
    assert_eq!(findings[0], "0: with the scene's own names written out this expression is too large");
}

#[test]
fn warnings_do_not_hide_that_the_model_is_missing() {
    let (_, findings) = open("---\ntitel: x\n---\n", &[]);
    assert_eq!(findings, ["0: the front matter has no key `titel`", "0: the document has no model"]);
    let (_, findings) = open(MODEL, &["---\nlanguage: a b\n---\n"]);
    assert_eq!(findings, ["1: `a b` is not a language"]);
}

#[test]
fn an_unknown_method_is_an_error_that_names_the_methods() {
    let (document, findings) = open(&format!("---\nmethod: leapfrog\n---\n{MODEL}"), &[]);
    assert_eq!(document.expect("the model is good").program.method, None);
    let methods = "euler, euler-richardson, velocity-verlet, rk4, dormand-prince and rosenbrock";
    assert_eq!(findings, [format!("0: there is no method `leapfrog`; the methods are {methods}")]);
}

#[test]
fn functions_of_the_model_may_be_called_everywhere() {
    let source = "```model\nparameter h = 2 [m] in 0..9\nfunction energy(v) = v^2/2\ny'' = -9.8 [m/s^2]\ny(0) = h\ny'(0) = 0\n```\n\
        ```scene\ne = energy(y')\n<svg viewBox=\"0 0 9 9\"><text>{2*e in [J/kg]}</text></svg>\n```\n\
        ```plots\n\"E\": energy(y') in [J/kg] against t\n```\n\
        ```presets\n\"High\": h = 3 [m] + energy(2)*(1 [m])\n```\n\
        ```question\nHow fast?\nanswer: energy(3 [m/s]) within 1 %\n```\n";
    let document = good(source, &[]);
    assert_eq!(document.program.plots[0].curves[0].value.unit.text, "J/kg");
    let wrong = source.replace("\"E\": energy(y')", "\"E\": energy(y', 2)");
    assert_eq!(open(&wrong, &[]).1, ["0: `energy` takes 1 argument, and 2 were given"]);
}

#[test]
fn presets_and_questions_set_switches_and_choices_by_their_words() {
    let source = "```model\nswitch drag = on\nchoice place { \"Earth\": g = 9.8 [m/s^2]; \"Moon\": g = 1.6 [m/s^2] }\n```\n\
        ```presets\n\"Moon\": drag = off, place = \"Moon\"\n```\n\
        ```question\nHow much?\nset: place = \"Moon\"\nanswer: g within 1 %\n```\n";
    let document = good(source, &[]);
    let model = &document.program.model;
    let values: Vec<_> =
        document.program.presets[0].values.iter().map(|one| model.graph.as_constant(one.value.node)).collect();
    assert_eq!(values, [Some(0.0), Some(1.0)]);
    let wrong = source.replace("drag = off, place = \"Moon\"", "drag = 2, place = \"Mars\"");
    assert_eq!(open(&wrong, &[]).1, ["0: `drag` cannot have this value", "0: `place` cannot have this value"]);
    let (_, said) = open(&format!("---\nvary: place\n---\n{source}"), &[]);
    assert_eq!(said, ["0: `place` cannot be varied: it is no number"]);
}

#[test]
fn texts_of_choices_are_translated() {
    let source = "```model\nchoice place { \"Earth\": g = 9.8 [m/s^2]; \"Moon\": g = 1.6 [m/s^2] }\n```\n";
    let translation =
        "---\nlanguage: es\ntranslates: a.md\n---\n```translations\n\"Earth\" = \"Tierra\"\n\"Moon\" = \"Luna\"\n```\n";
    let document = good(source, &[translation]);
    assert_eq!(document.program.text("es", "Moon"), "Luna");
}

#[test]
fn a_switch_and_a_choice_have_no_range_to_sweep_and_seeds_are_whole() {
    const NO_RANGE: &str = "it is a switch or a choice";
    for (name, declared, range, message) in [
        ("on", "switch on = on", "0..1", Some(NO_RANGE)),
        ("liquid", "choice liquid { \"Water\": a = 1, \"Oil\": a = 2 }", "0..1", Some(NO_RANGE)),
        ("seed", "random seed = 1 in 1..9", "1..9 step 0.5", Some("a seed is a whole number")),
        ("seed", "random seed = 1 in 1..9", "1..9", None),
    ] {
        let source = format!(
            "---\nuntil: 1 [s]\n---\n```model\n{declared}\nx' = -x/(1 [s])\nx(0) = 1\n```\n\
             ```plots\n\"Sweep\": x at end against {name} in {range}\n```\n"
        );
        let found: Vec<String> =
            document::open(&source, &[]).diagnostics.iter().map(|(_, one)| one.message.english()).collect();
        match message {
            Some(message) => assert!(found.iter().any(|found| found.contains(message)), "{name}: {found:?}"),
            None => assert_eq!(found, [""; 0], "{name}"),
        }
    }
}

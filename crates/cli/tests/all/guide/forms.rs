//! The forms and expressions in the text and the tables of the guide: each opens without an error in a document around it.

use super::{blocks, guide};
use std::collections::BTreeSet;

/// Models around a form. It is tried in each of them.
const MODELS: [&str; 8] = [
    // Pure numbers.
    "a = 1/2\nb = 1/3\nc = 1/4\nn = 3\np' = -p/(1 [s])\np(0) = 0.5\nx' = -x/(1 [s])\nx(0) = 0.5\ny'' = -y/(1 [s^2])\ny(0) = 0.2\ny'(0) = 0",
    // Conditions and texts.
    "a = t > 1 [s]\nb = t > 2 [s]\nc = t > 3 [s]\ndiscrete phase = \"up\"\nmoving = a\nlate = b\ny = 1\nx = 2\nn = 3",
    // Families.
    "size N = 3\nsize M = 2\ne = 0.5\na = 1 [m]\nx[i]' = 1 [m/s] for i in 1..N\nx[i](0) = 0 [m] for i in 1..N\n\
     y[i]'' = 1 [m/s^2] for i in 1..N\ny[i](0) = 0 [m] for i in 1..N\ny[i]'(0) = 0 for i in 1..N\nv[i] = y[i]' for i in 1..N\n\
     s[0] = 0 [m]",
    "size N = 3\ns[i] = i*1 [m] for i in 1..N",
    // Vectors.
    "size N = 2\na = (1, 2) [m]\nb = (3, 4) [m]\nc = t > 1 [s]\nr'' = -r/(1 [s^2])\nr(0) = (1, 0) [m]\nr'(0) = 0",
    "size N = 2\na[i] = (1, 2) [m] for i in 1..N\nr[i] = (i, 2)*1 [m] for i in 1..N\nx = 1",
    // Mechanics.
    "m = 1 [kg]\nk = 1 [N/m] \ng = 9.81 [m/s^2]\nmu = 0.1\nF = 1 [N]\nF_s = 2 [N]\nF_k = 1 [N]\ntau = 1 [s]\nl = 1 [m]\nL = 2 [m]\nphi = 1 [rad]\n\
     parameter omega = 3 [rad/s] in 1..12\nparameter q_8 = 1 [m] in 0..9\nomega_0 = 2 [rad/s]\nA = 1 [m]\nT = 2*omega\nn = 3\nlate = t > 99 [s]\n\
     theta' = 1 [rad/s]\ntheta(0) = 0\nv = y'\nx'' = -1 [m/s^2]\nx(0) = 1 [m]\nx'(0) = 0\n\
     y'' = -1 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0\nwhen y < 0 [m] as landing { y' = -y' }",
    "k = 1 [N/m]\nm = 1 [kg]\nmu = 0.1\ng = 9.81 [m/s^2]\nx(0) = 1 [m]\nx'(0) = 0",
];

/// Words of the forms, and what stands for them here.
const PLACEHOLDERS: [(&str, &str); 18] = [
    ("{expression}", "{y}"),
    ("[UNIT]", "[m]"),
    ("NUMBER", "1"),
    ("LOW..HIGH", "0..9"),
    ("STEP", "0.5"),
    ("EXPRESSION from EXPRESSION", "1 [s] from 0 [s]"),
    ("EXPRESSION", "x"),
    ("CONDITION", "y > 9 [m]"),
    ("ARGUMENT, ...", "z"),
    ("ARGUMENT", "z"),
    ("X [UNIT] Y  X Y ...", "0 [s] 1  2 3"),
    ("X [m] Y  X Y ...", "0 [s] 1  2 3"),
    ("TOLERANCE", "1 [mm]"),
    ("TIME", "1 [s]"),
    ("points ... at", "points x against y at"),
    (", ... }", " }"),
    ("{ ... }", "{ }"),
    (", ...)", ")"),
];

/// Forms with other instances: their placeholders are not all alike.
const INSTANCES: [(&str, &str); 13] = [
    ("next NAME = EXPRESSION \"LABEL\"", "independent j by 1\nnext q = 2*q \"LABEL\"\nq(0) = 1"),
    ("independent NAME by 1", "independent j by 1"),
    ("coulomb(v, F_s, F_k)", "v = x'\nx'' = -coulomb(v, 2 [N], 1 [N])/(1 [kg])\nx(0) = 1 [m]\nx'(0) = 0"),
    ("independent k by 1", "independent k by 1"),
    ("EXPRESSION = EXPRESSION", "2*q'' + q/(1 [s^2]) = 0\nq(0) = 1\nq'(0) = 0"),
    ("NAME(0) = EXPRESSION in [UNIT] \"LABEL\"", "q' = 1 [m/s]\nq(0) = 1 [m] in [m] \"LABEL\""),
    ("NAME'(0) = ...", "q'' = 1 [m/s^2]\nq(0) = 1 [m]\nq'(0) = 0"),
    (
        "when CONDITION as NAME { NAME' = EXPRESSION, let NAME = EXPRESSION, stop } \"LABEL\"",
        "when t > 9 [s] as q { x' = 2*u, let u = x', stop } \"LABEL\"",
    ),
    ("button \"TITLE\" as NAME { NAME' = EXPRESSION, ... }", "button \"TITLE\" as q { x' = 2*x' }"),
    (
        "choice NAME \"LABEL\" { \"TEXT\": NAME = EXPRESSION \"LABEL\", ... }",
        "choice q \"LABEL\" { \"TEXT\": p = 1 [m] \"LABEL\", \"OTHER\": p = 2 [m] }",
    ),
    ("function NAME(ARGUMENT, ...) = EXPRESSION", "function q(z, w) = z + w"),
    (
        "u[i, j]' = ... for i in 1..N, j in 1..M",
        "u[i, j]' = 1 [1/s] for i in 1..N, j in 1..M\nu[i, j](0) = 0 for i in 1..N, j in 1..M",
    ),
    ("for i in 1..N, j in i+1..N", "w[i, j] = i*j for i in 1..N, j in i+1..N"),
];

/// Documents around a form: what stands before and behind it in a block, with `MODEL` for the model.
const PLACES: [&str; 28] = [
    "```model\nMODEL\nFORM\n```",
    "```model\nMODEL\nq_9 = FORM\n```",
    "```model\nMODEL\nq_9 = 1 FORM\n```",
    "```model\nMODEL\nq_9 = y FORM\n```",
    "```model\nMODEL\nFORM { }\n```",
    "```model\nMODEL\nq_9 = sum(FORM for i in 1..N)\n```",
    "```model\nMODEL\nx'' = FORM/(1 [s^2])\n```",
    "```plots\n\"P\": FORM against t\n```",
    "```plots\n\"P\": x FORM\n```",
    "```plots\n\"P\": FORM\n```",
    "```plots\n\"P\": maximum(x) FORM against omega in 1..12\n```",
    "```plots\n\"P\": FORM against omega in 1..12\n```",
    "```model\nMODEL\nFORM as q_9 { }\n```",
    "```model\nMODEL\nrandom q_7 = 1 in 1..9\ndiscrete q_9 = 0\nevery 1 [s] { q_9 = FORM }\n```",
    "```plots\nFORM\n```",
    "```plots\n\"P\": l*q_8 FORM\n```",
    "```question\nQ\n\nanswer: tau FORM\n```",
    "```check\n\"C\": x within FORM of 1 [m] at end\n```",
    "```check\n\"C\": FORM always\n```",
    "```check\n\"C\": FORM\n```",
    "```check\n\"C\": x FORM of 1 [m] always\n```",
    "```check\n\"C\": x FORM always\n```",
    "```check\n\"C\": x < 9 [m] FORM\n```",
    "```question\nQ\n\nanswer: l FORM\n```",
    "```scene\n<svg viewBox=\"0 0 9 9\"><text x=\"1\" y=\"1\">FORM</text></svg>\n```",
    "```scene\n<svg viewBox=\"0 0 9 9\"><frame x=\"0..1 [m]\" y=\"0..1 [m]\"><bob at=\"(x, y)\" FORM/></frame></svg>\n```",
    "```scene\n<svg viewBox=\"0 0 9 9\"><frame x=\"0..1 [m]\" y=\"0..1 [m]\"><bob FORM r=\"5px\"/><bob at=\"FORM\"/></frame></svg>\n```",
    "```scene\n<svg viewBox=\"0 0 9 9\"><frame x=\"0..1 [m]\" y=\"0..1 [m]\"><polyline points=\"(0 [m], 0) FORM\"/></frame></svg>\n```",
];

/// The codes in the text of the guide outside of blocks.
fn codes(guide: &str) -> BTreeSet<String> {
    let mut text = guide.to_owned();
    for (_, content) in blocks(guide) {
        text = text.replace(&content, "");
    }
    let text = text.replace("````markdown\n````", "").replace("```model\n```", "");
    text.split('`').skip(1).step_by(2).map(|code| code.replace('\n', " ")).collect()
}

/// True for a word or a sign that is named and no form: `rk4`, `answer:`, `#`.
fn is_word(code: &str) -> bool {
    let code = code.trim_end_matches(':');
    code.chars().all(|c| c.is_alphanumeric() || "-_".contains(c)) || code.chars().all(|c| !c.is_alphanumeric())
}

fn opens(document: &str) -> bool {
    let opened = document::open(document, &[]);
    !opened.has_errors()
}

/// True if the code is right in one of the places in one of the models.
fn is_right(code: &str) -> bool {
    let form = INSTANCES.iter().find(|(form, _)| *form == code).map_or_else(
        || {
            let named = code.replace("parameter NAME", "parameter q_7").replace("size NAME", "size q_7");
            let filled = PLACEHOLDERS.iter().fold(named, |text, (word, instance)| text.replace(word, instance));
            let fresh = ["switch", "random", "table", "NAME ="].iter().any(|word| filled.starts_with(word));
            filled.replace("at NAME", "at landing").replace("NAME", if fresh { "q_7" } else { "q_8" })
        },
        |(_, instance)| (*instance).to_owned(),
    );
    MODELS.iter().any(|model| {
        // A text of the drawing holds any words; a value in it stands in braces.
        let fits = |place: &&&str| form.starts_with('{') || !place.contains("<text");
        PLACES.iter().filter(fits).any(|place| {
            let head = if place.contains("MODEL") { String::new() } else { format!("```model\n{model}\n```\n\n") };
            let document = place.replace("MODEL", model).replace("FORM", &form);
            opens(&format!("---\nuntil: 100\n---\n\n{head}{document}\n"))
        })
    })
}

#[test]
fn every_form_and_expression_of_the_text_is_right() {
    for model in MODELS.iter().take(7) {
        let opened = document::open(&format!("```model\n{model}\n```\n"), &[]);
        assert!(!opened.has_errors(), "{model}\n{:?}", opened.diagnostics);
    }
    let guide = guide();
    let other = |code: &str| {
        ["meniscus", "--", "~~", "$", "</", "[activities]", "(#", "![", "data:", "http"].iter().any(|start| code.starts_with(start))
            || ["<frame>", "<label>", "viewBox", "pt-BR", "{{", "5px", "b, v_0", "°C", "°F", "box=\"20 20 360 200\""].contains(&code)
            // Lists of units and functions, which have a test of their own.
            || code.split(' ').count() > 4 && code.split(' ').all(is_word)
            || code.starts_with("transform=") || code.starts_with("<g ") || code.ends_with(':')
    };
    let wrong: Vec<String> =
        codes(&guide).into_iter().filter(|code| !is_word(code) && !other(code) && !is_right(code)).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A form with an error in it is found.
#[test]
fn a_wrong_form_is_noticed() {
    for wrong in
        ["parameter NAME NUMBER", "every 0.1 [s] form 0 [s]", "y(0) 1", "within 1 [s] of", "[kg/m^^3]", "sin(30 [m])"]
    {
        assert!(!is_right(wrong), "{wrong}");
    }
}

/// The units, functions, methods and parts of the guide are those of the program.
#[test]
fn units_functions_methods_and_parts_are_known() {
    let guide = guide();
    let row = |start: &str| guide.lines().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start}"));
    let units: Vec<&str> = ["| SI", "| others", "| pure numbers"]
        .iter()
        .flat_map(|start| row(start).split('`').nth(1).unwrap().split(' '))
        .collect();
    assert!(units.len() > 60, "{units:?}");
    for unit in units {
        assert!(opens(&format!("```model\nq = 1 [{unit}]\n```\n")), "{unit}");
    }
    let functions =
        guide.lines().find(|line| line.starts_with("The functions are")).unwrap().split('`').nth(1).unwrap();
    assert!(functions.split(' ').count() > 15, "{functions}");
    for function in functions.split(' ') {
        assert!(opens(&format!("```model\nq = {function}(1/2)\n```\n")), "{function}");
    }
    let methods =
        guide.lines().skip_while(|line| !line.starts_with("The methods are")).take_while(|line| !line.is_empty());
    let methods: String = methods.collect();
    for method in engine::Method::ALL {
        assert!(methods.contains(&format!("`{}`", method.name())), "{method}");
    }
    let parts =
        guide.lines().skip_while(|line| !line.starts_with("| Part ")).skip(2).take_while(|line| line.starts_with('|'));
    let parts: Vec<&str> = parts.filter_map(|line| line.split('`').nth(1)).collect();
    assert!(parts.len() >= 8, "{parts:?}");
    for part in parts {
        let scene = format!("<svg viewBox=\"0 0 9 9\"><{part}/></svg>");
        let opened = document::open(&format!("```model\nx = 1\n```\n\n```scene\n{scene}\n```\n"), &[]);
        let message = |found: &model::Diagnostic| found.message.english().to_string();
        assert!(opened.diagnostics.iter().all(|(_, found)| !message(found).contains("cannot contain")), "{part}");
    }
}

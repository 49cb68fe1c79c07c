//! Short documents that cause enormous computations: each is refused with a reason, or stays small and runs.

use engine::{Run, Setup};
use program::Program;

/// Maximum number of nodes in the graph of a document.
const NODES: usize = 250_000;

/// Opens a document on a stack as small as that of a web page's module. Returns the messages, and the program if there is
/// one.
fn open(text: String) -> (Vec<String>, Option<Program>) {
    let open = move || {
        let opened = document::open(&text, &[]);
        let messages = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        (messages, opened.document.map(|document| document.program))
    };
    std::thread::Builder::new().stack_size(1 << 20).spawn(open).unwrap().join().unwrap()
}

/// Opens a model with further blocks, and takes its first steps.
fn check(what: &str, model: &str, blocks: &str, expected: &str) {
    let (messages, program) = open(format!("```model\n{model}\n```\n{blocks}"));
    if expected.is_empty() {
        assert!(program.is_some(), "{what}: {messages:?}");
    } else {
        assert!(messages.iter().any(|message| message.contains(expected)), "{what}: {messages:?}");
    }
    assert!(messages.len() < 200, "{what}: {} messages", messages.len());
    if let Some(program) = program {
        assert!(program.model.graph.len() < NODES, "{what}: {} nodes", program.model.graph.len());
        run(&program);
    }
}

/// Takes some steps of a run, which continues or ends with a reason.
fn run(program: &Program) {
    let Ok(mut run) = Run::start(&program.model, Setup::of(program)) else { return };
    for _ in 0..5 {
        if run.advance_within(1_000_000).is_err() {
            return;
        }
    }
}

const DECAY: &str = "independent t\nx' = -x\nx(0) = 1\n";
const SEED: &str = "random seed = 1 in 1..9999\n";

#[test]
fn families_and_sums_without_end() {
    let many = "the families have too many members";
    for (what, model, expected) in [
        ("a size", "size N = 1000000000\nx[i]' = -x[i] for i in 1..N", "a size is at most 10000"),
        ("a size beyond all integers", "size N = 99999999999999999999\nx[1]' = -x[1]", "a size is at most 10000"),
        ("a range", "s = sum(x*i for i in 1..1000000000)", "an index takes at most 10000 values"),
        ("a range downwards", "s = sum(x*i for i in 5..-1000000000)", ""),
        ("min of a range", "s = min(x*i for i in -1000000000..1000000000)", "an index takes at most 10000 values"),
        ("the greatest integer", "s = sum(x for i in 1..9223372036854775807)", "this index is too large"),
        ("a product of indices", "s = x[9223372036854775807*9223372036854775807]", "this index is too large"),
        (
            "a power of a size",
            "size N = 10\ns[i] = i for i in 1..N*N*N*N*N*N*N*N*N*N*N*N",
            "an index takes at most 10000 values",
        ),
        ("a division by 0", "size N = 10\ns[i] = i for i in 1..N/(N-10)", "an index is a whole number"),
        ("a remainder of 0", "size N = 10\ns[i] = i for i in 1..mod(N,N-10)", "an index is a whole number"),
        ("sums of sums of sums", "s = sum(sum(sum(i*j*k for k in 1..1000) for j in 1..1000) for i in 1..1000)", many),
        ("sums of sums", "s = sum(sum(x*i*j for j in 1..400) for i in 1..400)", "too many operations"),
        ("two indices", "size N = 10000\nu[i,j] = x*i*j for i in 1..N, j in 1..N", many),
        ("a recurring definition", "size N = 9000\ns[0] = x\ns[i] = s[i-1]*(1 + x) for i in 1..N\ny = s[N]", ""),
        ("its derivative", "size N = 300\ns[0] = x\ns[i] = s[i-1]*sin(s[i-1]) for i in 1..N\ny = s[N]''''", ""),
        ("events of pairs", "size N = 1000\nwhen x < i/j { x = i/j } for i in 1..N, j in 1..N", many),
    ] {
        check(what, &format!("{DECAY}{model}"), "", expected);
    }
}

#[test]
fn functions_and_vectors_without_end() {
    let nested = format!("y = {}x{}", "f(".repeat(60), ")".repeat(60));
    let vectors = "independent t\nsize N = 3000\nr[i]'' = -r[i]*sum(dot(r[i], r[j]) for j in 1..N) for i in 1..N\n\
                   r[i](0) = (1, 2, 3) for i in 1..N\nr[i]'(0) = (1, 2, 3) for i in 1..N";
    let pairs = "independent t\nsize N = 60\nr[i,j]'' = -cross(r[i,j], r[j,i]) for i in 1..N, j in 1..N\n\
                 r[i,j](0) = (1, 2, 3) for i in 1..N, j in 1..N\nr[i,j]'(0) = (1, 2, 3) for i in 1..N, j in 1..N";
    check("a vector family", vectors, "", "the families have too many members");
    check("vectors of pairs", pairs, "", "with its vectors written out in components, the model is too large");
    let circle = "call each other in a circle";
    for (what, model, expected) in [
        ("two functions", "function f(a) = g(a)\nfunction g(a) = f(a)\ny = f(x)", circle),
        ("three", "function f(a) = g(a) + h(a)\nfunction g(a) = h(a)*f(a)\nfunction h(a) = g(f(a))\ny = f(x)", circle),
        ("one", "function f(a) = 1 + f(a)\ny = f(x)", "the function `f` calls itself"),
        ("calls of calls", &format!("function f(a) = a*a + a\n{nested}"), "this expression is too large"),
        ("of a family", "size N = 3000\nfunction f(a) = sin(a)^2\ny[i] = f(f(f(x*i))) for i in 1..N", "too large"),
        ("parentheses", &format!("v = {}1, 2{}", "(".repeat(200), ")".repeat(200)), "nested too deeply"),
    ] {
        check(what, &format!("{DECAY}{model}"), "", expected);
    }
}

#[test]
fn tables_choices_and_maps_without_end() {
    let points = |count: usize| (0..count).map(|k| format!("{k} {}\n", k % 7)).collect::<String>();
    let alternatives: String = (0..500).map(|k| format!("\"a{k}\": q = {k}\n")).collect();
    let sum = (0..150).map(|k| format!("{k}*x*(1 - x)")).collect::<Vec<_>>().join(" + ");
    let remembered: String = (0..3000).map(|k| format!("m{k} = maximum(x*{k}) + integral(x/{})\n", k + 1)).collect();
    for (what, model, expected) in [
        (
            "a long table",
            format!("{DECAY}table a(s) {{\n{}}}\ny = a(t)", points(15_000)),
            "a table has at most 10000 points",
        ),
        (
            "a million rows",
            format!("{DECAY}table a(s) {{\n{}}}\ny = a(t)", points(1_000_000 / 8)),
            "200000 are the most",
        ),
        (
            "great numbers",
            format!("{DECAY}table a(s) {{ 0 1e308  1e-320 -1e308 }}\ny = a(t)"),
            "of the table `a` is too large",
        ),
        ("alternatives", format!("{DECAY}choice c {{\n{alternatives}}}"), "more than 40 alternatives"),
        ("what is remembered", format!("{DECAY}{remembered}"), "4096 are the most"),
        ("a long map", format!("independent n by 1\nnext x = {sum}\nx(0) = 0.5"), ""),
        (
            "a nested map",
            format!("independent n by 1\nnext x = {}x{}\nx(0) = 0.5", "sin(".repeat(99), ")".repeat(99)),
            "nested too deeply",
        ),
        (
            "a map of many",
            "independent n by 1\nh[0] = n\nnext h[i] = h[i-1] for i in 1..4000\nh[i](0) = 0 for i in 1..4000"
                .to_owned(),
            "",
        ),
        (
            "frictions",
            "independent t\nsize N = 100\nv[i]' = -coulomb(v[i], 1) for i in 1..N\nv[i](0) = i for i in 1..N"
                .to_owned(),
            "16 are the most",
        ),
    ] {
        check(what, &model, "", expected);
    }
    let rows = points(1_000_000 / 8);
    let (messages, _) = open(format!("```model\n{DECAY}y = a(t)\n```\n```table a(s)\n{rows}\n```\n"));
    assert!(messages.iter().any(|message| message.contains("are the most")), "{messages:?}");
}

#[test]
fn draws_and_clocks_without_end() {
    for (what, model, expected) in [
        (
            "a million draws",
            "every 0.1 { n = sum(uniform(0, 1)*i for i in 1..1000000) }",
            "an index takes at most 10000 values",
        ),
        (
            "draws of many",
            "discrete k[i] = 0 for i in 1..9999\nevery 0.1 { k[i] = normal(0, 1) for i in 1..9999 }",
            "4096 are the most",
        ),
        (
            "of a thousand",
            "discrete k[i] = 0 for i in 1..1000\nevery 1e-4 { k[i] = poisson(1e9) for i in 1..1000 }",
            "",
        ),
        ("great numbers", "every 0.1 { n = binomial(1e300, 0.5) + poisson(1e300) }", ""),
        ("no numbers", "every 0.1 { n = binomial(ln(-x), 1/(x - x)) + poisson(ln(-x)) + normal(x/0, -1) }", ""),
        ("a short interval", "every 1e-12 { n = n + 1 }", ""),
        ("the shortest", "every 1e-320 { n = n + 1 }", "an event cannot happen at intervals of 0"),
        ("an interval of 0", "parameter p = 0 in 0..1\nevery p { n = n + 1 }", ""),
        ("of less", "parameter p = -1 in -1..1\nevery p { n = n + 1 }", ""),
        ("events for ever", "when x < 2 { x = 1 }\nwhen x > 0 { x = 3 }", ""),
    ] {
        check(what, &format!("{DECAY}{SEED}discrete n = 0\n{model}"), "", expected);
    }
    let whole = "is a whole number without a unit";
    let number = "must be a number";
    for (seed, expected) in [("1 in 1..1e300", whole), ("1e300", whole), ("-5.5 in -10..-1", whole), ("1/0", number)] {
        check(seed, &format!("{DECAY}random seed = {seed}\ndiscrete n = uniform(0, 1)"), "", expected);
    }
}

#[test]
fn drawings_plots_and_checks_without_end() {
    let model = format!("{DECAY}size N = 5000\nparameter a = 1 in 0..2\ny[i] = sin(i*t) for i in 1..N");
    let members = "a plot cannot have more than 2000 members";
    for (plot, expected) in [
        ("histogram y[i] for i in 1..N", members),
        ("y[i] against i for i in 1..N", members),
        ("y[i] against i for i in 1..1000000000", members),
        ("maximum(x) from 60 against a in 0..2 step 1e-12", "a curve cannot have more than 2000 values"),
        ("a^2 against a in 0..2 step 1e-300", "a curve cannot have more than 2000 values"),
    ] {
        check(plot, &model, &format!("```plots\n\"P\": {plot}\n```\n"), expected);
    }
    let copies = "the elements of a scene cannot have more than 2000 copies";
    let nested = "<g repeat='i in 1..60'><g repeat='j in 1..60'><circle repeat='k in 1..60' r='{i*j*k}'/></g></g>";
    for (scene, expected) in [
        ("<circle repeat='i in 1..N' r='{y[i]}'/>", copies),
        ("<circle repeat='i in 1..1000000000' r='{y[1]}'/>", "the ends of an index must be whole numbers"),
        (nested, copies),
        (
            "<frame x='0..1' y='0..1'><spring from='(0, 0)' to='(x, 1)' turns='1e9'/></frame>",
            "a whole number from 1 to 60",
        ),
    ] {
        check(scene, &model, &format!("```scene\n<svg viewBox='0 0 1 1'>{scene}</svg>\n```\n"), expected);
    }
    let claims: String = (0..3000).map(|k| format!("\"c{k}\": x < {k} always\n")).collect();
    check("claims", &model, &format!("```check\n{claims}```\n"), "more than 100 claims");
}

#[test]
fn prose_without_end() {
    for piece in ["# a\n", "> ", "[", "$", "*a ", "**a*", "[a](", "- a\n  ", "|a", "`", "<b>", "![a](b)\n\n", "$x$ "] {
        let (_, program) = open(format!("```model\n{DECAY}```\n\n{}", piece.repeat(40_000)));
        assert!(program.is_some(), "{piece}");
    }
    let (_, program) = open(format!("```model\n{DECAY}```\n# a\n# a-2\n# a\n# a\n# a-2\n"));
    let sections = &program.unwrap().editions[0].sections;
    let ids: Vec<&str> = sections.iter().map(|section| &*section.id).collect();
    assert_eq!(ids, ["doc-a", "doc-a-2", "doc-a-3", "doc-a-4", "doc-a-2-2"]);
}

//! Short texts that cause enormous computations are refused, quickly and without exhausting the stack.

use crate::common::diagnostics;
use program::{Model, Node, State};
use std::fmt::Write;

/// Compiles on a stack as small as that of a web page's module.
fn on_a_small_stack(source: String) -> (Option<Model>, String) {
    let compile = move || {
        let (model, found) = model::compile(&source, std::slice::from_ref(&(0..source.len())));
        let model = model.map(|checked| checked.model);
        let text = crate::common::render(&source, &found);
        (model, text)
    };
    std::thread::Builder::new().stack_size(1 << 20).spawn(compile).unwrap().join().unwrap()
}

fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |mut text, number| {
        writeln!(text, "{}", line(number)).unwrap();
        text
    })
}

#[test]
fn definitions_that_double_each_time_stay_small() {
    let source = "independent t\na0 = t\n".to_owned() + &lines(1000, |n| format!("a{} = a{n} + sin(a{n})", n + 1));
    let (model, text) = on_a_small_stack(source);
    assert!(model.unwrap_or_else(|| panic!("{text}")).graph.len() < 3000);
}

#[test]
fn functions_that_double_each_time_are_refused() {
    let source = "function f0(x) = x + x\n".to_owned()
        + &lines(40, |n| format!("function f{}(x) = f{n}(x) + f{n}(2*x)", n + 1))
        + "y = f40(1)\n";
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_none());
    assert!(text.starts_with("error [model-too-large]"), "{text}");
}

#[test]
fn functions_of_functions_do_not_exhaust_the_stack() {
    let source = "function f0(x) = 1 + x\n".to_owned()
        + &lines(300, |n| format!("function f{}(x) = 1 + f{n}(2*(x - 1))", n + 1))
        + "y = f300(1)\nz = f10(2)\n";
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_none());
    assert!(text.starts_with("error [model-too-large]"), "{text}");
}

#[test]
fn many_primes_of_a_deep_expression_stay_bounded() {
    let nested = format!("{}t{}", "sin(1 + exp(".repeat(15), "))".repeat(15));
    let (model, text) = on_a_small_stack(format!("independent t\ny = {nested}\nz = y''''''''''''\n"));
    assert!(model.is_none_or(|model| model.graph.len() <= 200_000), "{text}");
}

#[test]
fn primes_of_primes_are_refused() {
    let source =
        "independent t\na0 = exp(t^2)*sin(t)\n".to_owned() + &lines(200, |n| format!("a{} = a{n}'*cos(t)", n + 1));
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_none());
    assert!(text.starts_with("error [model-too-large]"), "{text}");
}

#[test]
fn long_sums_are_fine() {
    let sum = (0..190).map(|n| format!("{n}*y")).collect::<Vec<_>>().join(" + ");
    let source = format!("independent t\ny' = -({sum})\ny(0) = 1\n");
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_some(), "{text}");
}

#[test]
fn long_products_are_fine() {
    let product = vec!["(1 + y)"; 380].join("*");
    let power = vec!["y"; 60].join("^");
    let condition = vec!["y < 1"; 380].join(" and ");
    let (model, text) =
        on_a_small_stack(format!("independent t\ny' = {product}\ny(0) = 1\na = {power}\nb = {condition}\n"));
    assert!(model.is_some(), "{text}");
}

#[test]
fn what_is_wrong_very_often_is_not_told_very_often() {
    let statements = lines(1000, |n| format!("a{n} = L + {}", vec!["sin(L)"; 20].join(" + ")));
    let (_, text) = on_a_small_stack(format!("parameter L = 1 [m]\n{statements}"));
    let told = text.matches("error [").count();
    assert!((50..100).contains(&told), "{told}");
    let names = (0..20_000).map(|n| format!("q{n}")).collect::<Vec<_>>();
    let sums = names.chunks(100).map(|names| names.join(" + ")).collect::<Vec<_>>();
    let (_, text) = on_a_small_stack(lines(200, |n| format!("a{n} = {}", sums[n])));
    assert_eq!(text.matches("error [").count(), 50);
}

#[test]
fn equations_that_say_all_the_same_are_told_shortly() {
    let source = "independent t\n".to_owned() + &lines(1000, |n| format!("x' = {n}"));
    let (_, text) = on_a_small_stack(source);
    assert!(text.len() < 1_000_000, "{}", text.len());
}

#[test]
fn a_long_sum_of_all_unknowns_is_refused() {
    let unknowns = (0..250).map(|n| format!("x{n}'")).collect::<Vec<_>>();
    let mut source = "independent t\n".to_owned();
    for (number, chunk) in unknowns.chunks(125).enumerate() {
        writeln!(source, "s{number} = {}", chunk.join(" + ")).unwrap();
    }
    let sums = lines(200, |n| {
        format!("r{} = {}{}", n + 1, if n == 0 { "s0 + s1".to_owned() } else { format!("r{n}") }, " + t".repeat(300))
    });
    source += &sums;
    source += &lines(250, |n| format!("x{n}' = {}\nx{n}(0) = 0", if n == 0 { "r200" } else { "t" }));
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_none());
    assert!(text.starts_with("error [model-too-large]"), "{text}");
}

#[test]
fn deep_nesting_is_fine_up_to_the_parsers_bound() {
    let nested = format!("{}t{}", "sin(".repeat(60), ")".repeat(60));
    let branches = "if t > 1 then 2 else ".repeat(60);
    let (model, text) = on_a_small_stack(format!("independent t\na = {nested}\nb = {branches}3\n"));
    assert!(model.is_some(), "{text}");
}

#[test]
fn too_many_states() {
    let source = "independent t\n".to_owned() + &lines(5000, |n| format!("x{n}'=-x{n}\nx{n}(0)=1"));
    assert!(diagnostics(&source).starts_with("error [model-too-large]: the model has 5000 states; 4096 are the most"));
}

#[test]
fn a_chain_of_oscillators_is_solved_one_by_one() {
    let source = "independent t\nx0'' = -x0\nx0(0) = 1\nx0'(0) = 0\n".to_owned()
        + &lines(100, |n| format!("x{m}'' + x{n}''/3 = x{n} - 2*x{m}\nx{m}(0) = 0\nx{m}'(0) = 0", m = n + 1));
    let (model, text) = on_a_small_stack(source);
    let model = model.unwrap_or_else(|| panic!("{text}"));
    assert!(model.graph.systems().is_empty());
    assert_eq!(model.states.iter().map(State::name).next_back().unwrap(), "x100'");
}

#[test]
fn too_many_equations_in_one_system() {
    let coupled = |count: usize| {
        let all = lines(count, |n| format!("x{n}'")).trim().replace('\n', " + ");
        "independent t\n".to_owned() + &lines(count, |n| format!("{n}*x{n}' + {all} = -x{n}\nx{n}(0) = 1"))
    };
    let (model, _) = on_a_small_stack(coupled(32));
    let model = model.unwrap();
    assert!(matches!(model.graph.node(model.states[0].derivative), Node::Solution { .. }));
    let (model, text) = on_a_small_stack(coupled(33));
    assert!(model.is_none());
    assert!(text.starts_with("error [too-many-coupled-equations]"), "{text}");
}

#[test]
fn many_equations_are_solved_together_where_each_is_coupled_with_few() {
    let ring = |count: usize| lines(count, |n| format!("3*x{n}' + x{}' = -x{n}\nx{n}(0) = 1", (n + 1) % count));
    for count in [33, 1000] {
        let (model, text) = on_a_small_stack("independent t\n".to_owned() + &ring(count));
        let model = model.unwrap_or_else(|| panic!("{text}"));
        assert_eq!(model.graph.systems()[0].numbers(), Some(7 * count), "two diagonals on each side, and two more");
    }
    // The sum of all left sides is 0.
    let dependent = lines(40, |n| format!("x{n}' - x{}' = -x{n}\nx{n}(0) = 1", (n + 1) % 40));
    assert!(diagnostics(&("independent t\n".to_owned() + &dependent)).starts_with("error ["));
}

#[test]
fn a_text_that_is_too_long() {
    let source = "a = 1 + ".to_owned() + &" ".repeat(300_000) + "1";
    assert!(diagnostics(&source).starts_with("error [model-too-large]: the model has 300009 bytes"));
}

#[test]
fn many_zeros_and_long_names_take_no_time() {
    let zeros = lines(1500, |n| format!("z{n} = {}", vec!["0*0"; 20].join("+")));
    let (model, text) = on_a_small_stack(zeros);
    assert!(model.is_some(), "{text}");
    let long = "x".repeat(90_000);
    let (_, text) = on_a_small_stack(format!("a = {long}\n"));
    assert!(text.starts_with("error [unknown-name]"));
}

#[test]
fn a_sum_of_all_unknowns_in_every_equation() {
    // 200 equations with 200 coefficients each would be 40,000 entries of one system.
    let sum = (0..200).map(|n| format!("{}*x{n}'", n + 1)).collect::<Vec<_>>().join(" + ");
    let source = "independent t\n".to_owned() + &lines(200, |n| format!("{sum} = {n}\nx{n}(0) = 0"));
    let (model, text) = on_a_small_stack(source);
    assert!(model.is_none());
    assert!(text.contains("error ["), "{text}");
}

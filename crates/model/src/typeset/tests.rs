//! Typeset expressions in a short notation similar to TeX. Reading them back also checks that every element is closed.

use super::expression::Typesetter;
use super::typeset_expression;
use crate::vectors::Vectors;
use crate::{parse, parse_expression};
use units::mathml::typeset_name;

/// The children of an element up to its end tag, in the short notation.
fn children(text: &mut &str, end: &str) -> Vec<String> {
    let mut all = Vec::new();
    loop {
        let (before, after) = text.split_once('<').expect("an element is open");
        assert!(before.is_empty() || end.is_empty(), "text between elements: {before}");
        let (tag, rest) = after.split_once('>').expect("a tag is open");
        *text = rest;
        if let Some(closed) = tag.strip_prefix('/') {
            assert_eq!(closed, end);
            return all;
        }
        if tag.starts_with("mspace") {
            all.push("~".to_owned());
            continue;
        }
        let name = tag.split(' ').next().unwrap_or_default();
        if matches!(name, "mi" | "mn" | "mo" | "mtext") {
            let (inside, rest) = text.split_once("</").expect("a token is open");
            *text = rest.strip_prefix(name).and_then(|rest| rest.strip_prefix('>')).expect("the same tag");
            let inside = inside.replace("&#x2062;", "").replace("&#x2061;", "");
            let upright = tag.contains("mathvariant") || name == "mi" && inside.chars().count() > 1;
            all.push(if upright { format!("\\{inside}") } else { inside });
            continue;
        }
        let inside = children(text, name);
        all.push(match (name, inside.as_slice()) {
            ("math" | "mrow" | "mtd", _) => inside.concat(),
            ("mfrac", [above, below]) => format!("{{{above}}}/{{{below}}}"),
            ("msup", [base, above]) => format!("{base}^{{{above}}}"),
            ("msub", [base, below]) => format!("{base}_{{{below}}}"),
            ("msubsup", [base, below, above]) => format!("{base}_{{{below}}}^{{{above}}}"),
            ("mover", [base, _]) => format!("{base}→"),
            ("msqrt", _) => format!("√{{{}}}", inside.concat()),
            ("mroot", [base, degree]) => format!("√[{degree}]{{{base}}}"),
            ("mtable", _) => inside.join("; "),
            ("mtr", _) => inside.join(" : "),
            _ => panic!("{name} with {} children", inside.len()),
        });
        if name == "math" {
            return all;
        }
    }
}

fn short(mathml: &str) -> String {
    let mut rest = mathml;
    let read = children(&mut rest, "").concat();
    assert_eq!(rest, "");
    read
}

fn set(source: &str) -> String {
    let (expression, _, diagnostics) = parse_expression(source, 0..source.len());
    assert!(diagnostics.is_empty(), "{source}: {diagnostics:?}");
    short(&typeset_expression(&expression))
}

#[test]
fn expressions_look_as_in_a_textbook() {
    for (source, expected) in [
        ("rho*S*L*y'' + b*y' + 2*rho*S*g*y", "ρSLy^{″}+by^{′}+2ρSgy"),
        ("(h_l - h_r)/2", "{h_{l}−h_{r}}/{2}"),
        ("m*y'^2/2", "{my^{′2}}/{2}"),
        ("1/2*m*v^2", "{1}/{2}~mv^{2}"),
        ("m*g*y^2/L", "{mgy^{2}}/{L}"),
        ("-g*y/L", "−{gy}/{L}"),
        ("-2*g/L*y - b/m*y'", "−{2g}/{L}~y−{b}/{m}~y^{′}"),
        ("a/b/c", "{a}/{bc}"),
        ("a/(b/c)", "{a}/{{b}/{c}}"),
        ("a/(b + c)", "{a}/{b+c}"),
        ("(a + b)*(c - d)", "(a+b)(c−d)"),
        ("a - (b - c)", "a−(b−c)"),
        ("a - b*c", "a−bc"),
        ("a + (b + c)", "a+b+c"),
        ("a*(b*c)", "abc"),
        ("a + -b", "a+(−b)"),
        ("a*-b", "a(−b)"),
        ("a - -b*c", "a−(−bc)"),
        ("-(a + b)", "−(a+b)"),
        ("--a", "−(−a)"),
        ("(a/b)^2", "({a}/{b})^{2}"),
        ("(-a)^2", "(−a)^{2}"),
        ("-a^2", "−a^{2}"),
        ("omega_0^2", "ω_{0}^{2}"),
        ("x_1''", "x_{1}^{″}"),
        ("(a^b)^c", "(a^{b})^{c}"),
        ("a^b^c", "a^{b^{c}}"),
        ("x^(n/2)", "x^{n/2}"),
        ("x^(a/(b*c))", "x^{a/(bc)}"),
        ("x^-1", "x^{−1}"),
        ("x⁻¹", "x^{−1}"),
        ("2*3*x", "2⋅3x"),
        ("x*2", "x⋅2"),
        ("2*x*10^3", "2x⋅10^{3}"),
        ("2 [m] + h_l", "2~\\m+h_{l}"),
        ("9.8 [m/s^2]*t", "9.8~\\m/\\s^{2}⋅t"),
        ("30 [deg]", "30\\°"),
        ("5 [Pa s]^2", "(5~\\Pa~\\s)^{2}"),
        ("5 [(m/s)^2]", "5~(\\m/\\s)^{2}"),
        ("5 [1/(m^(1/2) s^-1)]", "5~1/(\\m^{1/2}~\\s^{−1})"),
        ("5 [kohm]", "5~\\kΩ"),
        ("6.674e-11*m", "6.674×10^{−11}m"),
        ("1e9*x", "10^{9}x"),
        ("0.05 + 13600", "0.05+13600"),
        ("sqrt(2*g/L)", "√{{2g}/{L}}"),
        ("cbrt(x)", "√[3]{x}"),
        ("abs(x - y)", "|x−y|"),
        ("floor(x)^2", "⌊x⌋^{2}"),
        ("A*exp(-gamma*t)*cos(omega_d*t + delta)", "A\\e^{−γt}~\\cos(ω_{d}t+δ)"),
        ("exp(-t/tau)", "\\e^{−t/τ}"),
        ("sin(theta)", "\\sin~θ"),
        ("g*sin(theta)", "g~\\sin~θ"),
        ("sin(theta)*theta'", "\\sin(θ)~θ^{′}"),
        ("sin(theta')", "\\sin(θ^{′})"),
        ("sin(x)^2 + cos(x)^2", "\\sin^{2}(x)+\\cos^{2}(x)"),
        ("sin(x)^-1", "(\\sin~x)^{−1}"),
        ("asin(x)", "\\arcsin(x)"),
        ("log10(x)", "\\log_{10}~x"),
        ("max(a, b + 1)", "\\max(a,b+1)"),
        ("2*pi*sqrt(L/g)", "2\\π√{{L}/{g}}"),
        ("y'(0)", "y^{′}(0)"),
        ("y'''''", "y^{(5)}"),
        ("height*width", "\\height~\\width"),
        ("a < b and not c >= d or e != f", "a&lt;b∧¬(c≥d)∨e≠f"),
        ("a and (b or c)", "a∧(b∨c)"),
        ("if y < 0 then -y else y", "{−y : y&lt;0; y : y≥0"),
        (
            "if b < b_c then \"under\" else if b == b_c then \"critical\" else \"over\"",
            "{under : b&lt;b_{c}; critical : b=b_{c}; over : b&gt;b_{c}",
        ),
        ("if a < b and c < d then 1 else 2", "{1 : a&lt;b∧c&lt;d; 2 : "),
        ("2*(if a < b then 1 else 2)", "2({1 : a&lt;b; 2 : a≥b)"),
    ] {
        assert_eq!(set(source), expected, "{source}");
    }
}

#[test]
fn names_have_greek_letters_subscripts_and_primes() {
    for (name, expected) in [
        ("y", "y"),
        ("y''", "y^{″}"),
        ("omega_0", "ω_{0}"),
        ("omega0", "ω_{0}"),
        ("h_l'", "h_{l}^{′}"),
        ("x12", "x_{12}"),
        ("T_max", "T_{\\max}"),
        ("theta_1_x", "θ_{1,x}"),
        ("k_alpha", "k_{α}"),
        ("Deltax", "\\Δx"),
        ("Omega", "Ω"),
        ("pi", "\\π"),
        ("regime", "\\regime"),
        ("mass2", "\\mass2"),
        ("_a", "\\_a"),
        ("a_", "\\a_"),
    ] {
        assert_eq!(short(&typeset_name(name)), expected, "{name}");
    }
}

#[test]
fn statements_are_set_one_by_one() {
    let source = "parameter g = 9.8 [m/s^2]\nm = rho*L \"Mass\"\nm*y'' = -b*y'\ny'(0) = v_0\nr = \"a < b\"\n\
                  when y < 0 [m] { y' = -e*y'; y = 0 }\nbutton \"a < b\" as push { y' = 0; stop }\n\
                  function F_d(v, rho) = c*rho*v^2\nF = F_d(y', 2)*a";
    let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let translate = |text: &str| text.to_uppercase();
    let typesetter = Typesetter { translate: &translate, vectors: &Vectors::of(&statements) };
    let all: Vec<String> =
        statements.iter().filter_map(|statement| typesetter.kind(&statement.kind, &statement.over)).collect();
    assert!(all.iter().all(|one| one.starts_with("<math display=\"block\">") && one.ends_with("</math>")));
    let read: Vec<String> = all.iter().map(|one| short(one)).collect();
    assert_eq!(
        read,
        [
            "m=ρL",
            "my^{″}=−by^{′}",
            "y^{′}(0)=v_{0}",
            "r=A &lt; B",
            "y&lt;0~\\m⟹y^{′}←−ey^{′},y←0",
            "A &lt; B⟹y^{′}←0,stop",
            "F_{d}(v,ρ)=cρv^{2}",
            "F=F_{d}(y^{′},2)~a"
        ]
    );
}

#[test]
fn vectors_have_arrows() {
    let source = "r'' = -G*M*r/norm(r)^3\nr(0) = (1, 0) [km]\nr'(0) = (0, v_0)\nB = (0, 0, B_0)\n\
                  s(0) = (0, 0, 1)\nm*s'' = q*(E + cross(s', B))\nP = dot(F_1 - s, s')*m in [W]\nL = m*cross(r, r')\n\
                  p[i](0) = (i, 0) for i in 1..3\nh = r.x*r'.y^2 + p[2].x'^2\n\
                  when r.x > a { r.x' = -e*r.x', p[1] = (0, 0) }\nb = cross(s, cross(s, B)) + (r.x, 2, s.z^2)";
    let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let read: Vec<String> = super::typeset(&statements, &str::to_owned).iter().map(|one| short(one)).collect();
    assert_eq!(
        read,
        [
            "r→^{″}=−{GMr→}/{|r→|^{3}}",
            "r→(0)=(1,0)~\\km",
            "r→^{′}(0)=(0,v_{0})",
            "B→=(0,0,B_{0})",
            "s→(0)=(0,0,1)",
            "ms→^{″}=q(E+s→^{′}×B→)",
            "P=((F_{1}−s→)·s→^{′})~m",
            "L=m~(r→×r→^{′})",
            "p→_{i}(0)=(i,0)~i=1,…,3",
            "h=r_{x}r_{y}^{′2}+p_{2,x}^{′2}",
            "r_{x}&gt;a⟹r_{x}^{′}←−er_{x}^{′},p→_{1}←(0,0)",
            "b→=s→×(s→×B→)+(r_{x},2,s_{z}^{2})",
        ]
    );
}

#[test]
fn maps_have_the_count_below() {
    let source = "independent k by 1\nnext p = r*p*(1 - p)\nnext x[i] = x[i-1] + p for i in 1..N\np(0) = 0.1";
    let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let read: Vec<String> = super::typeset(&statements, &str::to_owned).iter().map(|one| short(one)).collect();
    assert_eq!(read, ["p_{k+1}=rp_{k}(1−p_{k})", "x_{i,k+1}=x_{i−1,k}+p_{k}~i=1,…,N", "p(0)=0.1"]);
}

#[test]
fn the_markup_itself() {
    let (expression, _, _) = parse_expression("g*y/2", 0..5);
    assert_eq!(
        typeset_expression(&expression),
        "<math><mfrac><mrow><mi>g</mi><mo>&#x2062;</mo><mi>y</mi></mrow><mn>2</mn></mfrac></math>"
    );
}

#[test]
fn a_table_is_two_rows_and_of_a_long_one_the_first_points_and_the_last() {
    let rows = |source: &str| {
        let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
        super::typeset(&statements, &str::to_owned).iter().map(|row| short(row)).collect::<Vec<_>>()
    };
    assert_eq!(
        rows("table eta(T) in [mPa s] { 273 [K] 1.792  293 1.002 }"),
        ["T~[~\\K] : 273 : 293; η(T)~[~\\mPa~\\s] : 1.792 : 1.002"]
    );
    let points: String = (0..20).map(|number| format!("{number} {}\n", number * number)).collect();
    assert_eq!(
        rows(&format!("steps table n(k) {{ {points} }}")),
        ["k : 0 : 1 : 2 : 3 : 4 : 5 : … : 19; n(k) : 0 : 1 : 4 : 9 : 16 : 25 : … : 361"]
    );
}

//! Mathematics in prose: LaTeX to MathML Core.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use model::{Diagnostic, Span};
use units::markup::escaped;
use units::{Language, Words, say, words};

/// Maximum nesting depth of a formula. The converter is recursive, and the stack in a page is small.
const DEPTH: usize = 20;
/// Maximum length of a formula, in bytes.
const LENGTH: usize = 4_000;

/// Converter for formulas. Its tables are created once.
pub struct Formulas {
    converter: LatexToMathML,
}

impl Formulas {
    /// Converter without macros.
    pub fn new() -> Self {
        // Creation can fail only for an invalid macro, and there are none.
        Self { converter: LatexToMathML::new(MathCoreConfig::default()).unwrap_or_default() }
    }

    /// MathML of `latex`, which stands at `span` of the source; after an error, the text itself.
    pub fn html(&self, latex: &str, display: MathDisplay, span: Span, diagnostics: &mut Vec<Diagnostic>) -> String {
        let problem = if latex.len() > LENGTH {
            Diagnostic::error("math", words!("a formula cannot be longer than {LENGTH} bytes"), span)
        } else if nesting(latex) > DEPTH {
            Diagnostic::error("math", words!("a formula cannot be nested deeper than {DEPTH} levels"), span)
        } else {
            match self.converter.convert_with_local_state(latex, display) {
                Ok(result) => return result.mathml,
                Err(error) => {
                    let part = latex.get(error.0.clone()).unwrap_or_default().trim();
                    let (part, message, label) = (part.to_owned(), error.to_string(), error.label().to_owned());
                    let reason = Words::each(move |language| reason(&message, &label, &part, language));
                    let message = words!("the formula cannot be read: {reason}");
                    Diagnostic::error("math", message, span)
                }
            }
        };
        diagnostics.push(problem);
        format!("<code class=\"problem\">{}</code>", escaped(latex))
    }
}

/// Why a formula cannot be read: in English the message of the converter, elsewhere its label with the part that is meant.
fn reason(message: &str, label: &str, part: &str, language: Language) -> String {
    if language == Language::English {
        let mut letters = message.trim_end_matches('.').chars();
        return letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect());
    }
    let label = known(label, language);
    if part.is_empty() { label.to_owned() } else { say!(language, "{label}, “{part}”") }
}

/// The usual labels of the errors of the converter.
fn known(label: &str, language: Language) -> &'static str {
    match label {
        "a group was never closed" => language.say("a group was never closed"),
        "no matching opening for this" => language.say("no matching opening for this"),
        "expected an argument here" => language.say("expected an argument here"),
        "expected a delimiter here" => language.say("expected a delimiter here"),
        "disallowed character" => language.say("disallowed character"),
        "unknown environment" => language.say("unknown environment"),
        "unknown command" => language.say("unknown command"),
        "unknown color" => language.say("unknown color"),
        "expected a different environment name here" => language.say("expected a different environment name here"),
        "cannot be used here" => language.say("cannot be used here"),
        "duplicate" | "unexpected bound" => language.say("duplicate"),
        "this is not valid in text mode" => language.say("this is not valid in text mode"),
        "this is not valid in math mode" => language.say("this is not valid in math mode"),
        "limit exceeded" => language.say("limit exceeded"),
        _ => language.say("a part is not understood"),
    }
}

/// Upper bound of the nesting depth of `latex`: open groups, and commands and scripts without their argument.
fn nesting(latex: &str) -> usize {
    // For each open group, the number of commands whose argument has not come yet.
    let mut waiting = vec![0usize];
    let mut deepest = 0;
    let mut letters = latex.chars().peekable();
    let mut long_arguments = false;
    while let Some(letter) = letters.next() {
        match letter {
            '\\' => {
                let mut command = String::new();
                while let Some(next) = letters.next_if(char::is_ascii_alphabetic) {
                    command.push(next);
                }
                if command.is_empty() {
                    letters.next();
                }
                if matches!(command.as_str(), "left" | "begin") {
                    waiting.push(0);
                } else if matches!(command.as_str(), "right" | "end") {
                    close(&mut waiting);
                } else if let Some(count) = waiting.last_mut() {
                    *count += 1;
                    // `\frac1\frac1...` nests although there is text between the commands.
                    long_arguments |= takes_two(&command);
                }
            }
            '{' | '[' | '(' => waiting.push(0),
            '}' | ']' | ')' => close(&mut waiting),
            '^' | '_' | '\'' => waiting.last_mut().into_iter().for_each(|count| *count += 1),
            _ if letter.is_whitespace() || long_arguments => {}
            _ => waiting.last_mut().into_iter().for_each(|count| *count = 0),
        }
        deepest = deepest.max(waiting.len() - 1 + waiting.iter().sum::<usize>());
    }
    deepest
}

/// Ends a group, which is then the argument of the command before it.
fn close(waiting: &mut Vec<usize>) {
    if waiting.len() > 1 {
        waiting.pop();
    }
    if let Some(count) = waiting.last_mut() {
        *count = 0;
    }
}

fn takes_two(command: &str) -> bool {
    ["frac", "binom", "set", "rel", "mod"].iter().any(|part| command.contains(part))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(latex: &str) -> (String, Vec<String>) {
        let mut diagnostics = Vec::new();
        let html = Formulas::new().html(latex, MathDisplay::Inline, Span::new(0, 0), &mut diagnostics);
        (html, diagnostics.into_iter().map(|d| d.message.english()).collect())
    }

    #[test]
    fn formulas_become_mathml() {
        assert_eq!(
            html("y'' < 2"),
            ("<math><msup><mi>y</mi><mo>″</mo></msup><mo>&lt;</mo><mn>2</mn></math>".to_owned(), vec![])
        );
    }

    #[test]
    fn what_cannot_be_read_is_shown_as_it_is() {
        let (html, messages) = html("\\frac{<b>");
        assert_eq!(html, "<code class=\"problem\">\\frac{&lt;b&gt;</code>");
        assert_eq!(messages, ["the formula cannot be read: expected closing token \"}\", but reached end of input"]);
    }

    #[test]
    fn ordinary_formulas_are_not_too_deep() {
        for latex in [
            r"y(t) = e^{-\gamma t}\left(y_0\cos\omega_d t + \frac{v_0 + \gamma y_0}{\omega_d}\sin\omega_d t\right)",
            r"\omega_0 = \sqrt{\frac{2g}{L}}, \qquad \gamma = \frac{b}{2m}, \qquad \omega_d = \sqrt{\omega_0^2-\gamma^2}",
            r"\alpha\,\beta\,\gamma\,\delta",
            r"\begin{aligned} a &= \frac{1}{2} \\ b &= \frac{1}{3} \\ c &= \frac{1}{4}\end{aligned}",
        ] {
            assert!(nesting(latex) <= DEPTH, "{} {latex}", nesting(latex));
            assert_eq!(html(latex).1, [""; 0], "{latex}");
        }
    }

    #[test]
    fn deep_nesting_is_refused_before_it_is_tried() {
        for unit in [
            "{",
            "\\sqrt",
            "\\sqrt{",
            "x^{",
            "\\frac",
            "\\left(",
            "\\frac1{",
            "\\frac1",
            "\\hat",
            "\\mathbf{",
            "\\not",
            "\\begin{cases}",
            "\\overset{",
            "x_",
            "\\mathrm",
            "\\frac 1 ",
            "\\overset x",
            "\\sqrt[",
            "\\left",
            "\\hat ",
            "^\\hat",
        ] {
            let latex = unit.repeat(3_900 / unit.len());
            std::thread::Builder::new()
                .stack_size(1 << 20)
                .spawn(move || html(&latex))
                .unwrap()
                .join()
                .unwrap_or_else(|_| panic!("{unit}"));
        }
    }
}

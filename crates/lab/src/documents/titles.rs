//! Titles of diagnostics: a short description of the kind of error for each code. The sentence below the title
//! describes the particular case.

use units::Language;

/// Title for the code of a diagnostic.
pub fn title(code: &str, language: Language) -> &'static str {
    let (english, spanish) = of(code);
    language.pick(english, spanish)
}

fn of(code: &str) -> (&'static str, &'static str) {
    match code {
        // Units and dimensions.
        "dimension-mismatch" => ("Dimensions do not match", "Las dimensiones no concuerdan"),
        "type-mismatch" => ("Wrong kind of value", "Clase de valor incorrecta"),
        "undetermined-dimension" => ("The dimension is not determined", "La dimensión no está determinada"),
        "dimension-too-large" => ("The dimension is too large", "La dimensión es demasiado grande"),
        "missing-unit"
        | "unit-without-brackets"
        | "unit-without-number"
        | "unit-of-equation"
        | "unit-in-range"
        | "unit-in-exponent"
        | "unknown-unit"
        | "malformed-unit"
        | "ambiguous-unit"
        | "dimension-overflow"
        | "bare-number"
        | "bare-tolerance"
        | "radians"
        | "temperature-scale" => ("Units", "Unidades"),

        // Writing.
        "unclosed-parenthesis"
        | "unclosed-bracket"
        | "unclosed-brace"
        | "unmatched-parenthesis"
        | "unmatched-bracket"
        | "unmatched-brace"
        | "missing-parentheses"
        | "missing-braces"
        | "scene-brace" => ("Brackets do not match", "Los paréntesis no concuerdan"),
        "unclosed-text" => ("Quotation marks do not match", "Las comillas no concuerdan"),
        "malformed-number" | "number-too-large" | "not-a-number" | "decimal-comma" => ("Numbers", "Números"),
        "foreign-derivative" | "foreign-power" | "foreign-loop" | "argument-separator" => ("Notation", "Notación"),
        "unexpected-token"
        | "unexpected-character"
        | "unknown-word"
        | "semicolon"
        | "missing-expression"
        | "missing-equals"
        | "second-equals"
        | "missing-name"
        | "missing-operator"
        | "foreign-operator"
        | "foreign-comment"
        | "foreign-assignment"
        | "foreign-choice"
        | "foreign-name"
        | "missing-then"
        | "missing-else"
        | "equals-in-condition"
        | "chained-comparison"
        | "label-not-last"
        | "ambiguous-logarithm"
        | "index-after-primes"
        | "index-not-whole"
        | "index-range"
        | "size-value"
        | "size-range" => ("This cannot be read", "Esto no se puede leer"),

        // Names.
        "unknown-name" | "unknown-function" => ("Unknown name", "Nombre desconocido"),
        "wrong-argument-count" => ("Wrong number of arguments", "Número de argumentos incorrecto"),
        "duplicate-name"
        | "duplicate-key"
        | "duplicate-independent"
        | "duplicate-initial-value"
        | "duplicate-action" => ("Defined twice", "Definido dos veces"),
        "reserved-name" | "reserved-word" | "name-character" => {
            ("This name cannot be used", "Este nombre no se puede usar")
        }
        "component-of-number"
        | "component-at-start"
        | "component-defined"
        | "no-component"
        | "number-for-vector"
        | "number-in-vector-function"
        | "vector-and-number"
        | "vector-comparison"
        | "vector-components"
        | "vector-division"
        | "vector-for-number"
        | "vector-in-function"
        | "vector-power"
        | "vector-product" => ("Vectors", "Vectores"),
        "aggregate-inside" | "function-form" | "unused-argument" | "argument-without-name" => {
            ("Functions", "Funciones")
        }
        "table-comma" | "table-form" | "table-order" | "table-points" => ("Tables", "Tablas"),
        "not-a-choice" | "choice-form" | "choice-incomplete" | "switch-value" => {
            ("Switches and choices", "Interruptores y elecciones")
        }
        "draw-out-of-place" | "draw-without-seed" | "duplicate-seed" | "seed" => ("Chance", "Azar"),
        "counts-by" | "next-in-a-flow" | "next-value" | "duplicate-next" | "rate-in-a-map" => {
            ("Discrete steps", "Pasos discretos")
        }
        "group-name" | "empty-group" | "hidden-form" | "button-title" | "button-for" => ("Controls", "Controles"),
        "discrete-text" | "discrete-truth" | "discrete-without-value" => {
            ("Discrete quantities", "Magnitudes discretas")
        }
        "not-a-condition" => ("Conditions", "Condiciones"),
        "cycle" => ("Circular definition", "Definición circular"),
        "prime-after-expression" | "prime-of-constant" | "too-many-primes" => ("Derivatives", "Derivadas"),

        // Parameters, initial values, equations, events.
        "parameter-range"
        | "parameter-value"
        | "parameter-without-value"
        | "parameter-step"
        | "parameter-not-finite"
        | "default-out-of-range"
        | "empty-range"
        | "out-of-range"
        | "hidden-parameter"
        | "varies"
        | "vary"
        | "main" => ("Parameters", "Parámetros"),
        "assigned-form" | "assigned-out-of-range" | "assigned-step" | "assigned-values" | "assignment" => {
            ("Assigned values", "Valores asignados")
        }
        "missing-initial-value"
        | "initial-value-of-highest"
        | "initial-value-of-constant"
        | "initial-value-not-at-zero"
        | "initial-value-without-equation"
        | "initial-value-varies"
        | "initial-value-of-definition"
        | "initial-not-finite" => ("Initial values", "Valores iniciales"),
        "too-few-equations"
        | "too-many-equations"
        | "equations-dependent"
        | "singular-equations"
        | "coefficient-zero"
        | "nonlinear-highest-derivative"
        | "nothing-to-solve-for"
        | "order-too-high"
        | "not-second-order" => ("The equations cannot be solved", "Las ecuaciones no se pueden resolver"),
        "event-action"
        | "event-changes-no-state"
        | "event-at-equality"
        | "empty-event"
        | "true-at-the-start"
        | "set-twice"
        | "interval-of-zero"
        | "let-of-known-name" => ("Events", "Sucesos"),
        "sign-as-friction"
        | "friction-without-effect"
        | "friction-of-friction"
        | "friction-not-linear"
        | "friction-outside"
        | "friction-at-start" => ("Dry friction", "Rozamiento seco"),
        "too-large"
        | "model-too-large"
        | "too-deep"
        | "too-many-coupled-equations"
        | "too-many-events"
        | "too-many-switches" => ("Too large", "Demasiado grande"),

        // Document around the model.
        "no-model" => ("There is no model", "No hay modelo"),
        "front-matter" | "setting" | "unknown-key" | "empty-key" | "language" | "step-not-positive"
        | "unknown-method" | "bad-tolerance" => ("Settings at the top", "Ajustes del encabezado"),
        "fence" | "unknown-fence" => ("Blocks of the document", "Bloques del documento"),
        "translation" | "untranslated" => ("Translation", "Traducción"),
        "scene-syntax" | "scene-style" | "scene-refused" | "scene-definition" | "scene-point" => ("Scene", "Escena"),
        "plot-syntax" | "constant-abscissa" | "sweep" => ("Plots", "Gráficas"),
        "preset-syntax" => ("Presets", "Valores predefinidos"),
        "check-syntax" | "check-constant" | "true-by-definition" => ("Checks", "Comprobaciones"),
        "question-syntax" => ("Questions", "Preguntas"),
        "survey-syntax" => ("Survey", "Encuesta"),
        "link" | "image" | "raw-html" | "math" => ("Text", "Texto"),
        "more-findings" => ("More messages", "Más mensajes"),
        _ => ("The document", "El documento"),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    /// Collects the codes used in the sources below a folder.
    fn codes(folder: &Path, found: &mut Vec<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                codes(&path, found);
            } else {
                let text = std::fs::read_to_string(&path).unwrap();
                for start in ["Diagnostic::error(", "Diagnostic::warning("] {
                    let calls = text.split(start).skip(1).filter_map(|call| call.trim_start().strip_prefix('"'));
                    found.extend(calls.filter_map(|call| Some(call.split_once('"')?.0.to_owned())));
                }
            }
        }
    }

    #[test]
    fn every_code_has_a_title_of_its_own() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let mut found = Vec::new();
        ["model/src", "document/src"].iter().for_each(|folder| codes(&crates.join(folder), &mut found));
        assert!(found.len() > 100, "only {} codes were found", found.len());
        found.retain(|code| super::of(code) == super::of("no such code"));
        assert!(found.is_empty(), "{found:?}");
    }
}

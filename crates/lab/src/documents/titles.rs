//! Titles of diagnostics: a short description of the kind of error for each code. The sentence below the title
//! describes the particular case.

use units::Language;

/// Title for the code of a diagnostic.
pub fn title(code: &str, language: Language) -> &'static str {
    match code {
        // Units and dimensions.
        "dimension-mismatch" => language.say("Dimensions do not match"),
        "type-mismatch" => language.say("Wrong kind of value"),
        "undetermined-dimension" => language.say("The dimension is not determined"),
        "dimension-too-large" => language.say("The dimension is too large"),
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
        | "cycles-in-sine"
        | "temperature-scale" => language.say("Units"),

        // Writing.
        "unclosed-parenthesis"
        | "unclosed-bracket"
        | "unclosed-brace"
        | "unmatched-parenthesis"
        | "unmatched-bracket"
        | "unmatched-brace"
        | "missing-parentheses"
        | "missing-braces"
        | "scene-brace" => language.say("Brackets do not match"),
        "unclosed-text" => language.say("Quotation marks do not match"),
        "malformed-number" | "number-too-large" | "not-a-number" | "decimal-comma" => language.say("Numbers"),
        "foreign-derivative" | "foreign-power" | "foreign-loop" | "argument-separator" => language.say("Notation"),
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
        | "size-range" => language.say("This cannot be read"),

        // Names.
        "unknown-name" | "unknown-function" => language.say("Unknown name"),
        "wrong-argument-count" => language.say("Wrong number of arguments"),
        "duplicate-name"
        | "duplicate-key"
        | "duplicate-independent"
        | "duplicate-initial-value"
        | "duplicate-action" => language.say("Defined twice"),
        "reserved-name" | "reserved-word" | "name-character" => language.say("This name cannot be used"),
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
        | "vector-product" => language.say("Vectors"),
        "aggregate-inside" | "function-form" | "unused-argument" | "argument-without-name" => language.say("Functions"),
        "table-comma" | "table-form" | "table-order" | "table-points" => language.say("Tables"),
        "not-a-choice" | "choice-form" | "choice-incomplete" | "switch-value" => language.say("Switches and choices"),
        "draw-out-of-place" | "draw-without-seed" | "duplicate-seed" | "seed" => language.say("Chance"),
        "counts-by" | "next-in-a-flow" | "next-value" | "duplicate-next" | "rate-in-a-map" => {
            language.say("Discrete steps")
        }
        "group-name" | "empty-group" | "hidden-form" | "button-title" | "button-for" => language.say("Controls"),
        "discrete-text" | "discrete-truth" | "discrete-without-value" => language.say("Discrete quantities"),
        "not-a-condition" => language.say("Conditions"),
        "cycle" => language.say("Circular definition"),
        "prime-after-expression" | "prime-of-constant" | "too-many-primes" => language.say("Derivatives"),

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
        | "main" => language.say("Parameters"),
        "assigned-form" | "assigned-out-of-range" | "assigned-step" | "assigned-values" | "assignment" => {
            language.say("Assigned values")
        }
        "missing-initial-value"
        | "initial-value-of-highest"
        | "initial-value-of-constant"
        | "initial-value-not-at-zero"
        | "initial-value-without-equation"
        | "initial-value-varies"
        | "initial-value-of-definition"
        | "initial-not-finite" => language.say("Initial values"),
        "too-few-equations"
        | "too-many-equations"
        | "equations-dependent"
        | "singular-equations"
        | "coefficient-zero"
        | "nonlinear-highest-derivative"
        | "nothing-to-solve-for"
        | "order-too-high"
        | "not-second-order" => language.say("The equations cannot be solved"),
        "event-action"
        | "event-changes-no-state"
        | "event-at-equality"
        | "empty-event"
        | "true-at-the-start"
        | "set-twice"
        | "interval-of-zero"
        | "let-of-known-name" => language.say("Events"),
        "sign-as-friction"
        | "friction-without-effect"
        | "friction-of-friction"
        | "friction-not-linear"
        | "friction-outside"
        | "friction-at-start" => language.say("Dry friction"),
        "too-large"
        | "model-too-large"
        | "too-deep"
        | "too-many-coupled-equations"
        | "too-many-events"
        | "too-many-switches" => language.say("Too large"),

        // Document around the model.
        "no-model" => language.say("There is no model"),
        "front-matter" | "setting" | "unknown-key" | "empty-key" | "language" | "step-not-positive"
        | "unknown-method" | "bad-tolerance" => language.say("Settings at the top"),
        "fence" | "unknown-fence" => language.say("Blocks of the document"),
        "translation" | "untranslated" => language.say("Translation"),
        "scene-syntax" | "scene-style" | "scene-refused" | "scene-definition" | "scene-point" | "clip-shapes" => {
            language.say("Scene")
        }
        "plot-syntax" | "constant-abscissa" | "sweep" => language.say("Plots"),
        "preset-syntax" => language.say("Presets"),
        "check-syntax" | "check-constant" | "true-by-definition" => language.say("Checks"),
        "question-syntax" => language.say("Questions"),
        "survey-syntax" => language.say("Survey"),
        "link" | "image" | "raw-html" | "math" => language.say("Text"),
        "more-findings" => language.say("More messages"),
        _ => language.say("The document"),
    }
}

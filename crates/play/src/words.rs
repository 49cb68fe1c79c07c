//! Texts of this crate in every language. Texts of the document are translated by the document.

use crate::{Announcement, Basis, Grade, Refusal, TimeLine};
use engine::Method;
use units::Language;

/// Name of a run with the document's own values.
pub fn defaults(language: Language) -> &'static str {
    language.pick("initial settings", "ajustes iniciales")
}

/// Text of a truth value.
pub fn truth(language: Language, value: bool) -> &'static str {
    if value { language.pick("yes", "sí") } else { language.pick("no", "no") }
}

/// Label of the readout of a dry friction.
pub fn dry_friction(language: Language) -> &'static str {
    language.pick("Dry friction", "Rozamiento seco")
}

/// State of a dry friction: sticking or slipping.
pub fn sticks(language: Language, sticks: bool) -> &'static str {
    if sticks { language.pick("sticks", "adherido") } else { language.pick("slips", "desliza") }
}

/// Name of an integration method.
pub fn method_name(language: Language, method: Method) -> &'static str {
    match method {
        Method::Euler => "Euler",
        Method::EulerRichardson => "Euler-Richardson",
        Method::VelocityVerlet => language.pick("velocity Verlet", "Verlet de velocidades"),
        Method::RungeKutta4 => language.pick("Runge-Kutta, order 4", "Runge-Kutta, orden 4"),
        Method::DormandPrince => language.pick("Dormand-Prince 5(4), adaptive", "Dormand-Prince 5(4), adaptativo"),
        Method::Rosenbrock => language.pick("Rosenbrock (RODAS), stiff", "Rosenbrock (RODAS), rígido"),
    }
}

/// Description of a plot.
pub fn against(language: Language, curves: &str, x: &str) -> String {
    language.pick(format!("{curves} against {x}."), format!("{curves} frente a {x}."))
}

/// Label of the vertical axis of a histogram.
pub fn count(language: Language) -> &'static str {
    language.pick("Count", "Frecuencia")
}

/// Description of a histogram.
pub fn counted(language: Language, values: &str, over_run: bool) -> String {
    match over_run {
        true => language
            .pick(format!("Histogram of {values} over the run."), format!("Histograma de {values} durante el ensayo.")),
        false => language.pick(
            format!("Histogram of {values} at the moment shown."),
            format!("Histograma de {values} en el instante mostrado."),
        ),
    }
}

/// Progress of the runs of a sweep plot.
pub fn runs_complete(language: Language, done: usize, all: usize) -> String {
    language.pick(format!("{done} of {all} runs"), format!("{done} de {all} ensayos"))
}

/// Axis label of the deviation from a claim.
pub fn deviation(language: Language, relative: bool) -> &'static str {
    match relative {
        true => language.pick("relative deviation", "desviación relativa"),
        false => language.pick("deviation", "desviación"),
    }
}

/// Name of the ghost run.
pub fn previous_run(language: Language) -> &'static str {
    language.pick("previous run", "ensayo anterior")
}

/// Name of a kept run in a list of other items.
pub fn kept_run(language: Language, name: &str) -> String {
    language.pick(format!("the kept run “{name}”"), format!("el ensayo guardado «{name}»"))
}

/// Name of the time of a run in a list of other items.
pub fn time(language: Language, time: &str) -> String {
    language.pick(format!("the time {time}"), format!("el tiempo {time}"))
}

/// Name of an answer in a list of other items.
pub fn answer(language: Language, typed: &str) -> String {
    language.pick(format!("the answer “{typed}”"), format!("la respuesta «{typed}»"))
}

/// Placeholder for a value hidden by a question.
pub fn hidden(language: Language) -> &'static str {
    language.pick("hidden", "oculto")
}

/// Comment on the error stated with an answer. `within`: true if the true value lies within that error.
pub fn stated_error(language: Language, correct: bool, within: bool) -> &'static str {
    match (correct, within) {
        (true, true) => {
            language.pick("The true value lies within your error.", "El valor verdadero está dentro de tu error.")
        }
        (true, false) => language.pick(
            "But the true value lies outside your error: it is too small.",
            "Pero el valor verdadero queda fuera de tu error, que es demasiado pequeño.",
        ),
        (false, true) => language.pick(
            "Your error covers the true value, but the value itself is what counts.",
            "Tu error abarca el valor verdadero, pero lo que cuenta es el valor mismo.",
        ),
        (false, false) => {
            language.pick("The true value lies outside your error.", "El valor verdadero queda fuera de tu error.")
        }
    }
}

/// Text of a grade.
pub fn grade(language: Language, grade: Grade) -> &'static str {
    match grade {
        Grade::Correct => language.pick("Correct.", "Correcto."),
        Grade::Close => {
            language.pick("Close, but not close enough. Measure again.", "Cerca, pero no lo suficiente. Mide otra vez.")
        }
        Grade::WrongSign => {
            language.pick("The size is right; think about the sign.", "El tamaño es correcto; piensa en el signo.")
        }
        Grade::WrongScale => language.pick(
            "The digits are right, but not the power of ten. Check the unit.",
            "Las cifras son correctas, pero no la potencia de diez. Revisa la unidad.",
        ),
        Grade::Wrong => language.pick("Not yet.", "Todavía no."),
        Grade::Unreadable => language.pick("This is not a number.", "Esto no es un número."),
        Grade::Unanswerable => language.pick(
            "With the present parameters this has no answer.",
            "Con los parámetros actuales esto no tiene respuesta.",
        ),
    }
}

/// Text of a refusal.
pub fn refusal_text(language: Language, refusal: &Refusal) -> String {
    match refusal {
        Refusal::NotANumber { typed } if typed.is_empty() => {
            language.pick("Type a number.", "Escribe un número.").to_owned()
        }
        Refusal::NotANumber { typed } => {
            language.pick(format!("“{typed}” is not a number."), format!("«{typed}» no es un número."))
        }
        Refusal::UnknownUnit { typed } => {
            language.pick(format!("“{typed}” is not a known unit."), format!("«{typed}» no es una unidad conocida."))
        }
        Refusal::OtherFrequency { typed, meant, angular: true } => language.pick(
            format!("{typed} is a frequency; the angular frequency is {meant}."),
            format!("{typed} es una frecuencia; la frecuencia angular es {meant}."),
        ),
        Refusal::OtherFrequency { typed, meant, angular: false } => language.pick(
            format!("{typed} is an angular frequency; the frequency is {meant}."),
            format!("{typed} es una frecuencia angular; la frecuencia es {meant}."),
        ),
        Refusal::NameInAnswer { name } => language.pick(
            format!("An answer consists of numbers and units; “{name}” is a quantity of the simulation."),
            format!("Una respuesta consta de números y unidades; «{name}» es una magnitud de la simulación."),
        ),
        Refusal::WrongUnit { typed, expected } if expected.is_empty() => language.pick(
            format!("{typed} measures something else; this is a pure number."),
            format!("{typed} mide otra cosa; esto es un número puro."),
        ),
        Refusal::WrongUnit { typed, expected } => language.pick(
            format!("{typed} measures something else; a unit such as {expected} is needed."),
            format!("{typed} mide otra cosa; hace falta una unidad como {expected}."),
        ),
        Refusal::TooSmall { name, least } => {
            language.pick(format!("{name}: at least {least}."), format!("{name}: como mínimo {least}."))
        }
        Refusal::TooLarge { name, greatest } => {
            language.pick(format!("{name}: at most {greatest}."), format!("{name}: como máximo {greatest}."))
        }
        Refusal::NoValue { name } => {
            language.pick(format!("{name} would have no finite value."), format!("{name} no tendría un valor finito."))
        }
        Refusal::NotPositive => {
            language.pick("It must be greater than zero.", "Tiene que ser mayor que cero.").to_owned()
        }
        Refusal::NotPaused => {
            language.pick("Pause first, then set the state.", "Pausa primero y luego cambia el estado.").to_owned()
        }
        Refusal::RunEnded => language
            .pick(
                "The run has ended here. Go on, go back in time or back to the start.",
                "El ensayo termina aquí. Continúa, retrocede en el tiempo o vuelve al inicio.",
            )
            .to_owned(),
        Refusal::TooManyPresses { most } => language.pick(
            format!("{most} presses in one run are the most. Go back to the start."),
            format!("En un ensayo caben {most} pulsaciones. Vuelve al inicio."),
        ),
        Refusal::Method { method } => {
            let name = method_name(language, *method);
            language.pick(
                format!("{name} is for equations of second order only."),
                format!("{name} solo sirve para ecuaciones de segundo orden."),
            )
        }
        Refusal::TooManyRuns { most } => language.pick(
            format!("{most} runs are kept already; remove one first."),
            format!("Ya hay {most} ensayos guardados; quita uno primero."),
        ),
        Refusal::Unknown { name } => {
            language.pick(format!("There is no “{name}” here."), format!("Aquí no hay «{name}»."))
        }
        Refusal::UnreadableState => language
            .pick(
                "The link was not understood; the document opens as it is.",
                "No se entendió el enlace; el documento se abre tal como es.",
            )
            .to_owned(),
        Refusal::DocumentTooLong => language.pick(
            "The document in this link is too long. Ask for its file and open that.",
            "El documento de este enlace es demasiado largo. Pide el archivo y ábrelo.",
        ).to_owned(),
        Refusal::DocumentNeeded { name } => language.pick(
            format!("This link is about the document {name}, which is not in this page. Open that file, and you will see what the link shows."),
            format!("Este enlace trata del documento {name}, que no está en esta página. Abre ese archivo y verás lo que muestra el enlace."),
        ),
        Refusal::NoSeat => language
            .pick(
                "A seat is a whole number from 1, as your teacher has given it to you.",
                "Un puesto es un número entero desde 1, el que te dio tu docente.",
            )
            .to_owned(),
        Refusal::PartlyRestored { left_out } => {
            let parts = left_out.join(", ");
            language.pick(
                format!("Parts of the link do not fit this document and were left out: {parts}."),
                format!("Partes del enlace no encajan en este documento y se omitieron: {parts}."),
            )
        }
    }
}

impl Announcement {
    /// Text in the chosen language.
    pub fn text(&self, basis: &Basis, line: &TimeLine) -> String {
        let say = |english: &str, spanish: &str| basis.language().pick(english, spanish).to_owned();
        let with = |english: &str, spanish: &str, value: &str| say(english, spanish).replace("{}", value);
        let time = |time: f64| basis.time_words(line.course(), time);
        match self {
            Announcement::Playing => say("Playing", "En marcha"),
            Announcement::Paused(at) => with("Paused at {}", "En pausa en {}", &time(*at)),
            Announcement::Ended(at) => with(
                "The run ends at {}; press Play to continue",
                "El ensayo termina en {}; pulsa Reproducir para continuar",
                &time(*at),
            ),
            Announcement::Stepped(at) => with("Step, {}", "Paso, {}", &time(*at)),
            Announcement::Scrubbed(at) => time(*at),
            Announcement::BackAtStart if line.course().begun().start.is_some() => {
                say("Back at the start that was set by hand", "De vuelta en el inicio fijado a mano")
            }
            Announcement::BackAtStart => say("Back at the start", "De vuelta en el inicio"),
            Announcement::Restarted(index) => with(
                "The run starts again: {} changed",
                "El ensayo comienza de nuevo: cambió {}",
                basis.parameter_label(*index),
            ),
            Announcement::ParameterSet(index, value) => {
                let value = basis.parameter_value_text(*index, *value);
                format!("{}: {value}", basis.parameter_label(*index))
            }
            Announcement::Drawn(index) => with(
                "The run starts again: {} drawn",
                "El ensayo comienza de nuevo: se dibujó {}",
                &basis.drawing_label(*index),
            ),
            Announcement::DrawingCleared(index) => {
                with("{}: as in the document", "{}: como en el documento", &basis.drawing_label(*index))
            }
            Announcement::Pressed(button, at) => {
                let title = basis.model().buttons.get(*button).map_or("", |button| basis.text(&button.title));
                format!("{title}, {}", time(*at))
            }
            Announcement::DefaultsRestored => say(
                "Defaults restored: parameters and start are those of the document",
                "Valores restaurados: los parámetros y el inicio son los del documento",
            ),
            Announcement::Preset(index) => {
                basis.program().presets.get(*index).map_or("", |preset| basis.text(&preset.name)).to_owned()
            }
            Announcement::StateSet(index, value) => {
                let unit = basis.model().states.get(*index).map(|state| &state.unit);
                let value = unit.map_or_else(String::new, |unit| basis.quantity_text(*value, unit));
                let label = basis.state_label(*index);
                with("{}; the run starts from there", "{}; el ensayo parte de ahí", &format!("{label}: {value}"))
            }
            Announcement::StartSet { state, value, before } => {
                let changed = basis.parameters(line.course()).into_iter();
                let changed = changed.filter(|now| before.get(now.index).is_some_and(|before| now.value != *before));
                let changed: Vec<String> = changed.map(|now| format!("{}: {}", now.label, now.spoken)).collect();
                let unit = basis.model().states.get(*state).map(|state| &state.unit);
                let value = unit.map_or_else(String::new, |unit| basis.quantity_text(*value, unit));
                format!("{}: {value}; {}", basis.state_label(*state), changed.join(", "))
            }
            Announcement::Speed(speed) => with("Speed {}", "Velocidad {}", &line.speed_text(basis, *speed)),
            Announcement::Kept(name) => with("Run kept: {}", "Ensayo guardado: {}", name),
            Announcement::Removed(name) => with("Run removed: {}", "Ensayo quitado: {}", name),
            Announcement::Undone => say("Undone", "Deshecho"),
            Announcement::Full => say("Paused: the recording is full", "En pausa: el registro está lleno"),
            Announcement::Failed => {
                let failure = || line.problem(basis).map(|problem| problem.message);
                line.ending(basis).or_else(failure).unwrap_or_default()
            }
            Announcement::Method(method) => with("Method: {}", "Método: {}", method_name(basis.language(), *method)),
            Announcement::Step(step) => {
                with("Step: {}", "Paso: {}", &basis.quantity_text(*step, &basis.model().independent.unit))
            }
            Announcement::QuestionSetup(_) => {
                say("Parameters set for the question", "Parámetros ajustados para la pregunta")
            }
            Announcement::Resized(lost) => {
                let size = |size: crate::SizeView| format!("{}: {}", size.label, size.value);
                let sizes = basis.sizes().into_iter().map(size).collect::<Vec<_>>().join(", ");
                match lost.as_slice() {
                    [] => sizes,
                    lost => with(
                        &format!("{sizes}; dropped, because it does not fit: {{}}"),
                        &format!("{sizes}; se omitió lo que no encaja: {{}}"),
                        &lost.join(", "),
                    ),
                }
            }
            Announcement::Replaced(lost) if lost.is_empty() => {
                say("The changed document runs", "El documento cambiado está en marcha")
            }
            Announcement::Replaced(lost) => with(
                "The changed document runs; dropped, because it does not fit: {}",
                "El documento cambiado está en marcha; se omitió lo que no encaja: {}",
                &lost.join(", "),
            ),
            Announcement::Seated(Some(seat)) => with(
                "Seat {}: your own values are set",
                "Puesto {}: tus propios valores están puestos",
                &seat.to_string(),
            ),
            Announcement::Seated(None) => {
                say("No seat: the values of the document are set", "Sin puesto: están los valores del documento")
            }
            Announcement::Restored => say("The saved state is back", "Se recuperó el estado guardado"),
        }
    }
}

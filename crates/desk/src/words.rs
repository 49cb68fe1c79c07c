//! Texts about measuring and fitting in every language.

use crate::fits::NothingFound;
use crate::{Announcement, Desk, Refusal};
use analysis::fit::FitError;
use units::Language;

/// Title and description of the plot of the residuals.
pub(crate) fn residuals(language: Language) -> (&'static str, &'static str) {
    language.pick(
        ("Residuals", "measured minus computed, against time."),
        ("Residuos", "lo medido menos lo calculado, frente al tiempo."),
    )
}

/// Labels of the zeros of the clock and of the scale.
pub(crate) fn zeros(language: Language) -> [&'static str; 2] {
    language.pick(["Time offset", "Offset of the readings"], ["Desfase temporal", "Desfase de las lecturas"])
}

/// Instructions to repeat a fit made on the page. `several`: true for several records.
pub(crate) fn how_to_repeat(language: Language, several: bool) -> &'static str {
    if several {
        return language.pick(
            "Made in the laboratory's page: open the document, drop the records, tick those to be fitted together, press Fit.",
            "Hecho en la página del laboratorio: abre el documento, suelta los registros, marca los que se ajustan juntos y pulsa Ajustar.",
        );
    }
    language.pick(
        "Made in the laboratory's page: open the document, drop the record, press Fit.",
        "Hecho en la página del laboratorio: abre el documento, suelta el registro y pulsa Ajustar.",
    )
}

pub(crate) fn record(language: Language) -> &'static str {
    language.pick("record", "registro")
}

/// Text for a search that did not converge.
pub(crate) fn not_converged(language: Language) -> &'static str {
    language.pick("The fit did not converge.", "El ajuste no ha convergido.")
}

/// Text for a fitted curve that is not finite.
pub(crate) fn not_finite(language: Language) -> &'static str {
    language.pick("The fitted curve is not finite.", "La curva ajustada no es finita.")
}

/// Text for estimates at a bound of their range.
pub(crate) fn stopped(language: Language, names: &str) -> String {
    language.pick(
        format!("The search has stopped at an end of the range: {names}."),
        format!("La búsqueda se ha detenido en un extremo del intervalo: {names}."),
    )
}

/// Text for a curve that does not follow the data.
pub(crate) fn missed(language: Language) -> &'static str {
    language.pick("The model does not describe these data.", "El modelo no describe estos datos.")
}

/// Text for a fit that is dominated by outliers.
pub(crate) fn misled(language: Language) -> &'static str {
    language.pick("Outliers dominate the fit.", "Los valores atípicos dominan el ajuste.")
}

/// Text for a fitted curve that oscillates faster than the samples can show (aliasing).
pub(crate) fn undersampled(language: Language) -> &'static str {
    language.pick(
        "The curve oscillates faster than the samples can show.",
        "La curva oscila más rápido de lo que las muestras pueden mostrar.",
    )
}

/// Text about the clock reading at which the initial values hold. `early`: number of values before it.
pub(crate) fn initial_values_hold(language: Language, at: &str, early: usize) -> String {
    let mut text = language
        .pick(format!("The initial values refer to {at}."), format!("Los valores iniciales corresponden a {at}."));
    if early > 0 {
        text += &language.pick(
            format!(" Nothing is predicted of the {early} values before."),
            format!(" De los {early} valores anteriores no se predice nada."),
        );
    }
    text
}

/// Sentences about the observations that were weighted with standard errors from the record, one per record.
pub(crate) fn given_errors(language: Language, task: &analysis::fit::Task) -> Vec<String> {
    let with_errors = |record: &analysis::fit::Record| {
        let known = record.observations.iter().filter(|one| one.errors.is_some()).map(|one| one.name.clone());
        (record.name.clone(), known.collect::<Vec<String>>().join(", "))
    };
    let sentence = |(record, names): (String, String)| {
        language.pick(
            format!(
                "{record}: the values of {names} are weighted by the standard errors that stand beside them in the record."
            ),
            format!(
                "{record}: los valores de {names} se ponderan con los errores estándar que están junto a ellos en el registro."
            ),
        )
    };
    task.records.iter().map(with_errors).filter(|(_, names)| !names.is_empty()).map(sentence).collect()
}

/// Text for standard errors that were ignored because some are missing. The last argument is the number of missing ones
/// and of all rows.
pub(crate) fn missing_errors(language: Language, record: &str, name: &str, (missing, rows): (usize, usize)) -> String {
    language.pick(
        format!(
            "{record}: {missing} of {rows} values of {name} have no standard error beside them, so the fit weighs all values equally. \
             Complete their column or remove these rows."
        ),
        format!(
            "{record}: {missing} de {rows} valores de {name} no tienen un error estándar a su lado, así que el ajuste pondera todos los \
             valores por igual. Completa su columna o quita esas filas."
        ),
    )
}

/// Text for a number that the data do not determine.
pub(crate) fn undetermined(language: Language) -> &'static str {
    language.pick("not determined by the data", "los datos no lo determinan")
}

/// True value of a virtual measurement, and the deviation of the estimate in standard errors.
pub(crate) fn truth_is(language: Language, truth: &str, off: Option<&str>) -> String {
    let off = off.map(|off| language.pick(format!("; deviation {off} σ"), format!("; desviación {off} σ")));
    let off = off.unwrap_or_default();
    language.pick(format!("true value: {truth}{off}"), format!("valor verdadero: {truth}{off}"))
}

pub(crate) fn run(language: Language) -> &'static str {
    language.pick("run", "ensayo")
}

/// Reason why a fit cannot be made.
pub(crate) fn fit_error(language: Language, error: &FitError) -> String {
    let text = match error {
        FitError::NothingVaried => language.pick("Tick what is to be varied.", "Marca lo que debe variar."),
        FitError::NothingObserved => language.pick(
            "No column is ticked for the fit, or none of its values lies between the two times.",
            "Ninguna columna está marcada para el ajuste, o ninguno de sus valores cae entre los dos tiempos.",
        ),
        FitError::TooFew { values, varied } => {
            return language.pick(
                format!("{values} values cannot determine {varied} numbers."),
                format!("{values} valores no pueden determinar {varied} números."),
            );
        }
        FitError::TooLarge => language.pick(
            "There are too many values or too many varied numbers.",
            "Hay demasiados valores o demasiados números que varían.",
        ),
        FitError::VariedTwice(_) | FitError::BadBounds(_) => {
            language.pick("The ranges leave no room.", "Los intervalos no dejan sitio.")
        }
        FitError::BadStart(_) | FitError::BadValue(_) => language.pick(
            "The value of a parameter is not a finite number.",
            "El valor de un parámetro no es un número finito.",
        ),
        FitError::BadScaleError(_) => language.pick(
            "The standard error of the film's scale is not greater than 0.",
            "El error estándar de la escala del vídeo no es mayor que 0.",
        ),
        FitError::BadErrors { count, .. } => {
            return language.pick(
                format!("{count} values have a standard error that is missing or not greater than 0."),
                format!("{count} valores tienen un error estándar que falta o no es mayor que 0."),
            );
        }
        FitError::RecordEmpty(_) => language.pick(
            "None of its values lies between the two times.",
            "Ninguno de sus valores cae entre los dos tiempos.",
        ),
        FitError::Model(message) => return message.text(language).to_owned(),
    };
    text.to_owned()
}

impl Desk {
    /// Text of a refusal in the chosen language.
    pub fn refusal_text(&self, refusal: &Refusal) -> String {
        let language = self.play.language();
        match refusal {
            Refusal::Play(refusal) => self.play.basis().refusal_text(refusal),
            Refusal::TooManyRecords { most } => language.pick(
                format!("{most} records are open already; remove one first."),
                format!("Ya hay {most} registros abiertos; quita uno primero."),
            ),
            Refusal::RecordTooLong { most } => language.pick(
                format!("The page reads records of up to {most} MiB; the program reads longer ones."),
                format!("La página lee registros de hasta {most} MiB; el programa lee otros más largos."),
            ),
            Refusal::UnreadableRecord { name, why } => {
                language.pick(format!("{name} could not be read. {why}"), format!("No se pudo leer {name}. {why}"))
            }
            Refusal::NoSuchPolynomial => language
                .pick(
                    "There is no such polynomial: the window is an odd number of rows up to ROWS, the degree is from 2 to 7 and below it.",
                    "No existe tal polinomio: la ventana es un número impar de filas hasta ROWS, y el grado va de 2 a 7 y es menor que \
                     ella.",
                )
                .replace("ROWS", &analysis::smoothing::WIDEST.to_string()),
            Refusal::NoDerivative => language
                .pick(
                    "No row has the neighbours that a derivative needs. Times must ascend; uneven ones can be smoothed by polynomials.",
                    "Ninguna fila tiene los vecinos que necesita una derivada. Los tiempos deben crecer; los irregulares se pueden suavizar con polinomios.",
                )
                .to_owned(),
            Refusal::Fit { why } | Refusal::Film { why } => why.clone(),
            Refusal::Size { why } => units::sentence(why),
        }
    }

    /// Text of an announcement in the chosen language.
    pub fn announcement_text(&self, announcement: &Announcement) -> String {
        let say = |english: &str, spanish: &str| self.play.language().pick(english, spanish).to_owned();
        let with = |english: &str, spanish: &str, value: &str| say(english, spanish).replace("{}", value);
        match announcement {
            Announcement::Play(announcement) => announcement.text(self.play.basis(), self.play.time_line()),
            Announcement::RecordAdded(name) => with("Record read: {}", "Registro leído: {}", name),
            Announcement::DerivativesMade(name) => {
                with("Velocity and acceleration made: {}", "Velocidad y aceleración calculadas: {}", name)
            }
            Announcement::FilmTracked => say("The film has been tracked", "El vídeo se ha seguido"),
            Announcement::RecordCancelled(name) => with("Not read: {}", "No se ha leído: {}", name),
            Announcement::RecordRemoved(name) => with("Record removed: {}", "Registro quitado: {}", name),
            Announcement::FitRemoved(theory) => with("Fit removed: {}", "Ajuste quitado: {}", theory),
            Announcement::FitFinished(None) => say("The fit is finished", "El ajuste ha terminado"),
            Announcement::FitFinished(Some(doubt)) => with(
                "The fit is finished, and the parameters keep their values. {} Press Show in the results to see the curve.",
                "El ajuste ha terminado y los parámetros conservan sus valores. {} Pulsa Mostrar en los resultados para ver la curva.",
                doubt,
            ),
            Announcement::TheoriesLeftOut(which) => with("Not fitted: {}", "Sin ajustar: {}", which),
            Announcement::FitFailed(NothingFound::NoCurve) => say(
                "The model has no finite curve at any start: nothing was found",
                "El modelo no tiene una curva finita desde ningún comienzo: no se encontró nada",
            ),
            Announcement::FitFailed(NothingFound::TooManySteps) => say(
                "Wherever it was tried, the model needs too many steps for this record: nothing was found. Fit a shorter part, or \
                 narrow the ranges of the parameters",
                "Donde se probó, el modelo necesita demasiados pasos para este registro: no se encontró nada. Ajusta una parte más \
                 corta o estrecha los intervalos de los parámetros",
            ),
            Announcement::FitCancelled => say("Fit cancelled", "Ajuste cancelado"),
            Announcement::FitApplied(record) if record.is_empty() => {
                say("The parameters have the fitted values", "Los parámetros tienen los valores ajustados")
            }
            Announcement::FitApplied(record) => with(
                "The parameters have the fitted values of {}",
                "Los parámetros tienen los valores ajustados de {}",
                record,
            ),
        }
    }
}

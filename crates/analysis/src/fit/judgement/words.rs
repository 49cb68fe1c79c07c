//! Sentences about the result of a fit.

use super::verdict::{Size, Verdict};
use crate::fit::outcome::Outcome;
use crate::fit::uncertainty::estimate::Estimate;
use units::Language::{self, English, Spanish};

impl Outcome {
    /// Verdict on the model, in a few sentences.
    pub fn verdict_text(&self, language: Language) -> String {
        let verdict = self.verdict();
        let text = match (verdict, language) {
            (Verdict::Exact, English) => {
                "The fit is exact: the residuals are less than a billionth of the scatter of the values. AICc and BIC are those \
                 of residuals of that size."
            }
            (Verdict::Exact, Spanish) => {
                "El ajuste es exacto: los residuos son menores que una milmillonésima parte de la dispersión de los valores. El \
                 AICc y el BIC son los de residuos de ese tamaño."
            }
            (Verdict::Saturated, English) => {
                "There are as many values as parameters: the curve can pass through all of them, and the fit is no test of the model."
            }
            (Verdict::Saturated, Spanish) => {
                "Hay tantos valores como parámetros: la curva puede pasar por todos ellos, y el ajuste no pone a prueba el modelo."
            }
            (Verdict::Misled, English) => "The residuals cannot be used to judge the model: outliers dominate the fit.",
            (Verdict::Misled, Spanish) => {
                "Los residuos no sirven para juzgar el modelo: los valores atípicos dominan el ajuste."
            }
            (Verdict::Compatible, English) => "The residuals look random: the model is compatible with the data.",
            (Verdict::Compatible, Spanish) => "Los residuos parecen aleatorios: el modelo es compatible con los datos.",
            (Verdict::TooLarge, English) => {
                "The residuals look random, but they are larger than the given errors: these are too small, or the model misses \
                 something."
            }
            (Verdict::TooLarge, Spanish) => {
                "Los residuos parecen aleatorios, pero son mayores que los errores dados: estos son demasiado pequeños o al \
                 modelo le falta algo."
            }
            (Verdict::TooSmall, English) => {
                "The residuals look random, but they are smaller than the given errors: these are too large."
            }
            (Verdict::TooSmall, Spanish) => {
                "Los residuos parecen aleatorios, pero son menores que los errores dados: estos son demasiado grandes."
            }
            (Verdict::Structured, English) => {
                "The residuals are autocorrelated: the model, or the measurement, misses something. Use the standard errors that \
                 allow for it."
            }
            (Verdict::Structured, Spanish) => {
                "Los residuos están autocorrelacionados: al modelo, o a la medición, le falta algo. Usa los errores estándar que \
                 lo tienen en cuenta."
            }
            (Verdict::Alternating, English) => {
                "Neighbouring residuals tend to have opposite signs (negative autocorrelation): the model, or the measurement, \
                 misses something that changes from one value to the next. Use the larger one of the two standard errors."
            }
            (Verdict::Alternating, Spanish) => {
                "Los residuos vecinos tienden a tener signos opuestos (autocorrelación negativa): al modelo, o a la medición, le \
                 falta algo que cambia de un valor al siguiente. Usa el mayor de los dos errores estándar."
            }
            (Verdict::Nothing, English) => {
                "The residuals look random, but the curve explains no more of the data than chance would: a constant fits as \
                 well. Its parameters mean nothing."
            }
            (Verdict::Nothing, Spanish) => {
                "Los residuos parecen aleatorios, pero la curva no explica de los datos más que el azar: una constante ajusta \
                 igual de bien. Sus parámetros no significan nada."
            }
            (Verdict::Missed, English) => {
                "The curve explains less than half of the variance of the data, and the residuals are autocorrelated: the model \
                 does not describe these data. Begin from values that are nearer, widen the ranges of the parameters, or try \
                 another theory."
            }
            (Verdict::Missed, Spanish) => {
                "La curva explica menos de la mitad de la varianza de los datos, y los residuos están autocorrelacionados: el \
                 modelo no describe estos datos. Empieza con valores más cercanos, amplía los intervalos de los \
                 parámetros o prueba otra teoría."
            }
            (Verdict::Unknown, English) => "There are too few values to judge the residuals.",
            (Verdict::Unknown, Spanish) => "Hay muy pocos valores para juzgar los residuos.",
        };
        // Added if the verdict itself is not about the size of the residuals.
        let size = match verdict {
            Verdict::Structured | Verdict::Alternating | Verdict::Nothing => self.size(),
            _ => None,
        };
        let of_size = match (size, language) {
            (None, _) => "",
            (Some(Size::Larger), English) => " They are larger than the given errors, too.",
            (Some(Size::Larger), Spanish) => " También son mayores que los errores dados.",
            (Some(Size::Smaller), English) => " They are smaller than the given errors: these are too large.",
            (Some(Size::Smaller), Spanish) => " Son menores que los errores dados: estos son demasiado grandes.",
        };
        [text, of_size].concat()
    }
}

impl Outcome {
    /// Sentences about the number of starts, if more than one, a lower minimum found by a profile, and trials that were given up.
    pub fn search_texts(&self, language: Language) -> Vec<String> {
        let mut texts = Vec::new();
        if self.starts > 1 {
            texts.push(match language {
                English => format!(
                    "The search was made from {} starts; these values are the best that were found.",
                    self.starts
                ),
                Spanish => format!(
                    "Se buscó desde {} comienzos; estos valores son los mejores que se encontraron.",
                    self.starts
                ),
            });
        }
        if self.improved > 0 {
            let text = match language {
                English => "The profile of a parameter met a lower chi-square: the fit was made again from there.",
                Spanish => "El perfil de un parámetro encontró un chi cuadrado menor: el ajuste se repitió desde ahí.",
            };
            texts.push(text.to_owned());
        }
        if self.gave_up {
            let text = match language {
                English => {
                    "Some trials needed too many steps of the integration and were given up: the search did not look there."
                }
                Spanish => {
                    "Algunas pruebas necesitaban demasiados pasos de integración y se abandonaron: la búsqueda no miró ahí."
                }
            };
            texts.push(text.to_owned());
        }
        texts
    }

    /// Sentence about another minimum that fits as well within the noise, if there is one. `quantity` formats a value in SI
    /// of an estimate with its unit.
    pub fn rival_text(&self, language: Language, quantity: impl Fn(&Estimate, f64) -> String) -> Option<String> {
        let rival = self.rival.as_ref()?;
        let values = self.parameters.iter().zip(&rival.values);
        let values: Vec<String> =
            values.map(|(one, value)| format!("{} = {}", one.name, quantity(one, *value))).collect();
        let values = values.join(", ");
        Some(match language {
            English => format!("Another minimum fits as well within the noise: {values}."),
            Spanish => format!("Otro mínimo ajusta igual de bien dentro del ruido: {values}."),
        })
    }
}

impl Estimate {
    /// Reason for a missing standard error, if the estimate or all that it depends on is stopped at a bound of its range.
    pub fn stopped_text(&self, language: Language) -> Option<&'static str> {
        self.at_bound.then_some(match (self.target, language) {
            (Some(_), English) => "at the end of its range",
            (Some(_), Spanish) => "en el extremo de su intervalo",
            (None, English) => "no error: its parameter is at the end of the range",
            (None, Spanish) => "sin error: su parámetro está en el extremo del intervalo",
        })
    }
}

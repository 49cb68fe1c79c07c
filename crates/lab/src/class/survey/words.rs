//! Texts of the survey in the dashboard, in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Survey", "Encuesta";
    intro: "Drop the files with answers here, too: their names end in .survey. Each counts as one person, and nothing is shown before five have answered.", "Suelta aquí también los archivos con respuestas: sus nombres acaban en .survey. Cada uno cuenta como una persona, y no se muestra nada antes de que hayan respondido cinco.";
    comments: "Comments", "Comentarios";
    comments_keys: "Keys: arrows for the next and the previous comment, + 0 - to mark it.", "Teclas: flechas para el comentario siguiente y el anterior, + 0 - para valorarlo.";
    previous: "Previous comment", "Comentario anterior";
    next: "Next comment", "Comentario siguiente";
    positive_mark: "Positive", "Positivo";
    neutral_mark: "Neutral", "Neutro";
    negative_mark: "Negative", "Negativo";
    release: "Release this comment", "Publicar este comentario";
    released: "Released comments", "Comentarios publicados";
    positive: "Positive among the marked ones", "Positivos entre los valorados";
    save: "Save survey", "Guardar encuesta";
    clear: "Remove all answers", "Quitar todas las respuestas";
}

/// Texts in the chosen language.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

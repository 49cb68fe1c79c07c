//! Texts of the page about its course and about handing in, in every language.

use view::{App, table_of_words};

table_of_words! {
    close: "Close", "Cerrar";
    hand_in_intro: "One file for your teacher: this document with your values and answers, and what follows from them. Send it as your course asks; the file is only saved on this device.", "Un archivo para tu profesor: este documento con tus valores y respuestas, y lo que se sigue de ellos. Envíalo como pida tu curso; el archivo solo se guarda en este dispositivo.";
    course: "This page is part of a course", "Esta página forma parte de un curso";
    course_sent: "Once you start, the page sends the course: your answers with all attempts and their grades, the score, the time spent, and the values you set. You go on from there on any device.", "Cuando empieces, la página enviará al curso: tus respuestas con todos los intentos y su calificación, la puntuación, el tiempo dedicado y los valores que pongas. Podrás continuar desde ahí en cualquier dispositivo.";
    course_host: "It is sent to", "Se envía a";
    course_not_sent: "Nothing is sent before, and nothing to anyone else.", "Antes no se envía nada, y a nadie más tampoco.";
    course_start: "Start", "Empezar";
    course_look: "Only look, send nothing", "Solo mirar, sin enviar nada";
    course_started: "The course keeps your work.", "El curso guarda tu trabajo.";
    course_shown: "The course only shows this work: nothing that you do here is kept.", "El curso solo muestra este trabajo: nada de lo que hagas aquí se guarda.";
    course_missing: "The course does not answer, and keeps nothing of this visit. Open the page from the course again, or go on here: your answers stay in this browser, and Hand in saves them as a file for your teacher.", "El curso no responde y no guarda nada de esta visita. Vuelve a abrir la página desde el curso, o sigue aquí: tus respuestas se quedan en este navegador, y Entregar las guarda en un archivo para tu profesor.";
    course_unread: "The work in the course could not be read as a whole; what is missing is as in the document. If it was yours, tell your teacher, and use Hand in from now on.", "El trabajo del curso no se ha podido leer entero; lo que falta está como en el documento. Si era tuyo, díselo a tu profesor y usa Entregar desde ahora.";
    course_refused: "The course has not accepted everything", "El curso no ha aceptado todo";
    course_cut: "The course takes 250 characters of an answer; the rest was not sent.", "El curso admite 250 caracteres de una respuesta; el resto no se ha enviado.";
    course_left_out: "The course has no room for everything. Not kept:", "En el curso no cabe todo. No se guarda:";
    course_way_out: "Hand in saves everything as a file for your teacher.", "Entregar lo guarda todo en un archivo para tu profesor.";
    left_attempts: "texts of earlier attempts", "textos de intentos anteriores";
    left_kept: "kept runs", "ensayos guardados";
    left_changes: "changes during the run", "cambios durante la simulación";
    left_texts: "texts of the answers", "textos de las respuestas";
    left_values: "values of the simulation", "valores de la simulación";
}

/// Texts in the language of the page. Not tracked: views with texts are rebuilt when the language changes.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

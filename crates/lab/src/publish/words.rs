//! Texts of publishing in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Share and publish", "Compartir y publicar";
    close: "Close", "Cerrar";
    faulty: "The text has errors. They are listed in the tab Write; what is published here is ready as soon as they are corrected.", "El texto tiene errores. Están en la pestaña Escribir; se podrá publicar en cuanto estén corregidos.";

    // Link and QR code.
    link: "Link", "Enlace";
    link_intro: "Opens this document with the present values in this laboratory.", "Abre este documento con los valores actuales en este laboratorio.";
    qr_code: "QR code", "Código QR";
    qr_save: "Save QR code", "Guardar código QR";
    qr_label: "QR code of the link", "Código QR del enlace";
    qr_too_long: "This link is too long for a QR code that a telephone reads reliably. Save the page, put it on a web server, and make the QR code of its address here:", "Este enlace es demasiado largo para un código QR que un teléfono lea con seguridad. Guarda la página, súbela a un servidor web y crea aquí el código QR de su dirección:";
    qr_local: "This laboratory is on this computer alone, where no other device can reach it. Save the page, put it on a web server, and make the QR code of its address here:", "Este laboratorio solo está en este ordenador, al que ningún otro dispositivo puede llegar. Guarda la página, súbela a un servidor web y crea aquí el código QR de su dirección:";
    qr_address: "Address for the QR code", "Dirección para el código QR";
    qr_not_made: "This address is too long for a QR code.", "Esta dirección es demasiado larga para un código QR.";

    // Worksheet.
    sheet: "Worksheet", "Hoja de trabajo";
    sheet_intro: "Printing this page gives a worksheet, also with the keys of the browser. Choose its parts.", "Al imprimir esta página sale una hoja de trabajo, también con las teclas del navegador. Elige sus partes.";
    sheet_parts: "Printed", "Se imprime";
    sheet_theory: "Theory", "Teoría";
    sheet_values: "Table of the parameters", "Tabla de los parámetros";
    sheet_lines: "Lines for answers", "Líneas para respuestas";
    sheet_solutions: "Solutions", "Soluciones";
    sheet_print: "Print", "Imprimir";

    // Link of a teacher.
    lesson: "Link for a class", "Enlace para una clase";
    lesson_intro: "Opens this document with the present values in this laboratory, and shows only what you choose. It is no lock: whoever changes the address sees the rest.", "Abre este documento con los valores actuales en este laboratorio y muestra solo lo que elijas. No es un cierre: quien cambie la dirección verá el resto.";
    lesson_tabs: "Tabs", "Pestañas";
    lesson_address: "Address", "Dirección";
    lesson_copy: "Copy this link", "Copiar este enlace";
    lesson_as_left: "as the reader has chosen", "las que haya elegido el lector";
    lesson_student: "of a student", "las de un estudiante";
    lesson_everything: "everything", "todo";

    // Page.
    page: "Page", "Página";
    page_intro: "One file that plays this simulation in any browser, without a network. Its source is inside: the laboratory opens it again.", "Un solo archivo que reproduce esta simulación en cualquier navegador, sin conexión. Lleva dentro su fuente: el laboratorio lo vuelve a abrir.";
    page_save: "Save as page", "Guardar como página";
    page_preparing: "The page is being prepared ...", "Se está preparando la página ...";
    page_too_large: "This document is too large for a page that plays it.", "Este documento es demasiado grande para una página que lo reproduzca.";
    page_missing: "The player could not be loaded. Check the connection, and open this dialog again.", "No se ha podido cargar el reproductor. Comprueba la conexión y vuelve a abrir este diálogo.";

    // Course.
    course: "Package for a course", "Paquete para un curso";
    course_intro: "A ZIP file for a learning platform: it keeps answers, score and state of each student, and gives assigned values by the student's id. Moodle takes SCORM 1.2.", "Un archivo ZIP para una plataforma de aprendizaje: guarda respuestas, puntuación y estado de cada estudiante, y da los valores asignados según su identificador. Moodle admite SCORM 1.2.";
    course_web: "Web page (ZIP)", "Página web (ZIP)";
    course_scores: "Scores come from the student's browser and can be forged, as in every package of this kind. A hand-in can be verified.", "La puntuación viene del navegador del estudiante y puede falsificarse, como en todo paquete de este tipo. Una entrega se puede comprobar.";

    // Frame.
    frame: "Frame in another page", "Marco en otra página";
    frame_intro: "Put the page on a web server, and this code into a page of Moodle, Google Sites or your own.", "Sube la página a un servidor web y pon este código en una página de Moodle, de Google Sites o tuya.";
    frame_address: "Address of the page", "Dirección de la página";
    frame_width: "Width", "Anchura";
    frame_height: "Height", "Altura";
    frame_follows: "The height follows the content (a script for the page around it is added)", "La altura sigue al contenido (se añade un script para la página que lo rodea)";
    frame_language: "Language", "Idioma";
    frame_any_language: "that of the reader", "el del lector";
    frame_shown: "Shown", "Se muestra";
    frame_locked: "Fix the values (parameters, presets and handles)", "Fijar los valores (parámetros, valores predefinidos y tiradores)";
    frame_state: "With the present values", "Con los valores actuales";
    frame_code: "Code", "Código";
    frame_copy: "Copy code", "Copiar código";
    frame_copied: "Copied.", "Copiado.";
    frame_not_copied: "The browser does not allow copying. Select the text and copy it.", "El navegador no permite copiar. Selecciona el texto y cópialo.";
    part_head: "Title and buttons", "Título y botones";
    part_scene: "Scene", "Escena";
    part_plots: "Plots", "Gráficas";
    part_parameters: "Parameters", "Parámetros";
    part_values: "Values", "Valores";
    part_activities: "Questions", "Preguntas";
    part_measure: "Measurements and fits", "Mediciones y ajustes";
    part_text: "Theory", "Teoría";

    // Files.
    files: "Files", "Archivos";
    source_intro: "The text of the document, with its translations beside it.", "El texto del documento, con sus traducciones al lado.";
    project_intro: "Everything in one file: document, translations, present values, records, fits, work on films and answers. Open it or drop it on this page to go on.", "Todo en un archivo: documento, traducciones, valores actuales, registros, ajustes, trabajo en vídeos y respuestas. Ábrelo o suéltalo en esta página para continuar.";
    project_save: "Save project", "Guardar proyecto";
    source_save: "Save as file", "Guardar como archivo";

    // Hand-in.
    hand_in_intro: "One file for your teacher: this document with your values, records, measured points of films, fits and answers, and the results that follow from them. Send it as your course asks; this page sends nothing.", "Un archivo para tu profesor: este documento con tus valores, registros, puntos medidos en vídeos, ajustes y respuestas, y los resultados que se siguen de ellos. Envíalo como pida tu curso; esta página no envía nada.";
    hand_in_left_out: "Not in it, because they are too long or cannot be restored: #.", "No están incluidos, por ser demasiado largos o no poder recuperarse: #.";
}

/// Texts in the language of the page. Not tracked: views with texts are rebuilt when the language changes.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

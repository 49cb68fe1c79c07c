//! Texts of the dashboard of a class in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Class", "Clase";
    close: "Close", "Cerrar";
    intro: "See what all groups have measured, fitted and answered. Drop their hand-ins or a folder of them here, or choose them. Everything is computed again from the raw values, on this device alone.", "Mira lo que todos los grupos han medido, ajustado y respondido. Suelta aquí sus entregas o una carpeta con ellas, o elígelas. Todo se calcula de nuevo a partir de los valores originales, solo en este dispositivo.";
    open: "Open the class", "Abrir la clase";
    choose_files: "Choose hand-ins", "Elegir entregas";
    choose_folder: "Choose a folder", "Elegir una carpeta";
    save_report: "Save report", "Guardar informe";
    save_workbook: "Save as XLSX", "Guardar como XLSX";
    clear: "Remove all", "Quitar todas";
    no_hand_in: "No hand-in is among these files. Their names end in .hand-in", "Entre estos archivos no hay ninguna entrega. Sus nombres acaban en .hand-in";

    curves: "Measured curves", "Curvas medidas";
    curves_quantity: "Quantity", "Magnitud";
    collect: "Collect curves for the wall", "Reunir curvas para la pared";
    results: "Fitted quantities", "Magnitudes ajustadas";
    against: "Results against a parameter", "Resultados en función de un parámetro";
    against_note: "If the groups held a parameter fixed at values of their own, their results can be set against it, with a straight line. Powers and reciprocals can be typed.", "Si los grupos dejaron fijo un parámetro, cada uno con su valor, sus resultados se pueden representar en función de él, con una recta. Se pueden escribir potencias e inversos.";
    against_x: "Parameter", "Parámetro";
    against_y: "Quantity (empty: all)", "Magnitud (vacío: todas)";
    against_none: "No such result has # held fixed in its fit.", "Ningún resultado así tiene # fijo en su ajuste.";
    answers: "Answers", "Respuestas";
    collect_answers: "Collect answers for the wall", "Reunir respuestas para la pared";
    stuck: "Stuck", "Atascados";
    stuck_rules: "A group is stuck if it gives three answers wrong in the same way, if it has kept the same run five times, if a fit does not determine its parameters, or if a result is far from the others.", "Un grupo está atascado si da tres respuestas mal del mismo modo, si ha guardado cinco veces la misma simulación, si un ajuste no determina sus parámetros o si un resultado está lejos de los demás.";
    nothing: "None.", "Nada.";

    snapshots: "For the wall", "Para la pared";
    snapshots_none: "Nothing is collected yet. Choose curves or answers above; they are shown without names.", "Todavía no hay nada reunido. Elige arriba curvas o respuestas; se muestran sin nombres.";
    wall_show: "Show on the wall", "Mostrar en la pared";
    wall_title: "Wall", "Pared";
    wall_previous: "Previous", "Anterior";
    wall_next: "Next", "Siguiente";
    wall_answer: "Answer", "Respuesta";
    move_up: "Show earlier", "Mostrar antes";
    remove: "Remove", "Quitar";

    hand_ins: "Hand-ins", "Entregas";
    number: "No.", "N.º";
    pseudonym: "Handed in as", "Entregado como";
    name: "Name (on this device only)", "Nombre (solo en este dispositivo)";
    name_of: "Name of", "Nombre de";
    seat: "Seat", "Puesto";
    file: "File", "Archivo";
    verification: "Verification", "Comprobación";
    work: "Work", "Trabajo";
    table: "Table of the hand-ins", "Tabla de las entregas";
    open_work: "Open the work", "Abrir el trabajo";
    show_all: "Show all #", "Mostrar las #";
}

/// Texts in the chosen language.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

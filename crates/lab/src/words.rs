//! The words of the interface in every language it speaks. What the document says is translated by the document, and
//! what playing and measuring say by `play` and `desk`.

use units::Language;

/// The words in one language.
pub fn words_in(language: Language) -> &'static Words {
    language.pick(&ENGLISH, &SPANISH)
}

/// Declares [`Words`] and its two tables from one: a word that lacks a language does not compile.
macro_rules! words {
    ($($name:ident: $english:literal, $spanish:literal;)*) => {
        /// The words of the interface in one language. Each is named after its English text.
        #[derive(Debug)]
        #[allow(missing_docs, reason = "each says itself")]
        pub struct Words { $(pub $name: &'static str,)* }
        static ENGLISH: Words = Words { $($name: $english,)* };
        static SPANISH: Words = Words { $($name: $spanish,)* };
    };
}

words! {
    // The page.
    skip: "Skip to the apparatus", "Ir al aparato";
    language: "Language", "Idioma";
    theme_system: "Colours: as the system", "Colores: como el sistema";
    theme_light: "Colours: light", "Colores: claros";
    theme_dark: "Colours: dark", "Colores: oscuros";
    presenter: "Presenter's size", "Tamaño para proyectar";
    share: "Copy link", "Copiar enlace";
    share_title: "Copy a link that reopens this state", "Copiar un enlace que reabre este estado";
    link_copied: "Link copied", "Enlace copiado";
    link_not_copied: "The link could not be copied; it is in the address bar", "No se pudo copiar el enlace; está en la barra de direcciones";
    link_without: "Not in the link", "No están en el enlace";
    link_without_translations: "The translations are too long for a link", "Las traducciones son demasiado largas para un enlace";
    link_needs_file: "The document is too long for a link; whoever opens it also needs the file", "El documento es demasiado largo para un enlace; quien lo abra necesita también el archivo";
    not_saved: "The browser does not let this page store anything (storage full or forbidden): records, fits and answers will be lost when the page is closed", "El navegador no deja que esta página guarde nada (almacenamiento lleno o prohibido): los registros, los ajustes y las respuestas se perderán al cerrar la página";
    records_closed: "More records are stored than can be open at once. Remove one and load the page again to see the others", "Hay más registros guardados de los que pueden estar abiertos a la vez. Quita uno y vuelve a cargar la página para ver los demás";
    open: "Open", "Abrir";
    open_title: "Open a simulation document or an exported page", "Abrir un documento de simulación o una página exportada";
    close: "Close", "Cerrar";
    messages: "Messages", "Mensajes";
    undo: "Undo", "Deshacer";
    show: "Show", "Mostrar";
    dismiss: "Dismiss", "Descartar";
    file_not_read: "The browser could not read this file:", "El navegador no pudo leer este archivo:";
    footer: "Made with Meniscus. This page is one file: it works offline and sends nothing to anyone.", "Hecho con Meniscus. Esta página es un solo archivo: funciona sin conexión y no envía nada a nadie.";

    drop_title: "Drop a document or measured data", "Suelta un documento o datos medidos";
    drop_what: "A simulation document, an exported page, or a table from a film or a sensor", "Un documento de simulación, una página exportada o una tabla de un vídeo o un sensor";

    // The apparatus.
    apparatus: "Apparatus", "Aparato";
    scene: "Scene", "Escena";
    no_scene: "This document draws no scene.", "Este documento no dibuja ninguna escena.";
    outline: "Dashed: measured", "A trazos: lo medido";
    drag_hint: "Drag in the scene, or use the arrow keys.", "Arrastra en la escena, o usa las flechas.";
    drag_hint_touch: "Drag in the scene with a finger.", "Arrastra en la escena con un dedo.";
    drag_role: "handle", "asa";

    instruments: "Instruments", "Instrumentos";
    stopwatch: "Stopwatch", "Cronómetro";
    stopwatch_start: "Start the stopwatch", "Poner en marcha el cronómetro";
    stopwatch_started: "Stopwatch started", "Cronómetro en marcha";
    stopwatch_stop: "Stop the stopwatch", "Parar el cronómetro";
    stopwatch_reset: "Reset the stopwatch", "Poner el cronómetro a cero";
    ruler: "Ruler", "Regla";
    ruler_end: "End of the ruler", "Extremo de la regla";

    // Transport.
    transport: "Transport", "Reproducción";
    play: "Play", "Reproducir";
    pause: "Pause", "Pausar";
    step_back: "Step back", "Paso atrás";
    step_forward: "Step forward", "Paso adelante";
    back_to_start: "Back to start", "Volver al inicio";
    speed: "Speed", "Velocidad";
    time: "Time", "Tiempo";
    time_line: "Time line", "Línea de tiempo";
    fill_screen: "Stage in full screen", "Escenario a pantalla completa";
    sound: "Sound", "Sonido";
    sound_title: "Hear the displacement as a pitch", "Oír el desplazamiento como un tono";
    slow: "The computation cannot keep up with the clock at this speed.", "El cálculo no alcanza al reloj a esta velocidad.";
    full: "The recording is full. Go back to the start, or scrub back and continue from there.", "El registro está lleno. Vuelve al inicio, o retrocede y continúa desde ahí.";

    // Keys.
    keys_title: "Keyboard shortcuts", "Atajos de teclado";
    keys_switch: "Single-key shortcuts", "Atajos de una sola tecla";
    keys_where: "They act while the focus is in the apparatus or nowhere, never while you type.", "Actúan cuando el foco está en el aparato o en ninguna parte, nunca mientras escribes.";
    keys_anywhere: "Apparatus", "Aparato";
    keys_plot: "In a plot", "En una gráfica";
    keys_scene: "On a handle of the scene", "En un asa de la escena";
    key_space: "Space", "Espacio";
    key_play: "Play or pause", "Reproducir o pausar";
    key_step: "Step back, step forward", "Paso atrás, paso adelante";
    key_speed: "Slower, faster", "Más lento, más rápido";
    key_keep: "Keep this run", "Guardar esta serie";
    key_undo: "Undo the last removal or reset of parameters", "Deshacer lo último que se quitó o se restableció";
    key_help: "This list", "Esta lista";
    key_cursor: "Move the read-out (with Shift: ten rows)", "Mover la lectura (con Mayús: diez filas)";
    key_zoom: "Zoom in, zoom out", "Acercar, alejar";
    key_pan: "Pan (with Ctrl)", "Desplazar (con Ctrl)";
    key_pin: "Pin the reading, unpin all", "Fijar la lectura, soltarlas todas";
    key_fit: "Show all of the data", "Mostrar todos los datos";
    key_handle: "Move it (with Shift: five times as far)", "Moverla (con Mayús: cinco veces más)";

    // Controls.
    controls: "Controls", "Controles";
    parameters: "Parameters", "Parámetros";
    presets: "Presets", "Ajustes";
    restore_defaults: "Restore defaults", "Restaurar valores";
    restore_defaults_title: "Give all parameters and the start of the run the values of the document", "Dar a todos los parámetros y al inicio de la serie los valores del documento";
    restarts: "Changing it starts the run anew", "Al cambiarlo, la serie comienza de nuevo";
    state: "State", "Estado";
    state_hint: "Pause to edit; the run then begins from there.", "Pausa para editar; la serie parte entonces de ahí.";
    started_by_hand: "The run starts from a state that was set by hand. Restore defaults brings the document's start back.", "La serie parte de un estado fijado a mano. Restaurar valores recupera el del documento.";
    method: "Method", "Método";
    step: "Step", "Paso";
    settings: "State and method", "Estado y método";
    numerics: "Numerical method", "Método numérico";

    // Readouts.
    readouts: "Values", "Valores";
    constants: "Derived quantities", "Magnitudes derivadas";
    changing: "Changing with time", "Cambian con el tiempo";
    hidden_why: "Hidden until the question about it is answered", "Oculto hasta que se responda la pregunta sobre él";
    show_hidden: "Show the values that questions ask for", "Mostrar los valores por los que se pregunta";

    // Plots.
    plots: "Plots", "Gráficas";
    plot: "plot", "gráfica";
    plots_shown: "Plots shown", "Gráficas visibles";
    no_plots: "All plots are hidden.", "Todas las gráficas están ocultas.";
    plot_keys: "Arrow keys read values, Enter pins a reading, plus and minus zoom, 0 shows everything.", "Las flechas leen valores, Intro fija una lectura, más y menos acercan y alejan, 0 muestra todo.";
    zoom_in: "Zoom in", "Acercar";
    zoom_out: "Zoom out", "Alejar";
    fit: "Show all", "Mostrar todo";
    save_svg: "Download SVG", "Descargar SVG";
    save_png: "Download PNG", "Descargar PNG";

    save_plot_csv: "Download CSV of this plot", "Descargar CSV de esta gráfica";
    plot_menu: "Download and full screen", "Descargas y pantalla completa";
    full_screen: "Full screen", "Pantalla completa";
    legend: "Legend", "Leyenda";
    pinned: "Pinned", "Fijado";
    unpin: "Unpin the readings", "Soltar las lecturas";
    unpinned: "Reading removed", "Lectura quitada";
    difference: "Difference", "Diferencia";
    difference_sign: "B − A", "B − A";

    // Runs.
    runs: "Kept runs", "Series guardadas";
    keep: "Keep run", "Guardar serie";
    keep_title: "Keep this run and draw the next one over it", "Guardar esta serie y dibujar la siguiente encima";
    remove_run: "Remove", "Quitar";
    ghost: "Previous run", "Serie anterior";

    // The panel.
    panel: "Panel", "Panel";
    tab_play: "Play", "Explorar";
    tab_activities: "Activities", "Actividades";
    tab_measure: "Measure", "Medir";
    tab_fit: "Fit", "Ajustar";
    tab_theory: "Theory", "Teoría";
    contents: "Contents", "Contenido";
    equations: "Model", "Modelo";
    equations_intro: "The equations as the document states them; the program solves exactly these.", "Las ecuaciones tal como las enuncia el documento; el programa resuelve exactamente estas.";
    source: "Source", "Fuente";
    source_intro: "The whole simulation is this text. Save it, change it, and open it again.", "Toda la simulación es este texto. Guárdalo, cámbialo y ábrelo de nuevo.";
    save_source: "Download", "Descargar";
    copy: "Copy", "Copiar";
    copied: "Copied", "Copiado";
    not_copied: "The browser did not allow copying", "El navegador no permitió copiar";
    table: "Recorded values", "Valores registrados";
    rows: "rows", "filas";
    follow: "Follow the present", "Seguir el presente";
    row_first: "First rows", "Primeras filas";
    row_previous: "Earlier rows", "Filas anteriores";
    row_next: "Later rows", "Filas siguientes";
    row_last: "Last rows", "Últimas filas";
    save_csv: "Download CSV", "Descargar CSV";
    save_xlsx: "Download XLSX", "Descargar XLSX";
    copy_csv: "Copy CSV", "Copiar CSV";

    // Measurements.
    measurements_intro: "Bring a record of a film or a sensor: a table of times and values as text, XLSX or ODS, as the tracking program or spreadsheet wrote it. Drop the file anywhere on this page, choose it, or paste it. It stays in your browser.", "Trae un registro de un vídeo o de un sensor: una tabla de tiempos y valores como texto, XLSX u ODS, tal como la escribió el programa de seguimiento o la hoja de cálculo. Suelta el archivo en cualquier parte de esta página, elígelo o pégalo. No sale de tu navegador.";
    records: "Records", "Registros";
    choose_record: "Choose a file", "Elegir un archivo";
    paste_record: "Paste a table", "Pegar una tabla";
    paste_label: "Table as text", "Tabla como texto";
    paste_name: "pasted table", "tabla pegada";
    read_record: "Read", "Leer";
    sample_records: "Sample records", "Registros de muestra";
    sample_title: "Simulated data with camera errors", "Datos simulados con los errores de una cámara";
    synthetic: "synthetic", "sintético";
    reading_record: "Reading", "Leyendo";
    cancel_reading: "Cancel reading", "Cancelar la lectura";
    not_lasting: "too long to be kept for the next visit", "demasiado largo para conservarlo hasta la próxima visita";
    show_record: "Show it in the plots", "Mostrarlo en las gráficas";
    remove_record: "Remove the record", "Quitar el registro";
    preview: "Columns and first values", "Columnas y primeros valores";
    column: "Column", "Columna";
    column_measures: "Measures", "Mide";
    column_unit: "Unit", "Unidad";
    column_unit_asked: "which unit?", "¿qué unidad?";
    column_fitted: "Fit it", "Ajustarla";
    column_off: "not used", "no se usa";
    findings: "Data quality", "Calidad de los datos";
    virtual_measurement: "Virtual measurement", "Medición virtual";
    virtual_intro: "A camera films the simulation as it is set now. What it reads has errors: random ones, and one that no repetition shows.", "Una cámara filma la simulación tal como está ajustada ahora. Lo que lee tiene errores: unos al azar, y uno que ninguna repetición delata.";
    virtual_quantity: "Filmed", "Se filma";
    virtual_rate: "Frames per second", "Imágenes por segundo";
    virtual_duration: "Duration", "Duración";
    virtual_pixel: "Size of a pixel", "Tamaño de un píxel";
    virtual_noise: "Noise of a reading", "Ruido de una lectura";
    virtual_jitter: "Jitter of the frames", "Irregularidad de las imágenes";
    virtual_scale: "Error of the scale", "Error de la escala";
    virtual_seed: "Seed", "Semilla";
    virtual_seed_hint: "The same seed gives the same errors again.", "La misma semilla da otra vez los mismos errores.";
    virtual_measure: "Measure", "Medir";
    virtual_name: "virtual measurement", "medición virtual";

    // Derivatives.
    derivatives_title: "Velocity and acceleration", "Velocidad y aceleración";
    derivatives_intro: "Computes two more columns from a position. They add no independent information to a fit that already uses the position. Gaps stay gaps.", "Calcula dos columnas más a partir de una posición. No aportan información independiente a un ajuste que ya usa la posición. Los huecos siguen siendo huecos.";
    derivatives_of: "Of", "De";
    derivatives_method: "By", "Con";
    derivatives_central: "central differences", "diferencias centrales";
    derivatives_smooth: "smoothing polynomials", "polinomios de suavizado";
    derivatives_rows: "Rows", "Filas";
    derivatives_degree: "Degree", "Grado";
    derivatives_make: "Make columns", "Calcular columnas";
    derivatives_forget: "Remove them", "Quitarlas";

    // Cycle by cycle.
    cycles_title: "Cycle by cycle", "Ciclo a ciclo";
    cycles_intro: "Before any theory: what each swing is like by itself. In the linear theory period, decrement, frequency and damping are the same in every cycle, and only the amplitude falls.", "Antes de cualquier teoría: cómo es cada oscilación por sí misma. En la teoría lineal el periodo, el decremento, la frecuencia y el amortiguamiento son iguales en todos los ciclos, y solo disminuye la amplitud.";
    cycles_column: "Column", "Columna";
    cycles_quantity: "Drawn", "Se dibuja";
    cycles_against: "against", "frente a";
    cycles_time: "time", "el tiempo";
    cycles_amplitude: "amplitude", "la amplitud";
    cycles_turn: "Turning point", "Punto de retorno";
    cycles_note: "Each row is a turning point with the half-cycles around it, after ± one standard error. Rows next to each other share data; each third row is independent.", "Cada fila es un punto de retorno con los semiciclos a su alrededor; tras ± figura un error estándar. Las filas vecinas comparten datos; una de cada tres es independiente.";
    cycles_run: "The line of the simulation is drawn once the simulation stands still.", "La línea de la simulación se dibuja cuando la simulación está detenida.";

    // The library.
    library: "Documents", "Documentos";
    library_title: "Simulations and theories that this page carries", "Simulaciones y teorías que lleva esta página";
    library_intro: "Records and fits stay when another document is opened.", "Los registros y los ajustes se conservan al abrir otro documento.";
    library_simulations: "Simulations", "Simulaciones";
    library_theories: "Theories of a liquid column that comes to rest", "Teorías de una columna de líquido que se detiene";

    // Fits.
    fit_record: "Record to be fitted", "Registro que se ajusta";
    fit_theory: "Theories", "Teorías";
    fit_step_record: "Record", "Registro";
    fit_step_theory: "Theory", "Teoría";
    fit_step_fit: "Result", "Resultado";
    fit_options: "Options", "Opciones";
    fit_statistics: "Statistics", "Estadística";
    fit_none: "There is no record to fit yet. Add one in the tab Measure, drop a file anywhere on this page, or take a sample.", "Todavía no hay ningún registro que ajustar. Añade uno en la pestaña Medir, suelta un archivo en cualquier parte de esta página o toma una muestra.";
    add_record: "Add a record", "Añadir un registro";
    fit_together: "Fitted together", "Se ajustan juntos";
    fit_same: "one value for all", "un valor para todos";
    fit_same_intro: "A parameter that all records have in common is fitted to all of them at once. To use a known value for each record, untick the parameter and enter the values.", "Un parámetro común a todos los registros se ajusta con todos a la vez. Para usar un valor conocido en cada registro, desmarca el parámetro y escribe los valores.";
    fit_vary: "Vary", "Varían";
    fit_part: "Part of the record", "Parte del registro";
    fit_part_in_plot: "Take the part in the plot", "Tomar la parte de la gráfica";
    fit_from: "From", "Desde";
    fit_until: "until", "hasta";
    fit_loss: "Loss", "Pérdida";
    fit_loss_note: "With Huber's or Tukey's loss, values far from the curve count less.", "Con la pérdida de Huber o la de Tukey, los valores lejos de la curva cuentan menos.";
    fit_begin: "Fit", "Ajustar";
    fit_rank: "Rank all theories", "Comparar todas las teorías";
    fit_rank_title: "Fit every theory that this page carries to the record", "Ajustar al registro todas las teorías que lleva esta página";
    fit_trials: "curves tried", "curvas probadas";
    fit_cancel: "Cancel", "Cancelar";
    fit_results: "Fits, the best first", "Ajustes, el mejor primero";
    fit_theory_head: "Theory", "Teoría";
    fit_counts: "Values / varied", "Valores / varían";
    fit_rmse: "Residuals (RMS)", "Residuos (RMS)";
    fit_predicted: "Outside the part", "Fuera de la parte";
    fit_weight: "Weight", "Peso";
    fit_apply: "Show", "Mostrar";
    fit_open: "Open", "Abrir";
    fit_remove: "Remove the fit", "Quitar el ajuste";
    fit_varied: "Found", "Hallado";
    fit_all_records: "All records", "Todos los registros";
    save_report: "Report", "Informe";
    fit_all: "All of them", "Todos";
    fit_errors: "The standard errors allow for autocorrelated residuals.", "Los errores típicos tienen en cuenta que los residuos pueden estar autocorrelacionados.";

    // The worksheet.
    sheet_name: "Name", "Nombre";
    sheet_date: "Date", "Fecha";
    sheet_answer: "Answer", "Respuesta";
    sheet_made: "Made with Meniscus.", "Hecho con Meniscus.";

    // Questions.
    question: "Question", "Pregunta";
    answer: "Your answer", "Tu respuesta";
    check: "Check", "Comprobar";
    hint: "Hint", "Pista";
    reveal: "Show the answer", "Mostrar la respuesta";
    right_answer: "Answer", "Respuesta";
    supposes: "This question supposes", "Esta pregunta supone";
    set_up: "Set these values", "Fijar estos valores";
    is_set_up: "set", "fijados";

    // Diagnostics.
    broken: "This document does not run yet", "Este documento aún no funciona";
    broken_intro: "Meniscus found errors in it. Each is shown with its place.", "Meniscus encontró errores en él. Cada uno se muestra con su lugar.";
    previous_document: "Back to the previous document", "Volver al documento anterior";
    other_documents: "Other documents", "Otros documentos";
    correct: "Correct the text", "Corrige el texto";
    correct_intro: "Change the text and check it again. Your file on disk stays as it is; download the text to keep your changes.", "Cambia el texto y compruébalo de nuevo. Tu archivo en el disco no cambia; descarga el texto para conservar los cambios.";
    check_again: "Check again", "Comprobar de nuevo";
    it_runs: "The document runs", "El documento funciona";
    warnings: "Remarks on this document", "Observaciones sobre este documento";
    error: "Error", "Error";
    warning: "Warning", "Aviso";
    line: "line", "línea";
    help: "Help", "Ayuda";
    nothing: "There is no document in this page", "No hay ningún documento en esta página";
    nothing_intro: "Open a simulation document: a Markdown file with a model in it, or a page that Meniscus exported.", "Abre un documento de simulación: un archivo Markdown con un modelo, o una página exportada por Meniscus.";
    unreadable: "This file is neither a simulation document nor an exported page", "Este archivo no es un documento de simulación ni una página exportada";
}

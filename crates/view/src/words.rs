//! Texts around a simulation in every language. Texts of the document are translated by the document, texts of playing
//! by `play`.

/// Declares a table of texts from one list; a text that lacks a language does not compile. With `@beside`, the texts of
/// another table can be read like own ones.
#[macro_export]
macro_rules! table_of_words {
    ($(@beside $other:ident;)? $($name:ident: $english:literal, $spanish:literal;)*) => {
        /// Texts of the interface in one language. Each is named after its English text.
        #[derive(Debug)]
        #[allow(missing_docs, reason = "each says itself")]
        pub struct Words { $(other: &'static $other::Words,)? $(pub $name: &'static str,)* }
        /// English texts.
        pub static ENGLISH: Words = Words { $(other: &$other::ENGLISH,)? $($name: $english,)* };
        /// Spanish texts.
        pub static SPANISH: Words = Words { $(other: &$other::SPANISH,)? $($name: $spanish,)* };

        /// Texts in one language.
        pub fn words_in(language: units::Language) -> &'static Words {
            language.pick(&ENGLISH, &SPANISH)
        }

        $(impl std::ops::Deref for Words {
            type Target = $other::Words;

            fn deref(&self) -> &$other::Words {
                self.other
            }
        })?
    };
}

table_of_words! {
    // Page.
    skip: "Skip to the apparatus", "Ir al aparato";
    skip_to_panel: "Skip to the panel", "Ir al panel";
    language: "Language", "Idioma";
    theme_system: "Colours: as the system", "Colores: como el sistema";
    theme_light: "Colours: light", "Colores: claros";
    theme_dark: "Colours: dark", "Colores: oscuros";
    projector: "Projector's view", "Vista para proyectar";
    menu: "Open a file, colours, language", "Abrir un archivo, colores, idioma";
    library: "Simulations", "Simulaciones";
    first_steps: "First steps", "Primeros pasos";
    guide: "60-second start", "Inicio en 60 segundos";
    guide_decline: "No guided start", "Sin inicio guiado";
    film_own: "Film your own", "Filma el tuyo";
    film_own_steps: ": film, marks, curve, fit", ": vídeo, marcas, curva, ajuste";
    published: "Published simulation", "Simulación publicada";
    open: "Open", "Abrir";
    publish: "Share", "Compartir";
    document: "Document", "Documento";
    document_title: "Save the document of this simulation; the laboratory of Meniscus opens it", "Guardar el documento de esta simulación; el laboratorio de Meniscus lo abre";
    all_simulations: "All simulations", "Todas las simulaciones";
    open_in_laboratory: "Open in the laboratory", "Abrir en el laboratorio";
    laboratory_title: "Open this simulation as it is now in the laboratory, to measure and to fit", "Abrir esta simulación tal como está en el laboratorio, para medir y ajustar";
    question_awaits: "Answer this first", "Responde antes";
    answers_not_saved: "The browser does not let this page store anything: your answers will be lost when it is closed", "El navegador no deja que esta página guarde nada: tus respuestas se perderán al cerrarla";
    damaged: "This file is damaged. Download it again.", "Este archivo está dañado. Vuelve a descargarlo.";
    locked: "The values are fixed in this page.", "Los valores están fijados en esta página.";
    share: "Copy link", "Copiar enlace";
    share_title: "Copy a link that reopens this state", "Copiar un enlace que reabre este estado";
    link_copied: "Link copied", "Enlace copiado";
    link_not_copied: "The link could not be copied; it is in the address bar", "No se pudo copiar el enlace; está en la barra de direcciones";
    link_without: "Not in the link", "No están en el enlace";
    close: "Close", "Cerrar";
    messages: "Messages", "Mensajes";
    undo: "Undo", "Deshacer";
    show: "Show", "Mostrar";
    dismiss: "Dismiss", "Descartar";
    footer: "Made with Meniscus. This page works offline and sends nothing to anyone.", "Hecho con Meniscus. Esta página funciona sin conexión y no envía nada a nadie.";

    // Apparatus.
    apparatus: "Apparatus", "Aparato";
    scene: "Scene", "Escena";
    no_scene: "This document draws no scene.", "Este documento no dibuja ninguna escena.";
    outline: "Dotted: measured", "A puntos: lo medido";
    drag_hint: "Drag in the scene, or use the arrow keys.", "Arrastra en la escena, o usa las flechas.";
    drag_hint_touch: "Drag in the scene with a finger.", "Arrastra en la escena con un dedo.";
    drag_role: "handle", "tirador";

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
    sound: "Sound", "Sonido";
    sound_title: "Hear the displacement as a pitch", "Oír el desplazamiento como un tono";
    slow: "The computation cannot keep up with the clock at this speed.", "El cálculo no alcanza al reloj a esta velocidad.";
    full: "The recording is full. Go back to the start, or scrub back and continue from there.", "El registro está lleno. Vuelve al inicio, o retrocede y continúa desde ahí.";

    go_on: "Go on", "Continuar";

    // Keys.
    keys_title: "Keyboard shortcuts", "Atajos de teclado";
    keys_switch: "Single-key shortcuts", "Atajos de una sola tecla";
    keys_where: "They act while the focus is in the apparatus or nowhere, never while you type.", "Actúan cuando el foco está en el aparato o en ninguna parte, nunca mientras escribes.";
    keys_anywhere: "Apparatus", "Aparato";
    keys_plot: "In a plot", "En una gráfica";
    keys_scene: "On a handle of the scene", "En un tirador de la escena";
    key_space: "Space", "Espacio";
    key_play: "Play or pause", "Reproducir o pausar";
    key_step: "Step back, step forward", "Paso atrás, paso adelante";
    key_speed: "Slower, faster", "Más lento, más rápido";
    key_keep: "Keep this run", "Guardar este ensayo";
    key_projector: "Leave the projector's view", "Salir de la vista para proyectar";
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
    index: "index", "índice";
    seat: "Seat", "Puesto";
    seat_unknown: "Type the number of your seat to work with values of your own. Until then the values of the document are set.", "Escribe el número de tu puesto para trabajar con valores propios. Hasta entonces valen los del documento.";
    seat_known: "The values of this seat are set.", "Están los valores de este puesto.";
    size_title: "Another size builds the model again", "Otro tamaño vuelve a construir el modelo";
    size_whole: "A size is a whole number.", "Un tamaño es un número entero.";
    size_fixed: "Fixed in this page; the laboratory can change it.", "Fijo en esta página; el laboratorio puede cambiarlo.";
    parameters: "Parameters", "Parámetros";
    buttons: "Actions", "Acciones";
    clear_drawing: "Clear", "Borrar";
    drawing_hint: "Draw the curve in the field; the run starts again. Keys: left and right choose a point, up and down move it.", "Dibuja la curva en el recuadro; el ensayo comienza de nuevo. Teclas: izquierda y derecha eligen un punto, arriba y abajo lo mueven.";
    further_parameters: "Further parameters", "Otros parámetros";
    more: "More", "Más";
    choose: "Choose ...", "Elegir ...";
    presets: "Presets", "Valores predefinidos";
    restore_defaults: "Restore defaults", "Restaurar valores";
    restore_defaults_title: "Give all parameters and the start of the run the values of the document", "Dar a todos los parámetros y al inicio del ensayo los valores del documento";
    restarts: "A change starts the run again", "Al cambiarlo, el ensayo comienza de nuevo";
    state: "State", "Estado";
    state_hint: "Pause to edit; the run then begins from there.", "Pausa para editar; el ensayo parte entonces de ahí.";
    started_by_hand: "The run starts from a state that was set by hand. Restore defaults brings the document's start back.", "El ensayo parte de un estado fijado a mano. Restaurar valores recupera el del documento.";
    method: "Method", "Método";
    step: "Step", "Paso";
    settings: "State and method", "Estado y método";
    numerics: "Numerical method", "Método numérico";

    // Hand-in.
    hand_in: "Hand in", "Entregar";
    hand_in_name: "Name, group or pseudonym", "Nombre, grupo o seudónimo";
    hand_in_save: "Save hand-in", "Guardar entrega";
    hand_in_unnamed: "Type a name first.", "Escribe antes un nombre.";
    hand_in_computing: "The results are being computed again ...", "Se están calculando de nuevo los resultados ...";
    hand_in_saved: "Saved {file} with # values.", "Se guardó {file} con # valores.";
    hand_in_meaning: "The results are computed again from the data when the file is verified. A result that does not follow from the data is listed.", "Al comprobar el archivo, los resultados se calculan de nuevo a partir de los datos. Se señala todo resultado que no se siga de ellos.";

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
    plot_menu: "Zoom, download and full screen", "Acercar, descargar y pantalla completa";
    full_screen: "Full screen", "Pantalla completa";
    legend: "Legend", "Leyenda";
    pinned: "Pinned", "Fijado";
    unpin: "Unpin the readings", "Soltar las lecturas";
    unpinned: "Reading removed", "Lectura quitada";
    difference: "Difference", "Diferencia";
    difference_sign: "B − A", "B − A";

    // Runs.
    runs: "Kept runs", "Ensayos guardados";
    keep: "Keep run", "Guardar ensayo";
    keep_title: "Keep this run and draw the next one over it", "Guardar este ensayo y dibujar el siguiente encima";
    remove_run: "Remove", "Quitar";
    ghost: "Previous run", "Ensayo anterior";

    // Panel.
    panel: "Panel", "Panel";
    tab_explore: "Explore", "Explorar";
    tab_questions: "Questions", "Preguntas";
    tab_measure: "Measure", "Medir";
    tab_theory: "Theory", "Teoría";
    tab_write: "Write", "Escribir";
    tab_class: "Class", "Clase";
    everything: "Everything", "Todo";
    tab_waits: "The laboratory is loading ...", "El laboratorio se está cargando ...";
    contents: "Contents", "Contenido";
    equations: "Model", "Modelo";
    equations_intro: "The equations as the document states them; the program solves exactly these.", "Las ecuaciones tal como las enuncia el documento; el programa resuelve exactamente estas.";
    checks: "Checks of this simulation", "Comprobaciones de esta simulación";
    checks_intro: "What the author claims about runs with the values of the document. Your own run is not changed.", "Lo que el autor afirma de simulaciones con los valores del documento. Tu propia simulación no cambia.";
    run_checks: "Run the checks", "Hacer las comprobaciones";
    checks_running: "Running", "En curso";
    checks_hold: "All claims hold", "Todas las afirmaciones se cumplen";
    checks_fail: "Claims that do not hold:", "Afirmaciones que no se cumplen:";
    checks_with: "With", "Con";
    check_plot_show: "Show in the present run", "Ver en esta simulación";
    check_plot_hide: "Hide the plot", "Ocultar la gráfica";
    check_plot_waits: "Play the simulation first.", "Pon primero en marcha la simulación.";
    check_open: "not checked", "sin comprobar";
    check_holds: "holds", "se cumple";
    check_fails: "does not hold", "no se cumple";
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
    copy_csv: "Copy CSV", "Copiar CSV";

    // Worksheet.
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
    supposes: "This question assumes", "Esta pregunta supone";
    set_up: "Set these values", "Fijar estos valores";
    is_set_up: "set", "fijados";

    // Survey.
    survey: "Survey", "Encuesta";
    survey_note: "Your answers stay in this page until you save them as a file, which has neither your name nor the time. They are part of no hand-in and no link.", "Tus respuestas se quedan en esta página hasta que las guardes como archivo, que no lleva ni tu nombre ni la hora. No forman parte de ninguna entrega ni de ningún enlace.";
    survey_none: "No answer", "Sin respuesta";
    survey_save: "Save answers", "Guardar respuestas";
    survey_saved: "The answers are saved as a file. Send it as the course asks.", "Las respuestas están guardadas en un archivo. Envíalo como pida el curso.";
    survey_empty: "Nothing is answered yet.", "Todavía no hay ninguna respuesta.";
}

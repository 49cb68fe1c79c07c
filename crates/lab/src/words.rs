//! The words of the interface in every language it speaks. What the document says is translated by the document, and
//! what the session says by the session.

/// A language of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// English.
    English,
    /// Spanish.
    Spanish,
}

impl Language {
    /// The languages, as the switch offers them.
    pub const ALL: [Self; 2] = [Self::English, Self::Spanish];

    /// The language of a tag such as `es-MX`; English where the interface does not speak it.
    pub fn of(tag: &str) -> Self {
        if tag.get(..2).is_some_and(|primary| primary.eq_ignore_ascii_case("es")) {
            Self::Spanish
        } else {
            Self::English
        }
    }

    /// The tag, for `lang` attributes.
    pub fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Spanish => "es",
        }
    }

    /// The language's own name.
    pub fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::Spanish => "Español",
        }
    }

    /// Its words.
    pub fn words(self) -> &'static Words {
        match self {
            Self::English => &ENGLISH,
            Self::Spanish => &SPANISH,
        }
    }
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
    jump: "On this page", "En esta página";
    language: "Language", "Idioma";
    theme_system: "Colours: as the system", "Colores: como el sistema";
    theme_light: "Colours: light", "Colores: claros";
    theme_dark: "Colours: dark", "Colores: oscuros";
    share: "Copy link", "Copiar enlace";
    share_title: "Copy a link that reopens this state", "Copiar un enlace que reabre este estado";
    link_copied: "Link copied", "Enlace copiado";
    link_not_copied: "The link could not be copied; it is in the address bar", "No se pudo copiar el enlace; está en la barra de direcciones";
    open: "Open", "Abrir";
    open_title: "Open a simulation document or an exported page", "Abrir un documento de simulación o una página exportada";
    close: "Close", "Cerrar";
    footer: "Made with Meniscus. This page is one file: it works offline and sends nothing to anyone.", "Hecho con Meniscus. Esta página es un solo archivo: funciona sin conexión y no envía nada a nadie.";

    // The apparatus.
    apparatus: "Apparatus", "Aparato";
    scene: "Scene", "Escena";
    no_scene: "This document draws no scene.", "Este documento no dibuja ninguna escena.";
    drag_hint: "Drag in the scene, or use the arrow keys.", "Arrastra en la escena, o usa las flechas.";
    drag_role: "handle", "asa";

    // Transport.
    transport: "Transport", "Reproducción";
    play: "Play", "Reproducir";
    pause: "Pause", "Pausar";
    step_back: "Step back", "Paso atrás";
    step_forward: "Step forward", "Paso adelante";
    reset: "Reset", "Reiniciar";
    speed: "Speed", "Velocidad";
    time: "Time", "Tiempo";
    time_line: "Time line", "Línea de tiempo";
    sound: "Sound", "Sonido";
    sound_title: "Hear the displacement as a pitch", "Oír el desplazamiento como un tono";
    slow: "The computation cannot keep up with the clock at this speed.", "El cálculo no alcanza al reloj a esta velocidad.";
    full: "The recording is full. Reset, or scrub back and continue from there.", "El registro está lleno. Reinicia, o retrocede y continúa desde ahí.";

    // Keys.
    keys_title: "Keyboard shortcuts", "Atajos de teclado";
    keys_switch: "Single-key shortcuts", "Atajos de una sola tecla";
    keys_where: "They act while the focus is in the apparatus or nowhere, never while you type.", "Actúan cuando el foco está en el aparato o en ninguna parte, nunca mientras escribes.";
    keys_anywhere: "Apparatus", "Aparato";
    keys_plot: "In a plot", "En una gráfica";
    keys_scene: "On a handle of the scene", "En un asa de la escena";
    key_space: "Space", "Espacio";
    key_play: "Play or pause", "Reproducir o pausar";
    key_reset: "Back to the start", "Volver al inicio";
    key_step: "Step back, step forward", "Paso atrás, paso adelante";
    key_speed: "Slower, faster", "Más lento, más rápido";
    key_keep: "Keep this run", "Guardar esta serie";
    key_help: "This list", "Esta lista";
    key_cursor: "Move the read-out (with Shift: ten rows)", "Mover la lectura (con Mayús: diez filas)";
    key_zoom: "Zoom in, zoom out", "Acercar, alejar";
    key_pan: "Pan (with Ctrl)", "Desplazar (con Ctrl)";
    key_fit: "Show all of the data", "Mostrar todos los datos";
    key_handle: "Move it (with Shift: five times as far)", "Moverla (con Mayús: cinco veces más)";

    // Controls.
    controls: "Controls", "Controles";
    parameters: "Parameters", "Parámetros";
    presets: "Presets", "Ajustes";
    reset_parameters: "Reset parameters", "Restablecer parámetros";
    restarts: "Changing it starts the run anew", "Al cambiarlo, la serie comienza de nuevo";
    state: "State", "Estado";
    state_hint: "Pause to edit; the run then begins from there.", "Pausa para editar; la serie parte entonces de ahí.";
    method: "Method", "Método";
    step: "Step", "Paso";
    numerics: "Numerical method", "Método numérico";

    // Readouts.
    readouts: "Values", "Valores";
    constants: "Derived quantities", "Magnitudes derivadas";
    changing: "Changing with time", "Cambian con el tiempo";

    // Plots.
    plots: "Plots", "Gráficas";
    plot: "plot", "gráfica";
    plots_shown: "Plots shown", "Gráficas visibles";
    no_plots: "All plots are hidden.", "Todas las gráficas están ocultas.";
    plot_keys: "Arrow keys read values, plus and minus zoom, 0 shows everything.", "Las flechas leen valores, más y menos acercan y alejan, 0 muestra todo.";
    zoom_in: "Zoom in", "Acercar";
    zoom_out: "Zoom out", "Alejar";
    fit: "Show all", "Mostrar todo";
    save_svg: "Download SVG", "Descargar SVG";
    save_png: "Download PNG", "Descargar PNG";

    // Runs.
    runs: "Kept runs", "Series guardadas";
    keep: "Keep run", "Guardar serie";
    keep_title: "Keep this run and draw the next one over it", "Guardar esta serie y dibujar la siguiente encima";
    remove_run: "Remove", "Quitar";
    ghost: "Earlier run", "Serie anterior";

    // The notebook.
    notebook: "Notebook", "Cuaderno";
    introduction: "Introduction", "Introducción";
    contents: "Contents", "Contenido";
    equations: "Model", "Modelo";
    equations_intro: "The equations as the document states them; the program solves exactly these.", "Las ecuaciones tal como las enuncia el documento; el programa resuelve exactamente estas.";
    data: "Data", "Datos";
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
    copy_csv: "Copy CSV", "Copiar CSV";

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
    warnings: "Remarks on this document", "Observaciones sobre este documento";
    error: "Error", "Error";
    warning: "Warning", "Aviso";
    line: "line", "línea";
    help: "Help", "Ayuda";
    nothing: "There is no document in this page", "No hay ningún documento en esta página";
    nothing_intro: "Open a simulation document: a Markdown file with a model in it, or a page that Meniscus exported.", "Abre un documento de simulación: un archivo Markdown con un modelo, o una página exportada por Meniscus.";
    unreadable: "This file is neither a simulation document nor an exported page", "Este archivo no es un documento de simulación ni una página exportada";
}

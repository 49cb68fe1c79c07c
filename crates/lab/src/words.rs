//! The words of measuring, fitting and opening documents in every language; those around a simulation are in `view`, what
//! measuring says is in `desk`.

use view::{table_of_words, words as around};

table_of_words! {
    @beside around;
    // The page.
    link_without_translations: "The translations are too long for a link", "Las traducciones son demasiado largas para un enlace";
    link_needs_file: "The document is too long for a link; whoever opens it also needs the file", "El documento es demasiado largo para un enlace; quien lo abra necesita también el archivo";
    not_saved: "The browser does not let this page store anything (storage full or forbidden): records, fits, answers and what is written will be lost when the page is closed", "El navegador no deja que esta página guarde nada (almacenamiento lleno o prohibido): los registros, los ajustes, las respuestas y lo que se escriba se perderán al cerrar la página";
    records_closed: "More records are stored than can be open at once. Remove one and load the page again to see the others", "Hay más registros guardados de los que pueden estar abiertos a la vez. Quita uno y vuelve a cargar la página para ver los demás";
    open: "Open", "Abrir";
    open_title: "Open a simulation document or an exported page", "Abrir un documento de simulación o una página exportada";
    file_not_read: "The browser could not read this file:", "El navegador no pudo leer este archivo:";

    drop_title: "Drop a document, a film or measured data", "Suelta un documento, un vídeo o datos medidos";
    drop_what: "A simulation document, an exported page, a film of an experiment, or a table from a sensor", "Un documento de simulación, una página exportada, un vídeo de un experimento o una tabla de un sensor";

    // Measurements.
    measurements_intro: "Open a film of an experiment and click what moves, or bring a record: a table of times and values as text, XLSX or ODS, as the tracking program or spreadsheet wrote it. Drop the file anywhere on this page, choose it, or paste it. It stays in your browser.", "Abre un vídeo de un experimento y haz clic en lo que se mueve, o trae un registro: una tabla de tiempos y valores como texto, XLSX u ODS, tal como la escribió el programa de seguimiento o la hoja de cálculo. Suelta el archivo en cualquier parte de esta página, elígelo o pégalo. No sale de tu navegador.";
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
    save_record: "Download", "Descargar";
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
    library_search: "Search", "Buscar";
    library_topics: "Topics", "Temas";
    library_found: "Documents found", "Documentos encontrados";
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

    // Writing.
    tab_write: "Write", "Escribir";
    editor_label: "Text of the document", "Texto del documento";
    editor_keys: "Tab leads out of the text. Control with M lets it indent, and again lead out. Control with F searches.", "El tabulador lleva fuera del texto. Control con M hace que ponga sangría, y otra vez que lleve fuera. Control con F busca.";
    editor_waiting: "The editor is loading ...", "El editor se está cargando ...";
    editor_missing: "The editor could not be loaded. Load the page again.", "No se ha podido cargar el editor. Vuelve a cargar la página.";
    writing_file: "File", "Archivo";
    save_writing: "Save", "Guardar";
    save_writing_title: "Save the text as a file", "Guardar el texto como archivo";
    format_writing: "Format", "Dar formato";
    format_writing_title: "Give the text one layout: blanks, indentation, columns. What it means stays the same.", "Dar al texto una disposición: espacios, sangrías, columnas. Lo que significa no cambia.";
    formatted: "The text has its layout.", "El texto tiene su disposición.";
    format_nothing: "The text has its layout already.", "El texto ya tiene su disposición.";
    format_left: "Parts with errors keep the layout they have.", "Las partes con errores conservan la disposición que tienen.";
    new_document: "New", "Nuevo";
    new_document_from: "Begin a new document with", "Empezar un documento nuevo con";
    kept_documents: "Go on with what you wrote", "Seguir con lo que escribiste";
    new_empty: "Empty document", "Documento vacío";
    versions: "Versions", "Versiones";
    versions_intro: "Open an earlier version; the present text becomes a version, too. Lines are compared with the version before.", "Abre una versión anterior; el texto actual también queda como versión. Las líneas se comparan con la versión anterior.";
    no_versions: "There are no versions yet. They are made while you write, and stay in this browser.", "Todavía no hay versiones. Se guardan mientras escribes y se quedan en este navegador.";
    version_first: "first version", "primera versión";
    version_lines: "lines", "líneas";
    version_opened: "The version is open. Ctrl Z in the text goes back.", "La versión está abierta. Ctrl Z en el texto vuelve atrás.";
    file_followed: "The file has changed; its text runs.", "El archivo ha cambiado; su texto está en marcha.";
    text_runs: "The simulation runs as written.", "La simulación funciona tal como está escrita.";
    text_waits: "The last version without errors is running.", "Sigue funcionando la última versión sin errores.";
    one_error: "error", "error";
    many_errors: "errors", "errores";
    one_warning: "remark", "observación";
    many_warnings: "remarks", "observaciones";

    writing_panels: "The document as", "El documento como";
    panel_text: "Text", "Texto";
    panel_model: "Model", "Modelo";
    insight: "Under the cursor", "Bajo el cursor";
    insight_none: "What the cursor is on is explained here.", "Aquí se explica aquello sobre lo que está el cursor.";
    panel_questions: "Questions", "Preguntas";
    questions_none: "This document asks no question yet.", "Este documento aún no hace ninguna pregunta.";
    question_answer: "Answer", "Respuesta";
    question_supposes: "Supposes", "Supone";
    question_unlocks: "Hidden until answered", "Oculto hasta responder";
    question_explanation_title: "Explanation", "Explicación";
    question_in_text: "Go to the text", "Ir al texto";
    question_prompt_title: "What is asked", "Qué se pregunta";
    question_tolerance: "Tolerance in percent", "Tolerancia en tanto por ciento";
    question_hides: "Hide its value until it is answered", "Ocultar su valor hasta que se responda";
    question_answers_note: "The model computes the answer from a definition that depends on parameters alone, such as T = 2*pi*sqrt(m/k).", "El modelo calcula la respuesta con una definición que solo depende de parámetros, como T = 2*pi*sqrt(m/k).";
    question_add: "Add question", "Añadir pregunta";
    panel_translation: "Translation", "Traducción";
    translation_none: "This document has no translation yet. Equations, drawing and answers are shared; a translation has the words alone.", "Este documento aún no tiene traducción. Las ecuaciones, el dibujo y las respuestas son comunes; una traducción solo tiene los textos.";
    translation_another: "Another translation", "Otra traducción";
    translation_begin: "Begin a translation", "Empezar una traducción";
    translation_exists: "There is a translation into this language already", "Ya hay una traducción a este idioma";
    translation_complete: "Nothing is missing.", "No falta nada.";
    translation_one_missing: "1 text has no translation.", "1 texto no tiene traducción.";
    translation_missing: "texts have no translation.", "textos no tienen traducción.";
    translation_only_missing: "Missing ones only", "Solo los que faltan";
    translation_mark: "missing", "falta";
    text_title: "Title", "Título";
    text_summary: "Summary", "Resumen";
    text_topics: "Topics", "Temas";
    text_prose: "Text", "Texto";
    question_prompt: "prompt", "enunciado";
    question_explanation: "explanation", "explicación";
    undo_change: "Undo", "Deshacer";
    redo_change: "Redo", "Rehacer";
    remove_statement: "Remove", "Quitar";
    form_parameters: "Parameters", "Parámetros";
    form_initial_values: "Initial values", "Valores iniciales";
    form_equations: "Equations and definitions", "Ecuaciones y definiciones";
    form_events: "Events", "Eventos";
    form_choices: "Choices", "Elecciones";
    form_tables: "Tables", "Tablas";
    form_statement: "Statement", "Sentencia";
    add_parameter: "Parameter", "Parámetro";
    add_initial_value: "Quantity with an initial value", "Magnitud con valor inicial";
    add_equation: "Equation or definition", "Ecuación o definición";
    add_event: "Event", "Evento";
    add_choice: "Choice", "Elección";
    add_table: "Table", "Tabla";
    column_name: "Name", "Nombre";
    column_quantity: "Quantity", "Magnitud";
    column_value: "Value", "Valor";
    column_start: "At the start", "Al inicio";
    column_shown_in: "Shown in", "Se muestra en";
    column_range: "Range", "Intervalo";
    column_step: "Step", "Paso";
    column_label: "Label", "Etiqueta";
    switch_on: "on", "sí";
    switch_off: "off", "no";

    // Diagnostics.
    nothing_runs: "There is nothing to run yet", "Todavía no hay nada que ejecutar";
    nothing_runs_intro: "The model has errors. They are listed below the text in the tab Write, each with its place. As soon as they are corrected, the simulation appears here.", "El modelo tiene errores. Están debajo del texto en la pestaña Escribir, cada uno con su lugar. En cuanto estén corregidos, la simulación aparece aquí.";
    previous_document: "Back to the previous document", "Volver al documento anterior";
    other_documents: "Other documents", "Otros documentos";
    warnings: "Remarks on this document", "Observaciones sobre este documento";
    error: "Error", "Error";
    warning: "Warning", "Aviso";
    line: "line", "línea";
    help: "Help", "Ayuda";
    nothing: "There is no document in this page", "No hay ningún documento en esta página";
    nothing_intro: "Open a simulation document: a Markdown file with a model in it, or a page that Meniscus exported.", "Abre un documento de simulación: un archivo Markdown con un modelo, o una página exportada por Meniscus.";
    unreadable: "This file is neither a simulation document nor an exported page", "Este archivo no es un documento de simulación ni una página exportada";
    project_items_refused: "Records, fits, films and answers that could not be taken:", "Registros, ajustes, vídeos y respuestas que no se han podido tomar:";
}

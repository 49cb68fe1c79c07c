//! Texts of the film views in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    // The stage.
    film: "Film", "Vídeo";
    scene: "Scene", "Escena";
    show_scene: "Show the scene", "Mostrar la escena";
    close: "Close the film", "Cerrar el vídeo";
    not_opened: "The film could not be opened:", "No se pudo abrir el vídeo:";
    no_document: "A film needs a document that runs. Open one from the list of documents first", "Un vídeo necesita un documento que funcione. Abre primero uno de la lista de documentos";
    taken_up: "Film recognised: your earlier work is restored", "Vídeo reconocido: se ha recuperado tu trabajo anterior";
    same_name: "Another film has the same name; the work on that one is kept apart", "Otro vídeo tiene el mismo nombre; el trabajo con aquel se conserva aparte";
    project_film_not_opened: "The positions of the project are a record; its film was not opened:", "Las posiciones del proyecto son un registro; no se abrió su vídeo:";
    project_film_opened: "The film of the project is open, with its positions and its scale. Times are now those of the film's frames", "El vídeo del proyecto está abierto, con sus posiciones y su escala. Los tiempos son ahora los de los fotogramas del vídeo";
    unpacked_too_large: "it is too large to be unpacked here; unpack the project and open the film itself", "es demasiado grande para descomprimirlo aquí; descomprime el proyecto y abre el vídeo mismo";
    opening: "Opening", "Abriendo";
    frames: "frames", "fotogramas";
    frame: "frame", "fotograma";
    film_time: "Frame of the film", "Fotograma del vídeo";
    film_transport: "Frames of the film", "Fotogramas del vídeo";
    previous: "Previous frame", "Fotograma anterior";
    next: "Next frame", "Fotograma siguiente";
    next_doubtful: "Next doubtful frame", "Siguiente fotograma dudoso";
    picture_keys: "Arrow keys: previous and next frame, with Shift ten frames. Period: next doubtful frame. Enter: place a point by keys; then arrows move it by a pixel, with Shift by ten, Enter sets it, Escape leaves it.", "Flechas: fotograma anterior y siguiente, con Mayús diez fotogramas. Punto: siguiente fotograma dudoso. Intro: colocar un punto con el teclado; entonces las flechas lo mueven un píxel, con Mayús diez, Intro lo fija y Escape lo abandona.";
    space_time: "Space-time picture, surface", "Imagen espacio-tiempo, superficie";
    space_time_hint: "A strip along the tube from every frame. Drag the curve up or down where it is wrong", "Una franja a lo largo del tubo de cada fotograma. Arrastra la curva arriba o abajo donde esté mal";
    space_time_keys: "Left and right: frames. Up and down: move the surface in this frame, with Shift ten rows; Enter sets it, Escape leaves it, Delete forgets a correction.", "Izquierda y derecha: fotogramas. Arriba y abajo: mover la superficie en este fotograma, con Mayús diez filas; Intro la fija, Escape la abandona, Suprimir olvida una corrección.";
    from_model: "from the model", "del modelo";
    model_far: "the model is far away: fit it to the record", "el modelo está lejos: ajústalo al registro";
    model_far_without_origin: "the model is far away: set the origin, or fit", "el modelo está lejos: fija el origen o ajusta";
    play: "Play the film", "Reproducir el vídeo";
    pause: "Pause the film", "Pausar el vídeo";

    // Prompts for the next click.
    leave: "Not now", "Ahora no";
    ask_surface: "Click the surface of the liquid", "Haz clic en la superficie del líquido";
    ask_second_surface: "Click the surface in the other arm", "Haz clic en la superficie de la otra rama";
    ask_body: "Click the body", "Haz clic en el cuerpo";
    ask_hand: "Click the point; the next frame follows", "Haz clic en el punto; sigue el fotograma siguiente";
    ask_tube: "Click one end of the tube's axis", "Haz clic en un extremo del eje del tubo";
    ask_other_end: "Click the other end", "Haz clic en el otro extremo";
    ask_still: "Click marks that rest, up to four", "Haz clic en marcas fijas, hasta cuatro";
    ask_ruler: "Click a mark of the ruler", "Haz clic en una marca de la regla";
    ask_second_mark: "Click another mark of the ruler", "Haz clic en otra marca de la regla";
    ask_origin: "Click the point that becomes zero", "Haz clic en el punto que será el cero";
    ask_axis: "Click a point to which the x axis leads from the origin", "Haz clic en un punto hacia el que va el eje x desde el origen";
    ask_corner: "Click the four corners of the rectangle", "Haz clic en las cuatro esquinas del rectángulo";
    remove: "Remove", "Quitar";
    remove_key: "Remove (Delete)", "Quitar (Suprimir)";
    surface: "Surface", "Superficie";
    tube_end: "End of the tube", "Extremo del tubo";
    body: "Body", "Cuerpo";
    point: "Point", "Punto";
    fixed_mark: "Fixed mark", "Marca fija";
    ruler_mark: "Mark of the ruler", "Marca de la regla";
    origin: "Origin", "Origen";
    axis: "Direction of the x axis", "Dirección del eje x";
    corner: "Corner", "Esquina";

    // The four steps.
    open: "Open film", "Abrir un vídeo";
    record_film: "Record film", "Grabar un vídeo";
    stop_recording: "Stop recording", "Detener la grabación";
    no_camera: "The browser gives no camera to this page: it was refused, or none is there", "El navegador no da ninguna cámara a esta página: se denegó o no la hay";
    film_simulation: "Film this simulation", "Filmar esta simulación";
    film_again: "Film again", "Filmar de nuevo";
    filming: "Filming the simulation", "Filmando la simulación";
    filmed: "The simulation was filmed", "La simulación se filmó";
    filming_note: "A virtual camera films the simulation with its present parameters from its start. The film is tracked like any other, and nothing leaves the page. Frames have no compression.", "Una cámara virtual filma la simulación con sus parámetros actuales desde el principio. El vídeo se sigue como cualquier otro y nada sale de la página. Los fotogramas no tienen compresión.";
    filming_seconds: "Duration", "Duración";
    filming_rate: "Frame rate", "Frecuencia";
    filming_exposure: "Exposure", "Exposición";
    filming_noise: "Noise", "Ruido";
    filming_seed: "Noise seed", "Semilla del ruido";
    filming_ruler: "In the picture, 640 × 360 px, stands a ruler of", "En la imagen, de 640 × 360 px, hay una regla de";
    filming_no_ruler: "The drawing has no scale of lengths: the record stays in pixels. The picture has 640 × 360 px.", "El dibujo no tiene escala de longitudes: el registro queda en píxeles. La imagen tiene 640 × 360 px.";
    start_filming: "Film", "Filmar";
    not_drawn: "The browser did not draw the scene. Try again, or another browser.", "El navegador no dibujó la escena. Inténtalo de nuevo o con otro navegador.";
    compare_truth: "Compare with the true values", "Comparar con los valores verdaderos";
    truth: "Deviation from the true values", "Desviación de los valores verdaderos";
    rms: "RMS", "RMS";
    truth_scale: "Error of the scale", "Error de la escala";
    truth_legend: "Found minus true over time", "Hallado menos verdadero en el tiempo";
    truth_legend_body: "Found minus true over time, to the right (solid) and down (dashed)", "Hallado menos verdadero en el tiempo, hacia la derecha (continua) y hacia abajo (discontinua)";
    ruler_is: "The ruler in the picture is", "La regla de la imagen mide";
    camera_picture: "Picture of the camera", "Imagen de la cámara";
    acts: "From film to record", "Del vídeo al registro";
    act_film: "Film", "Vídeo";
    act_follow: "Click what moves", "Haz clic en lo que se mueve";
    act_lengths: "Click the ruler and the origin", "Haz clic en la regla y en el origen";
    act_record: "Record", "Registro";
    times: "Times and part", "Tiempos y parte";
    factor: "Slow motion, factor", "Cámara lenta, factor";
    factor_note: "How many times slower the film plays than things happened: 8, or 240/30 as a quotient of rates. Compare a known time.", "Cuántas veces más lento se reproduce el vídeo que lo ocurrido: 8, o 240/30 como cociente de frecuencias. Compara un tiempo conocido.";
    from: "From", "Desde";
    until: "Until", "Hasta";
    from_here: "From this frame", "Desde este fotograma";
    until_here: "Until this frame", "Hasta este fotograma";
    kinds: "What to track", "Qué seguir";
    kind_surface: "Surface in a tube", "Superficie en un tubo";
    kind_arms: "Both arms", "Ambas ramas";
    kind_body: "Body", "Cuerpo";
    kind_hand: "By hand", "A mano";
    hint_surface: "One click on the surface in any frame; the curve follows.", "Un clic en la superficie en cualquier fotograma; la curva sigue.";
    hint_arms: "One click on the surface in each arm.", "Un clic en la superficie de cada rama.";
    hint_body: "One click on the body in the first frame of its motion; where it is lost, click it again.", "Un clic en el cuerpo en el primer fotograma de su movimiento; donde se pierda, haz clic de nuevo.";
    hint_hand: "A click in each frame, for what nothing else can follow.", "Un clic en cada fotograma, para lo que nada más puede seguir.";
    click_it: "Click it in the film", "Hacer clic en el vídeo";
    another_body: "Another body", "Otro cuerpo";
    radius: "Radius", "Radio";
    radius_found: "found from the click", "hallado a partir del clic";
    find_radius: "Find from the click", "Hallar a partir del clic";
    radius_note: "The circle around the click shows it. If the circle does not fit the body, enter its radius: the film is tracked again.", "El círculo alrededor del clic lo muestra. Si el círculo no se ajusta al cuerpo, escribe su radio: el vídeo se sigue de nuevo.";
    difficult: "Tilted tube, shaking camera", "Tubo inclinado, cámara que tiembla";
    tube: "Axis of the tube", "Eje del tubo";
    fixed_marks: "Fixed marks", "Marcas fijas";
    difficult_note: "A tube that is not upright: two points of its axis. A camera that shakes: two to four marks that rest, in the first frame of the part.", "Un tubo que no es vertical: dos puntos de su eje. Una cámara que tiembla: de dos a cuatro marcas fijas, en el primer fotograma de la parte.";
    forget_marks: "Forget the fixed marks", "Olvidar las marcas fijas";
    hint_ruler: "Two marks and the length between them; without a ruler the record stays in pixels. The origin is the point at which the quantity of the model is zero.", "Dos marcas y la longitud entre ellas; sin regla, el registro queda en píxeles. El origen es el punto en el que la magnitud del modelo es cero.";
    click_ruler: "Two marks", "Dos marcas";
    set_origin: "Origin", "Origen";
    lacks_origin: "The origin is missing: choose Origin and click the height that is zero in the model, such as the level of rest. Until then heights count from the bottom of the picture.", "Falta el origen: elige Origen y haz clic en la altura que es cero en el modelo, como el nivel de reposo. Hasta entonces las alturas se cuentan desde el borde inferior de la imagen.";
    set_axis: "x axis", "Eje x";
    length: "Length", "Longitud";
    intervals: "Marks divide it into", "Las marcas la dividen en";
    in_pixels: "Stay in pixels", "Dejar en píxeles";
    more_lengths: "Perspective, ruler behind the tube", "Perspectiva, regla detrás del tubo";
    rectangle: "Corners of a rectangle", "Esquinas de un rectángulo";
    width: "Width", "Anchura";
    height: "Height", "Altura";
    parallax_note: "A ruler that is not where the motion is:", "Una regla que no está donde el movimiento:";
    behind: "Behind it by", "Detrás, a";
    distance: "Camera at", "Cámara a";
    following: "Following", "Siguiendo";
    computing: "computing the positions", "calculando las posiciones";
    cancel: "Cancel", "Cancelar";
    no_record: "The record appears here once something has been clicked.", "El registro aparece aquí cuando se haya hecho clic en algo.";
    doubtful: "Doubtful frames", "Fotogramas dudosos";
    doubts_note: "The period key leads from one to the next. Drag the curve under the film where it is wrong.", "La tecla del punto lleva de uno al siguiente. Arrastra la curva bajo el vídeo donde esté mal.";
    fit: "Fit", "Ajustar";
    show_record: "Show the record", "Mostrar el registro";
}

/// Texts in the current language, without tracking the signal.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

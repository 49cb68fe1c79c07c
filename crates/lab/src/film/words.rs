//! The words of films in every language.

use view::table_of_words;

table_of_words! {
    film: "Film", "Vídeo";
    scene: "Scene", "Escena";
    show_scene: "Show the scene", "Mostrar la escena";
    show_film: "Show the film", "Mostrar el vídeo";
    close: "Close the film", "Cerrar el vídeo";
    not_opened: "The film could not be opened:", "No se pudo abrir el vídeo:";
    opening: "Opening", "Abriendo";
    frame: "frame", "fotograma";
    frames: "frames", "fotogramas";
    film_time: "Frame of the film", "Fotograma del vídeo";
    film_transport: "Frames of the film", "Fotogramas del vídeo";
    previous: "Previous frame", "Fotograma anterior";
    next: "Next frame", "Fotograma siguiente";
    next_doubtful: "Next doubtful frame", "Siguiente fotograma dudoso";
    picture_keys: "Arrow keys: previous and next frame, with Shift ten frames. Period: next doubtful frame. Enter: place a point by keys; then arrows move it by a pixel, with Shift by ten, Enter sets it, Escape leaves it.", "Flechas: fotograma anterior y siguiente, con Mayús diez fotogramas. Punto: siguiente fotograma dudoso. Intro: colocar un punto con el teclado; entonces las flechas lo mueven un píxel, con Mayús diez, Intro lo fija y Escape lo abandona.";
}

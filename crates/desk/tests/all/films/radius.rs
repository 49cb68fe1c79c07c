//! The radius of a body: found around the click, set, refused, and found again.

use super::scene::{HEIGHT, WIDTH, container, identity, track};
use super::{laboratory, ruler};
use desk::film::Plane;
use desk::film::tracking::column::Click;
use desk::film::tracking::lost_from;
use desk::saved::Item;
use desk::{Announcement, Desk, FilmedBody, Subject};

/// Frames of the film.
const FRAMES: usize = 24;
/// Radius of the ball in pixels.
const BALL: f64 = 12.0;
/// From the centre of the ball to the click, in pixels.
const BESIDE: [f64; 2] = [3.0, -2.0];

fn centre(frame: usize) -> [f64; 2] {
    [60.0 + 2.0 * frame as f64, 110.0 + 8.0 * libm::sin(0.3 * frame as f64)]
}

/// A dark ball on a bright wall, in the picture of the U-tube.
fn picture(frame: usize) -> Plane {
    let [x, y] = centre(frame);
    let grey = |at: usize| {
        let far = libm::hypot((at % WIDTH) as f64 + 0.5 - x, (at / WIDTH) as f64 + 0.5 - y);
        (200.0 - 70.0 * (1.0 - libm::erf((far - BALL) / 1.1)) + (at * 7 % 5) as f64).round() as u8
    };
    Plane::new(WIDTH, HEIGHT, (0..WIDTH * HEIGHT).map(grey).collect()).unwrap()
}

/// A click so many pixels from the centre of the ball.
fn ball([across, down]: [f64; 2]) -> Subject {
    let [x, y] = centre(0);
    Subject::Bodies(vec![FilmedBody::new(Click { frame: 0, position: [x + across, y + down] })])
}

/// A film with a clicked ball, not tracked yet.
fn clicked() -> Desk {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("ball.mp4"), container(FRAMES))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, ball(BESIDE))).unwrap();
    desk
}

/// Radius, distance of the centre from that of the ball, both in pixels; true for a radius that was set.
fn outline(desk: &Desk) -> Option<(f64, f64, bool)> {
    let outline = desk.films().current().unwrap().body_outline(0)?;
    let aside = libm::hypot(outline.offset[0] + BESIDE[0], outline.offset[1] + BESIDE[1]);
    Some((outline.radius, aside, outline.is_set))
}

fn assert_found(desk: &Desk) {
    let (radius, aside, is_set) = outline(desk).unwrap();
    assert!((radius - BALL).abs() < 2.0 && aside < 2.0 && !is_set, "{radius} {aside} {is_set}");
}

#[test]
fn the_radius_is_found_and_set_and_found_again() {
    let mut desk = clicked();
    assert_eq!(outline(&desk), None, "nothing is known before the film was tracked");
    track(&mut desk, &picture);
    assert_found(&desk);
    let found = desk.films().current().unwrap().tracks();
    let aside = libm::hypot(BESIDE[0], BESIDE[1]);
    desk.work_on_film(|films, play| films.set_radius(play, 0, Some(16.0))).unwrap();
    assert_eq!(outline(&desk), Some((16.0, aside, true)), "at once, around the click");
    assert_eq!(track(&mut desk, &picture), FRAMES, "the film is tracked with it");
    let set = desk.films().current().unwrap().tracks();
    assert_eq!(set[0].outline.map(|outline| outline.radius), Some(16.0), "by the tracker itself");
    assert!(set[0].points != found[0].points);
    desk.work_on_film(|films, play| films.set_radius(play, 0, None)).unwrap();
    assert_eq!(outline(&desk), None, "the radius that was set is not taken for one that was found");
    track(&mut desk, &picture);
    assert_eq!(desk.films().current().unwrap().tracks(), found);
}

#[test]
fn a_radius_is_a_length_once_there_is_a_scale() {
    let mut desk = clicked();
    let metres = |desk: &Desk| desk.films().current().unwrap().body_outline(0).unwrap().metres;
    desk.work_on_film(|films, play| films.set_radius(play, 0, Some(16.0))).unwrap();
    assert_eq!(metres(&desk), None);
    // 10 cm are 100 pixels.
    desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    assert!((metres(&desk).unwrap() - 0.016).abs() < 1e-12);
}

/// The picture has 240 rows: the tracker follows 3 to 80 pixels.
#[test]
fn a_radius_that_cannot_be_followed_is_refused() {
    let mut desk = clicked();
    desk.work_on_film(|films, play| films.set_radius(play, 0, Some(16.0))).unwrap();
    let texts = [("en", "from 3 to 80 px"), ("es", "de 3 a 80 px")];
    for radius in [f64::NAN, f64::INFINITY, -16.0, 0.0, 2.9, 80.1, 1e9] {
        for (language, part) in texts {
            desk.set_language(language);
            let refusal = desk.work_on_film(|films, play| films.set_radius(play, 0, Some(radius))).unwrap_err();
            let text = refusal.text(desk.play());
            assert!(text.contains(part), "{radius}: {text}");
        }
        assert!(outline(&desk).is_some_and(|outline| outline.0 == 16.0), "{radius} changes nothing");
    }
    for (click, radius) in [([BALL, 0.0], 3.0), (BESIDE, 80.0)] {
        desk.work_on_film(|films, play| films.follow(play, ball(click))).unwrap();
        desk.work_on_film(|films, play| films.set_radius(play, 0, Some(radius))).unwrap();
        track(&mut desk, &picture);
        let tracks = desk.films().current().unwrap().tracks();
        assert_eq!(tracks[0].outline.map(|outline| outline.radius), Some(radius), "no other radius is used");
    }
    // Inside the ball nothing is seen within so few pixels.
    desk.work_on_film(|films, play| films.set_radius(play, 0, Some(3.0))).unwrap();
    desk.change_films(|films, play| films.begin_tracking(play)).unwrap();
    let refusal = desk.change_films(|films, play| films.give_frame(play, 0, picture(0))).unwrap_err();
    let text = refusal.text(desk.play());
    assert!(text.contains("radio de 3 px") && text.contains("radio mayor"), "{text}");
    assert!(desk.work_on_film(|films, play| films.set_radius(play, 1, Some(16.0))).is_err(), "there is no second body");
    desk.work_on_film(|films, play| films.follow(play, super::surface())).unwrap();
    assert!(desk.work_on_film(|films, play| films.set_radius(play, 0, Some(16.0))).is_err(), "a surface has no radius");
    desk.change_films(|films, _| films.close());
    assert!(desk.work_on_film(|films, play| films.set_radius(play, 0, Some(16.0))).is_err());
}

/// At the next visit the circle is there before the film is tracked again, whether it was set or found.
#[test]
fn the_outline_is_there_at_the_next_visit() {
    for radius in [None, Some(16.0)] {
        let mut desk = clicked();
        desk.work_on_film(|films, play| films.set_radius(play, 0, radius)).unwrap();
        track(&mut desk, &picture);
        let text = desk.films().saved()[0].1.write(7);
        let visit = |text: &str| {
            let mut next = laboratory();
            next.restore_item(&Item::read(text).unwrap().1).unwrap();
            next.change_films(|films, play| films.open(play, identity("ball.mp4"), container(FRAMES))).unwrap();
            next
        };
        let next = visit(&text);
        assert!(outline(&next).is_some());
        assert_eq!(next.films().current().unwrap().body_outline(0), desk.films().current().unwrap().body_outline(0));
        // Stored text is not trusted.
        let Some(radius) = radius else { continue };
        let own = format!("\"radius\":{radius:?}");
        assert!(text.contains(&own), "{text}");
        let broken = visit(&text.replace(&own, "\"radius\":1e9"));
        assert!(broken.films().current().unwrap().subject().is_nothing());
    }
}

#[test]
fn a_lost_ball_is_announced_with_its_reason_in_place_of_success() {
    let mut desk = clicked();
    // Behind something from the ninth frame on.
    let wall = |frame: usize| {
        let grey = |at: usize| 200 + (at * (7 + frame) % 5) as u8;
        Plane::new(WIDTH, HEIGHT, (0..WIDTH * HEIGHT).map(grey).collect()).unwrap()
    };
    track(&mut desk, &|frame| if frame < 8 { picture(frame) } else { wall(frame) });
    let film = desk.films().current().unwrap();
    assert_eq!(lost_from(&film.doubtful()), Some(8));
    assert_eq!(
        desk.films().losses(),
        "Lost from frame 9 on (counted from 1; 0.266 s of the film): soon after the click, so that the circle may hold wall or shadow beside the body; set a smaller radius, or click it in another frame."
    );
    let said: Vec<_> = std::iter::from_fn(|| desk.take_announcement()).collect();
    assert!(said.contains(&Announcement::FilmTracked(desk.films().losses())), "{said:?}");
    // Followed to the end, it is tracked and nothing else.
    desk.work_on_film(|films, play| films.set_radius(play, 0, Some(BALL))).unwrap();
    track(&mut desk, &picture);
    assert_eq!(desk.films().losses(), "");
    let said: Vec<_> = std::iter::from_fn(|| desk.take_announcement()).collect();
    assert!(said.contains(&Announcement::FilmTracked(String::new())), "{said:?}");
}

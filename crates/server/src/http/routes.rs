//! The routes and the guards before them.

use super::state::Server;
use super::{guard, health, log, mine, stream, student, teacher};
use axum::Router;
use axum::middleware;
use axum::routing::{get, post};
use std::sync::Arc;

impl Server {
    /// The routes.
    pub fn routes(self: &Arc<Self>) -> Router {
        let students = Router::new()
            .route("/api/join", post(student::join))
            .route("/api/state", get(student::state))
            .route("/api/stream", get(stream::of_student))
            .route("/api/events", post(student::events))
            .route("/api/mine", get(mine::download))
            .route("/api/hand-in/{document}", get(mine::hand_in))
            .route("/api/erase", post(mine::erase))
            .route("/api/others", get(student::others))
            .route("/api/file/{name}", get(mine::file))
            .route("/api/survey", post(student::survey))
            .layer(middleware::from_fn(guard::any_origin));
        let teacher = Router::new()
            .route("/teacher", get(teacher::page))
            .route("/api/teacher/exchange", post(teacher::exchange))
            .route("/api/teacher/class", get(teacher::class))
            .route("/api/teacher/settings", post(teacher::set))
            .route("/api/teacher/approve", post(teacher::approve))
            .route("/api/teacher/erase", post(teacher::erase))
            .route("/api/teacher/erase-unused", post(teacher::erase_unused))
            .route("/api/teacher/renew-code", post(teacher::renew_code))
            .route("/api/teacher/revoke", post(teacher::revoke))
            .route("/api/teacher/events", get(stream::poll))
            .route("/api/teacher/stream", get(stream::of_teacher))
            .route("/api/teacher/hand-in", post(teacher::hand_in))
            .route("/api/teacher/sheets", get(teacher::sheets))
            .layer(middleware::from_fn_with_state(self.clone(), guard::teacher_place));
        Router::new()
            .route("/", get(student::index))
            .route("/d/{name}", get(student::document))
            .route("/stored", get(student::stored))
            .route("/health", get(health::health))
            .merge(students)
            .merge(teacher)
            .layer(middleware::from_fn_with_state(self.clone(), guard::host))
            .layer(middleware::from_fn_with_state(self.log.clone(), log::request))
            .with_state(self.clone())
    }
}

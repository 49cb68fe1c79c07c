//! The browser shell of the laboratory.
use leptos::prelude::*;

fn main() {
    let count = RwSignal::new(0);
    mount_to_body(
        move || view! { <button on:click=move |_| count.update(|n| *n += 1)>"Count " {count}</button> },
    );
}

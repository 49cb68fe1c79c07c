//! Tools for building views: Sycamore's elements and signals, and helpers to combine them. Closures are boxed first, so
//! that the code behind them is compiled once instead of for every use.

pub use crate::pieces::{
    button, column_head, cross, dialog, field_of, labelled, note, number_field, part, refusal_of, row_head,
    short_field, switch, table_in, tick, unit_of, why_refused, with_unit,
};
use std::borrow::Cow;
pub use sycamore_reactive::{ReadSignal, Signal, create_signal};
use sycamore_reactive::{create_effect, create_selector};
use sycamore_web::events::{Event, EventDescriptor};
pub use sycamore_web::tags::html_attributes::*;
pub use sycamore_web::tags::*;
pub use sycamore_web::{GlobalAttributes, HtmlGlobalAttributes, View, document, events, tags, window};
use sycamore_web::{GlobalProps, ViewHtmlNode};
use wasm_bindgen::JsCast;
use web_sys::HtmlInputElement;

/// Helper methods for building elements.
pub trait Build: GlobalProps {
    /// Adds a child.
    fn child(self, child: impl Into<View>) -> Self {
        self.children(child)
    }

    /// Adds a child, if there is one.
    fn maybe(self, child: Option<impl Into<View>>) -> Self {
        match child {
            Some(child) => self.child(child),
            None => self,
        }
    }

    /// Adds a child for each item.
    fn each<T, V: Into<View>>(self, items: impl IntoIterator<Item = T>, mut view: impl FnMut(T) -> V) -> Self {
        let mut element = self;
        for item in items {
            element = element.child(view(item));
        }
        element
    }

    /// Sets tooltip and accessible name.
    fn called(self, name: impl Into<Cow<'static, str>>) -> Self {
        let name: Cow<'static, str> = name.into();
        self.attr("title", name.clone()).attr("aria-label", name)
    }

    /// Sets the content as HTML, which must already be safe.
    fn inner_html(self, html: String) -> Self {
        self.dangerously_set_inner_html(html)
    }

    /// Calls `act` for each event of this type.
    fn when<E: EventDescriptor<EventTy: 'static>>(self, event: E, act: impl FnMut(E::EventTy) + 'static) -> Self {
        let act: Box<dyn FnMut(E::EventTy)> = Box::new(act);
        self.on(event, act)
    }

    /// Node of the element.
    fn node<T: JsCast>(&mut self) -> T {
        self.as_html_node().as_web_sys().clone().unchecked_into()
    }
}

impl<E: GlobalProps> Build for E {}

/// A view for each item, in sequence.
pub fn each<T, V: Into<View>>(items: impl IntoIterator<Item = T>, mut view: impl FnMut(T) -> V) -> View {
    let mut views: Vec<View> = Vec::new();
    for item in items {
        views.push(view(item).into());
    }
    views.into()
}

/// A text that changes. It is written only if it differs, because screen readers may read every change.
pub fn text(read: impl FnMut() -> String + 'static) -> View {
    memo(read).into()
}

/// A view that is rebuilt whenever a signal that it reads has changed.
pub fn changing<V: Into<View>>(mut build: impl FnMut() -> V + 'static) -> View {
    let build: Box<dyn FnMut() -> View> = Box::new(move || build().into());
    View::from_dynamic(build)
}

/// A value that is recomputed whenever a signal that it reads has changed. It notifies its readers only if it differs.
pub fn memo<T: PartialEq>(compute: impl FnMut() -> T + 'static) -> ReadSignal<T> {
    let compute: Box<dyn FnMut() -> T> = Box::new(compute);
    create_selector(compute)
}

/// Runs `act` now and whenever a signal that it reads has changed.
pub fn effect(act: impl FnMut() + 'static) {
    let act: Box<dyn FnMut()> = Box::new(act);
    create_effect(act);
}

/// Value of the field that is the target of an event.
pub fn value_of(event: &Event) -> String {
    event.target().map(|field| field.unchecked_into::<HtmlInputElement>().value()).unwrap_or_default()
}

/// True if the check box that is the target of an event is ticked.
pub fn is_checked(event: &Event) -> bool {
    event.target().is_some_and(|field| field.unchecked_into::<HtmlInputElement>().checked())
}

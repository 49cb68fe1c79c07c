//! Units that labels, axes and comments state. They are used only where the checker accepts all of them together.

use super::controls::Control;
use super::facts::{Facts, Role};
use super::motion::Motion;
use super::plots::Plot;
use super::value::Value;
use std::collections::BTreeMap;

/// Units by variable; empty if none of a state is known.
pub(super) fn stated_units(
    facts: &Facts,
    motion: &Motion,
    controls: &[Control],
    plots: &[Plot],
) -> BTreeMap<String, String> {
    let mut units = BTreeMap::new();
    for control in controls {
        if let Some(unit) = &control.label.unit {
            units.entry(control.variable.clone()).or_insert_with(|| unit.clone());
        }
    }
    for plot in plots {
        if let (Some(unit), [Value::Name(name)]) = (&plot.unit, plot.curves.as_slice()) {
            units.entry(name.clone()).or_insert_with(|| unit.clone());
        }
    }
    for name in &facts.order {
        let Some(fact) = facts.variable(name) else { continue };
        let has_control = controls.iter().any(|control| control.variable == *name && control.is_editable);
        if let Some(unit) = super::controls::label(&fact.comment).unit.filter(|_| !has_control) {
            units.entry(name.clone()).or_insert(unit);
        }
    }
    // The rate of a length is a velocity.
    for (state, rate) in &motion.rates {
        if let (Ok(Value::Name(velocity)), Some(unit)) = (rate, units.get(state).cloned())
            && facts.role(velocity) == Some(Role::State)
        {
            units.entry(velocity.clone()).or_insert_with(|| per_second(&unit));
        }
    }
    let is_of_state = |name: &String| facts.role(name) == Some(Role::State);
    if units.keys().any(is_of_state) { units } else { BTreeMap::new() }
}

fn per_second(unit: &str) -> String {
    match unit.strip_suffix("/s") {
        Some(base) => format!("{base}/s^2"),
        None if unit.contains(['/', ' ']) => format!("({unit})/s"),
        None => format!("{unit}/s"),
    }
}

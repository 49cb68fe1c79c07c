//! Events whose conditions are true at the start: a warning only if the event would have changed something.

/// True if a model is warned about.
fn is_remarked(text: &str) -> bool {
    let (_, found) = model::compile(text, std::slice::from_ref(&(0..text.len())));
    assert!(!model::has_errors(&found), "{text}\n{found:#?}");
    found.iter().any(|one| one.code == "true-at-the-start")
}

#[test]
fn a_thermostat_that_starts_as_its_event_would_set_it_is_not_remarked_on() {
    for (declared, set) in [
        ("discrete on = STATE", "on = true"),
        ("discrete heat = POWER", "heat = 40 [K/h]"),
        ("parameter P = 40 [K/h]\ndiscrete heat = POWER", "heat = P"),
        ("discrete on = STATE\ndiscrete heat = POWER", "on = true, heat = 40 [K/h]"),
    ] {
        let rate = if declared.contains("heat") { "heat" } else { "(if on then 40 [K/h] else 0 [K/h])" };
        for (name, also) in [("", ""), (" as cold", ""), ("", "\nT_max = maximum(T)"), ("", "\nm = mean(T)")] {
            for (begin, starts_cold) in [(15.0, true), (19.0, false)] {
                for starts_on in [true, false] {
                    let state = if starts_on { "true" } else { "false" };
                    let power = if starts_on { "40 [K/h]" } else { "0 [K/h]" };
                    let declared = declared.replace("STATE", state).replace("POWER", power);
                    let text = format!(
                        "{declared}\nT' = {rate} - (T - 280 [K])/(2 [h])\nT(0) = {} [K]\n\
                         when T < 291 [K]{name} {{ {set} }}{also}\n",
                        273.0 + begin
                    );
                    // The event does not fire at the start, so its action is missing there.
                    assert_eq!(is_remarked(&text), starts_cold && !starts_on, "{text}");
                }
            }
        }
    }
}

#[test]
fn an_action_that_always_changes_something_is_remarked_on() {
    for action in ["n = n + 1", "on = true, n = n + 1", "stop", "y = 2*y"] {
        let text = format!(
            "y' = -y/(1 [s])\ny(0) = 1\ndiscrete n = 0\ndiscrete on = true\nz = if on then n else 0\nwhen y > 0.5 {{ {action} }}\n"
        );
        assert!(is_remarked(&text), "{text}");
    }
}

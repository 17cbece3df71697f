//! `orogen params --format schema`: a JSON Schema that accepts every built-in preset and rejects what Orogen rejects.

use orogen::preset::listing;

use orogen::{Compose, Library, Preset, compose};

fn schema(preset: &Preset) -> jsonschema::Validator {
    let survey = Compose::default().survey(&Library::standard(), preset).expect("the scene is readable");
    let text = listing::schema(&survey.declarations, "the test's scene");
    jsonschema::validator_for(&serde_json::from_str(&text).expect("the schema is JSON"))
        .expect("it is a schema")
}

#[test]
fn every_built_in_preset_is_accepted() {
    for name in orogen::source::preset_names() {
        let text =
            std::fs::read_to_string(format!("presets/{name}.json")).expect("presets are in the repository");
        let json = serde_json::from_str(&text).expect("a preset is JSON");
        let schema = schema(&Preset::named(name).expect("it is built in"));
        let faults: Vec<_> = schema.iter_errors(&json).map(|error| error.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {faults:?}");
    }
}

const SCENE: &str = "
#option quality = high { low, high }
#option march.steps = 8, range 1 .. 16
#option water.waves = true
#param sun.elevation: f32 = 14, range -90 .. 90, unit deg
#param sun.color: vec3f = (1, 1, 1), range 0 .. 2, color
#param sun.tint: vec4f = (1, 1, 1, 1), color
#param wind.speed: vec2f = (1, 0)
#param count.rocks: u32 = 3
#param count.depth: i32 = -3
#param count.on: bool = true
@compute @workgroup_size(1) fn main() {}
";

/// Orogen's verdict and the schema's, about the same preset.
fn verdicts(set: &str) -> (bool, bool) {
    let text = format!("{{\"orogen\": 1, \"set\": {set}}}");
    let schema = schema(&Preset::of_text("scene", SCENE));
    let json: serde_json::Value = serde_json::from_str(&text).expect("the test's preset is JSON");
    let ours = Preset::parse("test", &text)
        .map(|preset| preset.with_scene_text("scene", SCENE))
        .and_then(|preset| compose(&Library::empty(), &preset, &orogen::Bake::constants()));
    (ours.is_ok(), schema.is_valid(&json))
}

#[test]
fn right_values_are_accepted_by_both() {
    for set in [
        r#"{}"#,
        r#"{"quality": "low"}"#,
        r#"{"march": {"steps": 16}, "water": {"waves": false}}"#,
        r#"{"march": {"steps": 16.0}, "count": {"rocks": 1e3, "depth": -2.0}}"#,
        r#"{"sun": {}}"#,
        r#"{"sun": {"elevation": -90, "color": [0, 1.5, 2]}}"#,
        r##"{"sun": {"color": "#ffcc00", "tint": "#ffcc0080"}}"##,
        r##"{"sun": {"color": "#fc0", "tint": "#ffcc00"}}"##,
        r#"{"wind": {"speed": [1e10, -3]}, "count": {"rocks": 4294967295, "depth": -5, "on": false}}"#,
    ] {
        assert_eq!(verdicts(set), (true, true), "{set}");
    }
}

#[test]
fn wrong_values_are_rejected_by_both() {
    for set in [
        r#"{"quality": "middling"}"#,
        r#"{"quality": 1}"#,
        r#"{"kwality": "low"}"#,
        r#"{"march": {"steps": 17}}"#,
        r#"{"march": {"steps": 2.5}}"#,
        r#"{"march": {"stepps": 2}}"#,
        r#"{"march": 3}"#,
        r#"{"water": {"waves": "yes"}}"#,
        r#"{"sun": {"elevation": 91}}"#,
        r#"{"sun": {"elevation": "high"}}"#,
        r#"{"sun": {"color": [1, 1]}}"#,
        r#"{"sun": {"color": [1, 1, 3]}}"#,
        r#"{"sun": {"color": [1, 1, true]}}"#,
        r##"{"sun": {"color": "#ffcc0"}}"##,
        r##"{"sun": {"color": "#ffcc0080"}}"##,
        r##"{"sun": {"color": "orange"}}"##,
        r#"{"wind": {"speed": [1, 2, 3]}}"#,
        r##"{"wind": {"speed": "#fff"}}"##,
        r#"{"wind": {"speed": [1e39, 0]}}"#,
        r#"{"count": {"rocks": -1}}"#,
        r#"{"count": {"rocks": 4294967296}}"#,
        r#"{"count": {"depth": 1.5}}"#,
        r#"{"count": {"on": 1}}"#,
        r#"{"moon": {"phase": 1}}"#,
        r#"{"moon": {}}"#,
        r#"{"quality": {}}"#,
        r#"{"sun.elevation": 5}"#,
    ] {
        assert_eq!(verdicts(set), (false, false), "{set}");
    }
}

#[test]
fn the_preset_itself_is_checked_too() {
    let schema = schema(&Preset::of_text("scene", SCENE));
    for text in [
        r#"{}"#,
        r#"[]"#,
        r#"{"orogen": 2}"#,
        r#"{"orogen": "1"}"#,
        r#"{"orogen": 1, "sett": {}}"#,
        r#"{"orogen": 1, "about": 3}"#,
        r#"{"orogen": 1, "set": []}"#,
    ] {
        assert!(Preset::parse("test", text).is_err(), "{text}");
        assert!(!schema.is_valid(&serde_json::from_str(text).expect("JSON")), "{text}");
    }
}

//! `npm run generate` writes the page's table of lists, `src/preset/lists.json`, from the simulator's own.

use std::fs;
use std::path::Path;

use sim::layout::parameters::{lists_as_json, rows};

#[test]
fn the_page_has_the_lists_of_the_simulator() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src/preset/lists.json");
    let expected = lists_as_json();
    if std::env::var_os("GENERATE").is_some() {
        fs::write(&path, &expected).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap();
    assert!(
        found == expected,
        "src/preset/lists.json is stale: run npm run generate"
    );
}

#[test]
fn every_parameter_of_a_list_has_a_label_and_a_text() {
    for row in rows().iter().filter(|row| row.is_of_list) {
        assert!(!row.meta.label.is_empty(), "{} has no label", row.key);
        assert!(
            row.meta.text.ends_with('.'),
            "{} says nothing: {:?}",
            row.key,
            row.meta.text
        );
        assert!(
            row.meta.text.starts_with(char::is_uppercase),
            "{}: {}",
            row.key,
            row.meta.text
        );
    }
}

//! The page's table of lists, `src/preset/lists.json`, is written from the simulator's own:
//! `UPDATE_LISTS=1 cargo test -p sim --test all page_table` writes it anew.

use std::fs;
use std::path::Path;

use sim::layout::parameters::{lists_as_json, rows};

#[test]
fn the_page_has_the_lists_of_the_simulator() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src/preset/lists.json");
    let expected = lists_as_json();
    if std::env::var_os("UPDATE_LISTS").is_some() {
        fs::write(&path, &expected).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap();
    assert!(
        found == expected,
        "src/preset/lists.json is not what the simulator has; write it anew as the head of this test tells"
    );
}

#[test]
fn every_parameter_of_a_list_says_what_it_does() {
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

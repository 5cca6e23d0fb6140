//! `npm run generate` writes the ranges and defaults of the page, `src/preset/lists.json` and `singles.json`, from the
//! simulator's own.

use std::fs;
use std::path::Path;

use sim::layout::parameters::{lists_as_json, rows, singles_as_json};

#[test]
fn the_page_has_the_parameters_of_the_simulator() {
    is_generated("src/preset/lists.json", &lists_as_json());
    is_generated("src/preset/singles.json", &singles_as_json());
}

/// Asserts that a file of the repository has this content. Writes it first under `GENERATE`.
fn is_generated(file: &str, expected: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    if std::env::var_os("GENERATE").is_some() {
        fs::write(&path, expected).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap();
    assert!(found == expected, "{file} is stale: run npm run generate");
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

//! The layers of `sim/src`: the `use` arrows between files lead to no higher layer. They form no cycle, also in
//! `reference/src`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The folders of `sim/src`, lowest first. A file uses its own layer and those before it.
const LAYERS: [&str; 10] = [
    "math",
    "layout",
    "particles",
    "emission",
    "forces",
    "collide",
    "rigids",
    "life",
    "arrange",
    "simulator",
];

/// For each module of the crate, by its path in segments, the modules that its file uses.
type Arrows = BTreeMap<Vec<String>, BTreeSet<Vec<String>>>;

#[test]
fn every_folder_is_a_layer() {
    let arrows = arrows_in("../src");
    let found: BTreeSet<&str> = arrows.keys().map(|module| module[0].as_str()).collect();
    assert_eq!(found, BTreeSet::from(LAYERS));
}

#[test]
fn no_arrow_leads_to_a_higher_layer() {
    let level = |module: &[String]| LAYERS.iter().position(|layer| *layer == module[0]);
    for (from, targets) in &arrows_in("../src") {
        for to in targets {
            assert!(
                level(to) <= level(from),
                "{} uses {}, which is in a higher layer",
                from.join("::"),
                to.join("::")
            );
        }
    }
}

#[test]
fn no_files_form_a_cycle() {
    for root in ["../src", "../../reference/src"] {
        demand_no_cycle(arrows_in(root));
    }
}

fn demand_no_cycle(mut arrows: Arrows) {
    // A file outside all cycles eventually has no remaining dependency.
    while let Some(done) = arrows
        .iter()
        .find(|(_, targets)| targets.is_empty())
        .map(|(from, _)| from.clone())
    {
        arrows.remove(&done);
        arrows.values_mut().for_each(|targets| {
            targets.remove(&done);
        });
    }
    let left: Vec<String> = arrows.keys().map(|module| module.join("::")).collect();
    assert!(left.is_empty(), "these files form a cycle or use one: {left:?}");
}

#[test]
fn paths_are_read_from_every_form_of_use() {
    let source = "use crate::a::{b::C, d};\nfn f(g: super::h::I) -> self::j::K { crate::l::m() } // crate::n";
    let expected = [
        "crate::a::b::C",
        "crate::a::d",
        "crate::l::m",
        "self::j::K",
        "super::h::I",
    ];
    assert_eq!(paths(source), expected.map(str::to_owned).into());
}

/// Of the crate in a folder, relative to that of these tests.
fn arrows_in(root: &str) -> Arrows {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(root);
    let mut sources = BTreeMap::new();
    read_folder(&root, &mut Vec::new(), &mut sources);
    // `lib.rs` only declares modules.
    sources.remove(&Vec::new());
    let resolve = |own: &[String], path: &str| -> Option<Vec<String>> {
        let mut full: Vec<String> = Vec::new();
        let mut rest = path.split("::").peekable();
        match rest.next_if(|first| ["crate", "self", "super"].contains(first)) {
            Some("crate") => {}
            Some("self") => full.extend_from_slice(own),
            Some(_) => {
                let above = 1 + std::iter::from_fn(|| rest.next_if_eq(&"super")).count();
                full.extend_from_slice(&own[..own.len() - above]);
            }
            None => full.extend_from_slice(own),
        }
        full.extend(rest.map(str::to_owned));
        // The longest prefix of the path that is a file.
        (1..=full.len())
            .rev()
            .map(|len| full[..len].to_vec())
            .find(|module| sources.contains_key(module))
    };
    sources
        .iter()
        .map(|(own, source)| {
            let targets = paths(source)
                .into_iter()
                .filter_map(|path| resolve(own, &path))
                .filter(|to| to != own);
            (own.clone(), targets.collect())
        })
        .collect()
}

fn read_folder(folder: &Path, module: &mut Vec<String>, sources: &mut BTreeMap<Vec<String>, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let is_root = !path.is_dir() && ["mod", "lib", "main"].contains(&name.as_str());
        if !is_root {
            module.push(name);
        }
        if path.is_dir() {
            read_folder(&path, module, sources);
        } else {
            sources.insert(module.clone(), fs::read_to_string(&path).unwrap());
        }
        if !is_root {
            module.pop();
        }
    }
}

/// The paths within the crate that `source` names outside of comments and unit tests.
fn paths(source: &str) -> BTreeSet<String> {
    let (source, _) = source.split_once("#[cfg(test)]\nmod tests").unwrap_or((source, ""));
    let lines = source.lines().map(|line| line.split("//").next().unwrap_or_default());
    let code = lines.collect::<Vec<_>>().join(" ");
    let modules: Vec<&str> = code
        .split("mod ")
        .skip(1)
        .filter_map(|rest| rest.split_once(';'))
        .map(|(name, _)| name)
        .collect();
    let is_inside = |path: &str| {
        let first = path.split("::").next().unwrap_or_default();
        path.contains("::") && (["crate", "self", "super"].contains(&first) || modules.contains(&first))
    };
    let mut found = BTreeSet::new();
    let word = |c: char| !(c.is_alphanumeric() || c == '_' || c == ':');
    for (index, piece) in code.split("use ").enumerate() {
        let (tree, rest) = if index == 0 {
            ("", piece)
        } else {
            piece.split_once(';').unwrap_or((piece, ""))
        };
        expand("", tree, &mut found);
        found.extend(rest.split(word).map(|path| path.trim_matches(':').to_owned()));
    }
    found.into_iter().filter(|path| is_inside(path)).collect()
}

/// Lists the paths of a tree such as `a::{b, c::{d, e}}`.
fn expand(prefix: &str, tree: &str, found: &mut BTreeSet<String>) {
    let tree = tree.trim();
    let Some((head, inner)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap_or_default();
        found.insert(format!("{prefix}{path}").trim_end_matches("::self").to_owned());
        return;
    };
    let inner = inner.trim_end().trim_end_matches('}');
    let (mut depth, mut start) = (0, 0);
    for (at, c) in inner.char_indices().chain([(inner.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !inner[start..at].trim().is_empty() {
                    expand(&format!("{prefix}{head}"), &inner[start..at], found);
                }
                start = at + 1;
            }
            _ => {}
        }
    }
}

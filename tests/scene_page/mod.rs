//! `docs/SCENE.md` says what the types of `src/scene` say: every table between markers is made from
//! them, and every example is read.
//!
//! `AERO_WRITE_PAGES=1 cargo test --test program scene_page` writes the tables anew.

mod tables;
mod types;

use std::path::{Path, PathBuf};

use self::tables::table;
use self::types::Types;
use aero::scene::Scene;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn page_path() -> PathBuf {
    root().join("docs/SCENE.md")
}

fn page() -> String {
    std::fs::read_to_string(page_path()).unwrap()
}

/// Types that all others are reached from: the file, and what a side is read as by hand.
const ROOTS: [&str; 2] = ["SceneFile", "SideTable"];

/// Text between two markers, each with the text before it.
const BEGIN: &str = "<!-- keys: ";
const END: &str = "<!-- end -->";

/// The page with its tables made anew, and the types that they are made from.
fn made(page: &str, types: &Types) -> (String, Vec<String>) {
    let mut text = String::new();
    let mut names = Vec::new();
    let mut rest = page;
    while let Some((before, after)) = rest.split_once(BEGIN) {
        let (name, after) = after.split_once(" -->").unwrap();
        let (_, after) = after.split_once(END).unwrap();
        text.push_str(before);
        let table = table(name, types);
        text.extend([BEGIN, name, " -->\n\n", &table, "\n", END]);
        names.push(name.to_owned());
        rest = after;
    }
    text.push_str(rest);
    (text, names)
}

#[test]
fn the_tables_are_those_of_the_types() {
    let types = Types::read(&root().join("src/scene"));
    let page = page();
    let (made, _) = made(&page, &types);
    if std::env::var_os("AERO_WRITE_PAGES").is_some() {
        std::fs::write(page_path(), made).unwrap();
    } else {
        assert!(
            page == made,
            "docs/SCENE.md is not what the types say; write it anew with \
             `AERO_WRITE_PAGES=1 cargo test --test program scene_page`"
        );
    }
}

#[test]
fn no_type_is_left_out() {
    let types = Types::read(&root().join("src/scene"));
    let (_, names) = made(&page(), &types);
    for name in ROOTS.iter().flat_map(|root| types.reached_from(root)) {
        assert!(
            names.contains(&name),
            "docs/SCENE.md has no table of `{name}`; add `{BEGIN}{name} -->` and `{END}`"
        );
    }
}

#[test]
fn every_key_is_explained() {
    let types = Types::read(&root().join("src/scene"));
    for name in ROOTS.iter().flat_map(|root| types.reached_from(root)) {
        for key in types.keys(&name) {
            assert!(!key.text.is_empty(), "`{name}.{}` has no comment", key.name);
        }
    }
}

/// The examples of the page: whole scenes, and lines of a `[[body]]`.
fn examples(page: &str) -> Vec<&str> {
    let parts = page.split("```toml\n").skip(1);
    parts
        .map(|part| part.split_once("```").unwrap().0)
        .collect()
}

#[test]
fn every_example_is_read() {
    let page = page();
    let examples = examples(&page);
    assert!(examples.len() > 3);
    for text in examples {
        if let Err(error) = Scene::parse(text, "example", Path::new("cases")) {
            panic!("{error}\n{text}");
        }
    }
}

#[test]
fn every_shape_has_an_example_that_is_read() {
    let page = page();
    let types = Types::read(&root().join("src/scene"));
    for shape in types.keys("ShapeEntry") {
        let start = format!("`{} = {{ ", shape.name);
        let rest = page.split_once(&start);
        let (_, rest) = rest.unwrap_or_else(|| panic!("no example of `{}`", shape.name));
        let (values, _) = rest.split_once("}`").unwrap();
        let text = format!(
            "dimension = 2\nspacing = 0.1\nend_time = 1.0\n\
             [domain]\nmin = [0.0, 0.0]\nmax = [1.0, 1.0]\n\
             [domain.sides]\nx_min = \"inlet\"\nx_max = \"outlet\"\ny_min = \"wall\"\ny_max = \"wall\"\n\
             [[body]]\nname = \"example\"\nshape = {{ {} = {{ {values}}} }}\n",
            shape.name
        );
        if let Err(error) = Scene::parse(&text, "example", Path::new("cases")) {
            panic!("{error}\n{text}");
        }
    }
}

#[test]
fn every_side_is_named() {
    let wrong = "dimension = 1\nspacing = 0.1\nend_time = 1.0\n[domain]\nmin = [0.0]\nmax = [1.0]\n\
                 [domain.sides]\nx_min = \"nonsense\"\nx_max = \"wall\"\n";
    let error = Scene::parse(wrong, "example", Path::new("")).unwrap_err();
    let text = error.to_string();
    let (_, known) = text.split_once("expected one of ").unwrap();
    let words: Vec<&str> = known.split('`').skip(1).step_by(2).collect();
    assert!(words.contains(&"inlet"), "{text}");
    let page = page();
    for word in words {
        let quoted = format!("`\"{word}\"`");
        assert!(page.contains(&quoted), "docs/SCENE.md has no side {quoted}");
    }
}

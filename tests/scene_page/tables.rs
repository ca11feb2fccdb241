//! Tables of keys in Markdown.

use std::fmt::Write as _;

use super::types::{Key, Types, Value};

/// The table of a type.
pub fn table(name: &str, types: &Types) -> String {
    let keys = types.keys(name);
    assert!(!keys.is_empty(), "there is no type `{name}` with keys");
    let mut text = String::from("| key | takes | |\n|---|---|---|\n");
    for key in keys {
        let takes = key.value.as_ref().map_or("", Value::name);
        assert!(
            !takes.contains('?'),
            "`{name}.{}` has a type of no name",
            key.name
        );
        let _ = writeln!(
            text,
            "| `{}` | {} | {} |",
            key.name,
            takes_of(key, types, types.is_choice(name)),
            key.text.replace('|', "\\|")
        );
    }
    text
}

fn takes_of(key: &Key, types: &Types, is_choice: bool) -> String {
    match &key.value {
        Some(value) if is_choice => words(value, types),
        None => "the word".into(),
        Some(Value::Optional(inner)) => words(inner, types),
        Some(value) => format!("{}, **needed**", words(value, types)),
    }
}

fn words(value: &Value, types: &Types) -> String {
    match value {
        Value::Optional(inner) => words(inner, types),
        Value::List(inner, None) => format!("list: {}", words(inner, types)),
        Value::List(inner, Some(count)) => format!("{count} of: {}", words(inner, types)),
        Value::Named(name) => match name.as_str() {
            "f64" => "a number".into(),
            "bool" => "`true` or `false`".into(),
            "String" => "text".into(),
            "PathBuf" => "a path".into(),
            "Formula" => "a number or a formula".into(),
            _ if types.is_words(name) => {
                let spelled = types
                    .keys(name)
                    .iter()
                    .map(|key| format!("`\"{}\"`", key.name));
                spelled.collect::<Vec<_>>().join(" or ")
            }
            _ if !types.keys(name).is_empty() => {
                format!("[a table](#{})", name.to_lowercase())
            }
            _ => first_sentence(types.text(name).unwrap_or(name)),
        },
    }
}

fn first_sentence(text: &str) -> String {
    let mut ends = text.match_indices(". ").map(|(place, _)| place);
    // Two dots stand for what is left out.
    let end = ends.find(|&place| !text[..place].ends_with('.'));
    let text = text[..end.unwrap_or(text.len())].trim_end_matches('.');
    let mut letters = text.chars();
    let first = letters
        .next()
        .map(|letter| letter.to_lowercase().to_string());
    format!("{}{}", first.unwrap_or_default(), letters.as_str())
}

//! `--set section.key=value`: edits the text of a scene, keeping its comments and lines, before it
//! is read. Whether the result is a scene is not decided here.

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, TableLike, Value};

/// The text of a scene with one value replaced or added.
///
/// `setting` is `path=value`. The path's parts are keys; a part below a list is an index, or the
/// `name` of the entry. A value that is not TOML is taken for a bare string.
///
/// # Errors
/// Says which part of the path leads nowhere.
pub fn apply(text: &str, setting: &str) -> Result<String, String> {
    let (path, value) = setting
        .split_once('=')
        .ok_or("has no `=`; write section.key=value")?;
    let path: Vec<&str> = path.trim().split('.').map(str::trim).collect();
    if path.iter().any(|part| part.is_empty()) {
        return Err("has an empty key; write section.key=value".into());
    }
    let value = value.trim();
    let value = value
        .parse::<Value>()
        .unwrap_or_else(|_| Value::from(value));

    let mut document: DocumentMut = text.parse().map_err(|_| "the scene is not TOML")?;
    in_table(document.as_table_mut(), &path, value)?;
    Ok(document.to_string())
}

fn in_table(table: &mut dyn TableLike, path: &[&str], value: Value) -> Result<(), String> {
    let (key, rest) = (path[0], &path[1..]);
    if rest.is_empty() {
        return replace(table.entry(key).or_insert(Item::None), key, value);
    }
    let inline = table.is_dotted();
    let item = table.entry(key).or_insert_with(|| {
        let mut section = Table::new();
        section.set_implicit(!inline);
        Item::Table(section)
    });
    in_item(item, key, rest, value)
}

fn in_item(item: &mut Item, key: &str, path: &[&str], value: Value) -> Result<(), String> {
    if let Item::Value(inner) = item {
        return in_value(inner, key, path, value);
    }
    if let Some(list) = item.as_array_of_tables_mut() {
        let index = index_of_table(list, key, path[0])?;
        let table = list.get_mut(index).ok_or("no such entry")?;
        return match &path[1..] {
            [] => Err(format!(
                "`{key}.{}` is a whole section; name a key in it",
                path[0]
            )),
            rest => in_table(table, rest, value),
        };
    }
    let table = item
        .as_table_like_mut()
        .ok_or_else(|| format!("`{key}` is no section"))?;
    in_table(table, path, value)
}

fn in_value(inner: &mut Value, key: &str, path: &[&str], value: Value) -> Result<(), String> {
    let kind = inner.type_name();
    match inner {
        Value::InlineTable(table) => in_table(table, path, value),
        Value::Array(list) => {
            let length = list.len();
            let index = path[0].parse().ok().filter(|&i: &usize| i < length);
            let index = index.ok_or_else(|| {
                format!(
                    "`{key}` has no entry `{}`; it has {length}, counted from 0",
                    path[0]
                )
            })?;
            let entry = list.get_mut(index).ok_or("no such entry")?;
            match &path[1..] {
                [] => {
                    *entry = value;
                    Ok(())
                }
                rest => in_value(entry, path[0], rest, value),
            }
        }
        _ => Err(format!("`{key}` is a {kind} and has no key `{}`", path[0])),
    }
}

/// Puts `value` in the place of `item`, with the comment that stood after the old value.
fn replace(item: &mut Item, key: &str, mut value: Value) -> Result<(), String> {
    match item {
        Item::Value(old) => {
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        Item::None => *item = Item::Value(value),
        Item::Table(_) if value.is_inline_table() => *item = Item::Value(value),
        Item::Table(_) | Item::ArrayOfTables(_) => {
            return Err(format!("`{key}` is a whole section; name a key in it"));
        }
    }
    Ok(())
}

fn index_of_table(list: &ArrayOfTables, key: &str, part: &str) -> Result<usize, String> {
    if let Ok(index) = part.parse::<usize>() {
        return if index < list.len() {
            Ok(index)
        } else {
            Err(format!(
                "there is no `{key}` number {part}; the scene has {}, counted from 0",
                list.len()
            ))
        };
    }
    let names: Vec<&str> = list
        .iter()
        .map(|table| table.get("name").and_then(Item::as_str).unwrap_or(""))
        .collect();
    names.iter().position(|name| *name == part).ok_or_else(|| {
        format!(
            "there is no `{key}` named `{part}`; the scene has {}",
            names.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "spacing = 0.1 # coarse\n\n[domain]\nmax = [1.0, 2.0]\n\n[[body]]\nname = \"ramp\"\nshape = { corner = { angle = 20 } }\n";

    #[test]
    fn a_value_is_replaced_and_its_comment_kept() {
        let text = apply(TEXT, "spacing=0.2").unwrap();
        assert!(text.starts_with("spacing = 0.2 # coarse\n"), "{text}");
    }

    #[test]
    fn a_body_is_found_by_name_and_by_index() {
        for part in ["ramp", "0"] {
            let text = apply(TEXT, &format!("body.{part}.shape.corner.angle=15")).unwrap();
            assert!(text.contains("angle = 15"), "{text}");
        }
    }

    #[test]
    fn a_bare_word_becomes_a_string() {
        let text = apply(TEXT, "scheme.extrapolation=wm").unwrap();
        assert!(text.contains("extrapolation = \"wm\""), "{text}");
    }

    #[test]
    fn one_number_of_a_vector_can_be_set() {
        let text = apply(TEXT, "domain.max.1=4.5").unwrap();
        assert!(
            text.contains("[1.0,4.5]") || text.contains("[1.0, 4.5]"),
            "{text}"
        );
    }

    #[test]
    fn an_unknown_body_is_refused_with_the_known_ones() {
        let message = apply(TEXT, "body.cone.spacing=1").unwrap_err();
        assert_eq!(
            message,
            "there is no `body` named `cone`; the scene has ramp"
        );
    }

    #[test]
    fn a_path_through_a_number_is_refused() {
        let message = apply(TEXT, "spacing.x=1").unwrap_err();
        assert_eq!(message, "`spacing` is a float and has no key `x`");
    }

    #[test]
    fn a_setting_without_an_equals_sign_is_refused() {
        assert!(apply(TEXT, "spacing").unwrap_err().contains("no `=`"));
        assert!(apply(TEXT, "a..b=1").unwrap_err().contains("empty key"));
    }
}

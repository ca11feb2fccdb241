//! A scene as sorted lines `section.key = value`: what a checkpoint remembers of it.

use toml::Value;

/// Keys on which no result depends.
const IDLE: [&str; 2] = ["title", "output.checkpoint_seconds"];

/// The lines of a scene's text, which has been read as a scene before.
pub(super) fn of(text: &str) -> String {
    let mut lines = Vec::new();
    if let Ok(table) = text.parse::<toml::Table>() {
        collect("", &Value::Table(table), &mut lines);
    }
    lines.sort();
    lines.concat()
}

fn collect(path: &str, value: &Value, lines: &mut Vec<String>) {
    let below = |key: &str| match path {
        "" => key.to_owned(),
        _ => format!("{path}.{key}"),
    };
    match value {
        Value::Table(table) => {
            for (key, value) in table {
                collect(&below(key), value, lines);
            }
        }
        Value::Array(values) if values.iter().any(Value::is_table) => {
            for (number, value) in values.iter().enumerate() {
                collect(&below(&number.to_string()), value, lines);
            }
        }
        _ if IDLE.contains(&path) => {}
        _ => lines.push(format!("{path} = {value}\n")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_comments_and_title_make_no_difference() {
        let one =
            "title = \"a\"\nspacing = 0.1 # fine\n[gas]\ngamma = 1.4\n[[body]]\nname = \"b\"\n";
        let other = "gas = { gamma = 1.4 }\nbody = [{ name = \"b\" }]\nspacing = 0.10\n";
        assert_eq!(of(one), of(other));
        assert_eq!(
            of(one),
            "body.0.name = \"b\"\ngas.gamma = 1.4\nspacing = 0.1\n"
        );
    }
}

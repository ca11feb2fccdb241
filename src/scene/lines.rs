//! A scene as sorted lines `section.key = value`: what a checkpoint remembers of it, and what can be run again.

use std::path::Path;

use toml::Value;

/// Keys on which no result depends.
const IDLE: [&str; 2] = ["title", "output.checkpoint_seconds"];

/// Ends of keys that hold paths, which start at the scene's folder where they are relative.
const PATHS: [&str; 2] = [".file", ".frame"];

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

/// Lines with the paths of a scene in `folder` whole: they can be run again from anywhere.
pub(super) fn from_anywhere(lines: &str, folder: &Path) -> String {
    let whole = |line: &str| {
        let (key, value) = line.split_once(" = ")?;
        PATHS.iter().find(|end| key.ends_with(*end))?;
        let table = format!("path = {value}").parse::<toml::Table>().ok()?;
        let path = std::path::absolute(folder.join(table.get("path")?.as_str()?)).ok()?;
        Some(format!("{key} = {}", Value::from(path.to_str()?)))
    };
    let lines = lines.lines();
    let lines = lines.map(|line| whole(line).unwrap_or_else(|| line.to_owned()) + "\n");
    lines.collect()
}

/// The text of a scene that was written as lines: its numbered tables as lists again; none of any other text.
pub(super) fn read(text: &str) -> Option<String> {
    let mut table = text.parse::<toml::Table>().ok()?;
    let mut has_numbered = false;
    for (_, value) in &mut table {
        has_numbered |= number(value);
    }
    has_numbered.then(|| table.to_string())
}

/// Turns tables whose keys are 0, 1, 2, ... into lists; tells whether there was one.
fn number(value: &mut Value) -> bool {
    let Value::Table(table) = value else {
        return false;
    };
    let mut has_numbered = false;
    for (_, below) in table.iter_mut() {
        has_numbered |= number(below);
    }
    let entries: Option<Vec<Value>> = (0..table.len())
        .map(|n| table.get(&n.to_string()).cloned())
        .collect();
    match entries {
        Some(entries) if !entries.is_empty() => {
            *value = Value::Array(entries);
            true
        }
        _ => has_numbered,
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

    #[test]
    fn paths_are_whole_where_lines_go_elsewhere() {
        let lines = "a.file = \"b/c.stl\"\nd.file = \"/e.stl\"\ninitial.frame = \"../f.vtp\"\nname = \"g.stl\"\n";
        let whole = from_anywhere(lines, Path::new("/home/x"));
        assert_eq!(
            whole,
            "a.file = \"/home/x/b/c.stl\"\nd.file = \"/e.stl\"\ninitial.frame = \"/home/x/../f.vtp\"\nname = \"g.stl\"\n"
        );
    }

    #[test]
    fn lines_are_read_as_the_scene_that_they_were() {
        let body = |n| format!("[[body]]\nname = \"b{n}\"\nshape.polygon = [[0, 1], [{n}, 2]]\n");
        let bodies: Vec<String> = (0..12).map(body).collect();
        let scene = format!("spacing = 0.1\n{}", bodies.concat());
        let lines = of(&scene);
        let read = read(&lines).unwrap();
        assert_eq!(of(&read), lines);
        assert!(read.contains("[[body]]"), "{read}");
        assert_eq!(super::read(&scene), None);
    }
}

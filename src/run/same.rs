//! Whether two scenes, a line for each value, are the same.

use std::path::{Component, Path};

/// True where two scenes have the same lines.
pub(super) fn is_same(one: &str, other: &str) -> bool {
    one.lines().count() == other.lines().count()
        && (one.lines().zip(other.lines())).all(|(a, b)| is_same_line(a, b))
}

/// True where two lines say the same: word by word, or of the same key a path that is whole and the end of it.
pub(super) fn is_same_line(one: &str, other: &str) -> bool {
    if one == other {
        return true;
    }
    let split = |line| str::split_once(line, " = ");
    let (Some((key, a)), Some((other_key, b))) = (split(one), split(other)) else {
        return false;
    };
    key == other_key && (is_end(a, b) || is_end(b, a))
}

/// True where `whole` is a path from the root, and `part` one that is not and that it ends with.
fn is_end(whole: &str, part: &str) -> bool {
    let unquoted = |text: &str| {
        let quote = text.chars().next().filter(|c| "\"'".contains(*c))?;
        Some(text.strip_prefix(quote)?.strip_suffix(quote)?.to_owned())
    };
    let (Some(whole), Some(part)) = (unquoted(whole), unquoted(part)) else {
        return false;
    };
    let (whole, part) = (Path::new(&whole), Path::new(&part));
    let parts = part.components().filter(|c| *c != Component::CurDir);
    whole.is_absolute()
        && part.is_relative()
        && whole.ends_with(parts.collect::<std::path::PathBuf>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_path_is_the_same_as_its_end_and_no_other() {
        let line = |path: &str| format!("a.file = \"{path}\"");
        let whole = line("/home/x/bodies/a.stl");
        for path in ["a.stl", "./a.stl", "bodies/a.stl", "/home/x/bodies/a.stl"] {
            assert!(is_same_line(&whole, &line(path)), "{path}");
            assert!(is_same_line(&line(path), &whole), "{path}");
        }
        for path in ["b.stl", "wings/a.stl", "/home/y/bodies/a.stl", ".stl"] {
            assert!(!is_same_line(&whole, &line(path)), "{path}");
        }
        assert!(!is_same_line(&whole, "b.file = \"a.stl\""));
        assert!(!is_same_line("x = 1", "x = 2"));
        assert!(!is_same("x = 1\ny = 2\n", "x = 1\n"));
        assert!(is_same("x = 1\n", "x = 1\n"));
    }
}

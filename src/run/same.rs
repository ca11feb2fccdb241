//! Whether a scene that goes on says the same as it did.

use std::path::{Component, Path, PathBuf};

/// True where two lines of a scene say the same: word by word, or of the same key a whole path `now`, as results keep it, of which `earlier`
/// was the end.
pub(super) fn is_same_line(earlier: &str, now: &str) -> bool {
    let split = |line| str::split_once(line, " = ");
    earlier == now
        || split(earlier)
            .zip(split(now))
            .is_some_and(|((key, part), (other, whole))| key == other && is_end(whole, part))
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
    whole.is_absolute() && part.is_relative() && whole.ends_with(parts.collect::<PathBuf>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_path_is_the_same_as_its_end_was_and_no_other() {
        let line = |path: &str| format!("a.file = \"{path}\"");
        let whole = line("/home/x/bodies/a.stl");
        for path in ["a.stl", "./a.stl", "bodies/a.stl", "/home/x/bodies/a.stl"] {
            assert!(is_same_line(&line(path), &whole), "{path}");
        }
        for path in ["b.stl", "wings/a.stl", "/home/y/bodies/a.stl", ".stl"] {
            assert!(!is_same_line(&line(path), &whole), "{path}");
        }
        assert!(!is_same_line(&whole, &line("a.stl")));
        assert!(!is_same_line("b.file = \"a.stl\"", &whole));
        assert!(!is_same_line("x = 1", "x = 2"));
    }
}

//! The comparison as one page: what misses, then every case with its table and its pictures.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use aero_validation::table::{Check, to_markdown};

use super::context::Level;

/// Name of the page.
pub const NAME: &str = "report.md";

/// Writes the page about `checks` into `folder`, which holds the pictures.
pub fn write(checks: &[Check], level: Level, folder: &Path) -> std::io::Result<()> {
    let pictures = pictures(folder)?;
    std::fs::write(folder.join(NAME), page(checks, level, &pictures))
}

/// Names of the pictures in a folder, sorted.
fn pictures(folder: &Path) -> std::io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path: PathBuf = entry?.path();
        let is_picture = path
            .extension()
            .is_some_and(|ending| ending == "png" || ending == "svg");
        if let (true, Some(name)) = (is_picture, path.file_name()) {
            names.push(name.to_string_lossy().into_owned());
        }
    }
    names.sort();
    Ok(names)
}

fn page(checks: &[Check], level: Level, pictures: &[String]) -> String {
    let how = match level {
        Level::Quick => "coarse and short",
        Level::Full => "at the published resolution",
    };
    let judged = checks
        .iter()
        .filter(|check| check.allowed_percent.is_some());
    let missed: Vec<Check> = checks.iter().filter(|check| !check.pass).cloned().collect();
    let mut text = String::from("# Comparison with theory\n\n");
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "By `aero validate` {}, {how}: {} of {} comparisons pass. Rows without an allowed error inform.\n",
        env!("CARGO_PKG_VERSION"),
        judged.clone().count() - missed.len(),
        judged.count(),
    );
    if !missed.is_empty() {
        let _ = writeln!(text, "## Misses\n\n{}", to_markdown(&missed));
    }
    let mut names: Vec<&str> = checks.iter().map(|check| check.case.as_str()).collect();
    names.dedup();
    for name in names {
        let rows: Vec<Check> = checks
            .iter()
            .filter(|check| check.case == name)
            .cloned()
            .collect();
        let _ = writeln!(text, "## {name}\n\n{}", to_markdown(&rows));
        for picture in pictures.iter().filter(|picture| belongs(picture, name)) {
            let _ = writeln!(text, "![{picture}]({picture})\n");
        }
    }
    text
}

/// True for the pictures of a case: `NAME-...`.
fn belongs(picture: &str, case: &str) -> bool {
    picture
        .strip_prefix(case)
        .is_some_and(|rest| rest.starts_with(['-', '.']))
}

#[cfg(test)]
mod tests {
    use super::*;
    use aero_validation::table::Subject;

    #[test]
    fn a_miss_stands_at_the_top_and_pictures_with_their_case() {
        let row =
            |case, measured| Subject::new(case, "height", "book").relative(measured, 1.0, 1.0);
        let checks = [row("step", 1.0), row("square", 2.0)];
        let pictures = ["square-10.png", "step-40.svg"].map(str::to_owned);
        let page = page(&checks, Level::Quick, &pictures);
        let place = |what: &str| {
            page.find(what)
                .unwrap_or_else(|| panic!("{what} in {page}"))
        };
        assert!(page.contains("1 of 2 comparisons pass"));
        assert!(place("## Misses") < place("## step"));
        assert!(place("## step") < place("(step-40.svg)"));
        assert!(place("(step-40.svg)") < place("## square"));
        assert!(place("## square") < place("(square-10.png)"));
    }
}

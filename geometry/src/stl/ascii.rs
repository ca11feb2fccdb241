//! The text form of STL, read word by word in any case and indentation, any number of solids.

use super::Soup;
use crate::Vector;
use crate::error::GeometryError;

/// Where in the grammar the reader stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Outside,
    Solid,
    Facet,
    Outer,
    Loop(usize),
    AfterLoop,
}

impl State {
    fn expected(self) -> &'static str {
        match self {
            Self::Outside => "`solid`",
            Self::Solid => "`facet` or `endsolid`",
            Self::Facet => "`outer loop`",
            Self::Outer => "`loop`",
            Self::Loop(3) => "`endloop`",
            Self::Loop(_) => "`vertex`",
            Self::AfterLoop => "`endfacet`",
        }
    }
}

/// True where the bytes begin with the word "solid" and look like text.
pub(super) fn is_ascii(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(512)];
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let word = text.trim_ascii_start();
    word.len() >= 5 && word[..5].eq_ignore_ascii_case(b"solid") && !head.contains(&0)
}

pub(super) fn parse(bytes: &[u8]) -> Result<Soup, GeometryError> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let mut reader = Reader {
        soup: Soup::default(),
        state: State::Outside,
        corners: [Vector::<3>::zeros(); 3],
    };
    // Files from old Macs part their lines by carriage returns alone.
    let parted_by = if text.contains('\n') { '\n' } else { '\r' };
    let count = text.split(parted_by).count();
    for (index, line) in text.split(parted_by).enumerate() {
        reader.line(line).map_err(|reason| {
            let last = index + 1 == count;
            let end = if last { ", where the file ends" } else { "" };
            GeometryError::Stl(format!("line {}{end}: {reason}", index + 1))
        })?;
    }
    if reader.state == State::Outside {
        return Ok(reader.soup);
    }
    let (name, first) = reader.soup.solids.last().cloned().unwrap_or_default();
    Err(GeometryError::Stl(format!(
        "the file is cut off: solid `{name}` does not end after {} triangles, where {} should follow",
        reader.soup.facets.len() - first,
        reader.state.expected()
    )))
}

struct Reader {
    soup: Soup,
    state: State,
    corners: [Vector<3>; 3],
}

impl Reader {
    fn line(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        while let Some(word) = words.next() {
            let lower = word.to_ascii_lowercase();
            self.state = match (self.state, lower.as_str()) {
                (State::Outside, "solid") => {
                    let name: Vec<&str> = words.by_ref().collect();
                    self.soup.begin(&name.join(" "));
                    State::Solid
                }
                (State::Solid, "facet") => State::Facet,
                (State::Solid, "endsolid") => {
                    words.by_ref().for_each(drop);
                    State::Outside
                }
                (State::Facet, "outer") => State::Outer,
                // The stored normal is not trusted, and of degenerate facets often not a number.
                (State::Facet, other) if !is_keyword(other) => State::Facet,
                (State::Outer, "loop") => State::Loop(0),
                (State::Loop(count), "vertex") if count < 3 => {
                    self.corners[count] = vertex(&mut words)?;
                    State::Loop(count + 1)
                }
                (State::Loop(3), "vertex") => {
                    return Err("a fourth vertex; split the facet into triangles".into());
                }
                (State::Loop(3), "endloop") => State::AfterLoop,
                (State::Loop(count), "endloop") => {
                    return Err(format!("a facet with {count} vertices; it needs three"));
                }
                (State::AfterLoop, "endfacet") => {
                    self.soup.facets.push(self.corners);
                    State::Solid
                }
                (state, _) => {
                    return Err(format!("`{word}` where {} should follow", state.expected()));
                }
            };
        }
        Ok(())
    }
}

fn is_keyword(word: &str) -> bool {
    [
        "solid", "endsolid", "facet", "endfacet", "loop", "endloop", "vertex",
    ]
    .contains(&word)
}

fn vertex<'a>(words: &mut impl Iterator<Item = &'a str>) -> Result<Vector<3>, String> {
    let mut point = Vector::<3>::zeros();
    for axis in 0..3 {
        let word = words
            .next()
            .ok_or_else(|| format!("a vertex with {axis} coordinates; it needs three"))?;
        let number: f64 = word
            .parse()
            .map_err(|_| format!("coordinate `{word}` is not a number"))?;
        if !number.is_finite() {
            return Err(format!("coordinate `{word}` is not finite"));
        }
        point[axis] = number;
    }
    Ok(point)
}

//! Changes to a scene's text.

/// Values that a number may be replaced with.
pub const NUMBERS: [&str; 26] = [
    "0",
    "-1",
    "1",
    "2",
    "3",
    "4",
    "0.0",
    "-0.0",
    "1e-3",
    "-1e-3",
    "0.3333333333333333",
    "1e-300",
    "1e300",
    "-1e300",
    "1e12",
    "1e-12",
    "1e150",
    "nan",
    "inf",
    "-inf",
    "9223372036854775807",
    "99999999999999999999",
    "360",
    "-90.0",
    "0.5",
    "1000000",
];

/// What else may stand in the place of a value.
const VALUES: [&str; 18] = [
    "\"\"",
    "true",
    "[]",
    "{}",
    "[1.0]",
    "[0.0, 0.0]",
    "[0.0, 0.0, 0.0]",
    "[nan, 1.0]",
    "\"wall\"",
    "\"inlet\"",
    "\"outlet\"",
    "\"periodic\"",
    "\"symmetry\"",
    "\"free-stream\"",
    "\"body\"",
    "\"no-slip\"",
    "1979-05-27",
    "\"1 / (x - x)\"",
];

/// Lines that may come in anywhere.
const LINES: [&str; 17] = [
    "spacing = 10.0",
    "wall = \"no-slip\"",
    "place = { scale = 1000.0 }",
    "place = { translate = [0.1, 0.1] }",
    "place = { scale = 1e-9 }",
    "place = { rotate = 1e9 }",
    "motion = { velocity = [1e9, 0.0] }",
    "motion = { angular_velocity = 1e6 }",
    "name = \"😀 näme\"",
    "disorder = 0.49",
    "shield = true",
    "shifting = true",
    "[[body]]\nname = \"again\"\nshape = { circle = { radius = 0.3 } }",
    "[[body]]\nname = \"flat\"\nshape = { rectangle = { size = [1.0, 1e-12] } }",
    "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 100.0 } }",
    "[initial.field]\ndensity = \"sin(40 * x)\"\npressure = \"exp(900 * x)\"",
    "[initial.riemann]\nposition = 0.5\nleft = { density = 1, pressure = 1e9 }\nright = { density = 1e-9, pressure = 1 }",
];

/// A generator of numbers (`SplitMix64`, Steele, Lea & Flood 2014).
pub struct Dice(pub u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `sides`, zero where there are none.
    pub fn throw(&mut self, sides: usize) -> usize {
        (self.next() % sides.max(1) as u64) as usize
    }

    pub fn choose<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.throw(from.len())]
    }
}

/// Byte ranges of all numbers in a text.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let first = bytes[at].is_ascii_digit() && (at == 0 || b" [=-,(".contains(&bytes[at - 1]));
        if !first {
            at += 1;
            continue;
        }
        let rest = &bytes[at..];
        let end = rest
            .iter()
            .position(|b| !(b.is_ascii_digit() || b".eE".contains(b)))
            .unwrap_or(rest.len());
        found.push((at, at + end));
        at += end;
    }
    found
}

/// One mutation of a scene's text.
pub fn mutate(text: &str, dice: &mut Dice) -> String {
    if text.is_empty() {
        return dice.choose(&LINES).into();
    }
    let lines: Vec<&str> = text.lines().collect();
    let line = dice.throw(lines.len());
    let joined = |lines: Vec<&str>| lines.join("\n") + "\n";
    match dice.throw(12) {
        0..=3 => {
            let found = numbers(text);
            let Some(&(from, to)) = found.get(dice.throw(found.len())) else {
                return text.into();
            };
            format!("{}{}{}", &text[..from], dice.choose(&NUMBERS), &text[to..])
        }
        4 | 5 => match lines[line].split_once('=') {
            Some((key, _)) => {
                let changed = format!("{key}= {}", dice.choose(&VALUES));
                let mut lines = lines.clone();
                lines[line] = &changed;
                joined(lines)
            }
            None => text.into(),
        },
        6 => {
            let mut lines = lines;
            lines.remove(line);
            joined(lines)
        }
        7 => {
            let mut lines = lines.clone();
            lines.insert(line, lines[dice.throw(lines.len())]);
            joined(lines)
        }
        8 | 9 => {
            let mut lines = lines;
            lines.insert(line + dice.throw(2), dice.choose(&LINES));
            joined(lines)
        }
        10 => {
            // A character comes, goes or changes; now and then a very long word.
            let mut characters: Vec<char> = text.chars().collect();
            let at = dice.throw(characters.len());
            match dice.throw(4) {
                0 => {
                    characters.remove(at);
                }
                1 => characters.insert(
                    at,
                    dice.choose(&["é", "=", "\"", "[", "\0", "-", "😀"])
                        .chars()
                        .next()
                        .unwrap_or(' '),
                ),
                2 => characters[at] = char::from(b'!' + dice.throw(90) as u8),
                _ => {
                    let word = "x".repeat(1 << dice.throw(16));
                    characters.splice(at..at, word.chars());
                }
            }
            characters.into_iter().collect()
        }
        _ => {
            let at = dice.throw(text.len());
            text.get(..at).unwrap_or(text).into()
        }
    }
}

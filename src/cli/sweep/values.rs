//! Lists of numbers as they are typed: `1.5,2,3`, `-4..8:2`, or both, `0,1..3:0.5`.

use std::str::FromStr;

use crate::cli::body::{mach, stream_angle};

/// More than anybody waits for.
const MOST: usize = 1_000;

/// Numbers in the order in which they were typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Values(pub Vec<f64>);

impl FromStr for Values {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut values = Vec::new();
        for part in text.split(',') {
            match part.split_once("..") {
                None => values.push(number(part)?),
                Some((from, rest)) => {
                    let (to, step) = rest.split_once(':').ok_or_else(|| {
                        format!("`{part}` has no step; write FROM..TO:STEP, -4..8:2 say")
                    })?;
                    values.extend(range(number(from)?, number(to)?, number(step)?)?);
                }
            }
            if values.len() > MOST {
                return Err(format!("more than {MOST} values; take a larger step"));
            }
        }
        Ok(Self(values))
    }
}

/// Mach numbers.
pub fn machs(text: &str) -> Result<Values, String> {
    each(text, mach)
}

/// Angles of a stream.
pub fn angles(text: &str) -> Result<Values, String> {
    each(text, stream_angle)
}

/// The numbers of `text`, each of which `check` lets pass.
fn each(text: &str, check: fn(&str) -> Result<f64, String>) -> Result<Values, String> {
    let values: Values = text.parse()?;
    for value in &values.0 {
        check(&value.to_string()).map_err(|error| format!("`{value}`: {error}"))?;
    }
    Ok(values)
}

fn number(text: &str) -> Result<f64, String> {
    let value: Result<f64, _> = text.trim().parse();
    value
        .ok()
        .filter(|value| value.is_finite())
        .ok_or_else(|| format!("`{text}` is not a number; write 1.5,2,3 or -4..8:2"))
}

/// `from`, `from + step` ... up to `to`, itself included where the steps lead there.
fn range(from: f64, to: f64, step: f64) -> Result<Vec<f64>, String> {
    let steps = (to - from) / step;
    if !steps.is_finite() || steps < 0.0 {
        return Err(format!(
            "no steps of {step} lead from {from} to {to}; turn its sign, or the ends"
        ));
    }
    // A last step that round-off cuts short counts.
    let steps = (steps + 1e-9).floor() as usize;
    if steps >= MOST {
        return Err(format!("more than {MOST} values; take a larger step"));
    }
    // Multiplied, not added up, so that 0.1 and 0.2 lead to 0.3 and not beside it.
    let rounded = |value: f64| (value * 1e9).round() / 1e9;
    Ok((0..=steps)
        .map(|k| rounded(from + k as f64 * step))
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Result<Vec<f64>, String> {
        text.parse::<Values>().map(|values| values.0)
    }

    #[test]
    fn lists_and_ranges_are_what_they_say() {
        assert_eq!(values("1.5,2,3").unwrap(), [1.5, 2.0, 3.0]);
        assert_eq!(values("-4..4:2").unwrap(), [-4.0, -2.0, 0.0, 2.0, 4.0]);
        assert_eq!(values("0,0.1..0.3:0.1").unwrap(), [0.0, 0.1, 0.2, 0.3]);
        assert_eq!(values("2..0:-1").unwrap(), [2.0, 1.0, 0.0]);
        assert_eq!(values("0..5:2").unwrap(), [0.0, 2.0, 4.0]);
    }

    #[test]
    fn what_is_no_list_is_refused() {
        for (text, words) in [
            ("two", "`two` is not a number"),
            ("0..4", "no step"),
            ("0..4:-1", "turn its sign"),
            ("0..4:0", "lead from 0 to 4"),
            ("0..1:1e-9", "larger step"),
            ("1,,2", "not a number"),
        ] {
            let error = values(text).unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}

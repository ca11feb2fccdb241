//! Where an axis carries marks, and what they say.

/// A mark on an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    /// Empty for a small mark between the labelled ones.
    pub(super) label: String,
}

/// About `count` round values (1, 2 or 5 times a power of ten apart) within `range`.
pub(super) fn linear([low, high]: [f64; 2], count: usize) -> Vec<Tick> {
    let raw = (high - low) / count.max(1) as f64;
    if !raw.is_finite() || raw <= 0.0 {
        return Vec::new();
    }
    let power = 10_f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|f| f * power)
        .into_iter()
        .find(|s| *s >= raw * 0.999)
        .unwrap_or(10.0 * power);
    let slack = 1e-9 * (high - low);
    let first = ((low - slack) / step).ceil() as i64;
    let last = ((high + slack) / step).floor() as i64;
    (first..=last)
        .map(|k| {
            let value = k as f64 * step;
            Tick {
                value,
                label: label(value, step),
            }
        })
        .collect()
}

/// Decades within `range` with labels, and small marks at 2 to 9 times a decade; on a span of less
/// than two decades 2 and 5 are labelled too.
pub(super) fn logarithmic([low, high]: [f64; 2]) -> Vec<Tick> {
    if low.is_nan() || low <= 0.0 || high <= low || !high.is_finite() {
        return Vec::new();
    }
    let short = (high / low).log10() < 2.0;
    let first = (low.log10() - 1e-9).floor() as i32;
    let last = (high.log10() + 1e-9).ceil() as i32;
    let mut ticks = Vec::new();
    for decade in first..=last {
        for times in 1..10 {
            let value = f64::from(times) * 10_f64.powi(decade);
            if value < low * (1.0 - 1e-9) || value > high * (1.0 + 1e-9) {
                continue;
            }
            let labelled = times == 1 || (short && (times == 2 || times == 5));
            ticks.push(Tick {
                value,
                label: if labelled {
                    label(value, value)
                } else {
                    String::new()
                },
            });
        }
    }
    ticks
}

/// `value` with the decimals that a step of `step` needs; powers of ten where a plain number would
/// be long.
pub(super) fn label(value: f64, step: f64) -> String {
    let size = value.abs().max(step.abs());
    if value == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        let exponent = size.log10().floor() as i32;
        let mantissa = value / 10_f64.powi(exponent);
        let digits = (exponent - (step.abs() * 1.001).log10().floor() as i32).max(0) as usize;
        let power: String = exponent.to_string().chars().map(superscript).collect();
        let front = format!("{mantissa:.digits$}").replace('-', "−");
        return if front == "1" {
            format!("10{power}")
        } else {
            format!("{front}×10{power}")
        };
    }
    let digits = (-(step.abs() * 1.001).log10().floor()).max(0.0) as usize;
    format!("{value:.digits$}").replace('-', "−")
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks
            .iter()
            .map(|t| t.label.as_str())
            .filter(|l| !l.is_empty())
            .collect()
    }

    #[test]
    fn linear_marks_are_round_numbers() {
        assert_eq!(labels(&linear([-1.0, 3.0], 5)), ["−1", "0", "1", "2", "3"]);
        assert_eq!(labels(&linear([0.0, 0.375], 4)), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(
            labels(&linear([0.98, 1.02], 4)),
            ["0.98", "0.99", "1.00", "1.01", "1.02"]
        );
        assert_eq!(
            labels(&linear([0.0, 3e6], 3)),
            ["0", "1×10⁶", "2×10⁶", "3×10⁶"].map(|l| l.trim_start_matches("1×"))
        );
    }

    #[test]
    fn logarithmic_marks_are_decades_with_small_marks_between() {
        let ticks = logarithmic([0.5, 2000.0]);
        assert_eq!(labels(&ticks), ["1", "10", "100", "1000"]);
        assert!(ticks.len() > 25);
        assert_eq!(
            labels(&logarithmic([0.1, 3.0])),
            ["0.1", "0.2", "0.5", "1", "2"]
        );
        assert_eq!(
            labels(&logarithmic([1e-6, 1e-3])),
            ["10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001"]
        );
    }

    #[test]
    fn senseless_ranges_have_no_marks() {
        assert!(linear([1.0, 1.0], 5).is_empty());
        assert!(linear([0.0, f64::NAN], 5).is_empty());
        assert!(logarithmic([0.0, 1.0]).is_empty());
    }
}

//! Numbers that a scene file may hold, each with its own range, so that a bad one is reported by
//! the reader with its position in the file.

use serde::Deserialize;

use super::atmosphere::{HIGHEST, LOWEST};

/// Declares a newtype over `f64` that only takes values for which a condition holds.
macro_rules! ranged {
    ($(#[$doc:meta])* $name:ident, $holds:expr, $wanted:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
        #[serde(try_from = "f64")]
        pub struct $name(f64);

        impl $name {
            /// The number.
            pub fn get(self) -> f64 {
                self.0
            }
        }

        impl TryFrom<f64> for $name {
            type Error = String;

            fn try_from(value: f64) -> Result<Self, String> {
                let holds: fn(f64) -> bool = $holds;
                if value.is_finite() && holds(value) {
                    Ok(Self(value))
                } else {
                    Err(format!(concat!("{} is not ", $wanted), value))
                }
            }
        }
    };
}

ranged!(
    /// A finite number.
    Finite, |_| true, "a finite number"
);
ranged!(
    /// A finite number above zero.
    Positive, |x| x > 0.0, "a positive number"
);
ranged!(
    /// A finite number, zero or above.
    NonNegative, |x| x >= 0.0, "zero or a positive number"
);
ranged!(
    /// A ratio of specific heats.
    Gamma, |x| x > 1.0, "a ratio of specific heats, which is above 1 (1.4 for air)"
);
ranged!(
    /// A part of the way between two runs that a third goes beyond.
    Part, |x| x > 0.0 && x <= 1.01, "a part of the way between two runs, which is above 0 and at most 1"
);
ranged!(
    /// A Courant number.
    Courant, |x| x > 0.0 && x <= 1.0, "a Courant number, which is above 0 and at most 1 (0.5 is usual)"
);
ranged!(
    /// A random displacement as a fraction of the spacing.
    Disorder, |x| (0.0..0.5).contains(&x), "a disorder, which is zero or more and below 0.5"
);

ranged!(
    /// An altitude that the standard atmosphere reaches to, m.
    Altitude, |x| (LOWEST..=HIGHEST).contains(&x),
    "an altitude in m that the standard atmosphere covers, which is -5000 to 86000; give pressure and temperature elsewhere"
);
ranged!(
    /// An angle between a stream and an axis, degrees.
    StreamAngle, |x| x.abs() < 90.0, "an angle of a stream in degrees, which is above -90 and below 90"
);

/// Number of space dimensions: 1, 2 or 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "i64")]
pub struct Dimension(usize);

impl Dimension {
    /// The number.
    pub fn get(self) -> usize {
        self.0
    }
}

impl TryFrom<i64> for Dimension {
    type Error = String;

    fn try_from(value: i64) -> Result<Self, String> {
        match value {
            1..=3 => Ok(Self(value as usize)),
            _ => Err(format!("{value} is not a dimension; it is 1, 2 or 3")),
        }
    }
}

/// A whole number above zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "i64")]
pub struct Count(usize);

impl Count {
    /// The number.
    pub fn get(self) -> usize {
        self.0
    }
}

impl TryFrom<i64> for Count {
    type Error = String;

    fn try_from(value: i64) -> Result<Self, String> {
        usize::try_from(value)
            .ok()
            .filter(|&n| n > 0)
            .map(Self)
            .ok_or_else(|| format!("{value} is not a whole number above zero"))
    }
}

/// The name of a body: letters, digits, `-` and `_`, because it becomes part of file names, column
/// names and keys.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct Name(String);

impl Name {
    /// The text.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The name that is most like `text`: what cannot be in one becomes `_`, and digits alone follow a word.
    pub fn like(text: &str) -> Self {
        let good = |c: char| if is_of_name(c) { c } else { '_' };
        let like: String = text.trim().chars().map(good).collect();
        if like.chars().all(|c| c.is_ascii_digit() || c == '_') {
            return Self(
                format!("body-{like}")
                    .trim_end_matches(['-', '_'])
                    .to_owned(),
            );
        }
        Self(like)
    }
}

/// True of what may be in a name.
fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '-' || c == '_'
}

impl TryFrom<String> for Name {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        // A name that is a number could not be told from an index in `--set body.0...`.
        let number = text.chars().all(|c| c.is_ascii_digit());
        if number || !text.chars().all(is_of_name) {
            return Err(format!(
                "`{text}` is not a name; use letters, digits, `-` and `_`, at least one of them not a digit"
            ));
        }
        Ok(Self(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_and_infinity_are_not_numbers_of_any_kind() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(Finite::try_from(bad).is_err());
            assert!(Positive::try_from(bad).is_err());
            assert!(NonNegative::try_from(bad).is_err());
        }
    }

    #[test]
    fn a_refused_number_is_named_in_the_message() {
        let message = Positive::try_from(-0.25).unwrap_err();
        assert_eq!(message, "-0.25 is not a positive number");
    }

    #[test]
    fn a_name_of_digits_alone_is_refused() {
        assert!(Name::try_from("7".to_owned()).is_err());
        assert!(Name::try_from(String::new()).is_err());
        assert!(Name::try_from("stage-2".to_owned()).is_ok());
    }

    #[test]
    fn any_text_has_a_name_like_it() {
        for (text, name) in [
            ("stage-2", "stage-2"),
            ("my body", "my_body"),
            ("v1.2", "v1_2"),
            ("Rocket (1)", "Rocket__1_"),
            ("c\u{f4}ne 15", "c\u{f4}ne_15"),
            ("123", "body-123"),
            ("", "body"),
            ("...", "body"),
        ] {
            let like = Name::like(text);
            assert_eq!(like.as_str(), name);
            assert_eq!(Name::try_from(name.to_owned()), Ok(like));
        }
    }
}

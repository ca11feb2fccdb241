//! Numbers as they are typed.

use aero::scene::number::Positive;

/// A number above zero.
pub fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    Positive::try_from(number).map(Positive::get)
}

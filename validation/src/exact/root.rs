//! One bracketed root finder and one bracketed maximum, enough for the smooth functions here.
//!
//! Bisection to the last bit: slower than Brent's method, but it cannot fail on the vertical and
//! horizontal tangents that the functions of this folder have at their ends.

/// Root of `f` between `a` and `b`, where `f` must change sign.
///
/// Where it does not, the end with the smaller `|f|` is returned: the callers have checked the
/// bracket, so this only happens when a root sits on an end to round-off.
pub(super) fn bracketed_root(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let (mut low, mut high) = (a, b);
    let (f_low, f_high) = (f(low), f(high));
    if f_low == 0.0 {
        return low;
    }
    if f_low.signum() == f_high.signum() {
        return if f_low.abs() < f_high.abs() {
            low
        } else {
            high
        };
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low.min(high) || middle >= low.max(high) {
            return middle;
        }
        if f(middle).signum() == f_low.signum() {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// Where `f`, with one maximum between `a` and `b`, has it: golden-section search.
///
/// Good to about `1e-8 (b - a)`, the square root of round-off, as the flat top allows.
pub(super) fn bracketed_maximum(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (a, b);
    let mut left = high - golden * (high - low);
    let mut right = low + golden * (high - low);
    let (mut f_left, mut f_right) = (f(left), f(right));
    while high - low > 1e-9 * (b - a).abs() {
        if f_left > f_right {
            high = right;
            right = left;
            f_right = f_left;
            left = high - golden * (high - low);
            f_left = f(left);
        } else {
            low = left;
            left = right;
            f_left = f_right;
            right = low + golden * (high - low);
            f_right = f(right);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_of_a_cubic_is_found_to_the_last_bit() {
        let root = bracketed_root(|x| x * x * x - 2.0, 0.0, 2.0);
        assert!((root - 2.0_f64.cbrt()).abs() < 1e-15);
    }

    #[test]
    fn a_root_on_the_bracket_is_returned() {
        assert_eq!(bracketed_root(|x| x - 1.0, 1.0, 3.0), 1.0);
    }

    #[test]
    fn a_falling_function_is_bracketed_too() {
        assert!((bracketed_root(|x| 1.0 - x, 0.0, 5.0) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_maximum_of_a_parabola_is_found() {
        let top = bracketed_maximum(|x| -(x - 0.3) * (x - 0.3), 0.0, 1.0);
        assert!((top - 0.3).abs() < 1e-7);
    }
}

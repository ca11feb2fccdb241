//! Lines on the terminal. One that cannot be written is left out: who reads no further, as `head` does, does not end a run.

use std::fmt::Arguments;
use std::io::Write as _;

/// Writes to the standard output.
pub fn out(text: Arguments<'_>) {
    let _ = std::io::stdout().write_fmt(text);
}

/// Writes to the standard error.
pub fn note(text: Arguments<'_>) {
    let _ = std::io::stderr().write_fmt(text);
}

/// A line on the standard output.
macro_rules! say {
    ($($text:tt)*) => {
        $crate::say::out(format_args!("{}\n", format_args!($($text)*)))
    };
}

/// Text on the standard output that ends its own lines.
macro_rules! say_all {
    ($($text:tt)*) => {
        $crate::say::out(format_args!($($text)*))
    };
}

/// A line on the standard error.
macro_rules! note {
    ($($text:tt)*) => {
        $crate::say::note(format_args!("{}\n", format_args!($($text)*)))
    };
}

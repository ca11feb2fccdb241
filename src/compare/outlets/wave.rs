//! A sound that is sent towards an outlet.

/// A sound in a stream, through a duct of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Sound {
    /// Of the stream.
    pub mach: f64,
    /// Highest speed of the gas in it over that of sound.
    pub strength: f64,
    /// Spacings to the duct.
    pub cells: u32,
}

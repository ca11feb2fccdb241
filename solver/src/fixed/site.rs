//! Places on a lattice whose cells are split in halves again and again.

/// Place of a point on the lattice: level of splitting and index on the lattice of that level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Site<const D: usize> {
    /// How often its cell was split.
    pub level: u8,
    /// Index on the lattice of its level.
    pub index: [i32; D],
}

/// All steps from a lattice cell to itself and to those around it.
pub fn steps<const D: usize>() -> impl Iterator<Item = [i32; D]> {
    (0..3_i32.pow(D as u32)).map(|code| std::array::from_fn(|k| code / 3_i32.pow(k as u32) % 3 - 1))
}

/// First cells of the parts of a block, each `half` wide, along the curve.
pub fn children<const D: usize>(low: [i32; D], half: i32) -> impl Iterator<Item = [i32; D]> {
    (0..1_usize << D)
        .map(move |n| std::array::from_fn(|k| low[k] + half * (n >> (D - 1 - k) & 1) as i32))
}

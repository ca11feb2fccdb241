//! In what order cells of an implicit step come: levels of cells that no face joins.

/// A neighbour of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Its number.
    pub cell: u32,
    /// Its place in the order.
    pub place: u32,
    /// Twice the number of its face's shape, and one more where the area points into the cell: sweeps read little else.
    face: u32,
}

impl Link {
    /// To a neighbour at this place in the order, behind a face of this shape, whose area points out of the cell or into it.
    pub fn new(cell: u32, place: u32, shape: u32, is_inward: bool) -> Self {
        Self {
            cell,
            place,
            face: 2 * shape + u32::from(is_inward),
        }
    }

    /// Number of the face's shape.
    #[inline(always)]
    pub fn shape(&self) -> usize {
        (self.face >> 1) as usize
    }

    /// What the area is taken by to point out of the cell.
    #[inline(always)]
    pub fn sign(&self) -> f64 {
        1.0 - 2.0 * f64::from(self.face & 1)
    }
}

/// The level of each cell: above those of its neighbours with a smaller key, and none that a neighbour with the same key has. Those `beside` each cell
/// follow one another from its place in `starts` on.
pub fn levels(starts: &[u32], beside: &[u32], keys: &[f64]) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut order: Vec<u32> = (0..keys.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| {
        keys[a as usize]
            .total_cmp(&keys[b as usize])
            .then(a.cmp(&b))
    });
    let mut levels = vec![NONE; keys.len()];
    let mut taken: Vec<u32> = Vec::new();
    for &cell in &order {
        let i = cell as usize;
        let mut level = 0;
        taken.clear();
        for &j in &beside[starts[i] as usize..starts[i + 1] as usize] {
            let j = j as usize;
            if levels[j] == NONE || i == j {
                continue;
            }
            if keys[j] < keys[i] {
                level = level.max(levels[j] + 1);
            } else {
                taken.push(levels[j]);
            }
        }
        while taken.contains(&level) {
            level += 1;
        }
        levels[i] = level;
    }
    levels
}

//! In what order cells of an implicit step come: levels of cells that no face joins.

/// A neighbour of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Its number.
    pub cell: u32,
    /// Its place in the order.
    pub place: u32,
    /// Number of its face's shape.
    pub shape: u32,
    /// The area points out of the cell, or into it.
    pub sign: f64,
}

/// The level of each cell: above those of its neighbours with a smaller key, and none that a neighbour with the same key has.
pub fn levels(starts: &[u32], links: &[Link], keys: &[f64]) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut order: Vec<u32> = (0..keys.len() as u32).collect();
    order.sort_by(|&a, &b| {
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
        for link in &links[starts[i] as usize..starts[i + 1] as usize] {
            let j = link.cell as usize;
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

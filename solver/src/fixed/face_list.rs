//! Faces between cells: which two each joins, and, once for all that are alike, what they look like. On a lattice few differ.

use std::collections::HashMap;
use std::hash::BuildHasher;

use aero_geometry::Vector;
use foldhash::fast::FixedState;
use rayon::slice::ParallelSliceMut;

/// A face between two cells, `i < j`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face<const D: usize> {
    /// First cell.
    pub i: u32,
    /// Second cell.
    pub j: u32,
    /// Area times the unit normal from `i` to `j`; times the radius about an axis.
    pub area: Vector<D>,
    /// From the point of `i` to that of `j`, or its periodic image.
    pub apart: Vector<D>,
    /// From halfway between both points to the middle of the face.
    pub skew: Vector<D>,
}

/// A face by what it joins and the number of its look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Join {
    /// First cell.
    pub i: u32,
    /// Second cell.
    pub j: u32,
    /// Number of what it looks like.
    pub shape: u32,
}

/// Area, distance and skew of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<const D: usize> {
    /// As of [`Face`].
    pub area: Vector<D>,
    /// As of [`Face`].
    pub apart: Vector<D>,
    /// As of [`Face`].
    pub skew: Vector<D>,
}

/// Faces in their order.
#[derive(Clone, Debug)]
pub struct FaceList<const D: usize> {
    joins: Vec<Join>,
    looks: Vec<Look<D>>,
}

impl<const D: usize> Look<D> {
    fn bits(&self) -> [[u64; D]; 3] {
        let bits = |vector: &Vector<D>| std::array::from_fn(|k| vector[k].to_bits());
        [bits(&self.area), bits(&self.apart), bits(&self.skew)]
    }
}

impl Join {
    /// The face of which this is the short form, where `looks` are those of its list.
    pub fn in_full<const D: usize>(&self, looks: &[Look<D>]) -> Face<D> {
        let Look { area, apart, skew } = looks[self.shape as usize];
        Face {
            i: self.i,
            j: self.j,
            area,
            apart,
            skew,
        }
    }
}

impl<const D: usize> Default for FaceList<D> {
    fn default() -> Self {
        Self {
            joins: Vec::new(),
            looks: Vec::new(),
        }
    }
}

impl<const D: usize> FaceList<D> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.joins.len()
    }

    /// True where there is none.
    pub fn is_empty(&self) -> bool {
        self.joins.is_empty()
    }

    /// The faces.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Face<D>> {
        self.joins.iter().map(|join| join.in_full(&self.looks))
    }

    /// The same sorted, those between the same points added up.
    #[must_use]
    pub fn folded(self, spacing: f64) -> Self {
        let Self {
            mut joins,
            mut looks,
        } = self;
        let ends = |join: &Join| (join.i, join.j);
        joins.par_sort_by_key(ends);
        let mut kept = 0;
        for number in 0..joins.len() {
            let join = joins[number];
            let own = looks[join.shape as usize];
            let is_same = |known: &&mut Join| {
                (looks[known.shape as usize].apart - own.apart).norm() < 1e-6 * spacing
            };
            let before = joins[..kept].iter_mut().rev();
            let mut between = before.take_while(|known| ends(known) == ends(&join));
            if let Some(known) = between.find(is_same) {
                let mut sum = looks[known.shape as usize];
                let (a, b) = (sum.area.norm(), own.area.norm());
                sum.skew += (own.skew - sum.skew) * (b / (a + b));
                sum.area += own.area;
                known.shape = looks.len() as u32;
                looks.push(sum);
            } else {
                joins[kept] = join;
                kept += 1;
            }
        }
        joins.truncate(kept);
        Self { joins, looks }
    }

    /// Their short forms.
    pub fn joins(&self) -> &[Join] {
        &self.joins
    }

    /// What they look like.
    pub fn looks(&self) -> &[Look<D>] {
        &self.looks
    }
}

impl<const D: usize> PartialEq for FaceList<D> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl<const D: usize> FromIterator<Face<D>> for FaceList<D> {
    fn from_iter<I: IntoIterator<Item = Face<D>>>(faces: I) -> Self {
        let mut filler = FaceFiller::default();
        faces.into_iter().for_each(|face| filler.push(&face));
        filler.list()
    }
}

/// A list that grows.
#[derive(Clone, Debug)]
pub struct FaceFiller<const D: usize> {
    list: FaceList<D>,
    /// The look of each hash, or of the next that was free.
    known: HashMap<u64, u32, FixedState>,
}

impl<const D: usize> Default for FaceFiller<D> {
    fn default() -> Self {
        Self {
            list: FaceList::default(),
            known: HashMap::default(),
        }
    }
}

impl<const D: usize> FaceFiller<D> {
    /// Adds a face.
    pub fn push(&mut self, face: &Face<D>) {
        let Face {
            area, apart, skew, ..
        } = *face;
        let shape = self.number(Look { area, apart, skew });
        self.list.joins.push(Join {
            i: face.i,
            j: face.j,
            shape,
        });
    }

    /// Adds all faces of another list.
    pub fn append(&mut self, other: &FaceList<D>) {
        let numbers: Vec<u32> = other.looks.iter().map(|look| self.number(*look)).collect();
        let joins = other.joins.iter().map(|join| Join {
            shape: numbers[join.shape as usize],
            ..*join
        });
        self.list.joins.extend(joins);
    }

    /// The list as it stands.
    pub fn list(self) -> FaceList<D> {
        self.list
    }

    /// The number of a look.
    fn number(&mut self, look: Look<D>) -> u32 {
        let hash = FixedState::default().hash_one(look.bits());
        self.number_at(hash, look)
    }

    /// The same of a look with this hash, or of the next hash that another look has not taken.
    fn number_at(&mut self, mut hash: u64, look: Look<D>) -> u32 {
        let looks = &mut self.list.looks;
        loop {
            let next = looks.len() as u32;
            let number = *self.known.entry(hash).or_insert(next);
            if number == next {
                looks.push(look);
                return next;
            }
            if looks[number as usize].bits() == look.bits() {
                return number;
            }
            hash = hash.wrapping_add(1);
        }
    }
}

/// A face between two cells, from the one with the lower number to the other.
pub(super) fn ordered<const D: usize>(
    (i, j): (u32, u32),
    area: Vector<D>,
    apart: Vector<D>,
    skew: Vector<D>,
) -> Face<D> {
    if i < j {
        Face {
            i,
            j,
            area,
            apart,
            skew,
        }
    } else {
        Face {
            i: j,
            j: i,
            area: -area,
            apart: -apart,
            skew,
        }
    }
}

/// A `skew` less what is but rounding.
pub(super) fn settled<const D: usize>(skew: Vector<D>, spacing: f64) -> Vector<D> {
    skew.map(|part| {
        if part.abs() > 1e-9 * spacing {
            part
        } else {
            0.0
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(i: u32, j: u32, along: f64, skew: f64) -> Face<2> {
        Face {
            i,
            j,
            area: Vector::<2>::new(along, 0.0),
            apart: Vector::<2>::new(0.5, 0.0),
            skew: Vector::<2>::new(0.0, skew),
        }
    }

    /// A zero with another sign is another look.
    #[test]
    fn faces_come_back_to_the_last_bit_and_like_ones_are_kept_once() {
        let faces = [
            face(0, 1, 0.25, 0.0),
            face(1, 2, 0.25, 0.0),
            face(0, 3, 0.25, -0.0),
            face(2, 3, 0.5, 0.0),
        ];
        let list: FaceList<2> = faces.into_iter().collect();
        assert_eq!(list.looks().len(), 3);
        for (found, face) in list.iter().zip(faces) {
            assert_eq!(found, face);
            assert_eq!(found.skew.y.to_bits(), face.skew.y.to_bits());
        }
        let mut both = FaceFiller::default();
        both.push(&face(5, 6, 0.5, 0.0));
        both.append(&list);
        let both = both.list();
        assert_eq!(both.looks().len(), 3);
        assert!(both.iter().skip(1).eq(faces));
    }

    #[test]
    fn looks_that_share_a_hash_stay_apart() {
        let mut filler = FaceFiller::default();
        let look = |size: f64| Look {
            area: Vector::<2>::new(size, 0.0),
            apart: Vector::zeros(),
            skew: Vector::zeros(),
        };
        let numbers = [1.0, 2.0, 3.0, 2.0, 1.0].map(|size| filler.number_at(u64::MAX, look(size)));
        assert_eq!(numbers, [0, 1, 2, 1, 0]);
    }

    /// Two parts of one face, with one between other cells and one to another image of the same cell.
    #[test]
    fn parts_of_a_face_become_one_with_its_middle() {
        let elsewhere = Face {
            apart: Vector::<2>::new(-0.5, 0.0),
            ..face(1, 4, 0.3, 0.0)
        };
        let parts = [
            face(2, 3, 0.25, 0.1),
            face(1, 4, 0.1, 0.2),
            elsewhere,
            face(1, 4, 0.3, -0.2),
        ];
        let list: FaceList<2> = parts.into_iter().collect();
        let folded: Vec<Face<2>> = list.folded(1.0).iter().collect();
        assert_eq!(folded.len(), 3);
        assert_eq!((folded[1], folded[2]), (elsewhere, parts[0]));
        assert!((folded[0].area.x - 0.4).abs() < 1e-15);
        assert!((folded[0].skew.y + 0.1).abs() < 1e-15);
    }
}

//! What a pair law is, and what the laws of one pass share.
//!
//! A pass treats one cluster of particles `i` in the lanes and broadcasts each neighbour `j`. Its [`Basis`] tells what is known of
//! them before any law is applied, and each [`Law`] what it loads on top, what it sums and what it makes of its sums. Laws do not
//! ask in what numbers the lanes are ([`crate::vectors`]). Two laws side by side, `(a, b)`, are a law, and `()` is none: a pass over
//! them costs what they cost.

use super::sum::Sum;
use crate::lanes::Lane;
use crate::records::Read;
use crate::vectors::Vectors;

/// What the laws of one pass share.
pub trait Basis<const D: usize>: Sync {
    /// What is read of the particles `i`, one per lane.
    type Own<V: Vectors>: Copy;
    /// What is known of a pair; laws may leave word in it for those after them.
    type Pair<V: Vectors>;
    /// A particle whose sums are complete; laws may leave word in it for those after them.
    type Site<'a>
    where
        Self: 'a;
    /// What the pass finds of each particle.
    type Result: Send;

    /// Slot of the first particle.
    fn first(&self) -> usize {
        0
    }

    /// Loads the particles at `slot(l)`, one per lane.
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Self::Own<V>;

    /// The particles `i` and the neighbour at slot `j`.
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        own: &Self::Own<V>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Self::Pair<V>;

    /// What is found where nothing is disturbed, without sums.
    fn rest(&self, slot: usize, result: &mut Self::Result);

    /// The particle at `slot`, before any law's sums are made use of.
    fn open(&self, slot: usize, result: &mut Self::Result) -> Self::Site<'_>;

    /// The particle after all laws.
    fn close(&self, site: Self::Site<'_>, result: &mut Self::Result);
}

/// A law of pairs.
pub trait Law<B: Basis<D>, const D: usize>: Sync {
    /// What it loads of the particles `i` beyond what its basis does, one per lane.
    type Own<V: Vectors>: Copy;
    /// What it sums.
    type Sums<V: Vectors>: Sum<V, Number = Self::Number>;
    /// Its sums of one particle.
    type Number;

    /// Loads the particles at `slot(l)`.
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V>;

    /// Adds the terms of the particles `i` with the neighbour in the gas at slot `j`.
    fn add<V: Vectors>(
        &self,
        i: (&B::Own<V>, &Self::Own<V>),
        pair: &mut B::Pair<V>,
        j: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    );

    /// The same for a ghost. Laws that act within the gas only (`phi_ij` of Villodi & Ramachandran 2024, below eq. 10) do nothing.
    #[inline(always)]
    fn add_ghost<V: Vectors>(
        &self,
        i: (&B::Own<V>, &Self::Own<V>),
        pair: &mut B::Pair<V>,
        j: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    ) {
        self.add(i, pair, j, sums);
    }

    /// The sums in metres, where the records are in lengths of their own: most go by the inverse of a length.
    #[inline(always)]
    fn in_metres<V: Vectors>(&self, sums: Self::Sums<V>, per_length: Lane<V>) -> Self::Sums<V> {
        sums.scaled(per_length)
    }

    /// Makes use of one particle's sums, over the gas alone and over all neighbours.
    fn finish(
        &self,
        gas: Self::Number,
        all: Self::Number,
        site: &mut B::Site<'_>,
        result: &mut B::Result,
    );
}

/// A neighbour `j`, broadcast to all lanes.
#[derive(Clone, Copy)]
pub struct Neighbour<'a, V: Vectors, const D: usize> {
    /// The vectors to broadcast to.
    pub vectors: V,
    /// All records.
    pub read: Read<'a, D, V::Number>,
    /// Its slot.
    pub slot: usize,
}

impl<B: Basis<D>, const D: usize> Law<B, D> for () {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = ();
    type Number = ();

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        _: V,
        _: Read<'_, D, V::Number>,
        _: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        _: (&B::Own<V>, &()),
        _: &mut B::Pair<V>,
        _: Neighbour<'_, V, D>,
        (): &mut (),
    ) {
    }

    #[inline(always)]
    fn finish(&self, (): (), (): (), _: &mut B::Site<'_>, _: &mut B::Result) {}
}

impl<B: Basis<D>, A: Law<B, D>, C: Law<B, D>, const D: usize> Law<B, D> for (A, C) {
    type Own<V: Vectors> = (A::Own<V>, C::Own<V>);
    type Sums<V: Vectors> = (A::Sums<V>, C::Sums<V>);
    type Number = (A::Number, C::Number);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        (
            self.0.load(vectors, read, slot),
            self.1.load(vectors, read, slot),
        )
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (own, (first, second)): (&B::Own<V>, &Self::Own<V>),
        pair: &mut B::Pair<V>,
        j: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    ) {
        self.0.add((own, first), pair, j, &mut sums.0);
        self.1.add((own, second), pair, j, &mut sums.1);
    }

    #[inline(always)]
    fn add_ghost<V: Vectors>(
        &self,
        (own, (first, second)): (&B::Own<V>, &Self::Own<V>),
        pair: &mut B::Pair<V>,
        j: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    ) {
        self.0.add_ghost((own, first), pair, j, &mut sums.0);
        self.1.add_ghost((own, second), pair, j, &mut sums.1);
    }

    #[inline(always)]
    fn in_metres<V: Vectors>(&self, sums: Self::Sums<V>, per_length: Lane<V>) -> Self::Sums<V> {
        (
            self.0.in_metres(sums.0, per_length),
            self.1.in_metres(sums.1, per_length),
        )
    }

    #[inline(always)]
    fn finish(
        &self,
        gas: Self::Number,
        all: Self::Number,
        site: &mut B::Site<'_>,
        result: &mut B::Result,
    ) {
        self.0.finish(gas.0, all.0, site, result);
        self.1.finish(gas.1, all.1, site, result);
    }
}

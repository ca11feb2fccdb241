//! What is made of one iterator, or two.

use super::Parallel;

/// See [`Parallel::with_min_len`].
pub struct MinLen<P> {
    pub(super) inner: P,
    pub(super) least: usize,
}

impl<P: Parallel> Parallel for MinLen<P> {
    type Item = P::Item;
    type Serial = P::Serial;

    fn length(&self) -> usize {
        self.inner.length()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let least = self.least;
        let (first, rest) = self.inner.part_at(place);
        let part = |inner| Self { inner, least };
        (part(first), part(rest))
    }

    fn serial(self) -> P::Serial {
        self.inner.serial()
    }

    fn elements(&self) -> usize {
        self.inner.elements()
    }

    fn least(&self) -> usize {
        self.inner.least().max(self.least)
    }
}

/// See [`Parallel::zip`].
pub struct Zip<P, Q>(pub(super) P, pub(super) Q);

impl<P: Parallel, Q: Parallel> Parallel for Zip<P, Q> {
    type Item = (P::Item, Q::Item);
    type Serial = std::iter::Zip<P::Serial, Q::Serial>;

    fn length(&self) -> usize {
        self.0.length().min(self.1.length())
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let (a, c) = self.0.part_at(place);
        let (b, d) = self.1.part_at(place);
        (Self(a, b), Self(c, d))
    }

    fn serial(self) -> Self::Serial {
        self.0.serial().zip(self.1.serial())
    }

    fn elements(&self) -> usize {
        self.0.elements().max(self.1.elements())
    }

    fn least(&self) -> usize {
        self.0.least().max(self.1.least())
    }
}

/// See [`Parallel::enumerate`].
pub struct Enumerate<P> {
    pub(super) inner: P,
    pub(super) first: usize,
}

impl<P: Parallel> Parallel for Enumerate<P> {
    type Item = (usize, P::Item);
    type Serial = std::iter::Zip<std::ops::RangeFrom<usize>, P::Serial>;

    fn length(&self) -> usize {
        self.inner.length()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let (inner, rest) = self.inner.part_at(place);
        let first = self.first;
        (
            Self { inner, first },
            Self {
                inner: rest,
                first: first + place,
            },
        )
    }

    fn serial(self) -> Self::Serial {
        (self.first..).zip(self.inner.serial())
    }

    fn elements(&self) -> usize {
        self.inner.elements()
    }

    fn least(&self) -> usize {
        self.inner.least()
    }
}

/// See [`Parallel::copied`].
pub struct Copied<P>(pub(super) P);

impl<'a, T: Copy + 'a, P: Parallel<Item = &'a T>> Parallel for Copied<P> {
    type Item = T;
    type Serial = std::iter::Copied<P::Serial>;

    fn length(&self) -> usize {
        self.0.length()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let (first, rest) = self.0.part_at(place);
        (Self(first), Self(rest))
    }

    fn serial(self) -> Self::Serial {
        self.0.serial().copied()
    }

    fn elements(&self) -> usize {
        self.0.elements()
    }

    fn least(&self) -> usize {
        self.0.least()
    }
}

/// Writes an iterator that hands every item to a closure.
macro_rules! with_closure {
    ($(#[$doc:meta])* $name:ident, $closure:ident, $method:ident, $serial:ty, [$($result:ident $(: $trait:path)?)?], $item:ty, $bound:path) => {
        $(#[$doc])*
        pub struct $name<P, F> {
            pub(super) inner: P,
            pub(super) $closure: F,
        }

        impl<P: Parallel, $($result $(: $trait)?,)? F: $bound + Clone + Send> Parallel for $name<P, F> {
            type Item = $item;
            type Serial = $serial;

            fn length(&self) -> usize {
                self.inner.length()
            }

            fn part_at(self, place: usize) -> (Self, Self) {
                let $closure = self.$closure;
                let (inner, rest) = self.inner.part_at(place);
                let first = Self {
                    inner,
                    $closure: $closure.clone(),
                };
                let rest = Self {
                    inner: rest,
                    $closure,
                };
                (first, rest)
            }

            fn serial(self) -> Self::Serial {
                self.inner.serial().$method(self.$closure)
            }

            fn elements(&self) -> usize {
                self.inner.elements()
            }

            fn least(&self) -> usize {
                self.inner.least()
            }
        }
    };
}

with_closure!(
    /// See [`Parallel::map`].
    Map, change, map, std::iter::Map<P::Serial, F>, [R], R, Fn(P::Item) -> R
);
with_closure!(
    /// See [`Parallel::filter`].
    Filter, keep, filter, std::iter::Filter<P::Serial, F>, [], P::Item, Fn(&P::Item) -> bool
);
with_closure!(
    /// See [`Parallel::filter_map`].
    FilterMap, change, filter_map, std::iter::FilterMap<P::Serial, F>, [R], R, Fn(P::Item) -> Option<R>
);
with_closure!(
    /// See [`Parallel::flat_map_iter`].
    FlatMap, change, flat_map, std::iter::FlatMap<P::Serial, R, F>, [R: IntoIterator], R::Item, Fn(P::Item) -> R
);

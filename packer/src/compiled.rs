//! The packing as this crate compiled it in the plane and in space: crates that use it call that and need not compile it again.

use std::any::Any;

use aero_geometry::{Bounds, Shape};

use crate::{PackError, PackOptions, Packing};

type Pack<const D: usize> = fn(&dyn Shape<D>, &PackOptions<D>) -> Result<Packing<D>, PackError>;
type ThinnestPart<const D: usize> = fn(&dyn Shape<D>, &Bounds<D>) -> Option<f64>;

/// The one of `works` whose type is `W`.
fn of_type<W: Copy + 'static>(works: [&dyn Any; 2]) -> Option<W> {
    works.iter().find_map(|work| work.downcast_ref()).copied()
}

/// Packs ghosts into `shape` in layers at depths `(k + 1/2) dx` and, if asked, conforming fluid
/// around it. The result is the same, bit by bit, for any number of threads.
///
/// # Errors
/// Options that make no sense, a body that is endless without a region, too small or too thin for
/// the spacing, and packings too large for memory.
pub fn pack<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Result<Packing<D>, PackError> {
    let work: Option<Pack<D>> = of_type([&(plane::pack as Pack<2>), &(space::pack as Pack<3>)]);
    work.map_or(Err(PackError::Dimension(D)), |pack| pack(shape, options))
}

/// Thickness of the thin parts of `shape` in `region`: a fiftieth of the surface is no farther from the surface opposite. None where no
/// part is thinner than a quarter of the body's extent, or where the shape shows no surface.
pub fn thinnest_part<const D: usize>(shape: &dyn Shape<D>, region: &Bounds<D>) -> Option<f64> {
    let work: Option<ThinnestPart<D>> = of_type([
        &(plane::thinnest_part as ThinnestPart<2>),
        &(space::thinnest_part as ThinnestPart<3>),
    ]);
    work?(shape, region)
}

macro_rules! compiled {
    ($module:ident $D:literal) => {
        mod $module {
            use super::*;

            #[inline(never)]
            pub fn pack(
                shape: &dyn Shape<$D>,
                options: &PackOptions<$D>,
            ) -> Result<Packing<$D>, PackError> {
                crate::pack::pack(shape, options)
            }

            #[inline(never)]
            pub fn thinnest_part(shape: &dyn Shape<$D>, region: &Bounds<$D>) -> Option<f64> {
                crate::thickness::thinnest_part(shape, region)
            }
        }
    };
}

compiled!(plane 2);
compiled!(space 3);

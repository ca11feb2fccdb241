//! The work of a flow as this crate compiled it for one, two and three dimensions: crates that use it call that and need not
//! compile all passes again.

use std::any::Any;
use std::sync::Arc;

use aero_geometry::Bounds;

use crate::carrier::{Carrier, FlowMemory};
use crate::fixed::Settled;
use crate::frame::{CellFrame, Frame, Load, PanelFrame, SurfaceFrame, Totals};
use crate::problem::Problem;
use crate::{Failure, Statistics};

/// `value`, whose type `A` and `B` both name.
fn renamed<A: Any, B: Any>(value: A) -> B {
    let mut value = Some(value);
    (&mut value as &mut dyn Any)
        .downcast_mut::<Option<B>>()
        .and_then(Option::take)
        .expect("flows have one, two or three dimensions")
}

/// The same behind a reference.
fn seen<A: Any, B: Any>(value: &A) -> &B {
    (value as &dyn Any)
        .downcast_ref()
        .expect("flows have one, two or three dimensions")
}

/// The same behind a reference that may change it.
fn held<A: Any, B: Any>(value: &mut A) -> &mut B {
    (value as &mut dyn Any)
        .downcast_mut()
        .expect("flows have one, two or three dimensions")
}

/// Writes each function once for every dimension, and once for any, which calls that of the dimension.
macro_rules! compiled {
    ($($(#[$doc:meta])* fn $name:ident($($how:ident $argument:ident: $type:ty),*) -> $result:ty = $work:path;)*) => {
        compiled!(@module one 1 $(fn $name($($argument: $type),*) -> $result = $work;)*);
        compiled!(@module two 2 $(fn $name($($argument: $type),*) -> $result = $work;)*);
        compiled!(@module three 3 $(fn $name($($argument: $type),*) -> $result = $work;)*);
        $(
            $(#[$doc])*
            pub fn $name<const D: usize>($($argument: $type),*) -> $result {
                match D {
                    1 => renamed(one::$name($($how($argument)),*)),
                    2 => renamed(two::$name($($how($argument)),*)),
                    _ => renamed(three::$name($($how($argument)),*)),
                }
            }
        )*
    };
    (@module $module:ident $D:literal $(fn $name:ident($($argument:ident: $type:ty),*) -> $result:ty = $work:path;)*) => {
        mod $module {
            use super::*;
            const D: usize = $D;
            $(
                #[inline(never)]
                pub fn $name($($argument: $type),*) -> $result {
                    $work($($argument),*)
                }
            )*
        }
    };
}

/// A number or a name, which no dimension changes.
fn same<A>(value: A) -> A {
    value
}

compiled! {
    /// See [`Carrier::new`].
    fn start(renamed problem: Problem<D>) -> Result<Carrier<D>, String> = Carrier::new;
    /// See [`Carrier::resume`].
    fn resume(renamed problem: Problem<D>, renamed memory: FlowMemory<'static, D>) -> Result<Carrier<D>, String> = Carrier::resume;
    /// See [`Carrier::step`].
    fn step(held carrier: &mut Carrier<D>, same limit: f64) -> Result<f64, Failure> = Carrier::step;
    /// See [`Carrier::settle_step`].
    fn settle_step(held carrier: &mut Carrier<D>) -> Option<Result<Settled, Failure>> = Carrier::settle_step;
    /// See [`Carrier::frame`].
    fn frame(seen carrier: &Carrier<D>) -> Frame = Carrier::frame;
    /// See [`Carrier::frame_within`].
    fn frame_within(seen carrier: &Carrier<D>, seen region: &Bounds<D>) -> Frame = Carrier::frame_within;
    /// See [`Carrier::surface`].
    fn surface(seen carrier: &Carrier<D>) -> SurfaceFrame = Carrier::surface;
    /// See [`Carrier::panels`].
    fn panels(seen carrier: &Carrier<D>) -> PanelFrame = Carrier::panels;
    /// See [`Carrier::cells`].
    fn cells(seen carrier: &Carrier<D>) -> Option<Arc<CellFrame>> = Carrier::cells;
    /// See [`Carrier::uniform_loads`].
    fn uniform_loads(seen carrier: &Carrier<D>) -> Vec<Load> = Carrier::uniform_loads;
    /// See [`Carrier::loads`].
    fn loads(seen carrier: &Carrier<D>) -> Vec<Load> = Carrier::loads;
    /// See [`Carrier::totals`].
    fn totals(seen carrier: &Carrier<D>) -> Totals = Carrier::totals;
    /// See [`Carrier::statistics`].
    fn statistics(seen carrier: &Carrier<D>) -> Statistics = Carrier::statistics;
}

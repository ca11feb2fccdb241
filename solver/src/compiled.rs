//! The work of a flow as this crate compiled it for one, two and three dimensions: crates that use it call that and need not
//! compile all passes again.

use std::any::Any;

use aero_geometry::Bounds;

use crate::fixed::Settled;
use crate::flow::{Flow, FlowMemory};
use crate::frame::{Frame, Load, PanelFrame, SurfaceFrame, Totals};
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
    /// See [`Flow::new`].
    fn start(renamed problem: Problem<D>) -> Result<Flow<D>, String> = Flow::start;
    /// See [`Flow::resume`].
    fn resume(renamed problem: Problem<D>, renamed memory: FlowMemory<'static, D>) -> Result<Flow<D>, String> = Flow::go_on;
    /// See [`Flow::step`].
    fn step(held flow: &mut Flow<D>, same limit: f64) -> Result<f64, Failure> = Flow::advance;
    /// See [`Flow::settle_step`].
    fn settle_step(held flow: &mut Flow<D>) -> Option<Result<Settled, Failure>> = Flow::settle;
    /// See [`Flow::frame`].
    fn frame(seen flow: &Flow<D>) -> Frame = Flow::all_shown;
    /// See [`Flow::frame_within`].
    fn frame_within(seen flow: &Flow<D>, seen region: &Bounds<D>) -> Frame = Flow::shown_within;
    /// See [`Flow::surface`].
    fn surface(seen flow: &Flow<D>) -> SurfaceFrame = Flow::surface_shown;
    /// See [`Flow::panels`].
    fn panels(seen flow: &Flow<D>) -> PanelFrame = Flow::panels_shown;
    /// See [`Flow::uniform_loads`].
    fn uniform_loads(seen flow: &Flow<D>) -> Vec<Load> = Flow::uniform_loads_summed;
    /// See [`Flow::loads`].
    fn loads(seen flow: &Flow<D>) -> Vec<Load> = Flow::loads_summed;
    /// See [`Flow::totals`].
    fn totals(seen flow: &Flow<D>) -> Totals = Flow::totals_summed;
    /// See [`Flow::statistics`].
    fn statistics(seen flow: &Flow<D>) -> Statistics = Flow::counted;
}

#![allow(missing_docs)]
mod shapes;
use aero_geometry::{Bounds, Closest, Shape, Vector};
use aero_packer::{PackOptions, pack};
use shapes::Ball;
#[derive(Debug)]
struct Plain<S>(S);
impl<S: Shape<3>> Shape<3> for Plain<S> {
    fn bounds(&self) -> Bounds<3> {
        self.0.bounds()
    }
    fn closest(&self, p: &Vector<3>) -> Closest<3> {
        self.0.closest(p)
    }
}
#[test]
fn big() {
    let r: f64 = std::env::var("R")
        .ok()
        .and_then(|v| v.parse().ok())
        .unwrap_or(20.0);
    for fl in if std::env::var("BOTH").is_ok() {
        vec![0, 3]
    } else {
        vec![0]
    } {
        let mut o = PackOptions::new(1.0 / r);
        o.fluid_layers = fl;
        let p = pack(&Plain(Ball::<3>::new(1.0)), &o).unwrap();
        println!("{} {} {:?}", p.report.ghosts, p.report.fluid, p.report);
    }
}

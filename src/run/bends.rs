//! Sharp convex bends of walls in a stream faster than sound, of particles, at the end of a run: a fan stands at one, which kernels smear and
//! which rings, so that pressures behind it are wrong over a number of spacings, however small these are.

use aero_packer::{About, Warning};
use aero_solver::frame::PanelFrame;
use aero_solver::problem::Problem;

/// Turns that are told of, degrees: of less the fan is weak, and gas does not follow farther.
const TURNS: [f64; 2] = [10.0, 50.0];

/// Mach number of the gas on both sides from which on a fan stands there.
const FAST: f64 = 1.05;

/// What there is to say of the bends of the bodies of a flow with these `panels`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, panels: &PanelFrame) -> Vec<Warning> {
    if D != 2 || problem.method.fixed().is_some() {
        return Vec::new();
    }
    let bends: Vec<[f64; 3]> = (1..panels.body.len())
        .filter(|&n| (panels.body[n] as usize) < problem.bodies.len())
        .filter_map(|n| bend(panels, n))
        .collect();
    let Some([x, y, _]) = bends.first() else {
        return Vec::new();
    };
    let where_they_are = match bends.len() {
        1 => format!("the sharp convex bend at ({x:.4}, {y:.4})"),
        many => format!("{many} sharp convex bends, the first at ({x:.4}, {y:.4})"),
    };
    let text = format!(
        "behind {where_they_are}, particles show wall pressures that are too high for six spacings and off by 5 % up to twenty, by a third where the pressure \
         falls below a fifth, however small spacings are; take points that stay (`scheme.motion = \"fixed\"`) for pressures there"
    );
    vec![Warning::new(About::Scene, text)]
}

/// Where panel `n` and the one before it meet at such a bend.
fn bend(panels: &PanelFrame, n: usize) -> Option<[f64; 3]> {
    let corner = panels.points[2 * n];
    let fast = panels.mach[n - 1].min(panels.mach[n]) > FAST;
    if !fast || panels.body[n - 1] != panels.body[n] || panels.points[2 * n - 1] != corner {
        return None;
    }
    let [before, behind] = [panels.normal[n - 1], panels.normal[n]];
    let (a, b) = (panels.middle(n - 1), panels.middle(n));
    // Normals part where it is convex.
    let part: f64 = (0..2)
        .map(|k| (b[k] - a[k]) * (behind[k] - before[k]))
        .sum();
    let cosine: f64 = (0..2).map(|k| before[k] * behind[k]).sum();
    let turn = cosine.clamp(-1.0, 1.0).acos().to_degrees();
    (part > 0.0 && turn > TURNS[0] && turn < TURNS[1]).then_some(corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two panels that meet at the origin, the second turned by so many degrees, down where that is below zero; gas above.
    fn panels(degrees: f64, mach: [f64; 2]) -> PanelFrame {
        let (s, c) = degrees.to_radians().sin_cos();
        PanelFrame {
            corners: 2,
            points: vec![[-1.0, 0.0, 0.0], [0.0; 3], [0.0; 3], [c, s, 0.0]],
            normal: vec![[0.0, 1.0, 0.0], [-s, c, 0.0]],
            mach: mach.to_vec(),
            body: vec![0; 2],
            ..PanelFrame::default()
        }
    }

    #[test]
    fn convex_bends_in_fast_gas_are_told_and_no_others() {
        let is_told = |degrees: f64, mach| bend(&panels(degrees, mach), 1).is_some();
        assert!(is_told(-15.0, [2.0, 2.5]));
        assert!(!is_told(15.0, [2.0, 1.5]), "concave");
        assert!(!is_told(-8.0, [2.0, 2.2]) && !is_told(-90.0, [2.0, 2.0]));
        assert!(!is_told(-15.0, [0.8, 1.2]), "slow");
        let mut apart = panels(-15.0, [2.0, 2.5]);
        apart.points[2][0] = 0.1;
        assert_eq!(bend(&apart, 1), None);
    }
}

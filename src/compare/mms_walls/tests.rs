//! Mistakes in a treatment must show in its rows, and solutions must be what they are said to be.

use super::arrangement::{Arrangement, Form};
use super::solution::{Condition, Family};
use super::study::Study;
use super::verdict::Judged;
use super::{QUICK, kept};

/// What is of first order adds little more with a wrong sign until spacings are as fine as these.
const LATE: [(&str, Condition); 2] = [
    ("Adami 2012", Condition::NoSlip),
    ("Hashemi 2012", Condition::Neumann),
];
const FINER: [u32; 3] = [0, 100, 200];

/// Every row passes, and with any mistake that should show one fails.
fn mistakes_show(condition: Condition) {
    for cells in [QUICK, FINER] {
        let arrangement = Arrangement {
            form: Form::Straight,
            is_packed: false,
            cells: 0,
        };
        let is_late = |name| LATE.contains(&(name, condition));
        let here: Vec<_> = kept(condition)
            .filter(|treatment| is_late(treatment.name()) == (cells == FINER))
            .collect();
        if here.is_empty() {
            continue;
        }
        let study = Study::new(arrangement, cells).expect("a lattice");
        let base = study.base(Family::Sheared, condition);
        let own = study.own(&base);
        for treatment in here {
            let judged = Judged {
                study: &study,
                condition,
                treatment,
                own: &own,
                is_quick: true,
            };
            let rows = judged.rows(&study.added(&base, treatment, None));
            assert!(rows.iter().all(|row| row.pass), "{rows:?}");
            for mistake in treatment.mistakes(condition) {
                let name = treatment.name();
                assert!(judged.shows(&base, *mistake), "{mistake:?} of {name}");
            }
        }
    }
}

#[test]
fn mistakes_in_the_pressure_show() {
    mistakes_show(Condition::Neumann);
}

#[test]
fn mistakes_at_slip_walls_show() {
    mistakes_show(Condition::Slip);
}

#[test]
fn mistakes_at_no_slip_walls_show() {
    mistakes_show(Condition::NoSlip);
}

/// The solutions keep the conditions that they are made for, and have the slopes at the wall that ours promise.
#[test]
fn solutions_keep_their_conditions() {
    use super::solution::Solution;
    use aero_geometry::Vector;
    for (family, form) in [Family::Published, Family::Sheared]
        .into_iter()
        .flat_map(|family| [Form::Straight, Form::Convex, Form::Concave].map(|form| (family, form)))
    {
        let angle: f64 = 0.7;
        let (sin, cos) = angle.sin_cos();
        let foot = if form == Form::Straight {
            Vector::<2>::new(0.3, 1.0)
        } else {
            Vector::<2>::repeat(0.5) + form.radius() * Vector::<2>::new(cos, sin)
        };
        let (height, normal) = form.height(&foot);
        assert!(height.abs() < 1e-12);
        let at = |condition| {
            let solution = Solution {
                family,
                condition,
                form,
            };
            let exact = solution.at(&foot);
            let [p, u, v] = exact.gradient.map(|g| g[0] * normal.x + g[1] * normal.y);
            let across = exact.value[1] * normal.x + exact.value[2] * normal.y;
            let speed = exact.value[1].hypot(exact.value[2]);
            let shear = (u * normal.y - v * normal.x).abs();
            (p, across, speed, shear)
        };
        let is_ours = family == Family::Sheared;
        let (slope, ..) = at(Condition::Neumann);
        assert_eq!(slope.abs() > 0.1, is_ours, "{form:?}");
        let (_, across, speed, shear) = at(Condition::Slip);
        assert!(across.abs() < 1e-12 && speed > 0.01);
        assert!(!is_ours || shear > 0.1);
        let (_, across, speed, shear) = at(Condition::NoSlip);
        assert!(across.abs() < 1e-12);
        assert_eq!(speed > 1e-12, is_ours, "{form:?}");
        assert!(!is_ours || shear > 0.1);
    }
}

/// The same bits by one thread and by three.
#[test]
fn threads_change_nothing() {
    let arrangement = Arrangement {
        form: Form::Concave,
        is_packed: true,
        cells: 0,
    };
    let by = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads").install(|| {
            let study = Study::new(arrangement, [0, 0, 40]).expect("a packed ring");
            let base = study.base(Family::Sheared, Condition::NoSlip);
            let added = kept(Condition::NoSlip).map(|treatment| {
                study
                    .added(&base, treatment, None)
                    .finest(Condition::NoSlip)
                    .to_bits()
            });
            added.collect::<Vec<u64>>()
        })
    };
    assert_eq!(by(1), by(3));
}

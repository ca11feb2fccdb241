//! What the coefficients of a body have been of late.

/// More samples than this are thinned out to half.
const MOST: usize = 512;

/// Part of the run, at its end, that is of late.
const PART: usize = 5;

/// Coefficients of a body as a run stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Drag.
    pub cd: f64,
    /// Lift.
    pub cl: f64,
    /// Half their range over the last fifth of the steps, relative to the force.
    pub swing: f64,
}

/// Remembers coefficients, evenly spread over all steps.
#[derive(Clone, Debug)]
pub(super) struct Lately {
    samples: Vec<[f64; 2]>,
    /// Every so many are remembered.
    every: usize,
    seen: usize,
}

impl Default for Lately {
    fn default() -> Self {
        Self {
            samples: Vec::new(),
            every: 1,
            seen: 0,
        }
    }
}

impl Lately {
    /// Adds those of a step.
    pub(super) fn add(&mut self, cd: f64, cl: f64) -> Coefficients {
        if self.seen.is_multiple_of(self.every) {
            self.samples.push([cd, cl]);
        }
        self.seen += 1;
        if self.samples.len() > MOST {
            let mut number = 0;
            self.samples.retain(|_| {
                number += 1;
                number % 2 == 1
            });
            self.every *= 2;
        }
        let from = self.samples.len() - self.samples.len().div_ceil(PART);
        let last = &self.samples[from..];
        let range = |k: usize| {
            let values = || last.iter().map(|sample| sample[k]);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        };
        let size = cd.hypot(cl);
        let swing = if size > 0.0 {
            0.5 * range(0).max(range(1)) / size
        } else {
            0.0
        };
        Coefficients { cd, cl, swing }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_last_fifth_counts_however_many_there_were() {
        for steps in [100, 10_000] {
            let mut lately = Lately::default();
            let mut last = lately.add(5.0, 5.0);
            for step in 1..steps {
                let wave = if step % 3 == 0 { 0.1 } else { -0.1 };
                let cd = if step < steps / 2 { 9.0 } else { 2.0 + wave };
                last = lately.add(cd, 0.0);
            }
            assert!((last.swing - 0.1 / last.cd).abs() < 1e-12, "{last:?}");
        }
    }
}

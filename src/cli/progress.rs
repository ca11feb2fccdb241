//! How far work is, for people: a bar where one watches, a line now and then where none does.

use std::io::IsTerminal;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use aero::run::Progress;
use aero_geometry::Watch;
use indicatif::{ProgressBar, ProgressStyle};

/// Ticks of a full bar.
const TICKS: u64 = 10_000;

/// Time between lines where no person watches.
const BETWEEN_LINES: Duration = Duration::from_secs(15);

/// A stage that begins this soon after the last line has none of its own: short work is silent.
const SHORT: Duration = Duration::from_secs(1);

/// A bar that lives through long stages shows the time as often as this.
const TICK: Duration = Duration::from_millis(250);

/// Shows progress on standard error.
pub enum Display {
    /// A bar.
    Bar(ProgressBar),
    /// Lines.
    Lines(Lines),
}

/// What lines are made from.
pub struct Lines {
    /// When the work began, and how far it was: a resumed run is not at its beginning.
    start: Instant,
    /// Part of the work that was done by then.
    done: Option<f64>,
    /// When the last line was printed.
    last: Instant,
    /// The stage that the work is in.
    stage: String,
}

impl Display {
    /// For a run: a bar with the time left on a terminal, lines elsewhere.
    pub fn of_run() -> Self {
        Self::styled("{wide_bar} {percent:>3}% {msg}, {eta} left")
    }

    /// For work in stages: a bar that begins anew with each on a terminal, lines elsewhere.
    pub fn of_stages() -> Self {
        let display = Self::styled("{wide_bar} {percent:>3}% {msg}, {elapsed} in all");
        if let Self::Bar(bar) = &display {
            bar.enable_steady_tick(TICK);
        }
        display
    }

    fn styled(template: &str) -> Self {
        match ProgressStyle::with_template(template) {
            Ok(style) if std::io::stderr().is_terminal() => {
                Self::Bar(ProgressBar::new(TICKS).with_style(style))
            }
            _ => Self::Lines(Lines {
                start: Instant::now(),
                done: None,
                last: Instant::now(),
                stage: String::new(),
            }),
        }
    }

    /// Shows where a run is.
    pub fn show(&mut self, progress: Progress) {
        if progress.settles {
            self.count(progress);
        } else {
            self.advance(progress);
        }
    }

    /// Shows at which iteration a flow is that settles: how many there will be nobody knows.
    fn count(&mut self, progress: Progress) {
        let text = format!("iteration {}{}", progress.steps, loads(&progress));
        match self {
            Self::Bar(bar) => {
                if bar.message().is_empty()
                    && let Ok(style) =
                        ProgressStyle::with_template("{spinner} {msg}, {elapsed} so far")
                {
                    bar.set_style(style);
                }
                bar.set_message(text);
            }
            Self::Lines(lines) => {
                if lines.last.elapsed() >= BETWEEN_LINES {
                    lines.last = Instant::now();
                    note!("  {text}");
                }
            }
        }
    }

    fn advance(&mut self, progress: Progress) {
        let part = (progress.time / progress.end_time).clamp(0.0, 1.0);
        let text = format!(
            "step {}, t = {:.4e}{}",
            progress.steps,
            progress.time,
            loads(&progress)
        );
        match self {
            Self::Bar(bar) => {
                let first = bar.position() == 0;
                fill(bar, part, text);
                if first {
                    bar.reset_eta();
                }
            }
            Self::Lines(lines) => {
                let done = *lines.done.get_or_insert(part);
                if lines.last.elapsed() < BETWEEN_LINES {
                    return;
                }
                let speed = (part - done) / lines.start.elapsed().as_secs_f64();
                let left = if speed > 0.0 {
                    format!(", about {:.0} s left", (1.0 - part) / speed)
                } else {
                    String::new()
                };
                lines.print(part, &format!("{text}, dt = {:.3e}{left}", progress.dt));
            }
        }
    }

    /// Shows which part of a stage is done.
    pub fn stage(&mut self, stage: &str, part: f64) {
        match self {
            Self::Bar(bar) => fill(bar, part, stage.to_owned()),
            Self::Lines(lines) => {
                let wait = if lines.stage == stage {
                    BETWEEN_LINES
                } else {
                    SHORT
                };
                stage.clone_into(&mut lines.stage);
                if lines.last.elapsed() >= wait {
                    lines.print(part, stage);
                }
            }
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

impl Lines {
    fn print(&mut self, part: f64, text: &str) {
        self.last = Instant::now();
        note!("{:5.1} %  {text}", 100.0 * part);
    }
}

/// How hard the first body is pressed, and how much that changes still.
fn loads(progress: &Progress) -> String {
    progress.coefficients.map_or(String::new(), |now| {
        let swing = 100.0 * now.swing;
        format!(", cd {:.4}, cl {:.4} +- {swing:.1} %", now.cd, now.cl)
    })
}

fn fill(bar: &ProgressBar, part: f64, text: String) {
    bar.set_position((part * TICKS as f64) as u64);
    bar.set_message(text);
}

/// Does `work` in stages and shows how far it is.
pub fn watched<T>(work: impl FnOnce(Watch) -> T) -> T {
    let display = Arc::new(Mutex::new(Display::of_stages()));
    let shown = Arc::clone(&display);
    let lock = |display: &Mutex<Display>, act: &dyn Fn(&mut Display)| {
        act(&mut display.lock().unwrap_or_else(PoisonError::into_inner));
    };
    let result = work(Watch::new(move |stage, part| {
        lock(&shown, &|display| display.stage(stage, part));
    }));
    lock(&display, &|display| display.finish());
    result
}

#[cfg(test)]
mod tests {
    use aero::run::Latest;

    use super::*;

    #[test]
    fn progress_shows_how_hard_the_first_body_is_pressed_where_there_is_one() {
        let latest = Latest {
            cd: 0.188_41,
            cl: -0.4507,
            swing: 0.0123,
        };
        let progress = |coefficients| Progress {
            steps: 1,
            time: 0.0,
            end_time: 1.0,
            dt: 0.1,
            settles: false,
            coefficients,
        };
        assert_eq!(
            loads(&progress(Some(latest))),
            ", cd 0.1884, cl -0.4507 +- 1.2 %"
        );
        assert_eq!(loads(&progress(None)), "");
    }
}

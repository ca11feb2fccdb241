//! How far a run is, for people: a bar where one watches, a line now and then where none does.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use aero::run::Progress;
use indicatif::{ProgressBar, ProgressStyle};

/// Ticks of a full bar.
const TICKS: u64 = 10_000;

/// Time between lines where no person watches.
const BETWEEN_LINES: Duration = Duration::from_secs(15);

/// Shows progress on standard error.
pub enum Display {
    /// A bar with the time left.
    Bar(ProgressBar),
    /// Lines; with the time of start and that of the last line.
    Lines {
        /// When the run began, and how far it was: a resumed run is not at its beginning.
        start: Instant,
        /// Part of the run that was done by then.
        done: Option<f64>,
        /// When the last line was printed.
        last: Instant,
    },
}

impl Display {
    /// A bar on a terminal, lines elsewhere.
    pub fn new() -> Self {
        let now = Instant::now();
        let template = "{wide_bar} {percent:>3}% {msg}, {eta} left";
        match ProgressStyle::with_template(template) {
            Ok(style) if std::io::stderr().is_terminal() => {
                Self::Bar(ProgressBar::new(TICKS).with_style(style))
            }
            _ => Self::Lines {
                start: now,
                done: None,
                last: now,
            },
        }
    }

    /// Shows where the run is.
    pub fn show(&mut self, progress: Progress) {
        let part = (progress.time / progress.end_time).clamp(0.0, 1.0);
        let text = format!("step {}, t = {:.4e}", progress.steps, progress.time);
        match self {
            Self::Bar(bar) => {
                let first = bar.position() == 0;
                bar.set_position((part * TICKS as f64) as u64);
                if first {
                    bar.reset_eta();
                }
                bar.set_message(text);
            }
            Self::Lines { start, done, last } => {
                let done = *done.get_or_insert(part);
                if last.elapsed() < BETWEEN_LINES {
                    return;
                }
                *last = Instant::now();
                let speed = (part - done) / start.elapsed().as_secs_f64();
                let left = if speed > 0.0 {
                    format!(", about {:.0} s left", (1.0 - part) / speed)
                } else {
                    String::new()
                };
                eprintln!(
                    "{:5.1} %  {text}, dt = {:.3e}{left}",
                    100.0 * part,
                    progress.dt
                );
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

//! `aero sweep`: a polar, a run for each Mach number and angle.

mod flown;
mod images;
mod polar;
mod values;

use std::path::{Path, PathBuf};

use aero::output::Summary;
use aero::run::{Destination, RunError, Stopwatch};
use aero::scene::Scene;
use clap::Args;
use serde_json::Value;

use super::body::BodyArgs;
use super::interrupt::Interrupt;
use super::neighbour::{Neighbour, started};
use super::scene::{SceneArgs, checked, folder, run_watched, tell};
use super::{CommandError, on_threads};
use polar::{Point, Row};
use values::{Values, angles, machs};

/// What `aero sweep` takes.
#[derive(Args, Debug)]
pub struct SweepArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(
        flatten,
        next_help_heading = "Of a body in place of a scene: STL, OBJ or PLY"
    )]
    how: BodyArgs,
    /// Mach numbers: 1.5,2,3 or 1.5..3:0.5
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, value_parser = machs)]
    mach: Option<Values>,
    /// Angles of attack in degrees: -4..8:2
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, value_parser = angles)]
    incidence: Option<Values>,
    /// Angles of sideslip in degrees
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, value_parser = angles)]
    sideslip: Option<Values>,
    /// Folder for the results, in which points that are done are kept; `out/NAME-sweep` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What is swept, in the order of a [`Point`], and how far apart two values of it are worth one.
const AXES: [(&str, f64); 3] = [("mach", 1.0), ("incidence", 5.0), ("sideslip", 5.0)];

/// Distance beyond which a point starts in the free stream: its neighbour's flow and points would be no help.
const FAR: f64 = 0.5;

/// What a folder's results belong to.
const SETTINGS: &str = "point.toml";

/// Runs all points that are not done yet.
pub fn sweep(args: &SweepArgs) -> Result<(), CommandError> {
    let lists = [&args.mach, &args.incidence, &args.sideslip];
    if lists.iter().all(|list| list.is_none()) {
        return Err(CommandError::wrong(
            "nothing to sweep; give --mach, --incidence or --sideslip, as in --incidence -4..8:2",
        ));
    }
    let interrupt = Interrupt::listen()?;
    let points = points(&lists);
    let (scene, flight) = flown::scene(args, points.len())?;
    let out = folder(args.out.as_ref(), &format!("{}-sweep", scene.name()));
    let stated = scene.stream();
    // All scenes are read before the first runs: a typing error shows at once, and so does a stream that a side does not go with.
    let scenes = points
        .iter()
        .map(|point| at(&scene, point))
        .collect::<Result<Vec<_>, CommandError>>()?;
    on_threads(args.scene.threads, || {
        let images = if images::may_be(&points) && has_mirror(&scenes[0])? {
            images::of(&points)
        } else {
            vec![None; points.len()]
        };
        let mut done: Vec<(Point, Neighbour)> = Vec::new();
        let mut rows: Vec<(usize, Row)> = Vec::new();
        for (number, (point, scene)) in points.iter().zip(scenes).enumerate() {
            if images[number].is_some() {
                continue;
            }
            let folder = out.join(name(point));
            let summary = if let Some(summary) = earlier(&folder, &scene)? {
                summary
            } else {
                note!("point {} of {}: {}", number + 1, points.len(), name(point));
                let start = start(point, &done);
                if start.is_none() && !done.is_empty() {
                    note!(
                        "it starts in the free stream: points that are done are too far off to help"
                    );
                }
                fly(&scene, &folder, start, &interrupt)?
            };
            let known = std::array::from_fn(|k| point[k].or(stated[k]));
            for mut row in polar::rows(known, &summary) {
                if let Some(flight) = &flight {
                    row.part(flight, &folder)?;
                }
                let other = images.iter().position(|of| *of == Some(number));
                rows.extend(other.map(|other| (other, row.mirrored(&name(point)))));
                rows.push((number, row));
            }
            rows.sort_by_key(|(number, _)| *number);
            polar::write(&in_order(&rows), &out)?;
            done.push((*point, Neighbour { scene, folder }));
        }
        let rows = in_order(&rows);
        say_all!("{}", polar::text(&rows));
        let mirrored = images.iter().flatten().count();
        if mirrored > 0 {
            say!(
                "not run, as mirror images of others: {mirrored} of {} points; bodies and sides are their own",
                images.len()
            );
        }
        say!("polar in `{}`", out.display());
        let open = rows.iter().filter(|row| !row.settled).count();
        if open > 0 {
            say!(
                "{open} of {} rows are not settled: they end at the scene's `end_time`; give it more, or `stop = \"steady\"`",
                rows.len()
            );
        }
        Ok(())
    })
}

/// The rows without their numbers.
fn in_order(rows: &[(usize, Row)]) -> Vec<Row> {
    rows.iter().map(|(_, row)| row.clone()).collect()
}

/// True of a scene that is its own mirror image across its lift.
fn has_mirror(scene: &Scene) -> Result<bool, CommandError> {
    const ACROSS_LIFT: usize = 1;
    Ok(scene.starts_in_the_free_stream() && checked(scene)?.has_mirror(ACROSS_LIFT))
}

/// All points; along the last list first, there and back, so that each is next to the one before.
fn points(lists: &[&Option<Values>; 3]) -> Vec<Point> {
    let mut points: Vec<Point> = vec![[None; 3]];
    for (axis, list) in lists.iter().enumerate() {
        let Some(Values(values)) = list else {
            continue;
        };
        let mut grown = Vec::new();
        for (number, point) in points.iter().enumerate() {
            let one = |value: &f64| {
                let mut point = *point;
                point[axis] = Some(*value);
                point
            };
            if number % 2 == 0 {
                grown.extend(values.iter().map(one));
            } else {
                grown.extend(values.iter().rev().map(one));
            }
        }
        points = grown;
    }
    points
}

/// The scene of a point.
fn at(scene: &Scene, point: &Point) -> Result<Scene, CommandError> {
    let mut scene = scene.clone();
    for ((key, _), value) in AXES.iter().zip(point) {
        if let Some(value) = value {
            let setting = format!("free_stream.{key}={value:?}");
            scene.set(&setting).map_err(CommandError::wrong)?;
        }
    }
    scene
        .check_stream()
        .map_err(|error| CommandError::wrong(format!("point {}: {error}", name(point))))?;
    Ok(scene)
}

/// A folder's name for a point.
fn name(point: &Point) -> String {
    let words = AXES.iter().zip(point);
    let words = words.filter_map(|((key, _), value)| value.map(|value| format!("{key}-{value}")));
    words.collect::<Vec<_>>().join("-")
}

/// Summary of a point that was done before; none of one that was not.
fn earlier(folder: &Path, scene: &Scene) -> Result<Option<Value>, CommandError> {
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).ok();
    let (Some(summary), Some(settings)) = (read("summary.json"), read(SETTINGS)) else {
        return Ok(None);
    };
    if settings != scene.lines() {
        return Err(CommandError::wrong(format!(
            "`{}` holds a run of another scene; give `--out` another folder, or remove it",
            folder.display()
        )));
    }
    let summary = serde_json::from_str(&summary);
    summary.map(Some).map_err(CommandError::failed)
}

/// How far apart two points are.
fn distance(a: &Point, b: &Point) -> f64 {
    let apart = AXES.iter().zip(a.iter().zip(b));
    apart
        .map(|((_, unit), (a, b))| a.zip(*b).map_or(0.0, |(a, b)| ((a - b) / unit).abs()))
        .sum()
}

/// Where a point starts from.
#[derive(Clone, Copy, Debug)]
struct Start<'a> {
    /// The nearest point that is done.
    nearest: &'a Neighbour,
    /// One from which the nearest is on the way to the point, and how much further that is, in parts of the way between them.
    trend: Option<(&'a Neighbour, f64)>,
}

/// Where `point` starts from, of what is done; none where all is too far.
fn start<'a>(point: &Point, done: &'a [(Point, Neighbour)]) -> Option<Start<'a>> {
    let closest = |to: &Point, others: &mut dyn Iterator<Item = &'a (Point, Neighbour)>| {
        others.min_by(|(a, _), (b, _)| distance(a, to).total_cmp(&distance(b, to)))
    };
    let (near, nearest) = closest(point, &mut done.iter())?;
    if distance(near, point) > FAR {
        return None;
    }
    let mut behind = done
        .iter()
        .filter(|(other, _)| further(other, near, point).is_some());
    let trend = closest(near, &mut behind);
    let trend = trend.and_then(|(other, it)| further(other, near, point).map(|part| (it, part)));
    Some(Start { nearest, trend })
}

/// How much further `point` is than `near` on the way from `other`, in parts of that; none where it is not, or by more than that.
fn further(other: &Point, near: &Point, point: &Point) -> Option<f64> {
    const ROUND_OFF: f64 = 1e-9;
    let mut part = None;
    for axis in 0..AXES.len() {
        let (Some(a), Some(b), Some(c)) = (other[axis], near[axis], point[axis]) else {
            continue;
        };
        if a == b && b == c {
            continue;
        }
        let way = (c - b) / (b - a);
        let fits = way > 0.0 && way <= 1.0 + ROUND_OFF;
        if !fits || part.is_some() {
            return None;
        }
        part = Some(way);
    }
    part
}

/// Runs one point.
fn fly(
    scene: &Scene,
    folder: &Path,
    start: Option<Start<'_>>,
    interrupt: &Interrupt,
) -> Result<Value, CommandError> {
    let nearest = start.map(|start| start.nearest);
    let started = started(scene, nearest, start.and_then(|start| start.trend))?;
    let is_started = started.lines() != scene.lines();
    let (mut summary, mut came_to_its_end) = run(&started, folder, is_started, interrupt)?;
    if !came_to_its_end && !interrupt.came() && is_started {
        note!("it is run again from the free stream");
        (summary, came_to_its_end) = run(scene, folder, false, interrupt)?;
    }
    if came_to_its_end {
        std::fs::write(folder.join(SETTINGS), scene.lines()).map_err(CommandError::failed)?;
    }
    serde_json::to_value(&summary).map_err(CommandError::failed)
}

/// Runs a scene, without the frame of its start where a neighbour's last is that; tells whether it came to its end.
fn run(
    scene: &Scene,
    folder: &Path,
    skips_start: bool,
    interrupt: &Interrupt,
) -> Result<(Summary, bool), CommandError> {
    let stopwatch = Stopwatch::start();
    let case = checked(scene)?;
    tell(&case);
    let lines = scene.lines();
    let destination = Destination {
        folder,
        scene: &lines,
        noted: &scene.lines_from_anywhere(),
        resume: false,
        skips_start,
        overwrite: true,
    };
    match run_watched(case, destination, stopwatch, interrupt, &[], &mut |_| false) {
        Ok(summary) => Ok((summary, true)),
        Err(RunError::Stopped { .. }) if interrupt.came() => Err(CommandError::failed(
            "interrupted; the same command goes on with the points that are left",
        )),
        Err(RunError::Stopped { reason, summary }) => {
            note!("the run in `{}` stopped: {reason}", folder.display());
            Ok((*summary, false))
        }
        Err(RunError::Output(error)) => Err(CommandError::failed(error)),
        Err(error @ (RunError::SetUp(_) | RunError::Resume(_) | RunError::Occupied(_))) => {
            Err(CommandError::wrong(error))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_point_is_next_to_the_one_before() {
        let list = |text: &str| Some(text.parse::<Values>().unwrap());
        let (mach, incidence) = (list("2,3"), list("0..4:2"));
        let points = points(&[&mach, &incidence, &None]);
        let names: Vec<String> = points.iter().map(name).collect();
        assert_eq!(names[2], "mach-2-incidence-4");
        assert_eq!(names[3], "mach-3-incidence-4");
        assert_eq!(points.len(), 6);
    }

    /// Only forward, on one axis at a time, and by no more than the way that is known.
    #[test]
    fn a_trend_leads_from_one_point_past_the_next() {
        let at = |mach: f64, incidence: f64| [Some(mach), Some(incidence), None];
        let from = |other: [f64; 2], near: [f64; 2], point: [f64; 2]| {
            let [other, near, point] = [other, near, point].map(|[m, i]| at(m, i));
            further(&other, &near, &point)
        };
        assert_eq!(from([2.0, 0.0], [2.0, 2.0], [2.0, 4.0]), Some(1.0));
        assert_eq!(from([2.0, 4.0], [2.0, 2.0], [2.0, 1.0]), Some(0.5));
        assert_eq!(from([2.0, 4.0], [2.0, 2.0], [2.0, 3.0]), None);
        assert_eq!(from([2.0, 0.0], [2.0, 2.0], [2.0, 5.0]), None);
        assert_eq!(from([2.0, 0.0], [2.0, 2.0], [2.5, 2.0]), None);
        assert_eq!(from([1.5, 0.0], [2.0, 2.0], [2.5, 4.0]), None);
    }
}

//! A run that starts where one like it has settled: another spacing of the same scene, or another stream.

use std::path::PathBuf;

use aero::fly::last_file;
use aero::scene::Scene;

use super::CommandError;

/// A run that is done.
#[derive(Clone, Debug)]
pub struct Neighbour {
    /// What was run, the start aside.
    pub scene: Scene,
    /// Where its files are.
    pub folder: PathBuf,
}

/// `scene` from where `neighbour` came to, if it is to become steady and says nothing of its start itself: with its points and its
/// flow, turned and sped up with the stream; beyond it by a part of the way to there from another one, where that is known.
pub fn started(
    scene: &Scene,
    neighbour: Option<&Neighbour>,
    trend: Option<(&Neighbour, f64)>,
) -> Result<Scene, CommandError> {
    let mut scene = scene.clone();
    let may = scene.file().stop.is_some() && scene.starts_in_the_free_stream();
    let Some(neighbour) = neighbour.filter(|_| may) else {
        return Ok(scene);
    };
    let Some(frame) = last_frame(neighbour)? else {
        return Ok(scene);
    };
    let mut settings = vec![format!("initial.frame={frame:?}")];
    settings.extend(stream("initial.stream", &scene, neighbour));
    if let Some((before, part)) = trend
        && let Some(frame) = last_frame(before)?
    {
        settings.push(format!(
            "initial.trend={{ frame = {frame:?}, part = {part:?} }}"
        ));
        settings.extend(stream("initial.trend.stream", &scene, before));
    }
    for setting in settings {
        scene.set(&setting).map_err(CommandError::wrong)?;
    }
    Ok(scene)
}

/// The last frame of a run, from wherever it is looked for.
fn last_frame(neighbour: &Neighbour) -> Result<Option<String>, CommandError> {
    let frame = last_file(&neighbour.folder, "frame-").map(std::path::absolute);
    let frame = frame.transpose().map_err(CommandError::failed)?;
    Ok(frame.map(|frame| frame.display().to_string()))
}

/// What a scene says of the free stream of another; nothing where it is its own.
fn stream(key: &str, now: &Scene, neighbour: &Neighbour) -> Vec<String> {
    let lines = |scene: &Scene| -> Vec<String> {
        let lines = scene.lines();
        let lines = lines.lines();
        let stream = lines.filter_map(|line| line.strip_prefix("free_stream."));
        stream.map(|line| format!("{key}.{line}")).collect()
    };
    let before = lines(&neighbour.scene);
    if before == lines(now) {
        Vec::new()
    } else {
        before
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const SCENE: &str = r#"
dimension = 1
spacing = 0.1
stop = "steady"

[scheme]
motion = "fixed"

[free_stream]
mach = 2.0
density = 1.4
pressure = 1.0

[domain]
min = [0.0]
max = [1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
"#;

    fn scene(mach: f64) -> Scene {
        let mut scene = Scene::parse(SCENE, "a", Path::new(".")).expect("a scene");
        let setting = format!("free_stream.mach={mach:?}");
        scene.set(&setting).expect("a Mach number");
        scene
    }

    /// One that has left its last frame in a folder of its own.
    fn done(place: &Path, mach: f64) -> Neighbour {
        let folder = place.join(format!("{mach}"));
        std::fs::create_dir(&folder).expect("a folder");
        std::fs::write(folder.join("frame-000001.vtp"), "").expect("a frame");
        Neighbour {
            scene: scene(mach),
            folder,
        }
    }

    #[test]
    fn a_run_starts_beyond_its_neighbour_on_the_way_from_the_one_before() {
        let place = tempfile::tempdir().expect("a folder");
        let [before, near] = [2.0, 2.5].map(|mach| done(place.path(), mach));
        let started = started(&scene(2.75), Some(&near), Some((&before, 0.5))).expect("a start");
        let initial = &started.file().initial;
        let trend = initial.trend.as_ref().expect("a trend");
        let folder = |frame: &Path| frame.parent().map(Path::to_owned);
        let from = initial.frame.as_deref().and_then(folder);
        assert_eq!(from, Some(near.folder));
        assert_eq!(folder(&trend.frame), Some(before.folder));
        assert_eq!(trend.part.get(), 0.5);
        for line in [
            "initial.stream.mach = 2.5",
            "initial.trend.stream.mach = 2.0",
        ] {
            let lines = started.lines();
            assert!(lines.lines().any(|it| it == line), "`{line}` in {lines}");
        }
    }

    #[test]
    fn a_run_whose_neighbour_has_left_no_frame_starts_in_the_free_stream() {
        let place = tempfile::tempdir().expect("a folder");
        let near = done(place.path(), 2.5);
        std::fs::remove_file(near.folder.join("frame-000001.vtp")).expect("a frame");
        let scene = scene(2.75);
        let started = started(&scene, Some(&near), None).expect("a start");
        assert_eq!(started.lines(), scene.lines());
    }
}

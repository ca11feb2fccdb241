//! `aero pack`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use aero::pack::{PackFile, Packed, pack_mesh, pack_scene};
use aero::scene::number::Positive;
use aero::scene::shapes::Unit;
use aero::scene::{PackWishes, Scene};
use aero_geometry::Watch;
use clap::{Args, ValueEnum};

use super::CommandError;
use super::progress::watched;

/// What `aero pack` takes.
#[derive(Args, Debug)]
pub struct PackArgs {
    /// STL file, or scene file (TOML) whose bodies are packed
    #[arg(value_name = "BODY|SCENE")]
    input: PathBuf,
    /// Spacing of the ghosts, in metres or in the scene's unit; picked unless given
    #[arg(long, value_name = "DX", value_parser = positive)]
    spacing: Option<f64>,
    /// Number of ghost layers; as many as cover the kernel unless given, five at the flow's spacing
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=50))]
    layers: Option<u16>,
    /// Number of conforming fluid layers to pack around the body as well
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(..=50))]
    fluid_layers: u16,
    /// Pack all the same where more than two per cent of the surface would have no ghosts
    #[arg(long)]
    allow_loss: bool,
    /// Unit of length of the STL file [default: m]
    #[arg(long)]
    unit: Option<UnitWord>,
    /// Folder for the results; `out/NAME` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The report and the files that were written.
type Made = (PackFile, Vec<PathBuf>);

/// A unit of length.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum UnitWord {
    /// Metres
    M,
    /// Millimetres
    Mm,
    /// Inches
    In,
}

impl From<UnitWord> for Unit {
    fn from(word: UnitWord) -> Self {
        match word {
            UnitWord::M => Self::M,
            UnitWord::Mm => Self::Mm,
            UnitWord::In => Self::In,
        }
    }
}

/// Packs the body or the bodies and says how good the packing is.
pub fn pack(args: &PackArgs) -> Result<(), CommandError> {
    let (report, files) = watched(|watch| make(args, watch))?;
    print!("{}", lines(&report, &files));
    Ok(())
}

/// Packs and writes the files; gives their names and the report.
fn make(args: &PackArgs, watch: Watch) -> Result<Made, CommandError> {
    let wishes = PackWishes {
        spacing: args.spacing,
        layers: args.layers.map(usize::from),
        fluid_layers: args.fluid_layers.into(),
        allow_loss: args.allow_loss,
        watch,
    };
    let path = &args.input;
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("stl") => {
            let packed = pack_mesh(path, args.unit.map(Unit::from), &wishes);
            write(&packed.map_err(CommandError::wrong)?, args, &wishes.watch)
        }
        Some("toml") => {
            if args.unit.is_some() {
                return Err(CommandError::wrong(
                    "`--unit` goes with an STL file; a scene says `unit` in the body's shape",
                ));
            }
            let scene = Scene::load(path).map_err(CommandError::wrong)?;
            match scene.dimension() {
                2 => scene_bodies::<2>(&scene, args, &wishes),
                3 => scene_bodies::<3>(&scene, args, &wishes),
                _ => Err(CommandError::wrong(format!(
                    "`{}` has dimension 1 and so no bodies to pack",
                    path.display()
                ))),
            }
        }
        _ => Err(CommandError::wrong(format!(
            "`{}` is neither an STL file (.stl) nor a scene (.toml)",
            path.display()
        ))),
    }
}

fn scene_bodies<const D: usize>(
    scene: &Scene,
    args: &PackArgs,
    wishes: &PackWishes,
) -> Result<Made, CommandError> {
    let packed = pack_scene::<D>(scene, wishes).map_err(CommandError::wrong)?;
    write(&packed, args, &wishes.watch)
}

fn write<const D: usize>(
    packed: &Packed<D>,
    args: &PackArgs,
    watch: &Watch,
) -> Result<Made, CommandError> {
    watch.begin("writing");
    let folder = match &args.out {
        Some(folder) => folder.clone(),
        None => Path::new("out").join(&packed.name),
    };
    let files = packed.write(&folder).map_err(CommandError::wrong)?;
    Ok((packed.report(), files))
}

/// The report for people.
fn lines(file: &PackFile, files: &[PathBuf]) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    for body in &file.bodies {
        let report = &body.report;
        let layers: Vec<String> = report
            .layer_counts
            .iter()
            .map(ToString::to_string)
            .collect();
        let _ = writeln!(
            text,
            "{}: spacing {} ({})\n  {} ghosts in layers of {}",
            body.name,
            report.spacing,
            file.spacing_reason,
            report.ghosts,
            layers.join(", ")
        );
        if report.fluid > 0 {
            let _ = writeln!(text, "  {} conforming fluid particles", report.fluid);
        }
        let _ = writeln!(
            text,
            "  density {:.2} % std, {:.2} % at most; shell volume {:+.3} %, whole volume {:+.3} %\n  wall layer off by {:.1e} dx, smallest gap {:.2} dx\n  {:.2} % of the surface without ghosts, largest hole {:.2} dx",
            report.density_std_percent,
            report.density_max_percent,
            report.shell_volume_error_percent,
            report.volume_error_percent,
            report.wall_offset_max,
            report.min_gap,
            report.uncovered_area_percent,
            report.hole_max
        );
        if report.thin > 0 {
            let _ = writeln!(
                text,
                "  {} ghosts in parts too thin for the layers of both sides",
                report.thin
            );
        }
        if let Some(error) = report.mirror_error_max {
            let _ = writeln!(text, "  mirror error {error:.1e} dx");
        }
        if let Some(error) = report.normal_error_max_deg {
            let _ = writeln!(text, "  normals off by {error:.2} degrees at most");
        }
        for line in &report.repairs {
            let _ = writeln!(text, "  repaired: {line}");
        }
        for line in &report.warnings {
            let _ = writeln!(text, "  warning: {line}");
        }
    }
    for path in files {
        let _ = writeln!(text, "wrote `{}`", path.display());
    }
    text
}

fn positive(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    Positive::try_from(value).map(Positive::get)
}

//! `aero pack`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use aero::output::write_packing;
use aero::pack::{AnyPacked, PackFile, pack_mesh, pack_scene};
use aero::scene::shapes::StlEntry;
use aero::scene::{PackWishes, Scene};
use aero_geometry::Watch;
use clap::Args;

use super::CommandError;
use super::mesh::MeshArgs;
use super::numbers::positive;
use super::progress::watched;

/// What `aero pack` takes.
#[derive(Args, Debug)]
pub struct PackArgs {
    /// STL, OBJ or PLY file, packed as .gz or not, or scene file (TOML) whose bodies are packed
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
    #[command(flatten)]
    mesh: MeshArgs,
    /// Lay a closed surface around whatever the file holds, as fine as the spacing
    #[arg(long, conflicts_with_all = ["fill", "thicken"])]
    wrap: bool,
    /// Folder for the results; `out/NAME` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The report and the files that were written.
type ReportAndFiles = (PackFile, Vec<PathBuf>);

/// Packs the body or the bodies and says how good the packing is.
pub fn pack(args: &PackArgs) -> Result<(), CommandError> {
    let (report, files) = watched(|watch| make(args, watch))?;
    say_all!("{}", lines(&report, &files));
    Ok(())
}

/// Packs and writes the files; gives their names and the report.
fn make(args: &PackArgs, watch: Watch) -> Result<ReportAndFiles, CommandError> {
    let wishes = PackWishes {
        spacing: args.spacing,
        layers: args.layers.map(usize::from),
        fluid_layers: args.fluid_layers.into(),
        allow_loss: args.allow_loss,
        watch,
    };
    let path = &args.input;
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ending != "toml" {
        let packed = pack_mesh(&body(args), &wishes);
        return write(&packed.map_err(CommandError::wrong)?, args, &wishes.watch);
    }
    let wrap = args.wrap.then_some("wrap");
    if let Some(flag) = args.mesh.given().or(wrap) {
        return Err(CommandError::wrong(format!(
            "`--{flag}` goes with a body's file, as an STL; a scene says `{flag}` in the body's shape"
        )));
    }
    let scene = Scene::load(path).map_err(CommandError::wrong)?;
    let packed = pack_scene(&scene, &wishes);
    write(&packed.map_err(CommandError::wrong)?, args, &wishes.watch)
}

/// The body's file as a scene would have it.
fn body(args: &PackArgs) -> StlEntry {
    StlEntry {
        wrap: Some(args.wrap),
        ..args.mesh.entry(&args.input)
    }
}

fn write(
    packed: &AnyPacked,
    args: &PackArgs,
    watch: &Watch,
) -> Result<ReportAndFiles, CommandError> {
    watch.begin("writing");
    let folder = match &args.out {
        Some(folder) => folder.clone(),
        None => Path::new("out").join(packed.name()),
    };
    let files = write_packing(packed, &folder).map_err(CommandError::wrong)?;
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
                "  {}{} ghosts in parts too thin for the layers of both sides",
                if report.thin == report.ghosts {
                    "all "
                } else {
                    ""
                },
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

//! The pictures of a flight, as parts of a page.

use aero_geometry::Shape;
use aero_solver::problem::AXES;

use super::body_view::{Eye, Skin, draw};
use super::error::FlyError;
use super::figure::Figure;
use super::flight::{Extent, Flight};
use super::level::Level;
use super::read::{self, Points};
use super::section::{Plane, range};
use super::skins;

/// Columns of pixels of a plane, and pixels, at most: a wing's span is many times what is shown of its chord.
const COLUMNS: usize = 760;
const PIXELS: f64 = 2.5e5;

/// Looks at a body: what it is called, degrees about the vertical and upwards, axes' names.
const EYES: [(&str, f64, f64, [&str; 2]); 2] = [
    ("from the side", 0.0, 0.0, ["x, m", "y, m"]),
    ("from ahead and above", -52.0, 24.0, ["", ""]),
];

/// From straight ahead.
fn ahead() -> Eye {
    Eye {
        right: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
    }
}

/// How the body lies: from the side with the stream, and from ahead.
pub(super) fn attitude(flight: &Flight) -> Vec<String> {
    let skin = skins::bare(flight);
    let angle = flight.wishes.incidence.to_radians();
    let side = draw(&skin, &Eye::turned(0.0, 0.0), [0.0, 1.0]);
    let front = draw(&skin, &ahead(), [0.0, 1.0]);
    vec![
        Figure {
            picture: &side.picture,
            window: side.window,
            axes: ["x, m", "y, m"],
            bar: None,
            stream: Some([angle.cos(), angle.sin()]),
            caption: "The body as it lies, from the side; the arrow is the stream",
        }
        .html(),
        Figure {
            picture: &front.picture,
            window: front.window,
            axes: ["-z, m", "y, m"],
            bar: None,
            stream: None,
            caption: "From ahead, as the stream sees it",
        }
        .html(),
    ]
}

/// Pressure on the body.
pub(super) fn pressure(flight: &Flight, level: &Level) -> Result<Vec<String>, FlyError> {
    let Some(path) = read::last(&level.folder, "surface-") else {
        return Ok(Vec::new());
    };
    let skin = skins::by_array(flight, &read::surface(&path)?, "pressure_coefficient");
    Ok(looks(&skin, range(&skin.values), "pressure coefficient"))
}

/// How finely the body's thickness is resolved.
pub(super) fn thickness(skin: &Skin) -> Vec<String> {
    looks(skin, [0.0, skins::ENOUGH], "finest cells across the body")
}

fn looks(skin: &Skin, range: [f64; 2], label: &str) -> Vec<String> {
    let each = EYES.into_iter().map(|(name, about, raised, axes)| {
        let view = draw(skin, &Eye::turned(about, raised), range);
        let mut caption = label.to_owned();
        caption[..1].make_ascii_uppercase();
        Figure {
            picture: &view.picture,
            window: view.window,
            axes,
            bar: Some((label, range)),
            stream: None,
            caption: &format!("{caption}, {name}"),
        }
        .html()
    });
    each.collect()
}

/// Mach number and schlieren in the planes of the flow.
pub(super) fn planes(flight: &Flight, level: &Level) -> Result<Vec<String>, FlyError> {
    let Some(path) = read::last(&level.folder, "frame-") else {
        return Ok(Vec::new());
    };
    let gas = read::gas(&path)?;
    let is_plane = flight.dimension() == 2;
    let region = flight.shown();
    let both = |axis: usize| {
        let most = region.max[axis].max(-region.min[axis]);
        [-most, most]
    };
    let mut found = Vec::new();
    let axes: &[[usize; 2]] = if is_plane {
        &[[0, 1]]
    } else {
        &[[0, 1], [0, 2]]
    };
    for &axes in axes {
        let mut mirrored = [false; 3];
        for axis in flight.mirrors() {
            mirrored[*axis] = true;
        }
        let mut up = [region.min[axes[1]], region.max[axes[1]]];
        if is_plane || mirrored[axes[1]] {
            mirrored[axes[1]] = true;
            up = both(axes[1]);
        }
        let plane = Plane {
            axes,
            at: 0.0,
            window: [[region.min[0], region.max[0]], up],
            mirrored,
            columns: columns([region.max[0] - region.min[0], up[1] - up[0]]),
        };
        found.extend(plane_figures(flight, &gas, &plane));
    }
    Ok(found)
}

/// Columns of pixels of a window so wide and high.
fn columns([wide, high]: [f64; 2]) -> usize {
    COLUMNS.min((PIXELS * wide / high).sqrt() as usize)
}

fn plane_figures(flight: &Flight, gas: &Points, plane: &Plane) -> Vec<String> {
    let is_plane = matches!(flight.extent, Extent::Meridian(_));
    let shape: &dyn Shape<3> = flight.shape.as_ref();
    let [across, up] = plane.axes.map(|k| AXES[k]);
    let labels = [format!("{across}, m"), format!("{up}, m")];
    let axes = [labels[0].as_str(), labels[1].as_str()];
    let angles = [0.0, flight.wishes.incidence, flight.wishes.sideslip].map(f64::to_radians);
    let stream = Some([1.0, angles[plane.axes[1]].tan()]);
    let field = plane.field(gas, ["mach", "density"], is_plane, Some(shape));
    let range = field.range();
    vec![
        Figure {
            picture: &field.coloured(range),
            window: plane.window,
            axes,
            bar: Some(("Mach number", range)),
            stream,
            caption: &format!("Mach number in the plane {across}-{up} through the middle"),
        }
        .html(),
        Figure {
            picture: &field.schlieren(),
            window: plane.window,
            axes,
            bar: None,
            stream: None,
            caption: &format!(
                "Schlieren, the size of the density's gradient, in the plane {across}-{up}"
            ),
        }
        .html(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_of_any_shape_take_so_many_pixels_at_most() {
        assert_eq!(columns([4.0, 1.0]), COLUMNS);
        for high in [2.0, 5.0, 40.0] {
            let wide = columns([1.0, high]) as f64;
            assert!(wide * wide * high <= PIXELS && wide > 50.0, "{wide}");
        }
    }
}

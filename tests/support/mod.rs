//! What the command-line tests share: the program, a folder of its own for each test, small scenes.

pub mod forces;
pub mod turned;

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

/// A folder that goes with the test.
pub struct Workplace {
    folder: TempDir,
}

/// What a command said and how it ended.
pub struct Answer {
    pub status: i32,
    pub out: String,
    pub err: String,
}

impl Workplace {
    pub fn new() -> Self {
        Self {
            folder: tempfile::tempdir().expect("a temporary folder"),
        }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        std::fs::write(&path, content).expect("a file in the temporary folder");
        path
    }

    /// Runs `aero` in the folder.
    pub fn aero<S: AsRef<std::ffi::OsStr>>(&self, arguments: &[S]) -> Answer {
        let output = Command::cargo_bin("aero")
            .expect("the program")
            .current_dir(self.folder.path())
            .args(arguments)
            .output()
            .expect("the program runs");
        Answer {
            status: output.status.code().expect("no signal"),
            out: String::from_utf8(output.stdout).expect("text"),
            err: String::from_utf8(output.stderr).expect("text"),
        }
    }

    /// Runs a scene given as text, over what an earlier one has left.
    pub fn run(&self, scene: &str, more: &[&str]) -> Answer {
        self.write("scene.toml", scene);
        let arguments = [
            &["run", "scene.toml", "--out", "results", "--overwrite"],
            more,
        ]
        .concat();
        self.aero(&arguments)
    }

    /// Runs `scene` with `from` changed to `to`, which is to be refused in one error that holds all `words`.
    #[track_caller]
    pub fn refuses_changed(&self, scene: &str, [from, to]: [&str; 2], words: &[&str]) {
        let changed = scene.replace(from, to);
        assert_ne!(changed, scene, "{from}");
        self.run(&changed, &[]).refuses(words);
    }

    pub fn json(&self, name: &str) -> serde_json::Value {
        let text = std::fs::read_to_string(self.path(name)).expect("a JSON file");
        serde_json::from_str(&text).expect("JSON")
    }
}

impl Answer {
    /// Asserts that the command was refused as wrong, in one error that holds all `words`.
    #[track_caller]
    pub fn refuses(&self, words: &[&str]) {
        assert_eq!(self.status, 2, "status of: {}", self.err);
        assert!(!self.err.contains("panicked"), "{}", self.err);
        assert!(self.err.starts_with("error: "), "{}", self.err);
        assert_eq!(self.err.matches("error: ").count(), 1, "{}", self.err);
        for word in words {
            assert!(
                self.err.contains(word),
                "`{word}` is missing in: {}",
                self.err
            );
        }
    }

    /// Asserts that the command succeeded.
    #[track_caller]
    pub fn succeeds(&self) {
        assert_eq!(self.status, 0, "{}{}", self.out, self.err);
    }
}

/// A gas at rest in a closed box, a few hundred particles.
pub const BOX: &str = r#"
dimension = 2
spacing = 0.05
end_time = 0.02

[domain]
min = [0.0, 0.0]
max = [1.0, 0.5]

[domain.sides]
x_min = "wall"
x_max = "wall"
y_min = "periodic"
y_max = "periodic"

[initial.riemann]
position = 0.5
left = { density = 1.0, pressure = 1.0 }
right = { density = 0.125, pressure = 0.1 }

[output]
frames = 2
"#;

/// `BOX` with one line in place of another.
#[track_caller]
pub fn box_with(old: &str, new: &str) -> String {
    assert!(BOX.contains(old), "`{old}` is not in the scene");
    BOX.replace(old, new)
}

/// An octahedron of unit radius about the origin, as ASCII STL.
pub fn octahedron(name: &str) -> String {
    let corners = |signs: [f64; 3]| {
        let [x, y, z] = signs;
        let mut corners = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        if x * y * z < 0.0 {
            corners.swap(0, 1);
        }
        corners
    };
    let facets = (0..8_u8).map(|number| {
        let sign = |bit: u8| if number >> bit & 1 == 0 { 1.0 } else { -1.0 };
        corners([sign(0), sign(1), sign(2)])
    });
    ascii_stl(name, &facets.collect::<Vec<_>>())
}

/// Triangles as ASCII STL.
pub fn ascii_stl(name: &str, facets: &[[[f64; 3]; 3]]) -> String {
    let mut lines = vec![format!("solid {name}")];
    for facet in facets {
        lines.push("facet normal 0 0 0\nouter loop".into());
        for [x, y, z] in facet {
            lines.push(format!("vertex {x} {y} {z}"));
        }
        lines.push("endloop\nendfacet".into());
    }
    lines.push(format!("endsolid {name}\n"));
    lines.join("\n")
}

/// Points and named arrays of a `.vtp` file, read back by an independent reader.
pub fn read_vtp(path: &Path) -> (usize, Vec<(String, usize)>) {
    use vtkio::model::{Attribute, DataSet, Piece, Vtk};
    let vtk = Vtk::import(path).expect("a VTK file");
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        panic!("not PolyData");
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        panic!("no piece");
    };
    let verts = piece.verts.as_ref().expect("vertex cells");
    let points = piece.points.len() / 3;
    assert_eq!(verts.num_cells(), points);
    let arrays = piece.data.point.iter().map(|attribute| match attribute {
        Attribute::DataArray(array) => (array.name.clone(), array.data.len()),
        Attribute::Field { .. } => panic!("a field in an XML file"),
    });
    (points, arrays.collect())
}

/// The numbers of an array of points.
pub fn vtp_array(path: &Path, name: &str) -> Vec<f64> {
    use vtkio::model::{Attribute, DataSet, Piece, Vtk};
    let vtk = Vtk::import(path).expect("a VTK file");
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        panic!("not PolyData");
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        panic!("no piece");
    };
    let mut arrays = piece
        .data
        .point
        .iter()
        .filter_map(|attribute| match attribute {
            Attribute::DataArray(array) if array.name == name => array.data.cast_into(),
            _ => None,
        });
    arrays.next().expect("the array")
}

/// Segments or triangles with their arrays, as `surface-NNNNNN.vtp` holds them.
pub struct Surface {
    /// Corners, cell by cell.
    pub cells: Vec<Vec<[f64; 3]>>,
    /// Values by name of the array.
    pub arrays: std::collections::BTreeMap<String, Vec<f64>>,
}

/// The numbers of an array that an XML file of VTK has appended, as it lies in memory or in letters, compressed or not; `None` where
/// there is none.
pub fn appended(path: &Path, name: &str) -> Option<Vec<f64>> {
    let bytes = std::fs::read(path).expect("a file");
    let begin = b"<AppendedData encoding=\"";
    let at = bytes
        .windows(begin.len())
        .position(|window| window == begin);
    let at = at.expect("appended data");
    let text = std::str::from_utf8(&bytes[..at]).expect("text");
    let is_lettered = bytes[at + begin.len()..].starts_with(b"base64");
    let start = at + bytes[at..].iter().position(|b| *b == b'_').expect("data") + 1;
    let line = text
        .lines()
        .find(|line| line.contains(&format!("Name=\"{name}\"")))?;
    let value = |key: &str| {
        let rest = line
            .split(&format!("{key}=\""))
            .nth(1)
            .expect("an attribute");
        rest.split('"').next().expect("its value").to_owned()
    };
    let mut from = start + value("offset").parse::<usize>().expect("an offset");
    // So many bytes of what begins at `from`.
    let read = |from: usize, count: usize| -> Vec<u8> {
        if is_lettered {
            let mut all = unlettered(&bytes[from..from + count.div_ceil(3) * 4]);
            all.truncate(count);
            all
        } else {
            bytes[from..from + count].to_vec()
        }
    };
    let word = |bytes: &[u8], n: usize| -> usize {
        u64::from_le_bytes(bytes[8 * n..8 * n + 8].try_into().expect("eight bytes")) as usize
    };
    let first = word(&read(from, 8), 0);
    let content = if text.contains("vtkZLibDataCompressor") {
        // Number of blocks, their size, that of the last, and what each takes.
        let length = 8 * (3 + first);
        let header = read(from, length);
        from += if is_lettered {
            length.div_ceil(3) * 4
        } else {
            length
        };
        let sizes: Vec<usize> = (0..first).map(|block| word(&header, 3 + block)).collect();
        let packed = read(from, sizes.iter().sum());
        let (mut at, mut content) = (0, Vec::new());
        for size in sizes {
            let mut reader = flate2::read::ZlibDecoder::new(&packed[at..at + size]);
            std::io::Read::read_to_end(&mut reader, &mut content).expect("a block");
            at += size;
        }
        content
    } else {
        read(from, 8 + first)[8..].to_vec()
    };
    let words = content.as_chunks::<8>().0.iter();
    Some(match value("type").as_str() {
        "Float64" => words.map(|word| f64::from_le_bytes(*word)).collect(),
        "Int64" => words.map(|word| i64::from_le_bytes(*word) as f64).collect(),
        _ => content.iter().map(|&b| f64::from(b)).collect(),
    })
}

/// What letters stand for [RFC 4648, 4]; zeros for what fills them up.
fn unlettered(letters: &[u8]) -> Vec<u8> {
    let six = |letter: &u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => 0,
    };
    let four = letters.as_chunks::<4>().0.iter();
    let bits = four.map(|four| {
        four.iter()
            .fold(0_u32, |sum, l| sum << 6 | u32::from(six(l)))
    });
    bits.flat_map(|bits| [(bits >> 16) as u8, (bits >> 8) as u8, bits as u8])
        .collect()
}

/// Reads a surface.
pub fn read_surface(path: &Path) -> Surface {
    use vtkio::model::{Attribute, DataSet, Piece, Vtk};
    let vtk = Vtk::import(path).expect("a VTK file");
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        panic!("not PolyData");
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        panic!("no piece");
    };
    let points: Vec<f64> = piece.points.clone().into_vec().expect("coordinates");
    let topology = piece
        .polys
        .as_ref()
        .or(piece.lines.as_ref())
        .expect("cells");
    let (connectivity, offsets) = topology.clone().into_xml();
    let mut from = 0;
    let cells = offsets.iter().map(|&to| {
        let corners = &connectivity[from..to as usize];
        from = to as usize;
        let corner = |&n: &u64| std::array::from_fn(|k| points[3 * n as usize + k]);
        corners.iter().map(corner).collect()
    });
    let cells = cells.collect();
    let arrays = piece.data.cell.iter().map(|attribute| match attribute {
        Attribute::DataArray(array) => {
            let values = array.data.clone().cast_into::<f64>().expect("numbers");
            (array.name.clone(), values)
        }
        Attribute::Field { .. } => panic!("a field in an XML file"),
    });
    Surface {
        cells,
        arrays: arrays.collect(),
    }
}

/// The pressure behind the Mach 2.5, 20 degree shock over that before it: NACA Report 1135 (1953), eq. 128.
pub const PRESSURE_RATIO: f64 = 3.2109;

/// The scene of the wedge by points that stay.
pub fn fixed_wedge() -> String {
    let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/wedge-fixed.toml");
    std::fs::read_to_string(scene).expect("the scene")
}

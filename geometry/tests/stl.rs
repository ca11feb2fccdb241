//! STL files, well-formed and not.

use aero_geometry::bodies::sphere;
use aero_geometry::stl::{Unit, parse, write_binary};
use aero_geometry::{GeometryError, Mesh, Shape, Vector};
use approx::assert_relative_eq;
use proptest::prelude::*;

const FACET: &str = "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n\
                     vertex 0 1 -0.0\n endloop\nendfacet\n";

fn text(contents: &str) -> Result<usize, String> {
    parse(contents.as_bytes().to_vec())
        .map(|soup| soup.facets.len())
        .map_err(|error| error.to_string())
}

fn binary(count: usize) -> Vec<u8> {
    let facets = sphere(1.0).unwrap().tessellate(12);
    let mut bytes = Vec::new();
    write_binary(&mut bytes, &facets[..count]).unwrap();
    bytes
}

fn refused(bytes: Vec<u8>) -> String {
    parse(bytes).unwrap_err().to_string()
}

#[test]
fn all_solids_of_a_text_file_are_read_in_any_spelling() {
    let contents = format!(
        "\u{feff}  SOLID First one \r\n{upper}ENDSOLID\n\nsolid\n\t{FACET}{FACET}endsolid whatever\n",
        upper = FACET.to_uppercase()
    );
    let soup = parse(contents.into_bytes()).unwrap();
    assert_eq!(soup.facets.len(), 3);
    assert_eq!(
        soup.solids,
        vec![("First one".to_owned(), 0), ("solid 2".to_owned(), 1)]
    );
}

#[test]
fn degenerate_normals_and_old_line_ends_are_read() {
    let facet = FACET.replace("0 0 1", "nan nan nan").replace('\n', "\r");
    assert_eq!(text(&format!("solid a\r{facet}endsolid a\r")), Ok(1));
    let bare = FACET.replace("normal 0 0 1", "");
    assert_eq!(text(&format!("solid a\n{bare}endsolid")), Ok(1));
}

#[test]
fn a_damaged_text_file_is_refused_with_the_line() {
    let body = |facet: &str| text(&format!("solid a\n{facet}endsolid a\n")).unwrap_err();
    assert_eq!(
        body(&FACET.replace("1 0 0", "1 zero 0")),
        "stl: line 5: coordinate `zero` is not a number"
    );
    assert_eq!(
        body(&FACET.replace("1 0 0", "1 inf 0")),
        "stl: line 5: coordinate `inf` is not finite"
    );
    assert_eq!(
        body(&FACET.replace("1 0 0", "1 0")),
        "stl: line 5: a vertex with 2 coordinates; it needs three"
    );
    assert!(body(&FACET.replace(" vertex 1 0 0\n", "")).contains("facet with 2 vertices"));
    assert!(body(&FACET.replace("endloop", "vertex 1 1 1\n endloop")).contains("a fourth vertex"));
    assert!(body(&FACET.replace("outer", "inner")).contains("`loop` where `outer loop`"));
    assert!(body(&format!("{FACET}colour 1 0 0\n")).contains("line 9: `colour`"));
    let cut = text(&format!("solid a\n{}", &FACET[..42])).unwrap_err();
    assert_eq!(
        cut,
        "stl: line 4, where the file ends: a vertex with 2 coordinates; it needs three"
    );
    let cut = text(&format!("solid a\n{FACET}{}", &FACET[..30])).unwrap_err();
    assert!(
        cut.contains("cut off: solid `a` does not end after 1 triangles"),
        "{cut}"
    );
    assert!(
        text("solid empty\nendsolid empty\n")
            .unwrap_err()
            .contains("no triangles")
    );
}

#[test]
fn a_binary_file_whose_header_says_solid_is_binary() {
    let mut bytes = binary(20);
    bytes[..5].copy_from_slice(b"solid");
    assert_eq!(parse(bytes).unwrap().facets.len(), 20);
}

#[test]
fn a_damaged_binary_file_is_refused_with_the_count() {
    assert!(refused(Vec::new()).contains("the file is empty"));
    assert!(refused(vec![7; 30]).contains("30 bytes are too few"));
    let mut cut = binary(20);
    cut.truncate(cut.len() - 60);
    assert_eq!(
        refused(cut),
        "stl: the header promises 20 triangles, but the file holds 18 and part of another: it is \
         cut off or damaged"
    );
    let mut wrong = binary(20);
    wrong[80..84].copy_from_slice(&19_u32.to_le_bytes());
    assert!(refused(wrong).contains("promises 19 triangles, but the file holds 20:"));
    let mut nan = binary(20);
    nan[84 + 50 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert!(refused(nan).contains("triangle 2 has a corner at (NaN"));
    assert!(refused(binary(0)).contains("no triangles"));
}

#[test]
fn a_written_sphere_reads_back_in_its_unit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sphere.stl");
    let mut file = std::fs::File::create(&path).unwrap();
    write_binary(&mut file, &sphere(2.0).unwrap().tessellate(64)).unwrap();
    for (unit, metres) in [
        (Unit::Metre, 1.0),
        (Unit::Millimetre, 1e-3),
        (Unit::Inch, 0.0254),
    ] {
        let mesh = Mesh::read(&path, unit).unwrap();
        let depth = mesh.signed_distance(&Vector::<3>::zeros());
        assert_relative_eq!(depth, -2.0 * metres, max_relative = 5e-3);
        assert_eq!(mesh.names(), ["solid 1"]);
        assert!(mesh.repairs().is_empty(), "{:?}", mesh.repairs());
    }
}

#[test]
fn errors_name_the_file() {
    let path = std::path::Path::new("no/such/body.stl");
    let error = Mesh::read(path, Unit::Metre).unwrap_err();
    assert!(matches!(error, GeometryError::Read { .. }));
    assert!(error.to_string().contains("no/such/body.stl"));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("open.stl");
    std::fs::write(&path, format!("solid a\n{FACET}endsolid\n")).unwrap();
    let message = Mesh::read(&path, Unit::Metre).unwrap_err().to_string();
    assert!(
        message.contains("open.stl`: surface: is open at 1 hole"),
        "{message}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse(bytes);
    }

    #[test]
    fn any_words_after_solid_are_read_or_refused(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet",
                "endsolid", "1", "nan", "-2.5e3", "\n", "ü",
            ]),
            0..60,
        ),
    ) {
        let _ = parse(format!("solid {}", words.join(" ")).into_bytes());
    }

    #[test]
    fn a_changed_byte_never_stops_the_reader(place in 0..1084_usize, value in any::<u8>()) {
        let mut bytes = binary(20);
        bytes[place] = value;
        let _ = parse(bytes);
    }
}

#[test]
fn a_body_whose_shape_single_precision_has_lost_is_refused() {
    let moved = |away: f64| {
        let facets = sphere(1.0).unwrap().tessellate(12);
        let offset = Vector::<3>::new(0.0, away, 0.0);
        let facets: Vec<_> = facets.iter().map(|f| f.map(|p| p + offset)).collect();
        let mut bytes = Vec::new();
        write_binary(&mut bytes, &facets).unwrap();
        parse(bytes).map(|_| ()).map_err(|error| error.to_string())
    };
    // Two across, in steps of 1e-7 of the distance.
    assert_eq!(moved(0.0), Ok(()));
    assert_eq!(moved(1e5), Ok(()));
    let refusal = moved(1e6).unwrap_err();
    assert!(refusal.contains("17 of its steps across"), "{refusal}");
    assert!(refusal.contains("move it to the origin"), "{refusal}");
}

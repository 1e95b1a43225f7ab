//! STL and OBJ files: the same box in each, and files that must be refused.

use std::fs;
use std::path::PathBuf;

use nalgebra::Vector3;
use polhode::body::{BodyError, MassProperties, Shape, Solid, TriangleMesh, mass_properties_of};
use proptest::prelude::*;
use tempfile::TempDir;

/// Exact in single precision, in the files' unit.
const SIZE: [f32; 3] = [2.0, 3.5, 5.25];
/// The files' unit in m.
const SCALE: f64 = 1e-3;
const DENSITY: f64 = 2700.0;

/// Corner `index` has the high end of axis `a` where bit `a` is set; faces counter-clockwise from outside.
const FACES: [[usize; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

fn corner(index: usize) -> [f32; 3] {
    // A low end of −0 in one corner: the same place as 0.
    let low = if index == 0 { -0.0 } else { 0.0 };
    [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { SIZE[axis] } else { low })
}

fn triangles() -> Vec<[[f32; 3]; 3]> {
    let fan = |[a, b, c, d]: [usize; 4]| [[a, b, c].map(corner), [a, c, d].map(corner)];
    FACES.into_iter().flat_map(fan).collect()
}

fn text_stl(triangles: &[[[f32; 3]; 3]], header: &str) -> Vec<u8> {
    let vertex = |[x, y, z]: &[f32; 3]| format!("  vertex {x:e} {y:e} {z:e}\n");
    let facet = |corners: &[[f32; 3]; 3]| {
        let loops: String = corners.iter().map(vertex).collect();
        format!("facet normal 0 0 0\n outer loop\n{loops} endloop\nendfacet\n")
    };
    let facets: String = triangles.iter().map(facet).collect();
    format!("{header}\n{facets}endsolid\n").into_bytes()
}

fn binary_stl(triangles: &[[[f32; 3]; 3]], header: &str) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend(u32::try_from(triangles.len()).unwrap().to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(triangle.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn obj(faces: &[[usize; 4]]) -> Vec<u8> {
    let vertex = |[x, y, z]: [f32; 3]| format!("v {x} {y} {z} 0.5 0.5 0.5\n");
    // Counted from 1 or, in every other face, back from the last.
    let forward = |corner: usize| format!(" {}/1/1", corner + 1);
    let backward = |corner: usize| format!(" -{}//1", 8 - corner);
    let face = |(index, face): (usize, &[usize; 4])| {
        let corners = if index % 2 == 0 { face.map(forward) } else { face.map(backward) };
        format!("g side{index}\nusemtl none\nf{}\n", corners.concat())
    };
    let vertices: String = (0..8).map(corner).map(vertex).collect();
    let faces: String = faces.iter().enumerate().map(face).collect();
    format!("mtllib absent.mtl\no box # in groups\nvt 0 0\nvn 0 0 1\n{vertices}{faces}").into_bytes()
}

fn file(name: &str, bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    (folder, path)
}

fn read(name: &str, bytes: &[u8]) -> Result<TriangleMesh, BodyError> {
    let (_folder, path) = file(name, bytes);
    TriangleMesh::read(&path, SCALE)
}

fn solid_box() -> MassProperties {
    let size = SIZE.map(|edge| f64::from(edge) * SCALE);
    let solid = Solid::new(Shape::Box { size }, DENSITY).unwrap().at(Vector3::from(size) * 0.5);
    mass_properties_of(&[solid]).unwrap()
}

#[test]
fn the_same_box_in_every_format_is_the_solid_box() {
    let triangles = triangles();
    let wanted = solid_box();
    for (name, bytes) in [
        ("text.stl", text_stl(&triangles, "solid box of lead")),
        ("nameless.STL", text_stl(&triangles, "solid")),
        ("binary.stl", binary_stl(&triangles, "box")),
        ("binary_called_solid.stl", binary_stl(&triangles, "solid box")),
        ("box.obj", obj(&FACES)),
    ] {
        let mesh = read(name, &bytes).unwrap();
        assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (8, 12), "{name}");
        let found = mesh.mass_properties(DENSITY).unwrap();
        let room = 2.0 * f64::EPSILON;
        assert!((found.mass.unwrap() / wanted.mass.unwrap() - 1.0).abs() <= room, "{name}");
        assert!((found.centre_of_mass - wanted.centre_of_mass).norm() <= room * wanted.centre_of_mass.norm(), "{name}");
        let difference = (found.tensor() - wanted.tensor()).norm();
        assert!(difference <= room * wanted.tensor().norm(), "{name}: {difference:e}");
    }
}

#[test]
fn open_and_inside_out_meshes_are_refused() {
    let open = read("open.stl", &binary_stl(&triangles()[..11], "open")).unwrap();
    let refused = open.mass_properties(DENSITY).unwrap_err();
    assert!(matches!(refused, BodyError::NotClosed { forward: 1, backward: 0, .. }), "{refused}");
    let turned: Vec<_> = triangles().into_iter().map(|[a, b, c]| [a, c, b]).collect();
    let refused = read("turned.stl", &text_stl(&turned, "solid")).unwrap().mass_properties(DENSITY).unwrap_err();
    assert!(refused.to_string().contains("counter-clockwise seen from outside"), "{refused}");
    // One face turned: each of its edges is used twice the same way.
    let mut faces = FACES;
    faces[2].reverse();
    let refused = read("mixed.obj", &obj(&faces)).unwrap().mass_properties(DENSITY).unwrap_err();
    assert!(matches!(refused, BodyError::NotClosed { .. }), "{refused}");
}

#[test]
fn damaged_and_hostile_files_are_refused_by_name() {
    let good = triangles();
    let mut vast = binary_stl(&good, "vast");
    vast[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let truncated = binary_stl(&good, "truncated");
    let mut not_a_number = binary_stl(&good, "nan");
    not_a_number[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    let text = text_stl(&good, "solid");
    for (name, bytes, says) in [
        ("box.ply", vec![], "must be stl or obj"),
        ("empty.stl", vec![], "binary STL of 0 triangles"),
        ("empty.obj", vec![], "no triangles"),
        ("none.stl", binary_stl(&[], "none"), "no triangles"),
        ("vast.stl", vast, "takes 214748364834 bytes"),
        ("truncated.stl", truncated[..truncated.len() - 1].to_vec(), "takes 684 bytes, but there are 683"),
        ("nan.stl", not_a_number, "coordinates must be finite"),
        ("cut.stl", text[..text.len() / 2].to_vec(), ""),
        ("two.stl", [text.clone(), text].concat(), "2 solids"),
        ("word.stl", b"solid\nfacet normal 0 0 x\n".to_vec(), ""),
        ("line.obj", b"v 0 0 0\nv 1 0 0\nf 1 2\n".to_vec(), "fewer than three corners"),
        ("missing.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 3\n".to_vec(), ""),
        ("zero.obj", b"v 0 0 0\nf 0 0 0\n".to_vec(), ""),
        ("back.obj", b"v 0 0 0\nf -1 -2 -9223372036854775808\n".to_vec(), ""),
        ("slashes.obj", b"v 0 0 0\nf / / /\n".to_vec(), ""),
        ("short.obj", b"v 0 0\nf 1 1 1\n".to_vec(), ""),
        ("infinite.obj", b"v inf 0 0\nf 1 1 1\n".to_vec(), "coordinates must be finite"),
        ("binary.obj", vec![0xff; 64], "utf-8"),
    ] {
        let refused = read(name, &bytes).unwrap_err();
        assert!(matches!(refused, BodyError::MeshFile { .. }), "{refused}");
        let message = refused.to_string();
        assert!(message.contains(name) && message.contains(says), "{message}");
    }
    let (folder, path) = file("box.stl", &binary_stl(&good, "box"));
    assert!(TriangleMesh::read(&path, 0.0).unwrap_err().to_string().starts_with("scale of a mesh file = 0"));
    let absent = folder.path().join("absent.stl");
    assert!(matches!(TriangleMesh::read(&absent, 1.0), Err(BodyError::MeshFile { .. })));
    #[cfg(target_os = "linux")]
    {
        let endless = folder.path().join("endless.stl");
        std::os::unix::fs::symlink("/dev/zero", &endless).unwrap();
        assert!(TriangleMesh::read(&endless, 1.0).unwrap_err().to_string().contains("larger than"));
    }
}

proptest! {
    #[test]
    fn files_with_bytes_changed_or_cut_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..8),
        kept in any::<prop::sample::Index>(),
    ) {
        let triangles = triangles();
        let originals =
            [("a.stl", text_stl(&triangles, "solid")), ("b.stl", binary_stl(&triangles, "")), ("c.obj", obj(&FACES))];
        for (name, original) in originals {
            let mut changed = original.clone();
            for (place, value) in &changes {
                changed[place.index(original.len())] = *value;
            }
            for bytes in [&changed[..], &changed[..kept.index(original.len())]] {
                if let Ok(mesh) = read(name, bytes) {
                    // Whether it is still a body does not matter, only that the answer is one.
                    drop(mesh.mass_properties(DENSITY));
                }
            }
        }
    }
}

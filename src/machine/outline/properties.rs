//! What must hold for the outline of every tool.

use super::*;
use crate::machine::{Shank, ToolMaterial, ToolShape};
use proptest::prelude::*;

/// Largest arc deviation of the polygons that the tests look at, mm.
const FINE: f64 = 1e-4;
/// Rounding of coordinates, mm.
const ROUNDING: f64 = 1e-9;

fn tool(shape: ToolShape, shank: Option<Shank>) -> Tool {
    Tool {
        id: "t".into(),
        name: "t".into(),
        edge: ToolMaterial::Carbide,
        shape,
        shank,
        holder: Vec::new(),
        interference_lines: Vec::new(),
    }
}

fn iso(insert: &str, holder: &str) -> Tool {
    tool(ToolShape::Iso { insert: insert.into(), holder: holder.into() }, None)
}

fn area(points: &[Point]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a.z * b.r - b.z * a.r).sum::<f64>() / 2.0
}

/// Corners of a closed contour, each once.
fn ring(contour: &Contour) -> Vec<Point> {
    let mut points = contour.polyline(FINE);
    points.pop();
    points
}

fn crosses_itself(points: &[Point]) -> bool {
    let count = points.len();
    let side = |a: Point, b: Point, p: Point| (b.z - a.z) * (p.r - a.r) - (b.r - a.r) * (p.z - a.z);
    (0..count).any(|i| {
        let (a, b) = (points[i], points[(i + 1) % count]);
        (i + 2..count).filter(|j| (j + 1) % count != i).any(|j| {
            let (c, d) = (points[j], points[(j + 1) % count]);
            side(a, b, c) * side(a, b, d) < -1e-12 && side(c, d, a) * side(c, d, b) < -1e-12
        })
    })
}

/// Every rule that holds for all tools.
fn check(outline: &ToolOutline) -> Result<(), TestCaseError> {
    for contour in [&outline.insert, &outline.holder] {
        prop_assert!(contour.segments.len() >= 2 && contour.largest_gap() < ROUNDING);
        let (first, last) = (contour.segments.first().unwrap(), contour.segments.last().unwrap());
        prop_assert!(first.start().distance(last.end()) < ROUNDING);
        let points = ring(contour);
        prop_assert!(area(&points) > 0.0);
        prop_assert!(!crosses_itself(&points), "{points:?}");
    }
    prop_assert_eq!(outline.cutting.len(), outline.insert.segments.len());
    prop_assert!(outline.cutting.iter().any(|c| *c));
    noses_are_tangent(&outline.insert)?;
    nose_touches_its_axes(outline)?;
    let edges: Vec<&Segment> = outline.cutting_edges().collect();
    holder_keeps_behind(outline, &edges)
}

/// Arcs join their neighbours without a kink, and they are the arcs of the nose.
fn noses_are_tangent(insert: &Contour) -> Result<(), TestCaseError> {
    let count = insert.segments.len();
    for (i, segment) in insert.segments.iter().enumerate().filter(|(_, s)| s.radius().is_some()) {
        let next = &insert.segments[(i + 1) % count];
        let before = &insert.segments[(i + count - 1) % count];
        prop_assert!((segment.direction_at(1.0) - next.direction_at(0.0)).norm() < 1e-6);
        prop_assert!((segment.direction_at(0.0) - before.direction_at(1.0)).norm() < 1e-6);
    }
    Ok(())
}

/// The nose touches those axes of tool space that its orientation names.
fn nose_touches_its_axes(outline: &ToolOutline) -> Result<(), TestCaseError> {
    let (rn, c) = (outline.nose_radius, outline.nose_center);
    let (z, r) = match outline.orientation {
        1 => (-rn, -rn),
        2 => (rn, -rn),
        3 => (rn, rn),
        4 => (-rn, rn),
        5 => (rn, 0.0),
        6 => (0.0, -rn),
        7 => (-rn, 0.0),
        8 => (0.0, rn),
        _ => (0.0, 0.0),
    };
    prop_assert!((c.z - z).abs() < ROUNDING && (c.r - r).abs() < ROUNDING, "{c:?} {}", outline.orientation);
    Ok(())
}

/// Where insert and holder overlap, the holder stays inside the insert: clear of the edges that cut.
fn holder_keeps_behind(outline: &ToolOutline, edges: &[&Segment]) -> Result<(), TestCaseError> {
    let points = outline.holder.segments.iter().flat_map(|s| (0..40).map(move |i| s.point_at(f64::from(i) / 40.0)));
    for p in points {
        for edge in edges {
            let distance = Contour::new(vec![**edge]).distance_to(p);
            prop_assert!(distance > 0.04, "{p:?} is {distance} mm from {edge:?}");
        }
    }
    Ok(())
}

const INSERTS: &[(&str, &[&str])] = &[
    ("CNMG120408", &["PCLN*2525M12", "PCLN*2020K12", "PCKN*2525M12"]),
    ("CNMG190616", &["PCLN*3232P19"]),
    ("CCMT060202", &["SCLC*1010H06", "S10K-SCLC*06"]),
    ("CCMT09T308", &["SCLC*1616H09", "S16R-SCLC*09", "S25T-SCLC*09"]),
    ("DNMG150608", &["PDJN*2525M15"]),
    ("DCMT11T304", &["SDJC*2020K11", "S16R-SDUC*11", "S20S-SDUC*11"]),
    ("VNMG160408", &["MVJN*2525M16"]),
    ("VBMT160404", &["SVJB*2525M16", "S25T-SVUB*16"]),
    ("VBMT110302", &["SVJB*1212F11"]),
    ("TNMG160408", &["PTGN*2525M16", "PTFN*2020K16"]),
    ("TNMG220412", &["PTGN*3225P22"]),
    ("WNMG080408", &["MWLN*2525M08"]),
    ("WNMG060404", &["MWLN*2020K06", "S25T-MWLN*06"]),
    ("SNMG120408", &["PSSN*2525M12", "PSBN*2525M12"]),
    ("RCMT0803M0", &["SRSC*2525M08"]),
    ("RCMT1204M0", &["SRSC*2525M12"]),
    ("16ER AG60", &["SE*2525M16", "SE*1616H16"]),
    ("16ER AG55", &["SE*2020K16"]),
    ("16IR AG60", &["SI*0020P16", "SI*0025R16"]),
    ("11IR AG55", &["SI*0013M11"]),
];

#[test]
fn every_iso_tool_and_its_mirror_image_keep_the_rules() {
    for (insert, holders) in INSERTS {
        for holder in *holders {
            let of = |hand: &str| {
                let code = holder.replace('*', hand);
                crate::machine::iso::IsoTool::read(insert, &code).unwrap_or_else(|e| panic!("{code}: {e:?}"));
                iso(insert, &code).outline()
            };
            let (right, left) = (of("R"), of("L"));
            check(&right).unwrap_or_else(|e| panic!("{insert} {holder}: {e}"));
            check(&left).unwrap_or_else(|e| panic!("{insert} {holder}: {e}"));
            assert_eq!(right.other_hand(), left, "{insert} {holder}");
            assert_eq!(left.other_hand(), right, "{insert} {holder}");
        }
    }
}

#[test]
fn neutral_tools_are_their_own_mirror_image() {
    for (insert, holder) in [("VBMT160404", "SVVBN2525M16"), ("RCMT0803M0", "SRDCN2525M08")] {
        let outline = iso(insert, holder).outline();
        check(&outline).unwrap();
        assert_eq!(outline.orientation, 8);
        for contour in [&outline.insert, &outline.holder] {
            let b = contour.bounds().unwrap();
            assert!((b.min.z + b.max.z).abs() < 1e-9, "{insert}: {b:?}");
            let mirrored = contour.segments.iter().map(|s| s.mirrored_at_z(0.0)).collect();
            let distance = |p: &Point| Contour::new(Vec::clone(&mirrored)).distance_to(*p);
            assert!(ring(contour).iter().map(distance).fold(0.0, f64::max) < 1e-9, "{insert}");
        }
    }
}

#[test]
fn every_shipped_tool_keeps_the_rules() {
    for tool in &Catalog::shipped().tools {
        let outline = tool.outline();
        let crossing = |c: &Contour| crosses_itself(&ring(c));
        assert!(!crossing(&outline.insert) && !crossing(&outline.holder), "{}", tool.id);
        nose_touches_its_axes(&outline).unwrap();
        noses_are_tangent(&outline.insert).unwrap();
    }
}

#[test]
fn a_cnmg_12_is_a_rhombus_about_12_7_mm_at_95_degrees() {
    let outline = iso("CNMG120408", "PCLNR2525M12").outline();
    let edges: Vec<&Segment> = outline.cutting_edges().collect();
    let angle = |s: &Segment| {
        let d = s.direction_at(0.5);
        d.y.atan2(d.x).to_degrees()
    };
    // The nose, the trailing edge at 5° and the leading edge, travelled downwards, at 85°.
    assert_eq!(edges.len(), 3);
    assert!((angle(edges[1]) - 5.0).abs() < 1e-9 && (angle(edges[2]) + 95.0).abs() < 1e-9);
    // The edge of 12.7 / sin 80° = 12.896 mm less 0.8 / tan 40° at either end... and 0.8 / tan 50° at the blunt one.
    let rounding = 0.8 / 40_f64.to_radians().tan() + 0.8 / 50_f64.to_radians().tan();
    assert!((edges[1].length() - (12.7 / 80_f64.to_radians().sin() - rounding)).abs() < 1e-9);
    let holder = outline.holder.bounds().unwrap();
    assert!((holder.max.z - 32.0).abs() < 1e-9 && (holder.max.r - 150.0).abs() < 1e-9);
}

#[test]
fn a_trigon_has_edges_of_0_684_inscribed_circles() {
    let polygon = insert::polygon(crate::machine::iso::InsertForm::Trigon { inscribed: 12.7 }, 1.0).unwrap();
    let edges = polygon.corners.iter().zip(polygon.corners.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b));
    for edge in edges {
        assert!((edge - 8.687).abs() < 0.01, "{edge}");
    }
}

#[test]
fn a_boring_bar_lies_below_its_tip_and_fits_its_smallest_bore() {
    let outline = iso("CCMT09T308", "S16R-SCLCR09").outline();
    assert_eq!((outline.kind, outline.orientation), (ToolKind::Boring, 2));
    assert!(outline.cuts_towards_headstock() && !outline.cuts_away_from_headstock());
    let near_tip = outline.holder.polyline(FINE).into_iter().filter(|p| p.z < 60.0);
    // 11 mm from the tip to the axis and 8 mm of bar: a bore of 20 mm and a little more than that.
    let lowest = near_tip.map(|p| p.r).fold(0.0, f64::min);
    assert!((lowest + 19.0).abs() < 1e-9, "{lowest}");
    assert!(outline.insert.bounds().unwrap().max.r.abs() < 1e-9);
}

#[test]
fn interference_lines_and_free_outlines_become_contours() {
    let shape = ToolShape::Outline {
        purpose: ToolKind::Turning,
        orientation: 3,
        nose_radius: 0.4,
        corners: vec![[0.0, 0.0], [6.0, 3.0], [6.0, 12.0], [0.0, 12.0]],
        cuts: vec![0],
    };
    let mut tool = tool(shape, None);
    tool.interference_lines = vec![[1.0, 5.0, 8.0, 12.0], [8.0, 12.0, 8.0, 60.0], [1.0, 60.0, 1.0, 5.0]];
    let outline = tool.outline();
    assert_eq!(outline.cutting, [true, true, false, false, false]);
    assert_eq!(outline.holder.segments.len(), 4);
    assert!(area(&ring(&outline.holder)) > 0.0);
}

fn turning() -> impl Strategy<Value = (ToolShape, Option<Shank>)> {
    let figures = (0.1..1.6, 35.0..85.0, 80.0..93.0, 8.0..20.0, 16.0..32.0);
    figures.prop_map(|(nose_radius, corner_angle, approach_angle, edge_length, width): (f64, f64, f64, f64, f64)| {
        let shape = ToolShape::Turning { hand: Hand::Right, nose_radius, corner_angle, approach_angle, edge_length };
        (shape, Some(Shank { width, length: 150.0 }))
    })
}

fn boring() -> impl Strategy<Value = (ToolShape, Option<Shank>)> {
    let figures = (0.1..0.8, 35.0..82.0, 90.0..96.0, 6.0..11.0, 10.0..32.0);
    figures.prop_map(|(nose_radius, corner_angle, approach_angle, edge_length, width): (f64, f64, f64, f64, f64)| {
        let shape = ToolShape::Boring { hand: Hand::Right, nose_radius, corner_angle, approach_angle, edge_length };
        (shape, Some(Shank { width, length: 4.0 * width }))
    })
}

fn blade() -> impl Strategy<Value = (ToolShape, Option<Shank>)> {
    let figures = (1.0..8.0, 0.05..0.4, 3.0..40.0, any::<bool>(), 12.0..32.0);
    figures.prop_map(|(width, nose_radius, depth, inside, shank): (f64, f64, f64, bool, f64)| {
        let shape = ToolShape::Parting { hand: Hand::Right, width, nose_radius, depth, inside };
        (shape, Some(Shank { width: shank, length: 150.0 }))
    })
}

fn other() -> impl Strategy<Value = (ToolShape, Option<Shank>)> {
    let shank = Some(Shank { width: 25.0, length: 150.0 });
    prop_oneof![
        (2.0..20.0).prop_map(move |diameter: f64| (ToolShape::Button { diameter }, shank)),
        (0.1..0.8, 40.0..75.0, 8.0..16.0).prop_map(move |(nose_radius, corner_angle, edge_length): (f64, f64, f64)| {
            (ToolShape::Copying { nose_radius, corner_angle, edge_length }, shank)
        }),
        (3.0..40.0, 90.0..140.0).prop_map(|(diameter, point_angle): (f64, f64)| {
            (ToolShape::Drill { diameter, point_angle, length: 5.0 * diameter, pecks_from: 3.0 }, None)
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn every_tool_by_dimensions_keeps_the_rules((shape, shank) in prop_oneof![turning(), boring(), blade(), other()]) {
        let tool = tool(shape, shank);
        prop_assert_eq!(crate::machine::check::tool(&tool), vec![]);
        let outline = tool.outline();
        check(&outline)?;
        prop_assert_eq!(outline.other_hand().other_hand(), outline.clone());
        prop_assert_eq!(outline.upside_down().upside_down(), outline);
    }
}

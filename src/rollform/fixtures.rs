//! Roll sets for tests.

use crate::document::{
    BendAngle, CrossSection, DevelopedWidth, Element, ElementKind, FormingLine, Opening, Origin, Pinch, Rates, RollSet,
    Sharpening, Station, StripMaterial,
};

/// The line of every set.
const LINE: FormingLine = FormingLine {
    station_pitch: 300.0,
    shaft_diameter: 40.0,
    side_shaft_diameter: 25.0,
    gear_ratio: None,
    bottom_rpm: None,
    drawn_gap: 10.0,
};

/// A line with this id and length.
pub(crate) const fn line(id: u32, length: f64) -> Element {
    Element { id, kind: ElementKind::Line { length } }
}

/// A bend with this id, inside radius and angle.
pub(crate) const fn bend(id: u32, inside_radius: f64, angle_deg: f64) -> Element {
    Element { id, kind: ElementKind::Bend { inside_radius, angle_deg } }
}

/// A station with this id that changes these bends.
pub(crate) fn station(id: u32, bends: &[(u32, f64)]) -> Station {
    Station {
        bends: bends.iter().map(|&(element, angle_deg)| BendAngle { element, angle_deg }).collect(),
        pass_height: 70.0,
        centre_distance: 130.0,
        ..Station::new(id, &LINE)
    }
}

/// A set of these elements and stations.
pub(crate) fn set(thickness: f64, origin: Origin, elements: Vec<Element>, stations: Vec<Station>) -> RollSet {
    RollSet {
        machine: "mori-fanuc-6t".to_owned(),
        material: "STEEL".to_owned(),
        strip: StripMaterial::default(),
        section: CrossSection {
            thickness,
            origin,
            first_angle_deg: 0.0,
            developed_width: DevelopedWidth::MeanLine,
            elements,
            other_side: Vec::new(),
        },
        opening: Opening::MeanLine,
        sharpening: Sharpening::None,
        composites: Vec::new(),
        line: LINE,
        stations,
        form_tolerance: 0.02,
        die_clearance: None,
        rates: Rates::default(),
        rolls: Vec::new(),
    }
}

/// A vee of 1 mm strip from left to right: 30 mm, one bend (element 2) of 2 mm to 90 degrees, 50 mm, at these angles.
pub(crate) fn vee(angles_deg: &[f64]) -> RollSet {
    let stations = (1..).zip(angles_deg).map(|(id, &angle)| station(id, &[(2, angle)])).collect();
    set(1.0, Origin::LeftToRight, vec![line(1, 30.0), bend(2, 2.0, 90.0), line(3, 50.0)], stations)
}

/// The published section 1470b (Wong 1983, Figs. 5.5 and 5.6) without what its rolls are designed by.
pub(crate) fn published() -> RollSet {
    const GAP: f64 = 0.001;
    let elements = vec![
        line(1, 40.6499),
        bend(2, 1.5, -23.0),
        line(3, GAP),
        bend(4, 1.5, -30.0),
        line(5, GAP),
        bend(6, 1.5, -20.0),
        line(7, GAP),
        bend(8, 1.5, -25.0),
        line(9, GAP),
        bend(10, 1.5, -45.0),
        line(11, 1.9499),
        bend(12, 2.5, 38.0),
        line(13, GAP),
        bend(14, 2.5, 25.0),
        line(15, GAP),
        bend(16, 2.5, 25.0),
        line(17, GAP),
        bend(18, 2.5, 25.0),
        line(19, 1.75),
        bend(20, 0.06, -180.0),
        line(21, 1.3),
    ];
    let stations = vec![
        station(1, &[(10, -45.0), (18, 25.0)]),
        station(2, &[(8, -25.0), (16, 25.0), (20, -50.0)]),
        station(3, &[(6, -20.0), (14, 25.0), (20, -75.0)]),
    ];
    set(0.5, Origin::Symmetrical, elements, stations)
}

/// The published roll design of section 1470b (Wong 1983, Fig. 5.8).
pub(crate) fn published_rolls() -> RollSet {
    use crate::document::{DriveSurface, ExtensionContour, ExtensionKind, Face, SideEnd, SideRoll};
    let mut set = published();
    let figures = [(71.755, 128.143, 0.5, 0.56, 9), (74.295, 130.683, 0.5, 0.61, 7), (76.2, 132.296, 0.53, 0.56, 5)];
    for (station, (pass_height, centre_distance, drive, clearance, last)) in set.stations.iter_mut().zip(figures) {
        station.pass_height = pass_height;
        station.centre_distance = centre_distance;
        station.tolerance_left = 0.149;
        station.tolerance_right = 0.15;
        station.pinch = Pinch::Gaps { drive, clearance };
        station.drive_right = Some(DriveSurface { first: 1, last });
    }
    let contour = |kind, lengths| ExtensionContour { kind, lengths };
    if let [first, second, third] = set.stations.as_mut_slice() {
        first.extension_right = vec![contour(ExtensionKind::SpigotA, [8.0, 0.0, 8.0, 13.0])];
        second.extension_right = vec![contour(ExtensionKind::SpigotA, [8.0, 13.0, 8.0, 13.0])];
        third.side_right = Some(SideRoll {
            axis_distance: 115.0,
            from: SideEnd { element: 6, face: Face::Top },
            to: SideEnd { element: 21, face: Face::Top },
            extensions: vec![
                contour(ExtensionKind::SideRoll, [0.0, 0.0, 12.0, 9.0]),
                contour(ExtensionKind::SideRoll, [0.0, 6.0, 13.5, 7.5]),
            ],
        });
    }
    set
}

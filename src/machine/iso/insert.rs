//! Insert codes of ISO 1832, and those that makers share for laydown threading inserts.

/// An insert by its code. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machine) struct IsoInsert {
    /// Letter of the shape; `E` or `I` inserts for threads have the holder's letter `E` or `I`.
    pub(in crate::machine) letter: char,
    /// Size code, as in the holder's code.
    pub(in crate::machine) size: String,
    /// Shape and size of the outline.
    pub(in crate::machine) form: InsertForm,
    /// Nose radius; half the diameter of a round insert.
    pub(in crate::machine) nose_radius: f64,
    /// Clearance angle below the edges.
    pub(in crate::machine) clearance_deg: f64,
    /// For threads: inside (`true`) or outside.
    pub(in crate::machine) inside: Option<bool>,
}

/// Outline of an insert.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machine) enum InsertForm {
    /// Four equal edges with this corner angle about an inscribed circle.
    Rhombus { corner_deg: f64, inscribed: f64 },
    /// An equilateral triangle about an inscribed circle.
    Triangle { inscribed: f64 },
    /// A trigon about an inscribed circle: three corners of 80°, three of 160°.
    Trigon { inscribed: f64 },
    /// A disc.
    Round { diameter: f64 },
    /// A triangle with a thread's point on its corner.
    ThreadPoint { point_deg: f64, inscribed: f64 },
}

/// Inscribed circles by size code. The code is the length of an edge in whole millimetres (ISO 1832, table of sizes).
const RHOMBIC_80: &[(&str, f64)] =
    &[("06", 6.35), ("09", 9.525), ("12", 12.7), ("16", 15.875), ("19", 19.05), ("25", 25.4)];
const RHOMBIC_75: &[(&str, f64)] = &[("06", 6.35), ("09", 9.525), ("13", 12.7), ("16", 15.875), ("20", 19.05)];
const RHOMBIC_55: &[(&str, f64)] = &[("07", 6.35), ("11", 9.525), ("15", 12.7), ("19", 15.875)];
const RHOMBIC_35: &[(&str, f64)] = &[("08", 4.76), ("11", 6.35), ("13", 7.94), ("16", 9.525), ("22", 12.7)];
const SQUARE: &[(&str, f64)] =
    &[("06", 6.35), ("09", 9.525), ("12", 12.7), ("15", 15.875), ("19", 19.05), ("25", 25.4)];
const TRIANGULAR: &[(&str, f64)] = &[
    ("06", 3.97),
    ("08", 4.76),
    ("09", 5.56),
    ("11", 6.35),
    ("16", 9.525),
    ("22", 12.7),
    ("27", 15.875),
    ("33", 19.05),
];
const TRIGONAL: &[(&str, f64)] = &[("04", 6.35), ("06", 9.525), ("08", 12.7), ("10", 15.875), ("13", 19.05)];
/// Round inserts: diameter in millimetres, `09` and the like are inch sizes.
const ROUND: &[(&str, f64)] = &[
    ("05", 5.0),
    ("06", 6.0),
    ("08", 8.0),
    ("09", 9.525),
    ("10", 10.0),
    ("12", 12.0),
    ("15", 15.875),
    ("16", 16.0),
    ("19", 19.05),
    ("20", 20.0),
    ("25", 25.0),
];
/// Nose radius of the full-range threading inserts (AG), mm: a flat of an eighth of the smallest pitch, 0.5 mm, rounded.
/// Makers give 0.05 to 0.08 mm.
const THREAD_NOSE_MM: f64 = 0.07;

impl IsoInsert {
    /// Reads a code such as `CNMG120408`, `RCMT0803M0` or `16ER AG60`. What follows the nose radius is a maker's own.
    ///
    /// # Errors
    /// A sentence that names the character that is not understood and what would be.
    pub(in crate::machine) fn read(code: &str) -> Result<Self, String> {
        let compact: String = code.chars().filter(|c| !c.is_whitespace()).collect();
        if !compact.is_ascii() {
            return Err(format!("The code \"{code}\" has characters that no code has."));
        }
        if compact.starts_with(|c: char| c.is_ascii_digit()) { threading(&compact) } else { turning(&compact) }
    }
}

fn turning(code: &str) -> Result<IsoInsert, String> {
    let part = |range: std::ops::Range<usize>| {
        code.get(range)
            .ok_or_else(|| format!("The code \"{code}\" is too short; one such as CNMG120408 has 10 characters."))
    };
    let mut letters = part(0..4)?.chars();
    let letter = letters.next().unwrap_or_default();
    let clearance_deg = clearance(letters.next().unwrap_or_default())?;
    let (size, nose) = (part(4..6)?, part(8..10)?);
    let inscribed = |sizes| inscribed_circle(letter, size, sizes);
    let rhombus = |corner_deg, sizes| Ok::<_, String>(InsertForm::Rhombus { corner_deg, inscribed: inscribed(sizes)? });
    let form = match letter {
        'C' => rhombus(80.0, RHOMBIC_80)?,
        'D' => rhombus(55.0, RHOMBIC_55)?,
        'E' => rhombus(75.0, RHOMBIC_75)?,
        'V' => rhombus(35.0, RHOMBIC_35)?,
        'S' => rhombus(90.0, SQUARE)?,
        'T' => InsertForm::Triangle { inscribed: inscribed(TRIANGULAR)? },
        'W' => InsertForm::Trigon { inscribed: inscribed(TRIGONAL)? },
        'R' => InsertForm::Round { diameter: inscribed(ROUND)? },
        other => return Err(format!("The shape \"{other}\" is not known; C, D, E, R, S, T, V and W are.")),
    };
    let nose_radius = match form {
        InsertForm::Round { diameter } => diameter / 2.0,
        _ => nose_radius(nose)?,
    };
    Ok(IsoInsert { letter, size: size.to_owned(), form, nose_radius, clearance_deg, inside: None })
}

/// Nose radius in tenths of a millimetre.
fn nose_radius(code: &str) -> Result<f64, String> {
    let tenths = code.parse::<u8>().ok().filter(|tenths| (1..=40).contains(tenths));
    tenths.map(|tenths| f64::from(tenths) / 10.0).ok_or_else(|| {
        format!("The nose radius \"{code}\" is not known; 02, 04, 08, 12 and the like are, in tenths of a millimetre.")
    })
}

fn inscribed_circle(letter: char, size: &str, sizes: &[(&str, f64)]) -> Result<f64, String> {
    sizes.iter().find(|(code, _)| *code == size).map(|&(_, circle)| circle).ok_or_else(|| {
        let known: Vec<&str> = sizes.iter().map(|&(code, _)| code).collect();
        format!("The size \"{size}\" of shape {letter} is not known; the sizes are {}.", known.join(", "))
    })
}

fn clearance(letter: char) -> Result<f64, String> {
    const ANGLES: [(char, f64); 9] = [
        ('A', 3.0),
        ('B', 5.0),
        ('C', 7.0),
        ('D', 15.0),
        ('E', 20.0),
        ('F', 25.0),
        ('G', 30.0),
        ('N', 0.0),
        ('P', 11.0),
    ];
    ANGLES
        .iter()
        .find(|(l, _)| *l == letter)
        .map(|&(_, angle)| angle)
        .ok_or_else(|| format!("The clearance \"{letter}\" is not known; A, B, C, D, E, F, G, N and P are."))
}

/// `16ER AG60`: edge length, outside or inside, hand, range of pitches, angle of the point.
fn threading(code: &str) -> Result<IsoInsert, String> {
    let wrong = || format!("The code \"{code}\" is not understood; threading inserts read like 16ERAG60 or 16IRAG55.");
    let (size, rest) = code.split_at_checked(2).ok_or_else(wrong)?;
    let inside = match rest.chars().next() {
        Some('E') => false,
        Some('I') => true,
        _ => return Err(wrong()),
    };
    let point_deg = match rest.get(rest.len().saturating_sub(2)..) {
        Some("60") => 60.0,
        Some("55") => 55.0,
        _ => return Err(wrong()),
    };
    let inscribed = inscribed_circle(if inside { 'I' } else { 'E' }, size, TRIANGULAR)?;
    Ok(IsoInsert {
        letter: if inside { 'I' } else { 'E' },
        size: size.to_owned(),
        form: InsertForm::ThreadPoint { point_deg, inscribed },
        nose_radius: THREAD_NOSE_MM,
        clearance_deg: 0.0,
        inside: Some(inside),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_give_the_standard_dimensions() {
        let read = |code| IsoInsert::read(code).unwrap();
        let cnmg = read("CNMG120408");
        assert_eq!(cnmg.form, InsertForm::Rhombus { corner_deg: 80.0, inscribed: 12.7 });
        assert_eq!((cnmg.nose_radius, cnmg.clearance_deg), (0.8, 0.0));
        assert_eq!(read("VBMT160404-PF").form, InsertForm::Rhombus { corner_deg: 35.0, inscribed: 9.525 });
        assert_eq!(read("DCMT11T304").nose_radius, 0.4);
        assert_eq!(read("WNMG080412").form, InsertForm::Trigon { inscribed: 12.7 });
        assert_eq!(read("RCMT0803M0").nose_radius, 4.0);
        assert_eq!(read("16ER AG60").inside, Some(false));
        assert_eq!(read("16IRAG55").form, InsertForm::ThreadPoint { point_deg: 55.0, inscribed: 9.525 });
    }

    #[test]
    fn a_wrong_code_is_named() {
        for (code, word) in [
            ("XNMG120408", "shape \"X\""),
            ("CXMG120408", "clearance \"X\""),
            ("CNMG130408", "size \"13\""),
            ("CNMG1204", "too short"),
            ("CNMG1204X8", "nose radius"),
            ("16ZR AG60", "not understood"),
            ("16ER AG61", "not understood"),
            ("CNMG12ü408", "characters"),
            ("", "too short"),
        ] {
            let message = IsoInsert::read(code).unwrap_err();
            assert!(message.contains(word), "{code}: {message}");
        }
    }
}

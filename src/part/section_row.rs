//! The form in which a section stands in a file: one flat row, with nothing unknown, missing or left over.

use super::{Section, SectionKind};
use serde::{Deserialize, Serialize};

/// A row as written. Which of the last columns belong to it depends on its type.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SectionRow {
    id: u32,
    #[serde(rename = "type")]
    kind: RowType,
    z1: f64,
    d1: f64,
    z2: f64,
    d2: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pitch: Option<f64>,
    /// 1 without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    starts: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    z3: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    d3: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    chords: Option<u32>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum RowType {
    Line,
    Concave,
    Convex,
    Thread,
    ParabolaAlongZ,
    ParabolaAlongX,
}

impl SectionRow {
    const fn new(section: &Section, kind: RowType) -> Self {
        let &Section { id, z1, d1, z2, d2, .. } = section;
        Self { id, kind, z1, d1, z2, d2, radius: None, pitch: None, starts: None, z3: None, d3: None, chords: None }
    }

    /// The value of a column that the type needs.
    fn needed<T>(&self, column: &str, value: Option<T>) -> Result<T, String> {
        value.ok_or_else(|| format!("section {} is of type {:?} and has no `{column}`", self.id, self.kind))
    }

    fn kind(&self) -> Result<SectionKind, String> {
        Ok(match self.kind {
            RowType::Line => SectionKind::Line,
            RowType::Concave => SectionKind::Concave { radius: self.needed("radius", self.radius)? },
            RowType::Convex => SectionKind::Convex { radius: self.needed("radius", self.radius)? },
            RowType::Thread => {
                SectionKind::Thread { pitch: self.needed("pitch", self.pitch)?, starts: self.starts.unwrap_or(1) }
            }
            RowType::ParabolaAlongZ => {
                let (z3, d3, chords) = self.parabola()?;
                SectionKind::ParabolaAlongZ { z3, d3, chords }
            }
            RowType::ParabolaAlongX => {
                let (z3, d3, chords) = self.parabola()?;
                SectionKind::ParabolaAlongX { z3, d3, chords }
            }
        })
    }

    fn parabola(&self) -> Result<(f64, f64, u32), String> {
        Ok((self.needed("z3", self.z3)?, self.needed("d3", self.d3)?, self.needed("chords", self.chords)?))
    }

    /// A column with a value that the type does not have.
    fn left_over(&self) -> Option<(&'static str, f64)> {
        let arc = matches!(self.kind, RowType::Concave | RowType::Convex);
        let parabola = matches!(self.kind, RowType::ParabolaAlongZ | RowType::ParabolaAlongX);
        [
            ("radius", self.radius, arc),
            ("pitch", self.pitch, self.kind == RowType::Thread),
            ("starts", self.starts.map(f64::from), self.kind == RowType::Thread),
            ("z3", self.z3, parabola),
            ("d3", self.d3, parabola),
            ("chords", self.chords.map(f64::from), parabola),
        ]
        .into_iter()
        .find_map(|(column, value, belongs)| value.filter(|_| !belongs).map(|v| (column, v)))
    }
}

impl TryFrom<SectionRow> for Section {
    type Error = String;

    fn try_from(row: SectionRow) -> Result<Self, String> {
        if let Some((column, value)) = row.left_over() {
            let SectionRow { id, kind, .. } = row;
            return Err(format!(
                "section {id} is of type {kind:?}, which has no `{column}`, but `{column}` is {value}"
            ));
        }
        Ok(Self { id: row.id, z1: row.z1, d1: row.d1, z2: row.z2, d2: row.d2, kind: row.kind()? })
    }
}

impl From<Section> for SectionRow {
    fn from(section: Section) -> Self {
        let row = |kind| Self::new(&section, kind);
        match section.kind {
            SectionKind::Line => row(RowType::Line),
            SectionKind::Concave { radius } => Self { radius: Some(radius), ..row(RowType::Concave) },
            SectionKind::Convex { radius } => Self { radius: Some(radius), ..row(RowType::Convex) },
            SectionKind::Thread { pitch, starts } => {
                Self { pitch: Some(pitch), starts: (starts != 1).then_some(starts), ..row(RowType::Thread) }
            }
            SectionKind::ParabolaAlongZ { z3, d3, chords } => {
                Self { z3: Some(z3), d3: Some(d3), chords: Some(chords), ..row(RowType::ParabolaAlongZ) }
            }
            SectionKind::ParabolaAlongX { z3, d3, chords } => {
                Self { z3: Some(z3), d3: Some(d3), chords: Some(chords), ..row(RowType::ParabolaAlongX) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_as_they_were_written() {
        let kinds = [
            SectionKind::Line,
            SectionKind::Concave { radius: 0.1 },
            SectionKind::Convex { radius: 2.0 },
            SectionKind::Thread { pitch: 1.75, starts: 1 },
            SectionKind::Thread { pitch: 2.0, starts: 3 },
            SectionKind::ParabolaAlongZ { z3: 1.0, d3: -2.0, chords: 10 },
            SectionKind::ParabolaAlongX { z3: -1.0, d3: 2.0, chords: 3 },
        ];
        for kind in kinds {
            let section = Section { kind, ..Section::line(7, 0.1, 0.2, 0.3, 1.0 / 3.0) };
            let text = serde_json::to_string(&section).unwrap();
            assert_eq!(serde_json::from_str::<Section>(&text).unwrap(), section, "{text}");
        }
    }

    #[test]
    fn unknown_missing_and_left_over_columns_are_refused() {
        for (columns, word) in [
            (r#""type":"line","colour":1"#, "colour"),
            (r#""type":"convex""#, "`radius`"),
            (r#""type":"line","pitch":2"#, "`pitch` is 2"),
            (r#""type":"line","starts":2"#, "`starts` is 2"),
            (r#""type":"parabola_along_x","z3":1,"d3":2,"chords":-1"#, "-1"),
            (r#""type":"sphere""#, "sphere"),
        ] {
            let text = format!(r#"{{"id":1,"z1":0,"d1":1,"z2":2,"d2":3,{columns}}}"#);
            let error = serde_json::from_str::<Section>(&text).unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
    }
}

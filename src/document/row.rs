//! The forms in which settings with a choice stand in a file: flat, with nothing unknown or left over.

use super::{Ends, ParabolaCut};
use serde::{Deserialize, Serialize};

/// [`Ends`] as written.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EndsRow {
    count: Count,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    split: Option<f64>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Count {
    One,
    Two,
}

impl TryFrom<EndsRow> for Ends {
    type Error = String;

    fn try_from(row: EndsRow) -> Result<Self, String> {
        match (row.count, row.split) {
            (Count::One, None) => Ok(Self::One),
            (Count::One, Some(split)) => Err(format!("one end is not split, but `split` is {split}")),
            (Count::Two, split) => Ok(Self::Two { split }),
        }
    }
}

impl From<Ends> for EndsRow {
    fn from(ends: Ends) -> Self {
        match ends {
            Ends::One => Self { count: Count::One, split: None },
            Ends::Two { split } => Self { count: Count::Two, split },
        }
    }
}

/// [`ParabolaCut`] as written.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParabolaCutRow {
    r#as: CutAs,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tolerance: Option<f64>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CutAs {
    Chords,
    Arcs,
}

impl TryFrom<ParabolaCutRow> for ParabolaCut {
    type Error = String;

    fn try_from(row: ParabolaCutRow) -> Result<Self, String> {
        match (row.r#as, row.tolerance) {
            (CutAs::Chords, None) => Ok(Self::Chords),
            (CutAs::Chords, Some(t)) => Err(format!("chords have no tolerance, but `tolerance` is {t}")),
            (CutAs::Arcs, Some(tolerance)) => Ok(Self::Arcs { tolerance }),
            (CutAs::Arcs, None) => Err("arcs have no `tolerance`".to_owned()),
        }
    }
}

impl From<ParabolaCut> for ParabolaCutRow {
    fn from(cut: ParabolaCut) -> Self {
        match cut {
            ParabolaCut::Chords => Self { r#as: CutAs::Chords, tolerance: None },
            ParabolaCut::Arcs { tolerance } => Self { r#as: CutAs::Arcs, tolerance: Some(tolerance) },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_come_back_as_they_were_written() {
        for ends in [Ends::One, Ends::Two { split: None }, Ends::Two { split: Some(1.0 / 3.0) }] {
            assert_eq!(serde_json::from_str::<Ends>(&serde_json::to_string(&ends).unwrap()).unwrap(), ends);
        }
        for cut in [ParabolaCut::Chords, ParabolaCut::Arcs { tolerance: 0.01 }] {
            assert_eq!(serde_json::from_str::<ParabolaCut>(&serde_json::to_string(&cut).unwrap()).unwrap(), cut);
        }
    }

    #[test]
    fn unknown_missing_and_left_over_settings_are_refused() {
        let ends = |text| serde_json::from_str::<Ends>(text).unwrap_err().to_string();
        assert!(ends(r#"{"count":"one","split":2}"#).contains("`split` is 2"));
        assert!(ends(r#"{"count":"three"}"#).contains("three"));
        assert!(ends(r#"{"count":"two","at":3}"#).contains("`at`"));
        let cut = |text| serde_json::from_str::<ParabolaCut>(text).unwrap_err().to_string();
        assert!(cut(r#"{"as":"arcs"}"#).contains("no `tolerance`"));
        assert!(cut(r#"{"as":"chords","tolerance":0.1}"#).contains("`tolerance` is 0.1"));
    }
}

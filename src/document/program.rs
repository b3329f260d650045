//! How the programs of a part are written, as far as that is the user's choice.

use serde::{Deserialize, Serialize};

/// Choices about the programs of a part on controls that read words; others ignore them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ProgramChoices {
    /// Number of the first program, the O word; the machine's usual one without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub number: Option<u32>,
    /// Write the control's own cycles (G71, G70, G76) where it has them; otherwise every move is written.
    pub canned_cycles: bool,
    /// Let the control compensate the nose radius of finishing tools (G41, G42); otherwise it is in the path.
    pub compensated_by_control: bool,
}

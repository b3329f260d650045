//! The fields of the words that a machine's control reads. Codes and word lengths are edited in the file.

use super::field::{Group, Is, plain};
use serde_json::{Value, json};

const POINT: Is = Is::OneOf(&[("always", "always"), ("never", "never")]);
const ZEROS: Is =
    Is::OneOf(&[("keep", "all written"), ("drop-leading", "none in front"), ("drop-trailing", "none behind")]);
const CENTER: Is = Is::OneOf(&[("incremental", "I K from the start"), ("absolute", "I K from zero"), ("radius", "R")]);
const TOOL: Is = Is::OneOf(&[("TxxYY", "T0203"), ("T M6 G43", "T2 M6 G43")]);
const COMMENTS: Is = Is::OneOf(&[("parentheses", "in parentheses"), ("none", "none")]);

/// The groups of a control of words.
pub(super) const GROUPS: [Group; 3] = [
    Group {
        title: "Program words",
        optional: None,
        fields: &[
            plain("words.x_is_diameter", "X is a ⌀", Is::YesNo),
            plain("words.incremental", "Moves by U W", Is::YesNo),
            plain("words.decimal_point", "Decimal point", POINT),
            plain("words.zeros", "Zeros", ZEROS),
            plain("words.decimals_mm", "Places, mm", Is::Whole),
            plain("words.decimals_inch", "Places, inch", Is::Whole),
            plain("words.arc_center", "Arc centre", CENTER),
            plain("words.arc_center_signed", "Signed I K", Is::YesNo),
            plain("words.g2_is_ccw", "G2 turns left", Is::YesNo),
            plain("words.surface_speed", "G96", Is::YesNo),
            plain("words.feed_per_rev", "Feed per turn", Is::YesNo),
            plain("words.tool_word", "Tool word", TOOL),
        ],
    },
    Group {
        title: "Program text",
        optional: None,
        fields: &[
            plain("words.comments", "Comments", COMMENTS),
            plain("words.tape_marks", "% at the ends", Is::YesNo),
            plain("words.word_space", "Blanks", Is::YesNo),
            plain("words.canned_cycles", "G70 to G76", Is::YesNo),
            plain("words.extension", "File ending", Is::Text),
            plain("words.max_line_chars", "Longest line", Is::MaybeWhole),
            plain("words.max_program_chars", "Memory, chars", Is::MaybeWhole),
        ],
    },
    Group {
        title: "Block numbers",
        optional: Some(("words.sequence_numbers", numbers)),
        fields: &[
            plain("words.sequence_numbers.first", "First", Is::Whole),
            plain("words.sequence_numbers.step", "Step", Is::Whole),
            plain("words.sequence_numbers.digits", "Digits", Is::Whole),
        ],
    },
];

fn numbers() -> Value {
    json!({"first": 10, "step": 10, "digits": 1})
}

#[cfg(test)]
mod tests {
    use super::super::field::{get, set};
    use super::*;
    use crate::machine::{Catalog, Machine, faults};

    #[test]
    fn every_field_of_a_shipped_control_of_words_is_there_and_every_choice_is_read() {
        for machine in Catalog::shipped().machines.into_iter().filter(|m| m.words.is_some()) {
            let mut value = serde_json::to_value(&machine).unwrap();
            set(&mut value, "words.sequence_numbers", numbers());
            for field in GROUPS.iter().flat_map(|g| g.fields) {
                assert!(get(&value, field.path).is_some(), "{}: {}", machine.id, field.path);
                let Is::OneOf(words) = field.is else { continue };
                for (word, _) in words {
                    let mut chosen = value.clone();
                    set(&mut chosen, field.path, Value::from(*word));
                    serde_json::from_value::<Machine>(chosen).unwrap();
                }
            }
            assert_eq!(faults(&serde_json::from_value::<Machine>(value).unwrap()), [], "{}", machine.id);
        }
    }
}

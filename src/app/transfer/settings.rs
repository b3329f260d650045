//! The line settings, editable.

use crate::app::widgets::{Typed, choice, field, form_label};
use crate::machine::{FlowControl, Parity, SerialProfile};
use egui::Ui;

/// Width of the labels, points.
const LABEL: f32 = 86.0;

/// `2400 7O1`: the settings as people write them.
pub(super) fn brief(profile: &SerialProfile) -> String {
    let parity = match profile.parity {
        Parity::None => 'N',
        Parity::Odd => 'O',
        Parity::Even => 'E',
    };
    format!("{} {}{parity}{}", profile.baud, profile.data_bits, profile.stop_bits)
}

/// Shows the settings as a form.
pub(super) fn show(ui: &mut Ui, profile: &mut SerialProfile) {
    let baud = profile.baud.to_string();
    let read = |text: &str| {
        let baud = text.trim().parse::<u32>().ok().filter(|b| (50..=4_000_000).contains(b));
        baud.ok_or_else(|| format!("“{}” is not a speed; the line takes 50 to 4000000 baud.", text.trim()))
    };
    row(ui, "Baud", |ui, width| {
        if let Some(Typed::Left(Some(baud))) = field(ui, "Baud", &baud, width, read) {
            profile.baud = baud;
        }
    });
    let bits = [(7, "7".to_owned()), (8, "8".to_owned())];
    pick(ui, "Data bits", &mut profile.data_bits, &bits);
    let parities =
        [(Parity::None, "none"), (Parity::Odd, "odd"), (Parity::Even, "even")].map(|(p, t)| (p, t.to_owned()));
    pick(ui, "Parity", &mut profile.parity, &parities);
    pick(ui, "Stop bits", &mut profile.stop_bits, &[(1, "1".to_owned()), (2, "2".to_owned())]);
    let flows = [
        (FlowControl::None, "none".to_owned()),
        (FlowControl::Software, "DC1/DC3".to_owned()),
        (FlowControl::Hardware, "RTS/CTS".to_owned()),
    ];
    pick(ui, "Flow control", &mut profile.flow, &flows);
}

fn row(ui: &mut Ui, label: &str, content: impl FnOnce(&mut Ui, f32)) {
    ui.horizontal(|ui| {
        form_label(ui, label, LABEL);
        let width = ui.available_width();
        content(ui, width);
    });
}

fn pick<T: PartialEq + Clone>(ui: &mut Ui, label: &str, value: &mut T, all: &[(T, String)]) {
    row(ui, label, |ui, width| {
        if let Some(new) = choice(ui, label, value, all, width) {
            *value = new;
        }
    });
}

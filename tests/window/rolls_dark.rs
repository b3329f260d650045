//! The panels of a set of form-rolls in the dark theme: each is drawn, and `WINDOW_PICTURES=FOLDER` keeps what they look like.

use crate::common::Window;
use egui::Theme;
use egui_kittest::kittest::Queryable;
use turnwright::app::Pane;

#[test]
fn every_panel_of_a_set_is_drawn_in_the_dark() {
    let mut window = Window::with_theme(Theme::Dark).designed("assets/examples/u-channel.turn");
    let station = window.session().document().content.roll_set().unwrap().stations[6].id;
    window.session().selection.station = Some(station);
    window.harness.run_steps(3);
    for (pane, name) in [
        (Pane::Elements, "elements"),
        (Pane::CrossSection, "section"),
        (Pane::Flower, "flower"),
        (Pane::Station, "station"),
        (Pane::StationData, "station-data"),
        (Pane::RollEditor, "editor"),
        (Pane::RollList, "list"),
        (Pane::Charts, "strain"),
    ] {
        window.show(pane);
        window.keep_picture(&format!("dark-{name}"));
    }
    for (choice, name) in [("Springback", "springback"), ("Section", "properties")] {
        window.click(choice);
        window.keep_picture(&format!("dark-{name}"));
    }
    window.show(Pane::Angles);
    window.click("parts");
    window.click("+ Bend");
    window.harness.run_steps(4);
    window.keep_picture("dark-parts");
    window.show(Pane::Solid);
    for (choice, name) in [("line", "line"), ("station", "station"), ("roll", "roll")] {
        if window.harness.query_by_label(choice).is_some() {
            window.click(choice);
            window.harness.run_steps(3);
        }
        window.keep_picture(&format!("dark-solid-{name}"));
    }
}

//! Where the panels of each kind of document lie for a new user.

use super::Pane;
use egui_tiles::{Linear, LinearDir, TileId, Tiles};

/// All tiles and the one that holds the others.
type Places = (Tiles<Pane>, TileId);

/// Table left, profile over cut over text, inspector over transfer.
pub(super) fn part(panes: [Pane; 9]) -> Places {
    let mut tiles = Tiles::default();
    let [sections, operations, profile, cut, program, problems, solid, inspector, transfer] =
        panes.map(|p| tiles.insert_pane(p));
    let text = tiles.insert_tab_tile(vec![program, problems, solid]);
    let middle = column(&mut tiles, &[(profile, 0.385), (cut, 0.375), (text, 0.24)]);
    let right = column(&mut tiles, &[(inspector, 0.49), (transfer, 0.51)]);
    let left = column(&mut tiles, &[(sections, 0.72), (operations, 0.28)]);
    let root = row(&mut tiles, &[(left, 0.302), (middle, 0.503), (right, 0.195)]);
    (tiles, root)
}

/// Elements over angles, flower over station over charts, data of the station over the rolls.
pub(super) fn rolls(panes: [Pane; 15]) -> Places {
    let mut tiles = Tiles::default();
    let [
        elements,
        angles,
        flower,
        section,
        station,
        editor,
        cut,
        solid,
        charts,
        program,
        operations,
        problems,
        station_data,
        list,
        transfer,
    ] = panes.map(|p| tiles.insert_pane(p));
    let strip = tiles.insert_tab_tile(vec![flower, section]);
    let shape = tiles.insert_tab_tile(vec![station, solid, editor, cut]);
    let text = tiles.insert_tab_tile(vec![charts, program, operations, problems]);
    let hand = tiles.insert_tab_tile(vec![list, transfer]);
    let left = column(&mut tiles, &[(elements, 0.58), (angles, 0.42)]);
    let middle = column(&mut tiles, &[(strip, 0.31), (shape, 0.44), (text, 0.25)]);
    let right = column(&mut tiles, &[(station_data, 0.5), (hand, 0.5)]);
    let root = row(&mut tiles, &[(left, 0.285), (middle, 0.515), (right, 0.2)]);
    (tiles, root)
}

/// Data left, former and roller over the wall, the operator right.
pub(super) fn shell(panes: [Pane; 9]) -> Places {
    let mut tiles = Tiles::default();
    let [data, view, wall, rig, runs, program, problems, operator, transfer] = panes.map(|p| tiles.insert_pane(p));
    let text = tiles.insert_tab_tile(vec![wall, rig, runs, program, problems]);
    let hand = tiles.insert_tab_tile(vec![operator, transfer]);
    let middle = column(&mut tiles, &[(view, 0.58), (text, 0.42)]);
    let root = row(&mut tiles, &[(data, 0.24), (middle, 0.5), (hand, 0.26)]);
    (tiles, root)
}

fn row(tiles: &mut Tiles<Pane>, children: &[(TileId, f32)]) -> TileId {
    share(tiles, LinearDir::Horizontal, children)
}

fn column(tiles: &mut Tiles<Pane>, children: &[(TileId, f32)]) -> TileId {
    share(tiles, LinearDir::Vertical, children)
}

fn share(tiles: &mut Tiles<Pane>, dir: LinearDir, children: &[(TileId, f32)]) -> TileId {
    let mut linear = Linear::new(dir, children.iter().map(|(id, _)| *id).collect());
    for (id, share) in children {
        linear.shares.set_share(*id, *share);
    }
    tiles.insert_container(linear)
}

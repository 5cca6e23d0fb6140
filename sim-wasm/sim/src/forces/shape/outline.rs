//! Outlines: closed lines on a sheet, in layers from back to front.
//!
//! Text: the layers, joined by `;`. A layer joins its lines by `.`, and may be empty. A line is its first point,
//! `(256 x + y)` in three digits to base 64, then for each step to the next point its x and its y plus 32, one digit
//! each; x to the right, y down. `src/base/outlineText.ts` writes and checks the text. Any other text is accepted here,
//! with unfinished points left out and places beyond the sheet moved to its border.

use crate::layout::parameters::field::{OUTLINE_CHARACTERS, OUTLINE_RADIX};

/// Width and height of the sheet.
pub const SIDE: i32 = 256;
/// Maximum number of layers.
pub const MAX_LAYERS: usize = 8;

const ZERO_STEP: i32 = 32;
const LINE_END: u64 = 65;
const LAYER_END: u64 = 66;

/// A point of the sheet.
pub type Point = [i32; 2];

/// The closed lines of each layer, at most [`MAX_LAYERS`]; without layers if the outline is empty.
pub fn layers_of(numbers: &[f64]) -> Vec<Vec<Vec<Point>>> {
    let mut characters = numbers
        .iter()
        .flat_map(|number| characters_of(*number as u64))
        .peekable();
    let mut layers = Vec::new();
    if characters.peek().is_none() {
        return layers;
    }
    let mut layer = Vec::new();
    let mut digits = Vec::new();
    for character in characters.chain([LAYER_END]) {
        if character < LINE_END {
            digits.push(character as i32 - 1);
            continue;
        }
        layer.push(line_of(&digits));
        digits.clear();
        if character == LAYER_END {
            layers.push(std::mem::take(&mut layer));
        }
    }
    layers.truncate(MAX_LAYERS);
    layers
}

fn characters_of(number: u64) -> impl Iterator<Item = u64> {
    let place = move |index| number / OUTLINE_RADIX.pow(index) % OUTLINE_RADIX;
    (0..OUTLINE_CHARACTERS).map(place).filter(|character| *character > 0)
}

fn line_of(digits: &[i32]) -> Vec<Point> {
    let Some(([a, b, c], steps)) = digits.split_first_chunk() else {
        return Vec::new();
    };
    let first = (a << 12) | (b << 6) | c;
    let mut point = [(first >> 8).min(SIDE - 1), first & 255];
    let mut line = vec![point];
    for [x, y] in steps.as_chunks().0 {
        point = [on_sheet(point[0] + x - ZERO_STEP), on_sheet(point[1] + y - ZERO_STEP)];
        line.push(point);
    }
    line
}

fn on_sheet(place: i32) -> i32 {
    place.clamp(0, SIDE - 1)
}

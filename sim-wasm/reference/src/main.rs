//! Reads a scene from standard input and writes its picture to standard output: see [`scene::Scene`] and
//! [`picture::Picture::to_bytes`]. Implements the definitions of the renderer with one ray through the centre of each
//! pixel. It shares nothing with the shaders, so that the two can be compared.

mod attributes;
mod billboards;
mod bites;
mod bodies;
mod contact;
mod creases;
mod form;
mod hull;
mod ink;
mod light;
mod lobes;
mod mesh;
mod pattern;
mod picture;
mod ray;
mod scene;
mod seams;
mod shade;
mod surfaces;
mod triangles;
mod volumes;

use std::error::Error;
use std::io::{Write, stdin, stdout};

fn main() -> Result<(), Box<dyn Error>> {
    let scene: scene::Scene = serde_json::from_reader(stdin().lock())?;
    stdout().write_all(&picture::draw(&scene).to_bytes())?;
    Ok(())
}

//! Memory per particle, and that stepping does not allocate.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use common::{LIVELY, simulator, steps};
use sim::Simulator;
use sim::arrange::view_layout::ViewNumbers;

/// The system's allocator. It counts per thread, because the test harness allocates on its own thread meanwhile.
struct Counting;

thread_local! {
    static CALLS: Cell<usize> = const { Cell::new(0) };
    static BYTES: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.set(CALLS.get() + 1);
        BYTES.set(BYTES.get() + layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Bytes allocated by a new simulator.
fn bytes_of(capacity: u32) -> usize {
    let before = BYTES.get();
    let simulator = Simulator::new(capacity, 1).unwrap();
    let after = BYTES.get();
    drop(simulator);
    after - before
}

/// Views of the eye and of a light with occlusion culling, for puffs of one ball.
fn views() -> [Vec<f32>; 2] {
    let eye = ViewNumbers {
        blend: 0.3,
        cull: 1.0,
        clip_from_world: std::array::from_fn(|i| if i % 5 == 0 { 0.2 } else { 0.0 }),
        direction: [0.0, 0.0, -1.0],
        reach: 1.2,
        nearest: -100.0,
        farthest: 100.0,
        covers: 1.0,
        balls: 4.0,
        ..ViewNumbers::default()
    };
    let light = ViewNumbers {
        purpose: 1.0,
        receivers: [0.0, 0.0, 0.0, 3.0, 3.0, 3.0],
        ..eye
    };
    let ball = std::array::from_fn::<f32, 16, _>(|i| if i == 12 { 1.0 } else { 0.0 });
    [eye, light].map(|view| [&view.to_array()[..], &ball].concat())
}

#[test]
fn memory_is_taken_at_creation_only() {
    let a_particle = (bytes_of(200_000) - bytes_of(100_000)) as f64 / 100_000.0;
    assert!(a_particle <= 96.0, "{a_particle} bytes a particle");
    let fixed = bytes_of(4);
    // About 19 kB of it are the table of puff rotations for culling, independent of the number of puffs.
    assert!(fixed < 81_920, "{fixed} bytes whatever the capacity");

    let others = [
        ("shedders.0.rate", 2000.0),
        ("shedders.0.strength", 1.0),
        // Their puffs get looks within the steps; torn ones have columns of motion.
        ("emitters.0.look.drag", 2.0),
        ("emitters.1.look.dissolve", 3.0),
        ("emitters.1.tint", 3.0),
        ("emitters.2.perMetre", 100.0),
    ];
    let mut simulator = simulator(3000, 1, &[LIVELY, &[("emission.rate", 6000.0)], &others]);
    let views = views();
    let before = CALLS.get();
    for _ in 0..300 {
        steps(&mut simulator, 1);
        for view in &views {
            simulator.arrange(view).unwrap();
        }
    }
    let calls = CALLS.get() - before;
    assert!(simulator.alive() > 2900 && simulator.waiting() > 0);
    assert_eq!(simulator.vortex_particles(), 1024);
    assert!(simulator.coverage_shape()[1] > 1.0, "the grid has rows");
    assert!(simulator.look_styles()[..6].contains(&3.0), "puffs have looks");
    assert_eq!(calls, 0, "allocations in 300 steps and 600 arrangements");
    println!("{a_particle} bytes a particle and {fixed} bytes besides");
}

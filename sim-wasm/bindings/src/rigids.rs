//! Rigids of the class `Simulator`. All variants have the same API: a call that needs a larger one is an error.

use wasm_bindgen::prelude::*;

use crate::simulator::Simulator;

#[cfg(feature = "meshes")]
mod with_rigids {
    use sim::rigids::{Grab, RigidDescription, RigidNumbers, Rigids, pose_of};
    use wasm_bindgen::JsValue;

    use crate::error::parameter_error;

    pub fn add(rigids: &mut Rigids, numbers: &RigidNumbers) -> Result<u32, JsValue> {
        let description = RigidDescription::from_numbers(numbers).map_err(parameter_error)?;
        rigids.add(description).map_err(parameter_error)
    }

    pub fn move_to(rigids: &mut Rigids, index: u32, pose: &[f32]) -> Result<(), JsValue> {
        let pose = pose_of(pose).map_err(parameter_error)?;
        rigids.move_to(index, pose).map_err(parameter_error)
    }

    pub fn drag(
        rigids: &mut Rigids,
        index: u32,
        anchor: [f32; 3],
        target: [f32; 3],
        stiffness: f32,
    ) -> Result<(), JsValue> {
        let grab = Grab::from_numbers(anchor, target, stiffness).map_err(parameter_error)?;
        rigids.drag(index, grab).map_err(parameter_error)
    }

    pub fn remove(rigids: &mut Rigids, index: u32) -> Result<(), JsValue> {
        rigids.remove(index).map_err(parameter_error)
    }

    pub fn release(rigids: &mut Rigids, index: u32) -> Result<(), JsValue> {
        rigids.release(index).map_err(parameter_error)
    }
}

#[cfg(not(feature = "meshes"))]
pub fn without_rigids() -> JsValue {
    crate::error::plain_error("This simulator has no rigids: use loadSimulators({ physics: true }).")
}

#[wasm_bindgen]
impl Simulator {
    /// Adds a rigid and returns its index. See `sim::rigids::RigidNumbers` for the numbers.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = addRigid)]
    pub fn add_rigid(&mut self, numbers: &[f32], vertices: &[f32], indices: &[u32]) -> Result<u32, JsValue> {
        #[cfg(feature = "meshes")]
        return with_rigids::add(
            self.simulator.rigids_mut(),
            &sim::rigids::RigidNumbers {
                numbers,
                vertices,
                indices,
            },
        );
        #[cfg(not(feature = "meshes"))]
        Err(without_rigids())
    }

    /// Removes a rigid. A later one reuses its index.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = removeRigid)]
    pub fn remove_rigid(&mut self, index: u32) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return with_rigids::remove(self.simulator.rigids_mut(), index);
        #[cfg(not(feature = "meshes"))]
        Err(without_rigids())
    }

    /// Sends a kinematic rigid to a pose, or teleports a dynamic one: position and quaternion. Seven numbers, since an
    /// array would be copied to newly allocated memory.
    #[allow(clippy::too_many_arguments, reason = "see above")]
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = moveRigid)]
    pub fn move_rigid(
        &mut self,
        index: u32,
        x: f32,
        y: f32,
        z: f32,
        i: f32,
        j: f32,
        k: f32,
        w: f32,
    ) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return with_rigids::move_to(self.simulator.rigids_mut(), index, &[x, y, z, i, j, k, w]);
        #[cfg(not(feature = "meshes"))]
        Err(without_rigids())
    }

    /// Drags the point a, b, c of a rigid to x, y, z in world space by a spring.
    #[allow(clippy::too_many_arguments, reason = "as with moveRigid")]
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = dragRigid)]
    pub fn drag_rigid(
        &mut self,
        index: u32,
        a: f32,
        b: f32,
        c: f32,
        x: f32,
        y: f32,
        z: f32,
        stiffness: f32,
    ) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return with_rigids::drag(self.simulator.rigids_mut(), index, [a, b, c], [x, y, z], stiffness);
        #[cfg(not(feature = "meshes"))]
        Err(without_rigids())
    }

    /// Ends the drag of a rigid.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = releaseRigid)]
    pub fn release_rigid(&mut self, index: u32) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return with_rigids::release(self.simulator.rigids_mut(), index);
        #[cfg(not(feature = "meshes"))]
        Err(without_rigids())
    }

    /// Number of rigids.
    #[wasm_bindgen(getter = rigidCount)]
    pub fn rigid_count(&self) -> u32 {
        #[cfg(feature = "meshes")]
        return self.simulator.rigids().count() as u32;
        #[cfg(not(feature = "meshes"))]
        0
    }

    /// Address of the poses, 14 float32 per rigid; 0 without rigids.
    #[wasm_bindgen(getter = rigidPosesPointer)]
    pub fn rigid_poses_pointer(&self) -> u32 {
        #[cfg(feature = "meshes")]
        return self.simulator.rigids().poses().as_ptr() as u32;
        #[cfg(not(feature = "meshes"))]
        0
    }
}

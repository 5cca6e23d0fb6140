//! Live inputs: they are quantised, applied and recorded.

use crate::emission::{Births, looks};
use crate::layout::blow::{Blow, BlowNumbers};
use crate::layout::error::ParameterError;
use crate::layout::limits::check_capacity;
use crate::math::hash::Hash;
use crate::simulator::Simulator;
use crate::simulator::take::input::Input;
use crate::simulator::take::origin::Origin;
use crate::simulator::take::recorder::Recorder;

impl Simulator {
    /// Starts a take at the current state. All later inputs are recorded.
    pub fn record(&mut self) {
        self.active_inputs.done = 0;
        self.recorder = Recorder::new(origin_of(self), Default::default(), self.steps);
    }

    /// Restarts the take after a change that the log cannot represent.
    pub(crate) fn begin_take_anew(&mut self) {
        self.active_inputs.done = 0;
        if self.recorder.is_on() {
            self.record();
        }
    }

    /// Sets all parameters in `entries`, or none of them if one is invalid.
    pub fn input_values(&mut self, entries: &[(&str, f64)]) -> Result<(), ParameterError> {
        self.changed_parameters(entries)?;
        for (key, value) in entries {
            let key = self.recorder.log.number_of(key);
            self.apply_input(Input::Set { key, value: *value })?;
        }
        Ok(())
    }

    /// Sets the maximum number of particles. See [`Simulator::resize`].
    pub fn input_capacity(&mut self, capacity: u32) -> Result<(), ParameterError> {
        check_capacity(capacity)?;
        self.apply_input(Input::Resize { capacity })
    }

    /// Sends a kinematic rigid to a pose, or teleports a dynamic one. `numbers`: x, y, z (m, rounded to millimetres)
    /// and the quaternion x, y, z, w.
    #[cfg(feature = "meshes")]
    pub fn input_pose(&mut self, rigid: u32, numbers: [f64; 7]) -> Result<(), ParameterError> {
        let pose = crate::layout::quantised::QuantisedPose::new(numbers)?;
        // An index too large for the log belongs to no rigid and is an error here.
        self.rigids.check_movable(rigid)?;
        let rigid = rigid as u16;
        self.apply_input(Input::Move { rigid, pose })
    }

    /// Drags a point of a rigid by a spring. `numbers`: the point x, y, z in the rigid's space (m), the target x, y, z
    /// in world space (m), the stiffness (1/s). See [`crate::rigids::Rigids::drag`].
    #[cfg(feature = "meshes")]
    pub fn input_drag(&mut self, rigid: u32, numbers: [f64; 7]) -> Result<(), ParameterError> {
        let grip = crate::layout::quantised::Grip::new(numbers)?;
        self.rigids.check_exists(rigid)?;
        let rigid = rigid as u16;
        self.apply_input(Input::Drag { rigid, grip })
    }

    /// Ends the drag of a rigid.
    #[cfg(feature = "meshes")]
    pub fn input_release(&mut self, rigid: u32) -> Result<(), ParameterError> {
        self.rigids.check_exists(rigid)?;
        let rigid = rigid as u16;
        self.apply_input(Input::Release { rigid })
    }

    /// Sets channel 0..=7 to a value in -1..=1.
    pub fn input_steer(&mut self, channel: u32, value: f64) -> Result<(), ParameterError> {
        self.apply_input(Input::steer(channel, value)?)
    }

    /// Starts a gust.
    pub fn input_blow(&mut self, numbers: &BlowNumbers) -> Result<(), ParameterError> {
        self.apply_input(Input::Blow(Blow::new(numbers)?))
    }

    /// Removes all particles, and the births that wait. Emitters keep the fractions that they owe.
    pub fn input_clear(&mut self) -> Result<(), ParameterError> {
        self.apply_input(Input::Clear)
    }

    /// Starts an emission, or changes one. Returns its number; none if all slots are taken, or if the one to change is over.
    /// See [`crate::emission::Births::emission`].
    pub fn input_emission(&mut self, numbers: &[f64], changed: Option<u64>) -> Result<Option<u64>, ParameterError> {
        let Some(emission) = self.births.emission(numbers, changed, self.steps)? else {
            return Ok(None);
        };
        if emission.is_long() {
            let changed = Some(emission.emitter());
            looks::needs(&self.parameters, &self.births, &self.particles, self.steps, changed)?;
        }
        let number = emission.number();
        self.apply_input(Input::Emit(Box::new(emission)))?;
        Ok(Some(number))
    }

    /// Value of a channel set by `input_steer`, -1..=1. 0 initially, and for an index out of range.
    pub fn control(&self, channel: u32) -> f32 {
        self.active_inputs.control(channel as usize)
    }

    /// Number of inputs of the take that were applied, and number that it holds.
    pub fn inputs(&self) -> (u32, u32) {
        (self.active_inputs.done, self.recorder.log.len() as u32)
    }

    /// Returns true if inputs exceeded the capacity of the take.
    pub fn is_truncated(&self) -> bool {
        self.recorder.log.is_truncated()
    }

    /// Number of steps at the farthest point of the take.
    pub fn end(&self) -> u64 {
        self.recorder.end
    }

    fn apply_input(&mut self, input: Input) -> Result<(), ParameterError> {
        self.with_log(|simulator, recorder| {
            simulator.perform(&input, &recorder.log)?;
            if recorder.is_on() {
                recorder.end = simulator.steps;
                recorder.log.cut(simulator.active_inputs.done as usize);
                recorder.log.push(simulator.steps, input);
                simulator.active_inputs.done = recorder.log.len() as u32;
            }
            Ok(())
        })
    }

    /// Applies the inputs of the log that are due.
    pub(crate) fn apply_due_inputs(&mut self) {
        self.recorder.end = self.recorder.end.max(self.steps);
        if self
            .recorder
            .next(&self.active_inputs)
            .is_none_or(|record| record.step > self.steps)
        {
            return;
        }
        self.with_log(|simulator, recorder| {
            while let Some(record) = recorder.next(&simulator.active_inputs)
                && record.step <= simulator.steps
            {
                // A forged take may move a rigid that cannot be moved; the error is ignored on every machine alike.
                let _ = simulator.perform(&record.input, &recorder.log);
                simulator.active_inputs.done += 1;
            }
        });
    }

    fn perform(&mut self, input: &Input, log: &crate::simulator::take::log::Log) -> Result<(), ParameterError> {
        match input {
            Input::Set { key, value } => {
                let changed = self.parameters.changed(&[(log.key(*key), *value)])?;
                self.put_parameters(&changed);
                Ok(())
            }
            Input::Resize { capacity } => self.resize(*capacity),
            #[cfg(feature = "meshes")]
            Input::Move { rigid, pose } => {
                let pose = crate::rigids::pose_of(&pose.numbers())?;
                self.rigids.move_to(u32::from(*rigid), pose)
            }
            #[cfg(feature = "meshes")]
            Input::Drag { rigid, grip } => {
                let (anchor, target, stiffness) = grip.numbers();
                let grab = crate::rigids::Grab::from_numbers(anchor, target, stiffness)?;
                self.rigids.drag(u32::from(*rigid), grab)
            }
            #[cfg(feature = "meshes")]
            Input::Release { rigid } => self.rigids.release(u32::from(*rigid)),
            #[cfg(not(feature = "meshes"))]
            Input::Move { .. } | Input::Drag { .. } | Input::Release { .. } => Ok(()),
            Input::Steer { channel, value } => {
                self.active_inputs.steer(*channel, *value);
                Ok(())
            }
            Input::Blow(blow) => {
                self.active_inputs.blow(*blow);
                Ok(())
            }
            Input::Clear => {
                self.particles.set_alive(0);
                self.births.forget_waiting();
                Ok(())
            }
            Input::Emit(emission) => {
                self.put_emission(emission);
                Ok(())
            }
        }
    }

    /// Borrows the recorder and the rest of the simulator at the same time.
    fn with_log<T>(&mut self, action: impl FnOnce(&mut Self, &mut Recorder) -> T) -> T {
        let mut recorder = std::mem::take(&mut self.recorder);
        let result = action(self, &mut recorder);
        self.recorder = recorder;
        result
    }
}

/// The state of `simulator` as the origin of a take.
pub(super) fn origin_of(simulator: &Simulator) -> Origin {
    Origin {
        state: simulator.save(),
        is_fresh: simulator.steps == 0
            && simulator.alive() == 0
            && simulator.active_inputs.is_nothing()
            && simulator.births == Births::default(),
        scene: scene_of(simulator),
        seed: simulator.seed,
        capacity: simulator.capacity() as u32,
        step: simulator.steps,
        parameters: simulator.parameters,
    }
}

fn scene_of(simulator: &Simulator) -> u64 {
    let mut hash = Hash::new();
    simulator.colliders.hash_into(&mut hash);
    #[cfg(feature = "meshes")]
    simulator.rigids.hash_into(&mut hash);
    simulator.surfaces.hash_into(&mut hash);
    hash.finish()
}

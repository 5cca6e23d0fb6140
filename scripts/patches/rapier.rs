//! A patch of Rapier, compiled into `sim-wasm/xtask`: removes functions that it runs only for soft bodies, multibodies or
//! unsupported shapes. The linker cannot know that there are none: they are a sixth of the module. The build fails if
//! Rapier or the compiler has other names for them.

use anyhow::{Result, bail};
use walrus::{FunctionBuilder, FunctionId, FunctionKind, LocalFunction, Module};

/// Parts of the names of functions that are called with a soft body, one of its constraints, a multibody or such a
/// shape. Their new body traps, so that nothing continues with wrong results.
const CALLED_WITH_ONE: &[&str] = &[
    "soft_body..soft_body..SoftBody$GT$",
    "SoftBodySet$GT$4tear",
    "SoftBodySet$GT$13split_cluster",
    "soft_body14collision_mesh",
    "soft_body17soft_body_builder",
    "soft_body17soft_body_cluster",
    "soft_constraint23soft_element_constraint",
    "SoftConstraintsSet$GT$22solve_color_constraint",
    "SoftConstraintsSet$GT$19solve_contact_chunk",
    "soft_contact_assembly_edge_contacts",
    "soft_contact_assembly_vertex_contacts",
    "soft_contact_assembly_volume_constraints",
    "soft_contacts_classify",
    "soft_contacts_edge_pass",
    "soft_contacts_vertex_pass",
    "soft_contacts_volume",
    "9multibody9Multibody",
    "contact_heightfield_shape",
    "contact_manifolds_heightfield",
    "contact_manifolds_voxels",
    "heightfield3..HeightField",
    "12heightfield311HeightField",
    "point_round_shape",
    "polyline..Polyline",
    "ray_round_shape",
    "shape_cast_heightfield",
    "shape_cast_voxels",
    "voxels..Voxels",
    "6voxels6Voxels",
];

/// Called in each step; returns immediately without an awake soft body.
const RETURNS_AT_ONCE: &[&str] = &["SoftConstraintsSet$GT$17assemble_contacts17h"];

/// Minimum size in instructions. Smaller functions stay: the compiler merges equal ones under any of their names.
const MIN_SIZE: u64 = 100;

/// Returns the module without these functions.
///
/// # Errors
/// When the bytes are no module, or when none of its functions has one of the names: after a change of Rapier or of the
/// compiler the lists want to be looked at.
pub fn trim(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut module = Module::from_buffer(bytes)?;
    for part in CALLED_WITH_ONE {
        empty(&mut module, part, |body| {
            body.unreachable();
        })?;
    }
    for part in RETURNS_AT_ONCE {
        empty(&mut module, part, |_| ())?;
    }
    walrus::passes::gc::run(&mut module);
    Ok(module.emit_wasm())
}

/// Replaces the body of each larger function with this part in its name.
fn empty(module: &mut Module, part: &str, fill: impl Fn(&mut walrus::InstrSeqBuilder)) -> Result<()> {
    let found: Vec<FunctionId> = module
        .funcs
        .iter_local()
        .filter(|(id, function)| {
            let name = module.funcs.get(*id).name.as_deref().unwrap_or_default();
            name.contains(part) && !name.contains("drop_in_place") && function.size() >= MIN_SIZE
        })
        .map(|(id, _)| id)
        .collect();
    if found.is_empty() {
        bail!("no function has {part} in its name: update scripts/patches/rapier.rs");
    }
    for id in found {
        let body = body_like(module, id, &fill);
        module.funcs.get_mut(id).kind = FunctionKind::Local(body);
    }
    Ok(())
}

/// Another function of the same type.
fn body_like(module: &mut Module, id: FunctionId, fill: impl Fn(&mut walrus::InstrSeqBuilder)) -> LocalFunction {
    let ty = module.types.get(module.funcs.get(id).ty());
    let (parameters, results) = (ty.params().to_vec(), ty.results().to_vec());
    let arguments = parameters.iter().map(|ty| module.locals.add(*ty)).collect();
    let mut builder = FunctionBuilder::new(&mut module.types, &parameters, &results);
    fill(&mut builder.func_body());
    builder.local_func(arguments)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_without_one_of_the_functions_is_an_error() {
        let mut module = Module::default();
        let message = trim(&module.emit_wasm()).unwrap_err().to_string();
        assert!(message.contains(CALLED_WITH_ONE[0]), "{message}");
    }

    #[test]
    fn smaller_functions_with_the_name_do_not_count() {
        let mut module = Module::default();
        let mut builder = FunctionBuilder::new(&mut module.types, &[], &[]);
        builder.name(CALLED_WITH_ONE[0].to_owned());
        builder.func_body().unreachable();
        let small = builder.finish(vec![], &mut module.funcs);
        module.exports.add("small", small);
        assert!(trim(&module.emit_wasm()).is_err());
    }
}

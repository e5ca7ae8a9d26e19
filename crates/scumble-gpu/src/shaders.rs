//! The shaders, each with the shared pieces before it.

use crate::wgsl::wgsl;

/// What all of them begin with.
const COMMON: &str = wgsl!("common");

/// Draws the triangles of a colour field.
pub(crate) const FIELD: [&str; 2] = [COMMON, wgsl!("field")];
/// Draws flat shapes.
pub(crate) const SHAPE: [&str; 2] = [COMMON, wgsl!("shape")];
/// Looks up what the grid solver found.
pub(crate) const SEEN: &str = wgsl!("seen");
/// Covers a target.
pub(crate) const TARGET: &str = wgsl!("target");
/// Draws what the grid solver found.
pub(crate) const SOLUTION: [&str; 4] = [COMMON, SEEN, TARGET, wgsl!("solution")];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::computing::{computed, program_text};
    use crate::grid::kernels::{BORDER, POINTS, SOURCES, drawn};
    use crate::grid::texels::{FORMAT, HALF_FORMAT};
    use naga::ShaderStage::{Fragment, Vertex};
    use naga::back::glsl;
    use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

    const SCENE: [(&str, &[&str]); 5] = [
        ("field.wgsl", &FIELD),
        ("shape.wgsl", &SHAPE),
        ("solution.wgsl", &SOLUTION),
        ("points", &[POINTS]),
        ("border", &BORDER),
    ];

    /// Pieces of the grid solver's kernels that are none themselves.
    const PIECES: [&str; 15] = [
        "block", "compute", "draw", "floats", "given", "halves", "level", "links", "load", "matrix",
        "merged", "parent", "pass", "program", "unknowns",
    ];

    /// The kernels, made for both formats in some way.
    fn kernels(
        way: impl Fn(wgpu::TextureFormat) -> [&'static str; 3],
    ) -> impl Iterator<Item = (&'static str, String)> {
        let ways = [FORMAT, HALF_FORMAT].map(way).into_iter();
        ways.flat_map(|way| SOURCES.iter().map(move |source| (source.name, source.text(&way))))
    }

    fn all() -> impl Iterator<Item = (&'static str, String)> {
        let scene = SCENE.into_iter().map(|(name, pieces)| (name, pieces.concat()));
        scene.chain(kernels(drawn))
    }

    fn validated(name: &str, source: &str) -> (naga::Module, ModuleInfo) {
        let module = naga::front::wgsl::parse_str(source)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(source)));
        let info = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32)
            .validate(&module)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(source)));
        (module, info)
    }

    fn webgl_source(
        module: &naga::Module,
        info: &ModuleInfo,
        stage: naga::ShaderStage,
        entry: &str,
    ) -> String {
        let options = glsl::Options { version: glsl::Version::new_gles(300), ..Default::default() };
        let pipeline =
            glsl::PipelineOptions { shader_stage: stage, entry_point: entry.to_owned(), multiview: None };
        let mut text = String::new();
        let bounds = naga::proc::BoundsCheckPolicies::default();
        glsl::Writer::new(&mut text, module, info, &options, &pipeline, bounds)
            .and_then(|mut writer| writer.write())
            .unwrap_or_else(|error| panic!("{entry}: {error}"));
        text
    }

    #[test]
    fn every_shader_is_valid_and_can_be_said_in_webgl() {
        for (name, source) in all() {
            let (module, info) = validated(name, &source);
            for (stage, entry) in [(Vertex, "vertex"), (Fragment, "fragment")] {
                assert!(webgl_source(&module, &info, stage, entry).contains("void main()"), "{name}");
            }
        }
    }

    #[test]
    fn every_kernel_can_be_computed() {
        for (name, source) in kernels(computed).chain([("program", program_text())]) {
            let (module, _) = validated(name, &source);
            assert_eq!(module.entry_points[0].stage, naga::ShaderStage::Compute, "{name}");
        }
    }

    #[test]
    fn uniforms_have_the_sizes_that_webgl_takes() {
        for (name, source) in all() {
            let (module, _) = validated(name, &source);
            let uniforms =
                module.global_variables.iter().filter(|(_, v)| v.space == naga::AddressSpace::Uniform);
            for (_, uniform) in uniforms {
                assert_eq!(module.types[uniform.ty].inner.size(module.to_ctx()) % 16, 0, "{name}");
            }
        }
    }

    fn files(folder: &str) -> Vec<String> {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shaders").join(folder);
        let mut names: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".wgsl"))
            .collect();
        names.sort();
        names
    }

    #[test]
    fn every_shader_file_is_used() {
        assert_eq!(
            files(""),
            ["common.wgsl", "field.wgsl", "seen.wgsl", "shape.wgsl", "solution.wgsl", "target.wgsl"]
        );
        let mut names: Vec<_> =
            SOURCES.iter().map(|source| source.name).chain(PIECES).chain(["border", "points"]).collect();
        names.sort();
        assert_eq!(files("grid"), names.iter().map(|name| format!("{name}.wgsl")).collect::<Vec<_>>());
    }
}

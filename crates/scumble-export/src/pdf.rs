//! A picture as PDF 1.4 (Adobe, third edition of the reference): shades as free-form triangle meshes, all else as paths.

mod content;
mod objects;
mod shading;

use crate::export::Export;
use crate::mesh::{Linear, linear};
use crate::numbers::number;
use objects::{Objects, reference};
use shading::Channels;

/// Points (of 1/72 inch) in a pixel (of 1/96).
const PT_PER_PX: f64 = 0.75;

/// Operators that show the shades: as they are, and where they fade.
const SHADES: &str = "/S sh\n";
const FADING_SHADES: &str = "/F gs\n/S Do\n/O gs\n";

/// What the operators of a page name: entries of dictionaries.
#[derive(Debug, Default)]
struct Resources {
    shadings: String,
    forms: String,
    states: String,
}

/// The document.
pub(crate) fn written(export: &Export) -> Vec<u8> {
    let page = Page::new(export);
    let mesh = linear(&export.regions.smooth, &export.tint);
    let mut objects = Objects::default();
    let mut resources = Resources::default();
    let shades = if mesh.is_empty() { "" } else { add_shades(&mut objects, &mesh, &page, &mut resources) };
    let content = content::of(export, &page, shades, &mut resources.states);
    let content = objects.stream("", content.as_bytes());
    page.finish(objects, &resources, content)
}

/// Adds what shows a mesh, and gives the operators that do.
fn add_shades(
    objects: &mut Objects,
    mesh: &[Linear],
    page: &Page,
    resources: &mut Resources,
) -> &'static str {
    let colors = shading::add(objects, mesh, Channels::Colors);
    let fades = mesh.iter().any(|part| part.colors.iter().any(|[.., alpha]| *alpha < 1.0));
    if !fades {
        resources.shadings = ["/S ", &reference(colors)].concat();
        return SHADES;
    }
    let alphas = shading::add(objects, mesh, Channels::Alpha);
    let mask = add_group(objects, alphas, "/DeviceGray", page);
    // A group: so a pixel that several triangles touch fades but once.
    let group = add_group(objects, colors, "/DeviceRGB", page);
    resources.forms = ["/S ", &reference(group)].concat();
    let mask = ["<</SMask <</S /Luminosity /G ", &reference(mask), ">>>>"].concat();
    resources.states = ["/F ", &mask, " /O <</SMask /None>>"].concat();
    FADING_SHADES
}

/// Adds a transparency group that shows a shading.
fn add_group(objects: &mut Objects, shading: usize, space: &str, page: &Page) -> usize {
    let [width, height] = page.size_du.map(number);
    let frame = ["/Type /XObject /Subtype /Form /BBox [0 0 ", &width, " ", &height, "]"].concat();
    let group = [" /Group <</S /Transparency /I true /CS ", space, ">>"].concat();
    let resources = [" /Resources <</Shading <</S ", &reference(shading), ">>>>"].concat();
    objects.stream(&[frame, group, resources].concat(), SHADES.as_bytes())
}

/// The page in points.
struct Page {
    size_pt: [f64; 2],
    size_du: [f64; 2],
    pt_per_du: f64,
}

impl Page {
    fn new(export: &Export) -> Self {
        let sheet = export.sheet();
        Self {
            size_pt: sheet.sides_px.map(|side| PT_PER_PX * side),
            size_du: sheet.sides_du(),
            pt_per_du: PT_PER_PX * sheet.px_per_du,
        }
    }

    /// The file with this page alone.
    fn finish(&self, mut objects: Objects, resources: &Resources, content: usize) -> Vec<u8> {
        let [width, height] = self.size_pt.map(number);
        let pages = objects.next() + 1;
        let page = objects.add(&[
            "<</Type /Page /Parent ",
            &reference(pages),
            " /MediaBox [0 0 ",
            &width,
            " ",
            &height,
            "] /Group <</S /Transparency /CS /DeviceRGB>> /Resources <</Shading <<",
            &resources.shadings,
            ">> /XObject <<",
            &resources.forms,
            ">> /ExtGState <<",
            &resources.states,
            ">>>> /Contents ",
            &reference(content),
            ">>",
        ]);
        let pages = objects.add(&["<</Type /Pages /Count 1 /Kids [", &reference(page), "]>>"]);
        let catalog = objects.add(&["<</Type /Catalog /Pages ", &reference(pages), ">>"]);
        objects.finish(catalog)
    }
}

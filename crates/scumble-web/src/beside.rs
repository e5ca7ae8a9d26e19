//! The renderer of the other build, in a module of its own: where WebGPU is given up, the session stays in its module, and what
//! there is to paint goes to WebGL 2 as bytes.

/// What a painter beside is told of the view: the affine map, width and height in pixels, and the paper as 0xrrggbb or -1.
type ViewNumbers = [f64; 9];

#[cfg(feature = "webgpu")]
mod asked {
    use scumble_core::Srgb8;
    use scumble_solve::{Shape, View};
    use wasm_bindgen::prelude::wasm_bindgen;

    use super::ViewNumbers;
    use crate::painting::{Changed, Painting};

    fn numbers_of(view: &View, paper: Option<Srgb8>) -> ViewNumbers {
        let [a, b, c, d, e, f] = view.px_from_du.as_coeffs();
        let paper = paper.map_or(-1.0, |Srgb8([r, g, b])| f64::from(u32::from_be_bytes([0, r, g, b])));
        [a, b, c, d, e, f, view.width_px.into(), view.height_px.into(), paper]
    }

    #[wasm_bindgen]
    extern "C" {
        /// A painter of the other module.
        #[derive(Debug)]
        pub type Beside;

        #[wasm_bindgen(method)]
        fn paint(
            this: &Beside,
            field: Option<&[u8]>,
            scribbles: Option<&[u8]>,
            ink: Option<&[u8]>,
            view: &[f64],
        );
    }

    impl Beside {
        /// Has it paint what has changed.
        pub(crate) fn show(&self, painting: &Painting<'_>, changed: Changed) {
            let Painting { field, layers, view, paper, .. } = painting;
            let field = changed.field.then(|| field.to_bytes());
            let scribbles = changed.scribbles.then(|| Shape::all_to_bytes(layers.scribbles()));
            let ink = changed.ink.then(|| Shape::all_to_bytes(layers.ink()));
            let [field, scribbles, ink] = [&field, &scribbles, &ink].map(Option::as_deref);
            self.paint(field, scribbles, ink, &numbers_of(view, *paper));
        }
    }
}

#[cfg(feature = "webgpu")]
pub use asked::Beside;

#[cfg(feature = "webgl")]
mod asking {
    use kurbo::Affine;
    use scumble_core::Srgb8;
    use scumble_gpu::{GpuError, Layer};
    use scumble_solve::{Field, Shape, View};
    use wasm_bindgen::JsError;
    use wasm_bindgen::prelude::wasm_bindgen;
    use web_sys::{HtmlCanvasElement, console};

    use super::ViewNumbers;
    use crate::screen::GpuScreen;

    fn view_of([a, b, c, d, e, f, width_px, height_px, paper]: ViewNumbers) -> (View, Option<Srgb8>) {
        // Casts keep within the range of their types.
        let view = View {
            px_from_du: Affine::new([a, b, c, d, e, f]),
            width_px: (width_px as u32).max(1),
            height_px: (height_px as u32).max(1),
        };
        let [_, r, g, b] = (paper as u32).to_be_bytes();
        (view, (paper >= 0.0).then_some(Srgb8([r, g, b])))
    }

    /// A painter for the module of the other build. That its context is lost, the canvas tells.
    #[wasm_bindgen]
    #[derive(Debug)]
    pub struct Beside(GpuScreen);

    #[wasm_bindgen]
    impl Beside {
        /// Claims a canvas.
        ///
        /// # Errors
        /// When the renderer does not start here.
        pub async fn create(canvas: HtmlCanvasElement) -> Result<Beside, JsError> {
            let warn = |error: GpuError| console::warn_1(&error.to_string().into());
            Ok(Self(GpuScreen::open(canvas, warn).await?))
        }

        /// Paints what a view shows (see [`super::ViewNumbers`]); what it is not given stays as it was.
        pub fn paint(
            &mut self,
            field: Option<Vec<u8>>,
            scribbles: Option<Vec<u8>>,
            ink: Option<Vec<u8>>,
            view: &[f64],
        ) {
            if let Some(field) = field.and_then(|bytes| Field::from_bytes(&bytes)) {
                self.0.set_field(&field);
            }
            for (layer, bytes) in [(Layer::Scribbles, scribbles), (Layer::Ink, ink)] {
                if let Some(shapes) = bytes.and_then(|bytes| Shape::all_from_bytes(&bytes)) {
                    self.0.set_shapes(layer, &shapes);
                }
            }
            if let Ok(numbers) = view.try_into() {
                let (view, paper) = view_of(numbers);
                self.0.show(&view, paper);
            }
        }
    }
}

#[cfg(feature = "webgl")]
pub use asking::Beside;

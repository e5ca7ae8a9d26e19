//! The renderer of the other build, in a module of its own: where WebGPU is given up, the session stays in its module, and what
//! there is to paint goes to WebGL 2 as bytes.

use kurbo::Affine;
use scumble_core::Srgb8;
use scumble_solve::View;

/// A view as numbers: the affine map, width and height in pixels, and the paper as 0xrrggbb or -1.
pub fn numbers_of(view: &View, paper: Option<Srgb8>) -> [f64; 9] {
    let [a, b, c, d, e, f] = view.px_from_du.as_coeffs();
    let paper = paper.map_or(-1.0, |Srgb8([r, g, b])| f64::from(u32::from_be_bytes([0, r, g, b])));
    [a, b, c, d, e, f, view.width_px.into(), view.height_px.into(), paper]
}

/// The view and the paper of such numbers.
pub fn view_of([a, b, c, d, e, f, width_px, height_px, paper]: [f64; 9]) -> (View, Option<Srgb8>) {
    let px_from_du = Affine::new([a, b, c, d, e, f]);
    // A cast keeps within the range of its type.
    let [width_px, height_px] = [width_px, height_px].map(|size| (size as u32).max(1));
    let [_, r, g, b] = (paper as u32).to_be_bytes();
    (View { px_from_du, width_px, height_px }, (paper >= 0.0).then_some(Srgb8([r, g, b])))
}

#[cfg(all(target_arch = "wasm32", feature = "webgpu"))]
/// In the module that has the session.
mod asked {
    use scumble_solve::Shape;
    use wasm_bindgen::JsValue;
    use wasm_bindgen::prelude::wasm_bindgen;

    use super::numbers_of;
    use crate::painting::{Changed, Painting};

    #[wasm_bindgen]
    extern "C" {
        /// A painter of the other module.
        #[derive(Debug)]
        pub type Beside;

        #[wasm_bindgen(method, catch)]
        fn paint(
            this: &Beside,
            field: Option<&[u8]>,
            scribbles: Option<&[u8]>,
            ink: Option<&[u8]>,
            view: &[f64],
        ) -> Result<(), JsValue>;

        #[wasm_bindgen(method, catch)]
        fn free(this: &Beside) -> Result<(), JsValue>;
    }

    /// The painter of the other module, which is freed with this.
    #[derive(Debug)]
    pub struct BesideScreen {
        painter: Beside,
        on_failure: fn(),
    }

    impl BesideScreen {
        /// What the page has of it; `on_failure` is called when it fails.
        pub fn new(painter: Beside, on_failure: fn()) -> Self {
            Self { painter, on_failure }
        }

        /// Has it paint what has changed.
        pub(crate) fn show(&self, painting: &Painting<'_>, changed: Changed) {
            let Painting { field, layers, view, paper, .. } = painting;
            let field = changed.field.is_any().then(|| field.to_bytes());
            let scribbles = changed.scribbles.then(|| Shape::all_to_bytes(layers.scribbles()));
            let ink = changed.ink.then(|| Shape::all_to_bytes(layers.ink()));
            let [field, scribbles, ink] = [&field, &scribbles, &ink].map(Option::as_deref);
            if self.painter.paint(field, scribbles, ink, &numbers_of(view, *paper)).is_err() {
                (self.on_failure)();
            }
        }
    }

    impl Drop for BesideScreen {
        fn drop(&mut self) {
            // One that has failed cannot be freed.
            let _ = self.painter.free();
        }
    }
}

#[cfg(all(target_arch = "wasm32", feature = "webgpu"))]
pub use asked::{Beside, BesideScreen};

#[cfg(all(target_arch = "wasm32", feature = "webgl"))]
/// In the module that paints for it.
mod asking {
    use std::cell::RefCell;

    use js_sys::Function;
    use scumble_gpu::{GpuError, Layer};
    use scumble_solve::{Field, FieldChange, Shape};
    use wasm_bindgen::prelude::wasm_bindgen;
    use wasm_bindgen::{JsError, JsValue};
    use web_sys::{HtmlCanvasElement, console};

    use super::view_of;
    use crate::screen::GpuScreen;

    thread_local! {
        /// What the last painter calls when its device fails: callbacks of the GPU may own nothing of JavaScript.
        static LOST: RefCell<Option<Function>> = const { RefCell::new(None) };
    }

    /// A painter for the module of the other build.
    #[wasm_bindgen]
    #[derive(Debug)]
    pub struct Beside(GpuScreen);

    #[wasm_bindgen]
    impl Beside {
        /// Claims a canvas. `lost` is called when its device fails, maybe in the middle of painting.
        ///
        /// # Errors
        /// When the renderer does not start here.
        pub async fn create(canvas: HtmlCanvasElement, lost: Function) -> Result<Beside, JsError> {
            std::panic::set_hook(Box::new(|panic| console::error_1(&panic.to_string().into())));
            LOST.set(Some(lost));
            Ok(Self(GpuScreen::open(canvas, tell).await?))
        }

        /// Paints what a view shows (see [`super::numbers_of`]); what it is not given stays as it was.
        ///
        /// # Errors
        /// For bytes or numbers that are none of these.
        pub fn paint(
            &mut self,
            field: Option<Vec<u8>>,
            scribbles: Option<Vec<u8>>,
            ink: Option<Vec<u8>>,
            view: &[f64],
        ) -> Result<(), JsError> {
            if let Some(field) = field {
                let field = Field::from_bytes(&field).ok_or_else(wrong)?;
                self.0.set_field(&field, &FieldChange::ALL);
            }
            for (layer, shapes) in [(Layer::Scribbles, scribbles), (Layer::Ink, ink)] {
                if let Some(shapes) = shapes {
                    self.0.set_shapes(layer, &Shape::all_from_bytes(&shapes).ok_or_else(wrong)?);
                }
            }
            let (view, paper) = view_of(view.try_into().map_err(|_| wrong())?);
            self.0.show(&view, paper);
            Ok(())
        }
    }

    fn wrong() -> JsError {
        JsError::new("what is to be painted is damaged")
    }

    fn tell(error: GpuError) {
        console::warn_1(&error.to_string().into());
        LOST.with_borrow(|lost| {
            if let Some(lost) = lost {
                // The page's function asks for an animation frame; that it throws would be its own fault to report.
                let _ = lost.call0(&JsValue::NULL);
            }
        });
    }
}

#[cfg(all(target_arch = "wasm32", feature = "webgl"))]
pub use asking::Beside;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_come_back_from_their_numbers() {
        let px_from_du = Affine::new([0.5, 0.25, -0.25, 0.5, 1e6, -0.1]);
        for paper in [None, Some(Srgb8([0; 3])), Some(Srgb8([255, 128, 1]))] {
            let view = View { px_from_du, width_px: 16_384, height_px: 1 };
            assert_eq!(view_of(numbers_of(&view, paper)), (view, paper));
        }
    }
}

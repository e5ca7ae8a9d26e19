//! All that is derived from a document: map, labels, colour points, field. Kept, and redone where the source
//! changed.

use std::mem;
use std::sync::Arc;

use kurbo::Rect;
use scumble_core::pace::{Slices, now};
use scumble_core::{
    Bends, Boundary, ColorPoint, Document, Drawing, Engine, KnownBoundary, Labels, MapError, PlanarMap,
    Sampling, Scribble, Settings,
};

use crate::field::{EVERYWHERE, Field, FieldChange};
use crate::mesh::{MeshSolver, Once, SolveError};

/// Up to here nobody sees that pieces of a curve are chords of it.
const CLOSE_PX_PER_DU: f64 = 3.0;

/// Largest distance of an edge from its curve, where it is seen from closer by.
const CHORD_PX: f64 = 0.1;

/// The picture of one drawing under changing scribbles.
///
/// The stages are [`Picture::new`] (map), [`Picture::mesh`], [`Picture::color`] and the solver's own; a caller
/// that does not care calls [`Picture::update`]. What is called an *-ing* does the same in slices; a picture that was not
/// let finish it is of no use.
#[derive(Debug)]
pub struct Picture {
    map: PlanarMap,
    /// The engine and the settings that it was made for.
    engine: Box<dyn Engine>,
    settings: Settings,
    boundary: KnownBoundary,
    /// Number of scribbles of the last boundary.
    scribble_count: usize,
    solver: Option<MeshSolver>,
    /// See [`Picture::part_du`].
    part_du: Option<Rect>,
}

impl Picture {
    /// Builds the planar map of a drawing.
    ///
    /// # Errors
    /// When the drawing has too many pieces.
    pub fn new(drawing: &Drawing) -> Result<Self, MapError> {
        now(Self::mapping(drawing))
    }

    /// [`Picture::new`] in slices.
    ///
    /// # Errors
    /// When the drawing has too many pieces.
    pub fn mapping(drawing: &Drawing) -> Slices<'_, Result<Self, MapError>> {
        Slices::new(async {
            let settings = Settings::default();
            let mut map = PlanarMap::building(drawing, &Sampling::default()).await?;
            map.closing_gaps(settings.gap_closing).await;
            Ok(Self::of(map, settings))
        })
    }

    /// The same drawing, of which nothing but the map is known.
    pub fn again(&self) -> Self {
        Self::of(self.map.clone(), self.settings)
    }

    /// Makes the picture rough: from the triangles between the lines as they are. That takes a third of the time, but long thin
    /// triangles give a few sides another label. Nothing but the map is known then.
    pub fn roughen(&mut self) {
        self.set_rough(true);
        self.narrow(Some(EVERYWHERE));
    }

    /// Has the next field be that of the regions alone that come near a part of the plane, in du, in less time; or of all.
    pub fn narrow(&mut self, part_du: Option<Rect>) {
        self.part_du = part_du;
    }

    /// Which part of the plane the next field is that of, in du, where it is to be a preview.
    pub fn part_du(&self) -> Option<Rect> {
        self.part_du
    }

    /// Makes a preview a whole picture again, from a fine mesh, and gives its field and where that is. Of a rough one nothing but
    /// the map is known then, of another no mesh.
    pub fn complete(&mut self) -> Option<(Rect, Arc<Field>)> {
        let part_du = self.part_du.take()?;
        let field = self.solver.take().map(|mut solver| solver.take_field());
        if self.map.is_rough() {
            self.set_rough(false);
        }
        field.map(|field| (part_du, field))
    }

    fn set_rough(&mut self, is_rough: bool) {
        self.map.set_rough(is_rough);
        self.engine = self.settings.engine();
        self.forget_colors();
    }

    fn forget_colors(&mut self) {
        (self.boundary, self.solver) = (KnownBoundary::default(), None);
    }

    fn of(map: PlanarMap, settings: Settings) -> Self {
        let boundary = KnownBoundary::default();
        Self {
            map,
            engine: settings.engine(),
            settings,
            boundary,
            scribble_count: 0,
            solver: None,
            part_du: None,
        }
    }

    /// The settings of the last labels.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Whether labels by other settings take neither another map nor another engine.
    pub fn suits(&self, settings: &Settings) -> bool {
        let settings = settings.clamped();
        self.settings.gap_closing == settings.gap_closing && self.settings.share_engine(&settings)
    }

    /// The planar map of the drawing.
    pub fn map(&self) -> &PlanarMap {
        &self.map
    }

    /// The solver on the refined map; meshes at the first call, or of a preview at each.
    pub fn mesh(&mut self) -> &mut MeshSolver {
        self.mesh_and_boundary().0
    }

    /// Whether [`Picture::mesh`] has been called since the map is what it is.
    pub fn has_mesh(&self) -> bool {
        self.solver.is_some()
    }

    /// The colour field of the last solve, if there was one since the map is what it is.
    pub fn field(&self) -> Option<&Arc<Field>> {
        self.solver.as_ref().map(MeshSolver::field)
    }

    /// What of it is not what it was at the last call, as long as the mesh is the same: with another one, all is.
    pub fn take_change(&mut self) -> FieldChange {
        self.solver.as_mut().map(MeshSolver::take_change).unwrap_or_default()
    }

    /// What comes near a part of the page of the field of the last solve, as it is seen at a scale: from close by, its edges
    /// bend as the curves of the drawing do. `None` where that makes no difference, or where nothing was solved.
    pub fn close_up(&self, drawing: &Drawing, part_du: Rect, px_per_du: f64) -> Option<Field> {
        let solver = self.solver.as_ref().filter(|_| px_per_du > CLOSE_PX_PER_DU)?;
        Some(solver.bent(&self.bends(drawing, part_du, px_per_du), part_du))
    }

    /// How the curves of the drawing bend in a part of the page, as it is seen at a scale; not at all where nobody sees it.
    pub fn bends(&self, drawing: &Drawing, part_du: Rect, px_per_du: f64) -> Bends {
        if px_per_du > CLOSE_PX_PER_DU {
            Bends::within(drawing, &self.map, part_du, CHORD_PX / px_per_du)
        } else {
            Bends::default()
        }
    }

    /// The labels of the sides and gaps, by the scribbles that fill; they name scribbles by their indices among all.
    pub fn label(&mut self, scribbles: &[Scribble], settings: &Settings) -> Labels {
        now(Slices::new(self.labelling(scribbles, settings)))
    }

    async fn labelling(&mut self, scribbles: &[Scribble], settings: &Settings) -> Labels {
        let settings = settings.clamped();
        let before = mem::replace(&mut self.settings, settings);
        let is_other_map =
            before.gap_closing != settings.gap_closing && self.map.closing_gaps(settings.gap_closing).await;
        if is_other_map {
            self.forget_colors();
        }
        if is_other_map || !before.share_engine(&settings) {
            self.engine = settings.engine();
        }
        self.label_fills(scribbles).await
    }

    async fn label_fills(&mut self, scribbles: &[Scribble]) -> Labels {
        if scribbles.iter().all(Scribble::is_fill) {
            return self.engine.labelling(&self.map, scribbles).await;
        }
        let (places, fills): (Vec<_>, Vec<_>) = (0..)
            .zip(scribbles)
            .filter(|(_, scribble)| scribble.is_fill())
            .map(|(i, s)| (i, s.clone()))
            .unzip();
        let mut labels = self.engine.labelling(&self.map, &fills).await;
        for label in labels.sides.iter_mut().flatten() {
            *label = places[*label as usize];
        }
        labels
    }

    /// The colours that scribbles and points set by hand give the sides, and the gaps that the scribbles leave closed.
    pub fn color(
        &mut self,
        scribbles: &[Scribble],
        by_hand: &[ColorPoint],
        settings: &Settings,
    ) -> &Boundary {
        now(self.coloring(scribbles, by_hand, settings));
        self.boundary()
    }

    /// [`Picture::color`] in slices.
    pub fn coloring<'a>(
        &'a mut self,
        scribbles: &'a [Scribble],
        by_hand: &'a [ColorPoint],
        settings: &'a Settings,
    ) -> Slices<'a, ()> {
        Slices::new(async {
            let labels = self.labelling(scribbles, settings).await;
            // While one is drawn, there are as many in each frame.
            if mem::replace(&mut self.scribble_count, scribbles.len()) != scribbles.len() {
                self.solver.iter_mut().for_each(MeshSolver::begin_step);
            }
            self.boundary.following(&self.map, &labels, scribbles, by_hand, settings.blend).await;
        })
    }

    /// The boundary of the last call of [`Picture::color`] for the map as it is; where there was none, that of no map.
    pub fn boundary(&self) -> &Boundary {
        self.boundary.get()
    }

    /// [`Picture::mesh`], and what it is given.
    pub fn mesh_and_boundary(&mut self) -> (&mut MeshSolver, &Boundary) {
        now(Slices::new(self.ready()))
    }

    async fn ready(&mut self) -> (&mut MeshSolver, &Boundary) {
        let once = self.part_du.map(|part_du| Once { boundary: self.boundary.get(), part_du });
        let solver = match self.solver.take().filter(|_| once.is_none()) {
            Some(solver) => solver,
            None => {
                self.map.refining().await;
                MeshSolver::meshing(self.map.refined().clone(), once).await
            }
        };
        (self.solver.insert(solver), self.boundary.get())
    }

    /// The colour field of [`Picture::boundary`].
    ///
    /// # Errors
    /// When the solver fails.
    pub fn solve(&mut self) -> Result<&Field, SolveError> {
        now(self.solving())
    }

    /// [`Picture::solve`] in slices.
    ///
    /// # Errors
    /// When the solver fails.
    pub fn solving(&mut self) -> Slices<'_, Result<&Field, SolveError>> {
        Slices::new(async {
            let blend = self.boundary.blend();
            let (solver, boundary) = self.ready().await;
            solver.solving(boundary, blend).await
        })
    }

    /// The colour field of a document with the drawing that this picture was made for.
    ///
    /// # Errors
    /// When the solver fails.
    pub fn update(&mut self, document: &Document) -> Result<&Field, SolveError> {
        now(self.updating(document))
    }

    /// [`Picture::update`] in slices.
    ///
    /// # Errors
    /// When the solver fails.
    pub fn updating<'a: 'b, 'b>(
        &'a mut self,
        document: &'b Document,
    ) -> Slices<'b, Result<&'a Field, SolveError>> {
        Slices::new(async {
            let Document { scribbles, color_points, settings, .. } = document;
            self.coloring(scribbles, color_points, settings).await;
            self.solving().await
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{Circle, Point, Shape};
    use scumble_core::{Curve, ScribbleKind, Shading, Srgb8};

    use crate::field::FieldTriangle;

    /// A disc with a scribble in it.
    fn disc() -> Document {
        let path = Circle::new((500.0, 500.0), 30.0).to_path(1e-6);
        let drawing = Drawing {
            curves: vec![Curve { path, line: None }],
            ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0))
        };
        let points = vec![Point::new(490.0, 500.0), Point::new(510.0, 500.0)];
        let color = Srgb8([9; 3]).into();
        let scribble = Scribble { color, kind: ScribbleKind::Fill, width_du: 10.0, points };
        Document { scribbles: vec![scribble], ..Document::new(drawing) }
    }

    #[test]
    fn a_rough_picture_has_the_same_colour_on_fewer_triangles_and_leaves_nothing_behind() {
        let document = disc();
        let [mut rough, mut fine] = [(); 2].map(|()| Picture::new(&document.drawing).expect("a map"));
        rough.roughen();
        rough.update(&document).expect("a field");
        let (_, field) = rough.complete().expect("a preview");
        assert_eq!(rough.part_du(), None);
        let expected = fine.update(&document).expect("a field");
        assert!((1..expected.triangles.len()).contains(&field.triangles.len()));
        assert!(field.triangles.iter().all(|triangle| triangle.colors == expected.triangles[0].colors));
        assert_eq!(rough.update(&document).expect("a field"), expected);
    }

    #[test]
    fn a_rough_picture_has_shades_also_where_nothing_has_a_colour() {
        let mut document = disc();
        let kind = ScribbleKind::Shade(Shading { crosses: true, ..Shading::default() });
        let points = vec![Point::new(480.0, 500.0), Point::new(700.0, 520.0)];
        document.scribbles.push(Scribble { kind, points, ..document.scribbles[0].clone() });
        let mut picture = Picture::new(&document.drawing).expect("a map");
        picture.roughen();
        picture.update(&document).expect("a field");
        let is_beyond = |triangle: &FieldTriangle| triangle.corners.iter().all(|corner| corner[0] > 600.0);
        let (_, field) = picture.complete().expect("a preview");
        let mut beyond = field.triangles.iter().filter(|triangle| is_beyond(triangle));
        assert!(beyond.any(|triangle| triangle.colors.iter().any(|color| color[3] > 0.1)));
    }

    /// Three discs in a row, of which the middle one is shaded: by a stroke that begins in the first one and ends in the last one.
    #[test]
    fn the_regions_of_a_part_are_as_in_the_whole_picture() {
        let circles = [200.0, 500.0, 800.0].map(|x| Circle::new((x, 500.0), 100.0).to_path(1e-6));
        let mut document = disc();
        document.drawing.curves = circles.map(|path| Curve { path, line: None }).into();
        let scribble = document.scribbles[0].clone();
        let stroke = |kind, ends: [f64; 2], level| {
            let points = ends.map(|x| Point::new(x, 500.0)).to_vec();
            Scribble { kind, points, color: Srgb8([level; 3]).into(), ..scribble.clone() }
        };
        let shade = |crosses| ScribbleKind::Shade(Shading { crosses, ..Shading::default() });
        document.scribbles = vec![
            stroke(ScribbleKind::Fill, [250.0, 320.0], 200),
            stroke(ScribbleKind::Fill, [480.0, 520.0], 100),
            stroke(ScribbleKind::Fill, [780.0, 820.0], 50),
            stroke(shade(false), [295.0, 550.0], 0),
            stroke(shade(true), [550.0, 850.0], 255),
        ];
        let mut picture = Picture::new(&document.drawing).expect("a map");
        let whole = picture.update(&document).expect("a field").triangles.clone();
        let mut part = |x: [f64; 2]| {
            picture.narrow(Some(Rect::new(x[0], 490.0, x[1], 510.0)));
            picture.solve().expect("a field");
            let (_, field) = picture.complete().expect("a preview");
            field.triangles.clone()
        };
        for (x, center) in [([480.0, 520.0], 500.0), ([870.0, 890.0], 800.0)] {
            let is_within = |triangle: &&FieldTriangle| {
                triangle
                    .corners
                    .iter()
                    .all(|&[x, y]| (f64::from(x) - center).hypot(f64::from(y) - 500.0) < 100.1)
            };
            let part = part(x);
            let [part, whole] = [&part, &whole].map(|all| all.iter().filter(is_within).collect::<Vec<_>>());
            assert!(part.len() > 10);
            assert_eq!(part.len(), whole.len());
            for (part, whole) in part.into_iter().zip(whole) {
                assert_eq!((part.corners, part.side_edges), (whole.corners, whole.side_edges));
                let pairs = part.colors.as_flattened().iter().zip(whole.colors.as_flattened());
                pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-4, "{a} {b}"));
            }
        }
        assert_eq!(part([2.0, 1020.0]).len(), whole.len());
        assert!(part([480.0, 520.0]).len() < whole.len());
    }

    #[test]
    fn what_is_seen_from_close_by_is_finer_and_from_afar_it_is_the_same() {
        let document = disc();
        let mut picture = Picture::new(&document.drawing).expect("a map");
        let drawing = &document.drawing;
        assert_eq!(picture.close_up(drawing, drawing.frame(), 16.0), None, "nothing is solved");
        let count = picture.update(&document).expect("a field").triangles.len();
        assert_eq!(picture.close_up(drawing, drawing.frame(), 2.0), None);
        let counts = [8.0, 64.0].map(|scale| {
            picture.close_up(drawing, drawing.frame(), scale).map_or(0, |field| field.triangles.len())
        });
        assert!(count < counts[0] && counts[0] < counts[1], "{count} {counts:?}");
    }
}

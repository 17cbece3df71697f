//! Curves → an SVG file.

use std::ops::Range;
use std::path::Path;

use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;

use crate::Outcome;

/// Points under a name.
pub(crate) struct Curve<'a> {
    pub(crate) name: &'a str,
    pub(crate) points: Vec<(f64, f64)>,
    /// Whether a line goes through them, in their order.
    pub(crate) joined: bool,
}

/// How an axis is divided.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scale {
    Linear,
    Log,
}

const SIZE: (u32, u32) = (720, 440);

/// Draws `curves` into the file at `path`; each axis with what it says and its scale.
pub(crate) fn plot(
    path: &Path,
    title: &str,
    x: (&str, Scale),
    y: (&str, Scale),
    curves: &[Curve<'_>],
) -> Outcome {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let across = range(points().map(|point| point.0), x.1)?;
    let up = range(points().map(|point| point.1), y.1)?;
    match (x.1, y.1) {
        (Scale::Log, Scale::Log) => drawn(path, title, x.0, y.0, across.log_scale(), up.log_scale(), curves),
        (Scale::Log, Scale::Linear) => drawn(path, title, x.0, y.0, across.log_scale(), up, curves),
        (Scale::Linear, Scale::Log) => drawn(path, title, x.0, y.0, across, up.log_scale(), curves),
        (Scale::Linear, Scale::Linear) => drawn(path, title, x.0, y.0, across, up, curves),
    }
}

/// From a little below the least of `values` to a little above the most.
fn range(values: impl Iterator<Item = f64>, scale: Scale) -> Outcome<Range<f64>> {
    let values: Vec<f64> =
        values.filter(|value| value.is_finite() && (scale == Scale::Linear || *value > 0.0)).collect();
    let least = values.iter().copied().min_by(f64::total_cmp).ok_or("there is nothing to plot")?;
    let most = values.iter().copied().max_by(f64::total_cmp).ok_or("there is nothing to plot")?;
    Ok(match scale {
        Scale::Log => least / 1.3..most * 1.3,
        Scale::Linear => {
            let margin = 0.05 * (most - least).max(1e-9);
            least - margin..most + margin
        }
    })
}

fn drawn<X, Y>(path: &Path, title: &str, x: &str, y: &str, across: X, up: Y, curves: &[Curve<'_>]) -> Outcome
where
    X: AsRangedCoord<Value = f64>,
    Y: AsRangedCoord<Value = f64>,
    X::CoordDescType: ValueFormatter<f64>,
    Y::CoordDescType: ValueFormatter<f64>,
{
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(across, up)?;
    chart.configure_mesh().light_line_style(TRANSPARENT).x_desc(x).y_desc(y).draw()?;
    for (index, curve) in curves.iter().enumerate() {
        let colour = Palette99::pick(index).to_rgba();
        let points = curve.points.iter().copied();
        let dots = points.clone().map(|point| Circle::new(point, 3, colour.filled()));
        chart.draw_series(dots)?.label(curve.name).legend(move |at| Circle::new(at, 3, colour.filled()));
        if curve.joined {
            chart.draw_series(LineSeries::new(points, colour.stroke_width(1)))?;
        }
    }
    chart.configure_series_labels().background_style(WHITE.mix(0.8)).border_style(BLACK.mix(0.3)).draw()?;
    area.present()?;
    Ok(())
}

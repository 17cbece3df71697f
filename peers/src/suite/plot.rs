//! Curves → an SVG file.

use std::ops::Range;
use std::path::Path;

pub(crate) use plotters::chart::SeriesLabelPosition as Corner;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
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
/// About as many marks an axis gets.
const MARKS: f64 = 6.0;
/// Told apart by those who see few colours, too (Okabe and Ito 2008).
const COLOURS: [RGBColor; 5] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 86, 86),
];

impl Scale {
    /// Where a value stands on the axis.
    fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log => value.log10(),
        }
    }

    /// What stands at a place of the axis.
    fn value(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Log => 10_f64.powf(place),
        }
    }

    /// The places from a little below the least of `values` to a little above the most.
    fn range(self, values: impl Iterator<Item = f64>) -> Outcome<Range<f64>> {
        let places: Vec<f64> =
            values.map(|value| self.place(value)).filter(|place| place.is_finite()).collect();
        let least = places.iter().copied().min_by(f64::total_cmp).ok_or("there is nothing to plot")?;
        let most = places.iter().copied().max_by(f64::total_cmp).ok_or("there is nothing to plot")?;
        let margin = 0.06 * (most - least).max(1e-9);
        Ok(least - margin..most + margin)
    }

    /// Places of round numbers.
    fn marks(self, range: &Range<f64>) -> Vec<f64> {
        let span = range.end - range.start;
        let within = |place: &f64| range.contains(place);
        match self {
            Self::Linear => {
                let rough = span / MARKS;
                let ten = 10_f64.powf(rough.log10().floor());
                let step = [1.0, 2.0, 5.0, 10.0].map(|times| times * ten);
                let step = step.into_iter().find(|step| *step >= rough).unwrap_or(rough);
                let first = (range.start / step).ceil() as i64;
                let last = (range.end / step).floor() as i64;
                (first..=last).map(|index| index as f64 * step).collect()
            }
            Self::Log => {
                let digits: &[f64] = match span {
                    _ if span < 0.8 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0],
                    _ if span < 3.0 => &[1.0, 2.0, 5.0],
                    _ => &[1.0],
                };
                let decades = range.start.floor() as i32..=range.end.ceil() as i32;
                let marks = decades
                    .flat_map(|decade| digits.iter().map(move |digit| digit.log10() + f64::from(decade)));
                marks.filter(within).collect()
            }
        }
    }

    /// The number at a mark, as people write it.
    fn label(self, place: f64) -> String {
        let value = self.value(place);
        let digits = if value == 0.0 { 0 } else { (2 - value.abs().log10().floor() as i32).max(0) };
        if value != 0.0 && digits > 5 {
            return format!("{value:.0e}");
        }
        let text = format!("{value:.*}", digits as usize);
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    }
}

/// Places, and which of them are marked.
struct Axis {
    range: Range<f64>,
    marks: Vec<f64>,
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (first, last): (i32, i32)) -> i32 {
        let part = (place - self.range.start) / (self.range.end - self.range.start);
        first + (part * f64::from(last - first)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.marks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(place: &f64) -> String {
        place.to_string() // the chart is told how to write the number there
    }
}

/// Draws `curves` into the file at `path`; each axis with what it says and its scale, the curves' names in a corner that they
/// leave free.
pub(crate) fn plot(
    path: &Path,
    title: &str,
    x: (&str, Scale),
    y: (&str, Scale),
    corner: Corner,
    curves: &[Curve<'_>],
) -> Outcome {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let across = x.1.range(points().map(|point| point.0))?;
    let up = y.1.range(points().map(|point| point.1))?;
    let (columns, rows) = (x.1.marks(&across), y.1.marks(&up));
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 22))
        .margin(12)
        .margin_right(24)
        .x_label_area_size(52)
        .y_label_area_size(76)
        .build_cartesian_2d(Axis { range: across, marks: columns }, Axis { range: up, marks: rows })?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc(x.0)
        .y_desc(y.0)
        .axis_desc_style(("sans-serif", 17))
        .label_style(("sans-serif", 16))
        .x_label_formatter(&|place| x.1.label(*place))
        .y_label_formatter(&|place| y.1.label(*place))
        .draw()?;
    for (curve, colour) in curves.iter().zip(COLOURS.iter().cycle()) {
        let points = curve.points.iter().map(|point| (x.1.place(point.0), y.1.place(point.1)));
        let dots = points.clone().map(|point| Circle::new(point, 4, colour.filled()));
        chart.draw_series(dots)?.label(curve.name).legend(move |at| Circle::new(at, 4, colour.filled()));
        if curve.joined {
            chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?;
        }
    }
    chart
        .configure_series_labels()
        .position(corner)
        .label_font(("sans-serif", 16))
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    area.present()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_round_and_read_so() {
        let labels = |scale: Scale, low: f64, high: f64| {
            let range = scale.place(low)..scale.place(high);
            scale.marks(&range).into_iter().map(|place| scale.label(place)).collect::<Vec<_>>()
        };
        assert_eq!(labels(Scale::Linear, -0.1, 2.9), ["0", "0.5", "1", "1.5", "2", "2.5"]);
        assert_eq!(labels(Scale::Linear, 31.0, 49.0), ["35", "40", "45"]);
        assert_eq!(labels(Scale::Log, 35.0, 420.0), ["50", "100", "200"]);
        assert_eq!(labels(Scale::Log, 120.0, 550.0), ["150", "200", "300", "400", "500"]);
        assert_eq!(labels(Scale::Log, 4e-7, 0.5), ["1e-6", "1e-5", "1e-4", "0.001", "0.01", "0.1"]);
    }
}

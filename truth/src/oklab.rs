//! Oklab (Ottosson 2020), in f64: linear sRGB to lightness and two axes of colour, by its definition: a matrix, the cube
//! root, a matrix.

const TO_CONES: [[f64; 3]; 3] = [
    [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
    [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
    [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
];
const TO_LAB: [[f64; 3]; 3] = [
    [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
    [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
    [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
];

fn times(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Lightness, green to red, blue to yellow.
#[must_use]
pub fn oklab(linear_srgb: [f64; 3]) -> [f64; 3] {
    times(&TO_LAB, times(&TO_CONES, linear_srgb).map(f64::cbrt))
}

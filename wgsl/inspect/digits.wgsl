// Numbers in a picture: digits of three by five cells.

// 0 to 9, the minus, the point: rows of three cells from the top, the first in the highest bits.
const GLYPHS: array<u32, 12> = array<u32, 12>(
    0x7b6fu, 0x2c97u, 0x73e7u, 0x73cfu, 0x5bc9u, 0x79cfu, 0x79efu, 0x7292u, 0x7befu, 0x7bcfu, 0x01c0u, 0x0002u,
);
const MINUS: u32 = 10u;
const POINT: u32 = 11u;

/// Whether `cell` is inked where `value` is written: `x` counts cells leftwards from the right end of the number, `y`
/// upwards from its foot. Two digits of a value count, and all before the point; 1e9 is the most.
fn number_inked(cell: vec2i, value: f32) -> bool {
    if cell.x < 0 || cell.y < 0 || cell.y > 4 || (cell.x & 3) == 3 {
        return false;
    }
    let magnitude = min(abs(value), 1e9);
    var decimals = 0;
    if magnitude > 0.0 && magnitude < 9.95 {
        decimals = clamp(1 - i32(floor(log2(magnitude) * 0.30103 + 1e-4)), 0, 6);
    }
    var digits = u32(magnitude * pow(10.0, f32(decimals)) + 0.5);
    for (var i = 0; i < 6; i++) {
        if decimals > 0 && digits % 10u == 0u { // 2.50 is 2.5
            digits /= 10u;
            decimals -= 1;
        }
    }
    let place = cell.x / 4; // which glyph, from the right
    var glyph = POINT;
    if decimals == 0 || place != decimals {
        var rest = digits;
        let before = place - i32(decimals > 0 && place > decimals);
        for (var i = 0; i < min(before, 10); i++) {
            rest /= 10u;
        }
        glyph = rest % 10u;
        let least = decimals + i32(decimals > 0) + 1; // a digit before the point, at least
        if rest == 0u && place >= least {
            // The minus stands before the first digit, and nothing before that.
            var shown = least;
            var more = digits;
            for (var i = 0; i < decimals + 1; i++) {
                more /= 10u;
            }
            for (var i = 0; i < 10; i++) {
                if more > 0u {
                    more /= 10u;
                    shown += 1;
                }
            }
            if value >= 0.0 || place != shown {
                return false;
            }
            glyph = MINUS;
        }
    }
    let bit = u32(3 * cell.y + (cell.x & 3));
    return ((GLYPHS[glyph] >> bit) & 1u) == 1u;
}

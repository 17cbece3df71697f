// What the host tells every frame. The one group that is always live.

/// Size of the picture.
#param frame.resolution: vec2f = (960, 540), live, unit px
/// Time since the start.
#param frame.time: f32 = 0.0, live, unit s
/// Time since the previous frame.
#param frame.delta: f32 = 0.0166667, live, unit s
/// Number of the frame, counted from 0.
#param frame.index: u32 = 0, live
/// The mouse as Shadertoy's iMouse: `xy` is where it was last dragged to, `zw` where it was pressed; `z` is negative
/// once the button is up, `w` positive only in the frame of the click. All zero: never pressed.
#param frame.mouse: vec4f = (0, 0, 0, 0), live, unit px
/// Offset of this frame's rays inside the pixel, -0.5 .. 0.5 each way: for renderers that accumulate frames.
#param frame.jitter: vec2f = (0, 0), live, unit px

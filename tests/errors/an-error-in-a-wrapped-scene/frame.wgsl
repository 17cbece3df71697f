#param frame.resolution: vec2f = (960, 540), live, unit px
#param frame.jitter: vec2f = (0, 0), live, unit px

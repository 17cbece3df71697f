fn land_height() {}

const land_depth = 1.0;

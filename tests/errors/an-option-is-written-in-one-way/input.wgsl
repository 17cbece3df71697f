#option a.b
#option a.b = perlin
#option a.b = perlin { value, }
#option a.b = 8, rnge 1 .. 2
#option a.b = perlin { value perlin }
#option a.b = 1 2

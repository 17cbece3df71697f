#option a.mode = perlin { value, perlin }
#if a.mode == perlim
#endif
#if fast != a.mode
#endif

#option terrain.basis = perlin { value, perlin, simplex }
#option quality = low { low, high }
#if terain.basis == simplex
#endif
#if qualty == high
#endif
#if true || quite.unlike
#endif
#if quality
#endif
#if low
#endif

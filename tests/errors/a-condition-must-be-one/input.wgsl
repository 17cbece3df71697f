#option a.b = true
#if
#endif
#if a.b &&
#endif
#if (a.b
#endif
#if a.b)
#endif
#if a.b = true
#endif
#if a.b & a.b
#endif
#if a.b a.b
#endif
#if 3 == 0x3
#endif
#if a. == 3
#endif
#if ((((((a.b)))))
#endif

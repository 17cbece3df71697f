#option a.count = 3
#option a.on = true
#option a.mode = low { low, high }
#if a.count == true
#endif
#if a.on < a.on
#endif
#if a.mode == 1
#endif

#option a.count = 3
#option a.on = true
#if a.count
#endif
#if a.on && 1
#endif
#if !3
#endif

#endif
#else
#elif true
#if true
#else
#else
#elif true
#endif
#if true
    #if false
    #endif

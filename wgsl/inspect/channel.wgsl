// Numbers that differ by colour, of which a picture with a scale shows one.

/// Which colour is measured; `all` shows red, green and blue at once, each as bright as it is far up the scale.
#option inspect.channel = green { red, green, blue, all }

/// The channel of `values` that is measured.
fn channel_of(values: vec3f) -> f32 {
#if inspect.channel == red
    return values.r;
#elif inspect.channel == blue
    return values.b;
#else
    return values.g;
#endif
}

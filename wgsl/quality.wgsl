// The one word that trades speed for quality: every element reads its step and octave counts from it.

/// How much work is done for a pixel.
#option quality = high { low, medium, high, ultra }

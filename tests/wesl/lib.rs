//! Nothing: all that there is stands in `tests/`.

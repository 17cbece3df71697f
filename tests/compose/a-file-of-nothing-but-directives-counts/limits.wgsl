// A check, and no more.

const_assert 2 > 1;

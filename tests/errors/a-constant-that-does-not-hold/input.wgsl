const A = 1;
const_assert A == 2;

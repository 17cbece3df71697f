const A = 1;
/* never closed
const B = 2;

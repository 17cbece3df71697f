const TWO = 2;

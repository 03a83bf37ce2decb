// a strength that leaves it flat

// a drawn body without a mass, and one that absorbs
compound Some = decompose {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)
  faces    base [a,c,b]  left [a,d,c]  front [a,b,d]  slope [b,c,d]
}
compound Other = decompose {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)
  faces    base [a,c,b]  left [a,d,c]  front [a,b,d]  slope [b,c,d]
} mass 1 absorb
process p = Some [nil]
process q = Other at translate (5, 0, 0) [nil]

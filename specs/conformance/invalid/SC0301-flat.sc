// a body without inside: both sides of one triangle
shape S {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)
  faces    up [a,b,c]  down [a,c,b]
}
process p = S mass 1 [nil]

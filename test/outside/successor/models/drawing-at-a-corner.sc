// Rule Draw: who goes first where reference points coincide. The corners p of all prisms are in one point: names
// of templates tell them apart, the further leaves of those that are bound, and the order of declaration.
timestep 1
shape Prism {
  vertices p (0,0,0)  q (2,0,0)  r (0,2,0)  s (0,0,2)  t (2,0,2)  u (0,2,2)
  faces    low [p,r,q]  high [s,t,u]  south [p,q,t,s]  west [p,s,u,r]  slope [q,r,u,t]
}
shape Alike = Prism scaled (1/2, 1, 1)
process z0 = z2 : Prism mass 1 at translate (0, 0, 2) [nil]
  <h, {z.high, z2.low}> z : Prism mass 1 at translate (0, 0, 0) [nil]
process d = Prism mass 2 at translate (0, 0, 0) * rotate quaternion (1, 0, 0, 1) [nil]
process c = Prism mass 2 at translate (0, 0, 0) * rotate quaternion (0, 0, 0, 1) [nil]
process b = Alike mass 1 at translate (0, 0, 0) * rotate quaternion (1, 0, 0, -1) [nil]
motion choose { (0, 0, 1) weight 2, (0, 0, 0) weight mass }

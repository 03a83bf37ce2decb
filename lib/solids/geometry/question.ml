type t = {
  a : Solid.t;
  b : Solid.t;
  offset : Shadow.floats;
  velocity : Shadow.floats;
  bound : float;
}

let bound_on (a : Solid.t) (b : Solid.t) r = a.shadow.reach +. b.shadow.reach +. Shadow.greatest r

let[@inline] sane (v : Shadow.floats) = Shadow.sane v.x && Shadow.sane v.y && Shadow.sane v.z

let make (a : Solid.t) (b : Solid.t) offset velocity =
  if a.shadow.usable && b.shadow.usable && sane offset && sane velocity then
    Some { a; b; offset; velocity; bound = bound_on a b offset }
  else None

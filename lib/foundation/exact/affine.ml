type t = { linear : Mat.t; translation : Vec.t }

let of_linear linear = { linear; translation = Vec.zero }
let identity = of_linear Mat.identity
let apply f v = Vec.add (Mat.apply f.linear v) f.translation
let compose f g = { linear = Mat.mul f.linear g.linear; translation = apply f g.translation }
let mirrors f = Rat.sign (Mat.det f.linear) < 0

let too_long { linear = m; translation } =
  List.exists (fun row -> Vec.bits row > 4_000) [ m.r0; m.r1; m.r2; translation ]

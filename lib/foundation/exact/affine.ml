type t = { linear : Mat.t; translation : Vec.t }

let translate translation = { linear = Mat.identity; translation }
let of_linear linear = { linear; translation = Vec.zero }
let apply f v = Vec.add (Mat.apply f.linear v) f.translation

let compose f g =
  { linear = Mat.mul f.linear g.linear; translation = apply f g.translation }

let equal f g = Mat.equal f.linear g.linear && Vec.equal f.translation g.translation

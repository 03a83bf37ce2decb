open Scc_exact

type t = { linear : Mat.t; translation : Form.place }

let translate translation = { linear = Mat.identity; translation }
let of_linear linear = { linear; translation = Form.place Vec.zero }
let identity = of_linear Mat.identity

let compose f g =
  {
    linear = Mat.mul f.linear g.linear;
    translation = Form.add_place (Form.turned f.linear g.translation) f.translation;
  }

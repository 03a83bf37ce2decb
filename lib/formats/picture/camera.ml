open Scc_exact

type t = { right : Ivec.t; up : Ivec.t; near : Ivec.t }

let whole v = Ivec.primitive (fst (Ivec.of_vec v))

let make ?(up = Vec.of_ints 0 1 0) direction =
  let near = whole direction in
  let across up = Ivec.primitive (Ivec.cross (whole up) near) in
  let right =
    let found v = if Ivec.is_zero (across v) then None else Some (across v) in
    let axes = [ up; Vec.of_ints 0 0 (-1); Vec.of_ints 0 1 0; Vec.of_ints 1 0 0 ] in
    match List.find_map found axes with
    | Some right -> right
    | None -> Scc_base.Bug.fail __POS__ "no direction to look from"
  in
  { right; up = Ivec.primitive (Ivec.cross near right); near }

let turn t v = Ivec.make (Ivec.dot t.right v) (Ivec.dot t.up v) (Ivec.dot t.near v)

let flat t v =
  (Vec.dot (Ivec.to_vec t.right) v, Vec.dot (Ivec.to_vec t.up) v)

let lengths t =
  let length v = Rat.root (Rat.make (Ivec.dot v v) Z.one) in
  (length t.right, length t.up)

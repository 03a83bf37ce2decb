open Scc_exact

type eye = { at : Vec.t; least : Rat.t }
type t = { right : Ivec.t; up : Ivec.t; near : Ivec.t; eye : eye option }

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
  { right; up = Ivec.primitive (Ivec.cross near right); near; eye = None }

let with_eye t eye = { t with eye = Some eye }

let turn t v = Ivec.make (Ivec.dot t.right v) (Ivec.dot t.up v) (Ivec.dot t.near v)

let flat t v =
  (Vec.dot (Ivec.to_vec t.right) v, Vec.dot (Ivec.to_vec t.up) v)

let length v = Rat.root (Rat.make (Ivec.dot v v) Z.one)
let lengths t = (length t.right, length t.up)
let length_near t = length t.near

(* How much farther in front of the eye a corner is than the least distance, times a positive number. *)
let in_front t over =
  match t.eye with
  | None -> None
  | Some eye ->
    let from = Rat.sub (Vec.dot (Ivec.to_vec t.near) eye.at) (Rat.mul eye.least (length_near t)) in
    let n = Z.mul (Q.num from) over and d = Q.den from in
    Some (fun corner -> Z.sub n (Z.mul d (Ivec.dot t.near corner)))

let sees_back t ~normal corner over =
  match t.eye with
  | None -> Z.sign (Ivec.dot normal t.near) < 0
  | Some eye ->
    let at, d = Ivec.of_vec eye.at in
    Z.sign (Ivec.dot normal (Ivec.sub (Ivec.scale over at) (Ivec.scale d corner))) < 0

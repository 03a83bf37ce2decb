open Scc_exact

type t = { low : Vec.t; high : Vec.t }

let corners { low; high } =
  let choices pick = [ pick low; pick high ] in
  let of_y x y = List.map (Vec.make x y) (choices (fun (v : Vec.t) -> v.z)) in
  let of_x x = List.concat_map (of_y x) (choices (fun (v : Vec.t) -> v.y)) in
  List.concat_map of_x (choices (fun (v : Vec.t) -> v.x))

let less a b = Rat.compare a b < 0
let axes : Vec.axis list = [ X; Y; Z ]

let overlap a b =
  let on axis =
    let at = Vec.component axis in
    less (at a.low) (at b.high) && less (at b.low) (at a.high)
  in
  List.for_all on axes

let with_component (axis : Vec.axis) c (v : Vec.t) =
  match axis with X -> { v with x = c } | Y -> { v with y = c } | Z -> { v with z = c }

(* What of the box lies outside another one that it overlaps: what is before and after it along each axis, of what
   is left after the axes before. *)
let without other box =
  let along (pieces, box) axis =
    let at v = Vec.component axis v in
    let cut low high = { low = with_component axis low box.low; high = with_component axis high box.high } in
    let before = if less (at box.low) (at other.low) then [ cut (at box.low) (at other.low) ] else [] in
    let after = if less (at other.high) (at box.high) then [ cut (at other.high) (at box.high) ] else [] in
    (before @ after @ pieces, cut (Rat.max (at box.low) (at other.low)) (Rat.min (at box.high) (at other.high)))
  in
  fst (List.fold_left along ([], box) axes)

let cover boxes box =
  let remove pieces other =
    List.concat_map (fun piece -> if overlap piece other then without other piece else [ piece ]) pieces
  in
  List.fold_left remove [ box ] boxes = []

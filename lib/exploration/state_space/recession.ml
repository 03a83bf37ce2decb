open Scc_exact

type body = { corners : Vec.t array; low : Vec.t; high : Vec.t }
type t = { bodies : (Vec.t * body) list; velocity : Vec.t; spread2 : Rat.t }

let body corners =
  let each f (v : Vec.t) (w : Vec.t) = Vec.make (f v.x w.x) (f v.y w.y) (f v.z w.z) in
  let all f = Array.fold_left (each f) corners.(0) corners in
  { corners; low = all Rat.min; high = all Rat.max }

let exceeds d2 a b =
  let rest = Rat.sub d2 (Rat.add a b) in
  Rat.sign rest > 0 && Rat.compare (Rat.mul rest rest) (Rat.mul (Rat.of_int 4) (Rat.mul a b)) > 0

(* The corner of a body that is farthest along n, and how far. *)
let farthest_of n { corners; _ } =
  let farther ((most, _) as best) v =
    let h = Vec.dot n v in
    if Rat.compare h most > 0 then (h, v) else best
  in
  Array.fold_left farther (Vec.dot n corners.(0), corners.(0)) corners

let farthest bodies n =
  let farther best (place, body) =
    let most, v = farthest_of n body in
    let h = Rat.add (Vec.dot n place) most in
    match best with
    | Some (known, _) when Rat.compare h known <= 0 -> best
    | Some _ | None -> Some (h, Vec.add place v)
  in
  match List.fold_left farther None bodies with
  | Some best -> best
  | None -> Scc_base.Bug.fail __POS__ "a set without points"

let range bodies n = (Rat.neg (fst (farthest bodies (Vec.neg n))), fst (farthest bodies n))

(* Not less than the greatest n.p: of the boxes. *)
let not_beyond bodies (n : Vec.t) =
  let pick c low high = if Rat.sign c < 0 then low else high in
  let reach (place, { low; high; _ }) =
    let corner = Vec.make (pick n.x low.Vec.x high.Vec.x) (pick n.y low.y high.y) (pick n.z low.z high.z) in
    Vec.dot n (Vec.add place corner)
  in
  match List.map reach bodies with
  | [] -> Scc_base.Bug.fail __POS__ "a set without points"
  | first :: rest -> List.fold_left Rat.max first rest

let corners margin =
  let both = if Rat.sign margin = 0 then [ margin ] else [ Rat.neg margin; margin ] in
  let with_z x y = List.map (Vec.make x y) both in
  List.concat_map (fun x -> List.concat_map (with_z x) both) both

(* All corners with n.p = h. *)
let on_plane bodies n h =
  let of_body (place, { corners; _ }) = List.map (Vec.add place) (Array.to_list corners) in
  List.filter (fun p -> Rat.equal (Vec.dot n p) h) (List.concat_map of_body bodies)

(* Whether some convex combinations of three lists, one of each, sum to 0. *)
let meet one two three =
  let column i (p : Vec.t) =
    let share j = if i = j then Rat.one else Rat.zero in
    [| p.x; p.y; p.z; share 0; share 1; share 2 |]
  in
  let columns_of i points = List.map (column i) points in
  let columns = Array.of_list (List.concat (List.mapi columns_of [ one; two; three ])) in
  let rows = Array.init 6 (fun r -> Array.map (fun c -> c.(r)) columns) in
  let right = Array.init 6 (fun r -> if r < 3 then Rat.zero else Rat.one) in
  let cost = Array.map (fun _ -> Rat.zero) columns in
  Option.is_some (Linear_program.least rows right ~cost)

(* Such a direction exists iff 0 is not in the convex hull of all differences d and of the ball about w: iff it is
   none of the d, and the cone that these span is farther from -w than the radius. *)
let for_ever ~margin one two =
  let w = Vec.sub two.velocity one.velocity in
  let is_beyond d2 = exceeds d2 one.spread2 two.spread2 in
  let cube = [ (Vec.zero, body (Array.of_list (corners margin))) ] in
  let back = Vec.neg w in
  (* Along w itself, as a rule. *)
  let by_boxes () =
    let reach = Rat.add (not_beyond two.bodies back) (not_beyond one.bodies w) in
    Rat.sign (Rat.add reach (not_beyond cube w)) < 0
  in
  let most n =
    let difference = Vec.sub (snd (farthest two.bodies n)) (snd (farthest one.bodies (Vec.neg n))) in
    if Rat.sign margin = 0 then difference else Vec.add difference (snd (farthest cube n))
  in
  let by_corners () =
    (* For all d now n.d >= 0. *)
    let n = Vec.add w (Nnls.nearest_in_cone ~most back) in
    let least bodies = on_plane bodies n (fst (range bodies n)) in
    is_beyond (Vec.norm2 n)
    && (Rat.sign (Vec.dot n (most (Vec.neg n))) > 0
        ||
        let greatest = on_plane one.bodies n (snd (range one.bodies n)) in
        not (meet (least two.bodies) (List.map Vec.neg greatest) (least cube)))
  in
  is_beyond (Vec.norm2 w) && (by_boxes () || by_corners ())

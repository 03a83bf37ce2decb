open Scc_exact

type t = { points : (Vec.t * Vec.t array) list; velocity : Vec.t; spread2 : Rat.t }

let exceeds d2 a b =
  let rest = Rat.sub d2 (Rat.add a b) in
  Rat.sign rest > 0 && Rat.compare (Rat.mul rest rest) (Rat.mul (Rat.of_int 4) (Rat.mul a b)) > 0

let fold f acc points =
  let about acc (place, around) = Array.fold_left (fun acc v -> f acc place v) acc around in
  List.fold_left about acc points

let farthest points n =
  let farther best place v =
    let h = Rat.add (Vec.dot n place) (Vec.dot n v) in
    match best with
    | Some (most, _, _) when Rat.compare h most <= 0 -> best
    | Some _ | None -> Some (h, place, v)
  in
  match fold farther None points with
  | Some (most, place, v) -> (most, Vec.add place v)
  | None -> Scc_base.Bug.fail __POS__ "a set without points"

let range points n = (Rat.neg (fst (farthest points (Vec.neg n))), fst (farthest points n))

let corners margin =
  let both = if Rat.sign margin = 0 then [ margin ] else [ Rat.neg margin; margin ] in
  let with_z x y = List.map (Vec.make x y) both in
  List.concat_map (fun x -> List.concat_map (with_z x) both) both

(* All points with n.p = h. *)
let on_plane points n h =
  fold (fun found place v ->
      let p = Vec.add place v in
      if Rat.equal (Vec.dot n p) h then p :: found else found)
    [] points

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
  let cube = [ (Vec.zero, Array.of_list (corners margin)) ] in
  let most n =
    let difference = Vec.sub (snd (farthest two.points n)) (snd (farthest one.points (Vec.neg n))) in
    if Rat.sign margin = 0 then difference else Vec.add difference (snd (farthest cube n))
  in
  is_beyond (Vec.norm2 w)
  &&
  (* For all d now n.d >= 0. *)
  let n = Vec.add w (Nnls.nearest_in_cone ~most (Vec.neg w)) in
  let least points = on_plane points n (fst (range points n)) in
  is_beyond (Vec.norm2 n)
  && (Rat.sign (Vec.dot n (most (Vec.neg n))) > 0
      ||
      let greatest = on_plane one.points n (snd (range one.points n)) in
      not (meet (least two.points) (List.map Vec.neg greatest) (least cube)))

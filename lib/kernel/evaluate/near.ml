open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_rigid
open Scc_motion

let reason = "touching within resolution cannot be decided at this instant"

(* What is needed of two parts that move: [speed] bounds how fast their distance changes, and [reach] is the sum of
   what the parts reach from their centres. *)
type pair = { one : Motion.t; two : Motion.t; speed : Rat.t; reach : Rat.t; resolution : Rat.t }

let square x = Rat.mul x x

(* Not near each other at an instant, by a margin, for the spheres about the centres. *)
let far_at p t margin =
  let centre (m : Motion.t) = Vec.axpy t m.velocity m.centre in
  let gap2 = Vec.norm2 (Vec.sub (centre p.one) (centre p.two)) in
  Rat.compare gap2 (square (Rat.add p.reach margin)) > 0

let distance2 p t = Closest.distance2 (Motion.vertices p.one t) (Motion.vertices p.two t)

let at p t =
  (not (far_at p t p.resolution)) && Rat.compare (distance2 p t) (square p.resolution) <= 0

(* Throughout the closed interval of half-width [h] about [t], if the distance at [t] tells. *)
let throughout p t h =
  let change = Rat.mul p.speed h in
  let apart = Rat.add p.resolution change in
  if far_at p t apart then Some false
  else
    let d2 = distance2 p t in
    if Rat.compare d2 (square apart) > 0 then Some false
    else
      let near = Rat.sub p.resolution change in
      if Rat.sign near >= 0 && Rat.compare d2 (square near) <= 0 then Some true else None

(* Closed intervals, in order, that cover [0, d]: what is known of each. Those that nothing was found of are
   narrow, or come after too many others. *)
let most_looks = 4_000

let same_known a b = Option.equal Bool.equal a b

(* Neighbours of which the same is known are one. *)
let join (low, high, known) = function
  | (low', _, known') :: rest when same_known known known' -> (low', high, known) :: rest
  | found -> (low, high, known) :: found

let pieces p d =
  let looks = ref 0 in
  let narrow h = Rat.compare (Rat.mul (Rat.of_int 32) (Rat.mul p.speed h)) p.resolution < 0 in
  let rec go found = function
    | [] -> List.rev found
    | (low, high) :: rest -> (
        let middle = Rat.middle low high and h = Rat.mul Rat.half (Rat.sub high low) in
        incr looks;
        match throughout p middle h with
        | Some known -> go (join (low, high, Some known) found) rest
        | None when narrow h || !looks > most_looks -> go (join (low, high, None) found) rest
        | None -> go found ((low, middle) :: (middle, high) :: rest))
  in
  go [] [ (Rat.zero, d) ]

let of_known = function
  | Some b -> Truth.of_bool b
  | None -> Truth.Undecided reason

(* The known intervals are closed, hence a cut between two is decided by either. *)
let over p d =
  let found = pieces p d in
  let cuts = List.map (fun (low, _, _) -> low) found in
  let covers t (low, high, _) = Rat.compare low t <= 0 && Rat.compare t high <= 0 in
  let is_end t (low, high, _) = Rat.equal low t || Rat.equal t high in
  let value t =
    let here = List.filter (covers t) found in
    match List.find_map (fun (_, _, known) -> known) here with
    | Some b -> Truth.of_bool b
    | None when List.exists (is_end t) here -> Truth.of_bool (at p t)
    | None -> of_known None
  in
  Timeline.simplify Truth.equal (Timeline.of_cuts (Timeline.Lasts d) cuts Truth.equal value)

let turns_or_moves p = Motion.turns p.one || Motion.turns p.two || not (Vec.equal p.one.velocity p.two.velocity)

(* A time from which on two straight ways lead apart, so far that the parts are not near: the distance of the
   centres grows from where it is least. *)
let parted p =
  let c = Vec.sub p.two.centre p.one.centre and w = Vec.sub p.two.velocity p.one.velocity in
  let nearest = Rat.max Rat.zero (Rat.neg (Rat.div (Vec.dot c w) (Vec.norm2 w))) in
  let rec from t = if far_at p t p.resolution then t else from (Rat.add (Rat.mul (Rat.of_int 2) t) Rat.one) in
  from nearest

(* For ever, in a quiescent network: two of which one turns stay apart by more than the resolution
   (rule Quiescent). *)
let for_ever p =
  if Motion.turns p.one || Motion.turns p.two then Timeline.constant Timeline.Forever Truth.False
  else if turns_or_moves p then
    let d = Rat.add (parted p) Rat.one in
    let piece = over p d in
    let value t = if Rat.compare t d >= 0 then Truth.False else Timeline.at piece (Algebraic.of_rat t) in
    let cuts = List.filter_map (fun (c : Truth.t Timeline.piece) -> Algebraic.to_rat c.cut) piece.rest in
    Timeline.of_cuts Timeline.Forever (d :: cuts) Truth.equal value
  else Timeline.constant Timeline.Forever (Truth.of_bool (at p Rat.zero))

let pair_touching p (extent : Timeline.extent) =
  match extent with
  | Instant -> Timeline.constant extent (Truth.of_bool (at p Rat.zero))
  | Lasts d when turns_or_moves p -> over p d
  | Lasts _ -> Timeline.constant extent (Truth.of_bool (at p Rat.zero))
  | Forever -> for_ever p

let touching ~resolution extent (p, i) (q, j) =
  let leaf path i = State.leaf_of (Path.process path) i in
  let same = State.has_leaf (Path.process p) j in
  let extent_of_pair = if same then Timeline.Instant else extent in
  let pair (one, reach_one) (two, reach_two) =
    let pair = { one; two; speed = Cast.speed_bound one two; reach = Rat.add reach_one reach_two; resolution } in
    pair_touching pair extent_of_pair
  in
  let others = Path.motions q (leaf q j) in
  let pairs = List.concat_map (fun a -> List.map (pair a) others) (Path.motions p (leaf p i)) in
  let found = List.fold_left (Timeline.map2 Truth.or_) (Timeline.constant extent_of_pair Truth.False) pairs in
  if same then Timeline.constant extent found.start else found

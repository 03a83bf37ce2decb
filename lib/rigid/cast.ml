open Scc_exact
open Scc_geometry

let speed_bound = Speed.bound
let grid = Speed.grid

type outcome = Never | Inside | At of Rat.t

(* {1 The grid} *)

let cell grid (t : Rat.t) = Z.fdiv (Z.shift_left t.num grid) t.den

(* k / 2^grid. *)
let point grid k =
  if Z.sign k = 0 then Rat.zero
  else
    let twos = Int.min grid (Z.trailing_zeros k) in
    { Q.num = Z.shift_right k twos; den = Z.shift_left Z.one (grid - twos) }

let instant grid k = At (point grid k)

(* Of an interval no wider than a cell at most one grid point lies strictly inside. *)
let floor_of grid t =
  match Algebraic.to_rat t with
  | Some t -> instant grid (cell grid t)
  | None ->
    let low, high = Algebraic.enclose t ~width:(point grid Z.one) in
    let k = cell grid high in
    let at = point grid k in
    if Rat.compare low at >= 0 || Algebraic.compare_rat t at > 0 then instant grid k
    else instant grid (Z.pred k)

(* {1 Without a turn} *)

let add v w = if Vec.is_zero w then v else Vec.add v w
let sub v w = if Vec.is_zero w then v else Vec.sub v w

let straight obstacle (a : Motion.t) (b : Motion.t) ~span ~grid =
  let obstacle, offset =
    if Quaternion.is_identity a.turned && Quaternion.is_identity b.turned then
      let obstacle = match obstacle with Some o -> o | None -> Obstacle.make a.solid b.solid in
      (obstacle, sub (add b.centre b.arm) (add a.centre a.arm))
    else
      let sa, pa = Motion.placed a Rat.zero and sb, pb = Motion.placed b Rat.zero in
      (Obstacle.make sa sb, Vec.sub pb pa)
  in
  match Obstacle.first_time_of_contact obstacle offset (sub b.velocity a.velocity) with
  | Never -> Never
  | Inside -> Inside
  | At t -> if Rat.compare t span < 0 then instant grid (cell grid t) else Never

(* {1 Exactly} *)

type query = { a : Motion.t; b : Motion.t; obstacle : Obstacle.t option; span : Rat.t; grid : int }

let turning q = Motion.turns q.a || Motion.turns q.b

(* The interiors are disjoint up to [from]. *)
let sweep q from until =
  if not (turning q) then straight q.obstacle q.a q.b ~span:q.span ~grid:q.grid
  else
    match Sweep.first_penetration q.a q.b ~from ~until with
    | Never -> Never
    | At t -> floor_of q.grid t

let exactly q =
  if not (turning q) then straight q.obstacle q.a q.b ~span:q.span ~grid:q.grid
  else
    match Sweep.relation q.a q.b Rat.zero with
    | Interpenetrating -> Inside
    | Apart | Touching -> sweep q Rat.zero q.span

(* {1 In floats} *)

let most_steps = 64

(* At a delay, until a proof holds for one. *)
let most_tries = 6

type search = {
  query : query;
  flight : Flight.t;
  simplex : Simplex.t;
  plane : Separation.t;
  last : float;  (** the span, rounded down *)
  fine : bool;  (** every instant of the grid in the span is a float *)
}

(* How the search stands: the interiors are disjoint up to [t], which is 0 only at first. *)
type stand = {
  t : float;
  steps : int;  (** that may still be taken *)
  probes : int;  (** how often a penetration was looked for in vain *)
  sweeps : int;  (** how often exact arithmetic had to help *)
}

(* Whether the interiors meet at the instant that the flight is at. [Simplex.miss] finds a point q + k c of the
   displaced set, q a vector from A to B, c the vector between inner points, around which there is a ball of radius
   r in the set of all such vectors. If |q + k c| < k r, then -q/k is in that ball; and the origin, which lies
   between -q/k and q, is in the interior of the set. *)
let meets s =
  let noise = Flight.epsilon *. s.flight.scales.length and r = Simplex.depth s.simplex in
  let k = 4. *. noise /. r in
  k < 0x1p-10 && Simplex.miss s.simplex k < 0.5 *. k *. r

(* Of an instant of the span: the cell of the grid that holds it, and where a cell begins. *)
let cell_of s t = Float.of_int (int_of_float (Float.ldexp t s.query.grid))
let begin_of s k = Float.ldexp k (-s.query.grid)

(* A delay that leads from t beyond t' >= t or just there: the difference is rounded up. *)
let delay t t' = Float.succ (t' -. t)

let rec advance s at =
  if at.steps = 0 then sweep s.query (Q.of_float at.t) s.query.span
  else begin
    Flight.move s.flight at.t;
    match Simplex.search s.simplex with
    | Near -> if at.t = 0. then begin_near s at else slowly s at
    | Apart _ ->
      Heading.aim s.plane s.simplex;
      (* as yet no one knows that they do not meet now *)
      if at.t = 0. && not (Separation.holds s.plane 0.) then begin_near s at else look_ahead s at
  end

(* The instant of contact is guessed between two bounds, which are the closer together the nearer it is. *)
and look_ahead s at =
  let { Heading.sooner; later } = Heading.delays s.plane s.simplex in
  let rest = delay at.t s.flight.scales.end_ in
  if not (sooner > 0.) then slowly s at
  else if sooner >= rest then if Separation.holds s.plane rest then Never else shorten s at rest most_tries
  else
    let careful = 0x0.ffcp0 *. sooner in
    let expected = at.t +. later in
    let k = if s.fine && expected < s.last then cell_of s (at.t +. sooner) else -1. in
    if k < 0. || cell_of s expected <> k then step s at careful most_tries
    else
      let from = begin_of s k in
      let apart_until_cell =
        from <= at.t || (delay at.t from < sooner && Separation.holds s.plane (delay at.t from))
      in
      if apart_until_cell then probe s at k (expected +. (later -. sooner)) careful
      else step s at careful most_tries

(* The interiors are disjoint until cell k begins, and are expected to meet in it. Whether they do is looked at a
   while after the expected instant, but not long after, as they might be apart again; and not at the expected
   instant, where they may hardly meet. *)
and probe s at k expected careful =
  let while_ = Float.ldexp s.last (-8 - (6 * at.probes)) in
  let probed = Float.min s.last (Float.min (begin_of s (k +. 1.)) (expected +. while_)) in
  Flight.move s.flight probed;
  if probed > at.t && meets s then instant s.query.grid (Z.of_float k)
  else begin
    Flight.move s.flight at.t;
    step s { at with probes = at.probes + 1 } careful most_tries
  end

and step s at delay tries =
  if Separation.holds s.plane delay then
    advance s { at with t = Float.pred (at.t +. delay); steps = at.steps - 1 }
  else shorten s at delay tries

and shorten s at delay tries =
  let shorter = Heading.fitted s.plane delay in
  let gains = at.t +. shorter > at.t +. (0x1p-30 *. s.last) in
  if tries > 0 && s.plane.low.(0) > 0. && gains then step s at shorter (tries - 1) else slowly s at

(* What floats cannot tell is left to exact arithmetic for a while, between short numbers; each time for longer. *)
and slowly s at =
  let unit = Float.ldexp 1. (snd (Float.frexp s.last) - 8) in
  let from = unit *. Float.floor (at.t /. unit) in
  let until = from +. (Float.ldexp unit (2 + (3 * at.sweeps))) in
  if at.sweeps > 3 || not (until < s.last) || not (turning s.query) then
    sweep s.query (Q.of_float from) s.query.span
  else
    match sweep s.query (Q.of_float from) (Q.of_float until) with
    | Never -> advance s { at with t = until; steps = at.steps - 1; sweeps = at.sweeps + 1 }
    | known -> known

and begin_near s at =
  if meets s then Inside
  else
    match Sweep.relation s.query.a s.query.b Rat.zero with
    | Interpenetrating -> Inside
    | Apart | Touching -> slowly s at

let first_time_of_contact ?obstacle a b ~span ~grid =
  let q = { a; b; obstacle; span; grid } in
  let still (m : Motion.t) = not (Motion.turns m) && Quaternion.is_identity m.turned in
  if still a && still b then straight obstacle a b ~span ~grid
  else
    let end_ = Float_box.up span in
    match Flight.make a b end_ with
    | None -> exactly q
    | Some flight ->
      if Flight.apart_forever flight then Never
      else
        let s =
          {
            query = q;
            flight;
            simplex = Simplex.make flight;
            plane = Separation.make flight;
            last = Float_box.down span;
            fine = grid < 900 && Float.ldexp end_ grid < 0x1p51;
          }
        in
        advance s { t = 0.; steps = most_steps; probes = 0; sweeps = 0 }

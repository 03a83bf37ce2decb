open Scc_exact
open Scc_geometry

let speed_bound = Speed.bound
let grid = Speed.grid

type outcome = Never | Inside | At of Rat.t

(* {1 The grid} *)

(* Its instants are those at which the time since it began to count is a multiple of 2^-grid; the phase is the time
   since then. *)
type clock = { grid : int; phase : Rat.t }

let add_phase c t = if Rat.sign c.phase = 0 then t else Rat.add t c.phase
let cell_at grid (t : Rat.t) = Z.fdiv (Z.shift_left t.num grid) t.den
let cell c t = cell_at c.grid (add_phase c t)

(* k / 2^grid. *)
let point grid k =
  if Z.sign k = 0 then Rat.zero
  else
    let twos = Int.min grid (Z.trailing_zeros k) in
    { Q.num = Z.shift_right k twos; den = Z.shift_left Z.one (grid - twos) }

let begin_of_cell c k =
  let t = point c.grid k in
  if Rat.sign c.phase = 0 then t else Rat.sub t c.phase

(* An instant that has passed is now. *)
let instant c k = At (Rat.max Rat.zero (begin_of_cell c k))
let next_instant ~grid ~phase t =
  let c = { grid; phase } in
  begin_of_cell c (Z.succ (cell c t))

(* Of an interval no wider than a cell at most one grid point lies strictly inside. *)
let floor_of c t =
  match Algebraic.to_rat t with
  | Some t -> instant c (cell c t)
  | None ->
    let low, high = Algebraic.enclose t ~width:(point c.grid Z.one) in
    let k = cell c high in
    let at = begin_of_cell c k in
    if Rat.compare low at >= 0 || Algebraic.compare_rat t at > 0 then instant c k
    else instant c (Z.pred k)

(* {1 Without a turn} *)

let add v w = if Vec.is_zero w then v else Vec.add v w
let sub v w = if Vec.is_zero w then v else Vec.sub v w

let straight obstacle (a : Motion.t) (b : Motion.t) ~span clock =
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
  | At t -> if Rat.compare t span < 0 then instant clock (cell clock t) else Never

(* {1 Exactly} *)

type query = { a : Motion.t; b : Motion.t; obstacle : Obstacle.t option; span : Rat.t; clock : clock }

let turning q = Motion.turns q.a || Motion.turns q.b

(* The interiors are disjoint up to [from]. *)
let sweep q from until =
  if not (turning q) then straight q.obstacle q.a q.b ~span:q.span q.clock
  else
    match Sweep.first_penetration q.a q.b ~from ~until with
    | Never -> Never
    | At t -> floor_of q.clock t

let exactly q =
  if not (turning q) then straight q.obstacle q.a q.b ~span:q.span q.clock
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
  simplex : Gjk.t;
  plane : Separation.t;
  last : float;  (** the span, rounded down *)
  fine : bool;  (** every instant of the grid, counted from its begin, in the span is a float *)
  phase : float;
  phase_below : float;
  phase_above : float;  (** of the grid: about, and rounded down and up *)
}

(* How the search stands: the interiors are disjoint up to [t], which is 0 only at first. *)
type stand = {
  t : float;
  steps : int;  (** that may still be taken *)
  probes : int;  (** how often a penetration was looked for in vain *)
  sweeps : int;  (** how often exact arithmetic had to help *)
}

(* Whether the interiors meet at the instant that the flight is at. [Gjk.miss] finds a point q + k c of the
   displaced set, q a vector from A to B, c the vector between inner points, around which there is a ball of radius
   r in the set of all such vectors. If |q + k c| < k r, then -q/k is in that ball; and the origin, which lies
   between -q/k and q, is in the interior of the set. *)
let meets s =
  let noise = Flight.epsilon *. s.flight.scales.length and r = Gjk.depth s.simplex in
  let k = 4. *. noise /. r in
  k < 0x1p-10 && Gjk.miss s.simplex k < 0.5 *. k *. r

(* Of an instant of the span: the cell of the grid that holds it, and where a cell begins, or a little after, and a
   little before it. Which cell it is may be wrong by one where the grid has a phase: it is a guess there. *)
let cell_of s t = Float.of_int (int_of_float (Float.ldexp (t +. s.phase) s.query.clock.grid))
let exactly_begins s k = Float.ldexp k (-s.query.clock.grid)
let begins_by s k =
  if s.phase = 0. then exactly_begins s k else Next_float.succ (exactly_begins s k -. s.phase_below)

let begins_after s k =
  if s.phase = 0. then exactly_begins s k else Next_float.pred (exactly_begins s k -. s.phase_above)

(* A delay that leads from t beyond t' >= t or just there: the difference is rounded up. *)
let delay t t' = Next_float.succ (t' -. t)

let rec advance s at =
  if at.steps = 0 then sweep s.query (Q.of_float at.t) s.query.span
  else begin
    Flight.move s.flight at.t;
    match Gjk.search s.simplex with
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
      let from = begins_by s k in
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
  let probed = Float.min s.last (Float.min (begins_after s (k +. 1.)) (expected +. while_)) in
  Flight.move s.flight probed;
  if probed > at.t && meets s then instant s.query.clock (Z.of_float k)
  else begin
    Flight.move s.flight at.t;
    step s { at with probes = at.probes + 1 } careful most_tries
  end

and step s at delay tries =
  if Separation.holds s.plane delay then
    advance s { at with t = Next_float.pred (at.t +. delay); steps = at.steps - 1 }
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

let first_time_of_contact ?obstacle ?(phase = Rat.zero) a b ~span ~grid =
  let clock = { grid; phase } in
  let q = { a; b; obstacle; span; clock } in
  let still (m : Motion.t) = not (Motion.turns m) && Quaternion.is_identity m.turned in
  if still a && still b then straight obstacle a b ~span clock
  else
    let end_ = Float_box.up span in
    match Flight.make a b end_ with
    | None -> exactly q
    | Some flight ->
      if Flight.apart_forever flight then Never
      else
        let phase_above = if Rat.sign phase = 0 then 0. else Float_box.up phase in
        let s =
          {
            query = q;
            flight;
            simplex = Gjk.make flight;
            plane = Separation.make flight;
            last = Float_box.down span;
            fine = grid < 900 && Float.ldexp (end_ +. phase_above) grid < 0x1p51;
            phase = Rat.to_float phase;
            phase_below = Float_box.down phase;
            phase_above;
          }
        in
        advance s { t = 0.; steps = most_steps; probes = 0; sweeps = 0 }

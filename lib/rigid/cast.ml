open Scc_exact
open Scc_geometry

let speed_bound = Speed.bound
let grid = Speed.grid

type outcome = Never | Inside | At of Rat.t

(* {1 The grid} *)

let power grid = Z.shift_left Z.one grid
let cell grid t = Rat.floor (Rat.mul t (Q.of_bigint (power grid)))
let instant grid k = At (Rat.make k (power grid))

(* Of an interval no wider than a cell at most one grid point lies strictly inside. *)
let floor_of grid t =
  match Algebraic.to_rat t with
  | Some t -> instant grid (cell grid t)
  | None ->
    let low, high = Algebraic.enclose t ~width:(Rat.make Z.one (power grid)) in
    let k = cell grid high in
    let point = Rat.make k (power grid) in
    if Rat.compare low point >= 0 || Algebraic.compare_rat t point > 0 then instant grid k
    else instant grid (Z.pred k)

(* {1 Without a turn} *)

let straight obstacle (a : Motion.t) (b : Motion.t) ~span ~grid =
  let obstacle, offset =
    match obstacle with
    | Some o when Quaternion.is_identity a.turned && Quaternion.is_identity b.turned ->
      (o, Vec.sub (Vec.add b.centre b.arm) (Vec.add a.centre a.arm))
    | _ ->
      let sa, pa = Motion.placed a Rat.zero and sb, pb = Motion.placed b Rat.zero in
      (Obstacle.make sa sb, Vec.sub pb pa)
  in
  match Obstacle.first_time_of_contact obstacle offset (Vec.sub b.velocity a.velocity) with
  | Never -> Never
  | Inside -> Inside
  | At t -> if Rat.compare t span < 0 then instant grid (cell grid t) else Never

(* {1 Exactly} *)

type query = { a : Motion.t; b : Motion.t; obstacle : Obstacle.t option; span : Rat.t; grid : int }

let turning q = Motion.turns q.a || Motion.turns q.b

(* The interiors are disjoint up to [from]. *)
let sweep q from until =
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

type search = {
  query : query;
  flight : Flight.t;
  simplex : Simplex.t;
  plane : Separation.t;
  last : float;  (** the span, rounded down *)
  fine : bool;  (** the grid is coarse enough for floats *)
}

(* Whether the interiors meet at the instant that the flight is at: the point that [Simplex.miss] finds in the set of
   all vectors from A to B, displaced by k c, is q, c the vector between inner points and r the radius of a ball around
   it in the set. The origin is on the way from q - k c, which is in the set, to x = c - q / k. If |q| < k r, x is
   inside that ball, and the origin in the interior of the set. *)
let meets s =
  let noise = Flight.epsilon *. s.flight.scales.length and r = Simplex.depth s.simplex in
  let k = 4. *. noise /. r in
  k < 0x1p-10 && Simplex.miss s.simplex k < 0.5 *. k *. r

let point s t = Float.of_int (int_of_float (Float.ldexp t s.query.grid))
let instant_of s k = instant s.query.grid (Z.of_float k)
let time s k = Float.ldexp k (-s.query.grid)

(* A proof for [delay t t'] covers all instants from t to t' > t: the difference is rounded up. *)
let delay t t' = Float.succ (t' -. t)
let most_steps = 64
let most_fits = 6

(* The interiors are disjoint up to [t]. [tries]: how often a penetration was looked for in vain. *)
let rec advance s t steps tries =
  if steps = 0 then sweep s.query (Q.of_float t) s.query.span
  else begin
    Flight.move s.flight t;
    match Simplex.search s.simplex with
    | Near -> if t = 0. then begin_near s steps else slowly s t steps
    | Apart _ -> look_ahead s t steps tries
  end

and look_ahead s t steps tries =
  Heading.aim s.plane s.simplex;
  let { Heading.sooner; later } = Heading.delays s.plane s.simplex in
  let rest = delay t s.flight.scales.end_ in
  if sooner >= rest then if Separation.holds s.plane rest then Never else fit s t steps tries rest most_fits
  else
    let careful = sooner *. (1. -. 0x1p-10) in
    let k = if s.fine && t +. later < s.last then point s (t +. sooner) else -1. in
    if k >= 0. && point s (t +. later) = k then
      let from = time s k in
      if from <= t then enter s t k t ((2. *. later) -. sooner) steps tries careful
      else if delay t from < sooner && Separation.holds s.plane (delay t from) then
        enter s t k from ((2. *. later) -. sooner) steps tries careful
      else step s t steps tries careful most_fits
    else step s t steps tries careful most_fits

(* The interiors are disjoint up to [from], which lies in cell k; they are expected to meet at some delay after [t]. *)
and enter s t k from expected steps tries careful =
  let scale = Float.ldexp s.last (-8 - (6 * tries)) in
  let probe = Float.min s.last (Float.min (time s (k +. 1.)) (t +. expected +. scale)) in
  Flight.move s.flight probe;
  if meets s then instant_of s k
  else begin
    ignore (from : float);
    Flight.move s.flight t;
    ignore (Simplex.search s.simplex);
    step s t steps (tries + 1) careful most_fits
  end

and step s t steps tries delay fits =
  if Separation.holds s.plane delay then advance s (Float.pred (t +. delay)) (steps - 1) tries
  else fit s t steps tries delay fits

and fit s t steps tries delay fits =
  let shorter = Heading.fitted s.plane delay in
  if fits = 0 || not (s.plane.low.(0) > 0.) || not (t +. shorter > t +. (0x1p-30 *. s.last)) then slowly s t steps
  else step s t steps tries shorter (fits - 1)

(* What floats cannot tell at [t]. *)
and slowly s t steps =
  let until = t +. Float.max (0x1p-6 *. s.last) (0x1p-40 *. t) in
  if until >= s.last then sweep s.query (Q.of_float t) s.query.span
  else
    match sweep s.query (Q.of_float t) (Q.of_float until) with
    | Never -> advance s until (steps - 1) 0
    | known -> known

and begin_near s steps =
  if meets s then Inside
  else
    match Sweep.relation s.query.a s.query.b Rat.zero with
    | Interpenetrating -> Inside
    | Apart | Touching -> slowly s 0. steps

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
            fine = grid < 1000 && Float.ldexp end_ grid < 0x1p51;
          }
        in
        advance s 0. most_steps 0

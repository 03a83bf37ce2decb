open Scc_exact
open Enclosure

type solution = { interval : int -> Rat.t * Rat.t option; row : int array; sweeps : int }

(* How much of the uncertainty of a component comes from what it leads to: a share of what is there, and so much
   more. Half of the widest interval, as guesses are made with the middles of intervals. *)
type outside = { share : float; more : float }

let first_entry_of e v = Equations.first_entry e (Equations.first_row e v)

let outside_of t part =
  let share = ref 0. and more = ref 0. in
  let e = t.e in
  for i = first_entry_of e part.first to first_entry_of e (part.last + 1) - 1 do
    let w = Equations.node e i in
    if w < part.first || w > part.last then begin
      let low = t.r.lower.(w) in
      let gap = t.r.upper.(w) -. low in
      if t.effort.relative && low > 1e-200 then begin
        if gap > !share *. low then share := gap /. low
      end
      else if gap > !more then more := gap
    end
  done;
  { share = 0.5 *. !share; more = 0.5 *. !more }

let bounded o = o.share < infinity && o.more < infinity

(* What the ends of an interval around a guess x are to be, but for what comes from outside: farther from x by a
   share of it (or by that itself, where widths are absolute); by the same for all nodes; or by so much for each of
   the steps that the component is expected to take from there. *)
type margin = Gap of float | Even of float | Per_step of float

let low_end t o ~gap x =
  let o = if bounded o then o else { share = 0.; more = 0. } in
  if t.effort.relative then (x *. (1. -. gap -. o.share)) -. o.more else x -. gap -. o.more

let high_end t o ~gap x =
  if t.effort.relative then (x *. (1. +. gap +. o.share)) +. o.more +. 1e-200 else x +. gap +. o.more

(* Whether all intervals of a component are as narrow as trials would make them. *)
let narrow t part o ~gap =
  let twice = { share = 2. *. o.share; more = 2. *. o.more } in
  let rec go v =
    v > part.last || (t.r.upper.(v) <= high_end t twice ~gap:(2. *. gap) t.r.lower.(v) && go (v + 1))
  in
  go part.first

type side = Low | High

(* Guesses ends of one side, and sees in so many sweeps at most whether they are right. [quickly]: as long as each
   sweep leaves half of the doubts, or those are very few. *)
let attempt t part o side margin ~quickly ~sweeps =
  let first = part.first and last = part.last in
  let gap = match margin with Gap gap -> gap | Even _ | Per_step _ -> 0. in
  let farther v =
    match (margin, t.steps) with
    | Even far, _ -> far
    | Per_step far, Some steps -> far *. steps.guess.(v)
    | Per_step _, None | Gap _, _ -> 0.
  in
  for v = first to last do
    match side with
    | Low -> Rounded.set_low t.r v (low_end t o ~gap t.r.guess.(v) -. farther v)
    | High -> Rounded.set_high t.r v (high_end t o ~gap t.r.guess.(v) +. farther v)
  done;
  let drop () =
    match side with
    | Low -> Rounded.drop_low t.r ~first ~last
    | High -> Rounded.drop_high t.r ~first ~last
  in
  let rec go n ~least ~patience =
    if n = 0 || patience = 0 then false
    else begin
      (match worked t (size part) with
       | () -> ()
       | exception Enough ->
         drop ();
         raise Enough);
      let forward = n land 1 = 0 in
      match
        match side with
        | Low -> Rounded.sweep_low t.r ~first ~last ~forward
        | High -> Rounded.sweep_high t.r ~first ~last ~forward
      with
      | Proved ->
        (match side with
         | Low -> Rounded.accept_low t.r ~first ~last
         | High -> Rounded.accept_high t.r ~first ~last);
        true
      | Open ->
        let against = t.r.measure.(0) in
        if quickly && against > 0.5 *. least && against > 0.001 *. float_of_int (size part) then false
        else if against < least then go (n - 1) ~least:against ~patience:(8 + (n / 4))
        else go (n - 1) ~least ~patience:(patience - 1)
      | Refuted -> false
    end
  in
  let proved = go sweeps ~least:infinity ~patience:(8 + (sweeps / 4)) in
  if not proved then drop ();
  proved
let solve_part t part ~gap =
  let first = part.first and last = part.last in
  let o = outside_of t part in
  let p = Guess.pace t in
  let trial ?(quickly = false) side margin sweeps = attempt t part o side margin ~quickly ~sweeps in
  let early change =
    p.early <- 2 * p.early;
    let near = Guess.distance p change in
    if near < infinity then begin
      ignore (trial Low (Gap (2. *. near)) (4 + (p.sweeps / 16)));
      if bounded o then ignore (trial High (Gap (2. *. near)) (4 + (p.sweeps / 16)))
    end
    else ignore (trial Low (Gap 0.) 4)
  in
  (* Until the limit seems to be so near, or is as near as floats come. *)
  let rec approach target =
    let change = Guess.round t part p ~target in
    if Guess.stalled t part change || Guess.circling p then true
    else if Guess.distance p change <= target then false
    else begin
      if p.sweeps >= p.early then early change;
      approach target
    end
  in
  (* Where some scheduler may stay for ever, there may be no greatest number of steps. *)
  let by_steps =
    lazy (Guess.per_step t part ~gap ~sweeps:((if t.proper then 16 else 1) * (1_000 + p.sweeps)))
  in
  let prove side gap sweeps =
    (t.effort.relative && trial side (Even (gap *. Guess.least t part)) 2)
    || trial ~quickly:true side (Gap gap) sweeps
    || (let far = Lazy.force by_steps in
        far > 0. && trial side (Per_step far) 8)
    || trial side (Gap gap) sweeps
  in
  let rec go ~low ~high ~tries target gap =
    let stalled = approach target in
    let sweeps = tries * (16 + p.sweeps) in
    let low = low || prove Low gap sweeps in
    let high = high || (not (bounded o)) || prove High gap sweeps in
    if not (low && high) then
      let tries = 2 * tries in
      if not stalled then go ~low ~high ~tries (target /. 64.) gap
      else if gap < Rounded.ceiling then go ~low ~high ~tries target (64. *. gap)
  in
  if not (narrow t part o ~gap) then begin
    let direct = Guess.directly t part in
    if t.fresh && (not direct) && Float.is_finite t.r.upper.(first) then Guess.start t part p;
    if t.fresh && not direct then Krylov.approach t t.r part;
    let low = direct && trial Low (Gap gap) 8 in
    let high = direct && bounded o && trial High (Gap gap) 8 in
    if not (low && (high || not (bounded o))) then go ~low ~high ~tries:1 (gap /. 64.) gap
  end;
  Option.iter (fun (r : Rounded.t) -> Array.fill r.guess first (size part) 0.) t.steps;
  Rounded.settle t.r ~first ~last

let parts_of (e : Equations.t) = Array.length e.parts - 1

(* The greatest number of components of more than one node that a way can go through. *)
let depth (e : Equations.t) =
  let at = Array.make e.size 0 and deepest = ref 0 in
  for k = 0 to parts_of e - 1 do
    let first = e.parts.(k) and last = e.parts.(k + 1) - 1 in
    let below = ref 0 in
    for i = first_entry_of e first to first_entry_of e (last + 1) - 1 do
      if Equations.node e i < first then below := Int.max !below at.(Equations.node e i)
    done;
    let here = if last > first then !below + 1 else !below in
    Array.fill at first (last - first + 1) here;
    deepest := Int.max !deepest here
  done;
  !deepest

let pass t ~gap =
  for k = 0 to parts_of t.e - 1 do
    let part = { first = t.e.parts.(k); last = t.e.parts.(k + 1) - 1 } in
    if size part = 1 then begin
      worked t 1;
      Rounded.single t.r part.first
    end
    else solve_part t part ~gap
  done

(* The sum of the gaps of what is asked for: it tells whether a pass was of any use. *)
let uncertainty t =
  Array.fold_left (fun sum v -> sum +. (t.r.upper.(v) -. t.r.lower.(v))) 0. t.asked

let rec passes t ~gap ~before =
  pass t ~gap;
  t.fresh <- false;
  if not (Array.for_all (good t) t.asked) then begin
    let now = uncertainty t in
    if gap > 0x1p-60 && (now < 0.9 *. before || gap > 0x1p-40) then passes t ~gap:(gap /. 8.) ~before:now
  end

let solve (e : Equations.t) (effort : Effort.t) ~upper ~asked =
  let t = Enclosure.start e effort ~upper ~asked in
  let gap = 0.45 *. Rat.to_float effort.width /. float_of_int (Int.max 1 (depth e)) in
  (match passes t ~gap ~before:infinity with () -> () | exception Enough -> ());
  {
    interval = Rounded.interval t.r;
    row = (match e.direction with Max -> t.r.low_row | Min -> t.r.high_row);
    sweeps = t.work / Int.max 1 e.size;
  }

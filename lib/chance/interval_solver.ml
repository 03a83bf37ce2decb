open Scc_exact
open Scc_data

type solution = { interval : int -> Rat.t * Rat.t option; row : int array; sweeps : int }

exception Enough

type t = {
  e : Equations.t;
  effort : Effort.t;
  r : Rounded.t;
  asked : int list;
  few : bool;  (** so few are asked for that to look at them costs nothing *)
  mutable work : int;  (** nodes that were looked at *)
  mutable next : int;  (** the work at which the next question is due whether to go on *)
}

let stride = 100_000

(* Whether the interval of a node is good enough, exactly. *)
let good t v =
  let low, high = Rounded.interval t.r v in
  let decided () =
    match t.effort.bound with
    | None -> false
    | Some bound ->
      let a : Answer.t = match high with None -> At_least low | Some high -> Within (low, high) in
      Option.is_some (Answer.holds a bound)
  in
  match high with
  | None -> decided ()
  | Some high ->
    let width = if t.effort.relative then Rat.mul t.effort.width low else t.effort.width in
    Rat.compare (Rat.sub high low) width <= 0 || decided ()

let worked t n =
  t.work <- t.work + n;
  if t.work >= t.next then begin
    t.next <- t.work + stride;
    if t.effort.interrupted () || (t.few && List.for_all (good t) t.asked) then raise Enough
  end

type part = { first : int; last : int }

let size part = part.last - part.first + 1

(* How much of the uncertainty of a component comes from what it leads to: a share of what is there, and so much
   more. Half of the widest interval, as guesses are made with the middles of intervals. *)
type outside = { share : float; more : float }

let outside_of t part =
  let share = ref 0. and more = ref 0. in
  let e = t.e in
  for i = (Int_array.get e.first_entry ((Int_array.get e.first_row (part.first)))) to (Int_array.get e.first_entry ((Int_array.get e.first_row (part.last + 1)))) - 1 do
    let w = (Int_array.get e.node i) in
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

(* What the ends of an interval around a guess are to be. *)
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

(* Guesses ends of one side, and sees in so many sweeps at most whether they are right. *)
let attempt t part o side ~gap ~sweeps =
  let first = part.first and last = part.last in
  for v = first to last do
    match side with
    | Low -> Rounded.set_low t.r v (low_end t o ~gap t.r.guess.(v))
    | High -> Rounded.set_high t.r v (high_end t o ~gap t.r.guess.(v))
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
        if against < least then go (n - 1) ~least:against ~patience:(8 + (n / 4))
        else go (n - 1) ~least ~patience:(patience - 1)
      | Refuted -> false
    end
  in
  let proved = go sweeps ~least:infinity ~patience:(8 + (sweeps / 4)) in
  if not proved then drop ();
  proved

(* Guesses come nearer to the solution by rounds (modified policy iteration): one sweep finds the best rows, and
   then these are evaluated by pairs of sweeps, one up and one down. Of each pair the first one's change is
   looked at. Changes become a geometric sequence in the end, and what is changed is the same up to a factor: so
   the limit can be seen from far. Nothing that is proved depends on it. *)
type pace = {
  mutable sweeps : int;
  mutable rounds : int;
  mutable change : float;  (** the greatest one of the last pair *)
  mutable moved : float;  (** the sum of its changes *)
  mutable ratio : float;  (** of the last two sums *)
  mutable steady : int;  (** for how many pairs of sweeps the ratio has been nearly the same *)
  mutable rate : float;  (** the ratio when it last was so *)
  mutable least : float;  (** of the changes of the first sweeps of all rounds *)
  mutable since : int;  (** the round of that *)
  mutable early : int;  (** the number of sweeps at which ends are tried before they are near *)
}

let distance ~rate change =
  if change = 0. then 0. else if rate >= 1. then infinity else change *. rate /. (1. -. rate)

let pair t part p =
  let relative = t.effort.relative and first = part.first and last = part.last in
  worked t (2 * size part);
  Rounded.remember t.r ~first ~last;
  let change = Rounded.evaluate t.r ~first ~last ~forward:true ~relative in
  let moved = t.r.measure.(0) in
  ignore (Rounded.evaluate t.r ~first ~last ~forward:false ~relative);
  let ratio = if p.moved > 0. && p.moved < infinity then moved /. p.moved else 1. in
  p.steady <- (if Float.abs (ratio -. p.ratio) < 0.1 *. (1. -. ratio) then p.steady + 1 else 0);
  p.ratio <- ratio;
  if p.steady > 0 || ratio > p.rate then p.rate <- ratio;
  p.change <- change;
  p.moved <- moved;
  p.sweeps <- p.sweeps + 2;
  if p.steady > 0 then begin
    Rounded.go_on t.r ~first ~last ~factor:(ratio /. (1. -. ratio));
    p.steady <- 0;
    p.ratio <- 1.;
    p.moved <- infinity
  end

(* Floats do not get on when a sweep changes the last digits alone. *)
let stalled t part change =
  change = 0.
  || change
     <= 0x1p-49
             *. (if t.effort.relative then 1.
                 else
                   let greatest = ref 0. in
                   for v = part.first to part.last do
                     if t.r.guess.(v) > !greatest then greatest := t.r.guess.(v)
                   done;
                   !greatest)

let pairs = 12

(* Guesses that leap, or follow rows that are not the best, may go in circles. What does not get on after so many
   rounds goes on with the best rows alone, and this comes to the solution from wherever it is. *)
let patience = 500

(* One round; the change of its first sweep. *)
let round t part p ~target =
  let first = part.first and last = part.last in
  worked t (size part);
  let change = Rounded.improve t.r ~first ~last ~forward:(p.rounds land 1 = 0) ~relative:t.effort.relative in
  p.sweeps <- p.sweeps + 1;
  p.rounds <- p.rounds + 1;
  if change < p.least then begin
    p.least <- change;
    p.since <- p.rounds
  end;
  p.change <- infinity;
  p.moved <- infinity;
  p.ratio <- 1.;
  p.steady <- 0;
  let enough = Float.max (0.25 *. target) (0.25 *. change) in
  let rec go n =
    if n > 0 && not (stalled t part p.change) then begin
      pair t part p;
      if distance ~rate:p.rate p.change > enough then go (n - 1)
    end
  in
  if distance ~rate:p.rate change > target && not (stalled t part change) then
    if p.rounds - p.since < patience then go (Int.min pairs p.rounds);
  change

let solve_part t part ~gap =
  let o = outside_of t part in
  let p =
    {
      sweeps = 0;
      rounds = 0;
      change = infinity;
      moved = infinity;
      ratio = 1.;
      steady = 0;
      rate = 1.;
      least = infinity;
      since = 0;
      early = (if t.few then 64 else 256);
    }
  in
  let trial side gap sweeps = attempt t part o side ~gap ~sweeps in
  let early change =
    p.early <- 2 * p.early;
    let near = distance ~rate:p.rate change in
    if near < infinity then begin
      ignore (trial Low (2. *. near) (4 + (p.sweeps / 16)));
      if bounded o then ignore (trial High (2. *. near) (4 + (p.sweeps / 16)))
    end
    else ignore (trial Low 0. 4)
  in
  (* Until the limit seems to be so near, or is as near as floats come. *)
  let rec approach target =
    let change = round t part p ~target in
    if stalled t part change || p.rounds - p.since > 2 * patience then true
    else if distance ~rate:p.rate change <= target then false
    else begin
      if p.sweeps >= p.early then early change;
      approach target
    end
  in
  let rec go ~low ~high target gap =
    let stalled = approach target in
    let sweeps = 16 + p.sweeps in
    let low = low || trial Low gap sweeps in
    let high = high || (not (bounded o)) || trial High gap sweeps in
    if not (low && high) then
      if not stalled then go ~low ~high (target /. 64.) gap
      else if gap < Rounded.ceiling then go ~low ~high target (64. *. gap)
  in
  if not (narrow t part o ~gap) then go ~low:false ~high:false (gap /. 64.) gap;
  Rounded.settle t.r ~first:part.first ~last:part.last

let parts_of (e : Equations.t) = Array.length e.parts - 1

(* The greatest number of components of more than one node that a way can go through. *)
let depth (e : Equations.t) =
  let at = Array.make e.size 0 and deepest = ref 0 in
  for k = 0 to parts_of e - 1 do
    let first = e.parts.(k) and last = e.parts.(k + 1) - 1 in
    let below = ref 0 in
    for i = (Int_array.get e.first_entry ((Int_array.get e.first_row first))) to (Int_array.get e.first_entry ((Int_array.get e.first_row (last + 1)))) - 1 do
      if (Int_array.get e.node i) < first then below := Int.max !below at.((Int_array.get e.node i))
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
  List.fold_left (fun sum v -> sum +. (t.r.upper.(v) -. t.r.lower.(v))) 0. t.asked

let rec passes t ~gap ~before =
  pass t ~gap;
  if not (List.for_all (good t) t.asked) then begin
    let now = uncertainty t in
    if gap > 0x1p-60 && (now < 0.9 *. before || gap > 0x1p-40) then passes t ~gap:(gap /. 8.) ~before:now
  end

let solve (e : Equations.t) (effort : Effort.t) ~upper ~asked =
  let t =
    {
      e;
      effort;
      r = Rounded.start e ~upper;
      asked;
      few = List.compare_length_with asked 16 <= 0;
      work = 0;
      next = stride;
    }
  in
  let gap = 0.45 *. Rat.to_float effort.width /. float_of_int (Int.max 1 (depth e)) in
  (match passes t ~gap ~before:infinity with () -> () | exception Enough -> ());
  {
    interval = Rounded.interval t.r;
    row = (match e.direction with Max -> t.r.low_row | Min -> t.r.high_row);
    sweeps = t.work / Int.max 1 e.size;
  }

open Scc_exact

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

(* The greatest uncertainty of what a component leads to. *)
let gap_outside t part =
  let greatest = ref 0. in
  let e = t.e in
  for i = e.first_entry.(e.first_row.(part.first)) to e.first_entry.(e.first_row.(part.last + 1)) - 1 do
    let w = e.node.(i) in
    if w < part.first || w > part.last then begin
      let gap = t.r.upper.(w) -. t.r.lower.(w) in
      if gap > !greatest then greatest := gap
    end
  done;
  !greatest

let trial_of t ~outside ~gap x =
  if t.effort.relative then (x *. (1. +. gap)) +. outside +. (gap *. 0x1p-20) else x +. outside +. gap

(* Whether all intervals of a component are as narrow as a trial would make them. *)
let narrow t part ~outside ~gap =
  let rec go v =
    v > part.last || (t.r.upper.(v) <= trial_of t ~outside ~gap t.r.lower.(v) && go (v + 1))
  in
  go part.first

let drop t part = Rounded.drop_trial t.r ~first:part.first ~last:part.last

(* Guesses upper ends, and sees in so many sweeps at most whether they are right. *)
let attempt t part ~outside ~gap ~sweeps =
  for v = part.first to part.last do
    Rounded.set_trial t.r v (trial_of t ~outside ~gap t.r.lower.(v))
  done;
  let rec go n =
    if n = 0 then false
    else begin
      (match worked t (size part) with
       | () -> ()
       | exception Enough ->
         drop t part;
         raise Enough);
      match Rounded.sweep_trial t.r ~first:part.first ~last:part.last ~forward:(n land 1 = 0) with
      | Proved ->
        Rounded.accept_trial t.r ~first:part.first ~last:part.last;
        true
      | Open -> go (n - 1)
      | Refuted -> false
    end
  in
  let proved = go sweeps in
  if not proved then drop t part;
  proved

(* Changes become a geometric sequence in the end. From two of them, [lag] sweeps apart, how far the limit is away:
   a guess, on which nothing depends but when upper ends are tried. *)
let lag = 8

type pace = {
  mutable sweeps : int;
  mutable change : float;
  mutable earlier : float;  (** the change [lag] sweeps or more before, or infinity *)
  mutable mark : float;
  mutable early : int;  (** the number of sweeps at which upper ends are tried before they are near *)
}

let distance p =
  if p.change = 0. then 0.
  else
    let ratio = (p.change /. p.earlier) ** (1. /. float_of_int lag) in
    if ratio >= 1. || p.earlier = infinity then infinity else p.change *. ratio /. (1. -. ratio)

let sweep t part p =
  worked t (size part);
  p.change <-
    Rounded.raise_lower t.r ~first:part.first ~last:part.last ~forward:(p.sweeps land 1 = 0)
      ~relative:t.effort.relative;
  p.sweeps <- p.sweeps + 1;
  if p.sweeps mod lag = 0 then begin
    p.earlier <- p.mark;
    p.mark <- p.change
  end

(* Floats do not get on when a sweep changes the last digits alone. *)
let stalled t p part =
  p.change = 0.
  || p.sweeps mod lag = 0
     && p.change
        <= 0x1p-49
                *. (if t.effort.relative then 1.
                    else
                      let greatest = ref 0. in
                      for v = part.first to part.last do
                        if t.r.lower.(v) > !greatest then greatest := t.r.lower.(v)
                      done;
                      !greatest)

let solve_part t part ~gap =
  let outside = gap_outside t part in
  let p = { sweeps = 0; change = infinity; earlier = infinity; mark = infinity; early = 32 } in
  let trial gap sweeps = attempt t part ~outside ~gap ~sweeps in
  (* Until the limit seems to be so near, or is as near as floats come. *)
  let rec approach target =
    sweep t part p;
    if stalled t p part then true
    else if p.sweeps mod lag = 0 && distance p <= target then false
    else begin
      if p.sweeps >= p.early then begin
        p.early <- 2 * p.early;
        let near = distance p in
        if near > gap && near < infinity && outside < infinity then
          ignore (trial (2. *. near) (4 + (p.sweeps / 8)))
      end;
      approach target
    end
  in
  let rec go target gap =
    let stalled = approach target in
    if outside < infinity && not (trial gap (16 + (p.sweeps / 2))) then
      if not stalled then go (target /. 4.) gap
      else if gap < Rounded.ceiling then go target (4. *. gap)
  in
  if not (narrow t part ~outside ~gap) then go (gap /. 4.) gap

let parts_of (e : Equations.t) = Array.length e.parts - 1

(* The greatest number of components of more than one node that a way can go through. *)
let depth (e : Equations.t) =
  let at = Array.make e.size 0 and deepest = ref 0 in
  for k = 0 to parts_of e - 1 do
    let first = e.parts.(k) and last = e.parts.(k + 1) - 1 in
    let below = ref 0 in
    for i = e.first_entry.(e.first_row.(first)) to e.first_entry.(e.first_row.(last + 1)) - 1 do
      if e.node.(i) < first then below := Int.max !below at.(e.node.(i))
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
  let gap = 0.9 *. Rat.to_float effort.width /. float_of_int (Int.max 1 (depth e)) in
  (match passes t ~gap ~before:infinity with () -> () | exception Enough -> ());
  {
    interval = Rounded.interval t.r;
    row = (match e.direction with Max -> t.r.low_row | Min -> t.r.high_row);
    sweeps = t.work / Int.max 1 e.size;
  }

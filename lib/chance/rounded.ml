open Scc_exact

type t = {
  equations : Equations.t;
  below : float array;
  above : float array;
  lower : float array;
  upper : float array;
  low_row : int array;
  high_row : int array;
  trial : float array;
  trial_row : int array;
}

let ceiling = 1e18
let tiny = 1e-250
let step = 0x1p-52

let start (e : Equations.t) ~upper =
  let below c = if Rat.sign c = 0 then 0. else Float.max 0. (Float.pred (Rat.to_float c)) in
  let above c = if Rat.sign c = 0 then 0. else Float.succ (Rat.to_float c) in
  let rows () = Array.init e.size (fun v -> e.first_row.(v)) in
  {
    equations = e;
    below = Array.map below e.constant;
    above = Array.map above e.constant;
    lower = Array.make e.size 0.;
    upper = Array.make e.size upper;
    low_row = rows ();
    high_row = rows ();
    trial = Array.make e.size upper;
    trial_row = rows ();
  }

(* The loops below make up all the time of large models. They allocate nothing: that is why they are written out,
   once for each side, and not made of functions that return floats. Indices come from the equations, where rows
   and entries are contiguous, and nodes of entries are less than the size. *)

let raise_lower t ~first ~last ~forward ~relative =
  let e = t.equations in
  let lower = t.lower and near = e.near and node = e.node and below = t.below in
  let is_max = match e.direction with Max -> true | Min -> false in
  let greatest = ref 0. in
  for n = 0 to last - first do
    let v = if forward then first + n else last - n in
    let best = ref (if is_max then 0. else infinity) and best_row = ref (-1) in
    let from = ref e.first_entry.(e.first_row.(v)) in
    for r = e.first_row.(v) to e.first_row.(v + 1) - 1 do
      let till = e.first_entry.(r + 1) in
      let sum = ref (Array.unsafe_get below r) in
      for i = !from to till - 1 do
        sum := !sum +. (Array.unsafe_get near i *. Array.unsafe_get lower (Array.unsafe_get node i))
      done;
      let x = if !sum < tiny then 0. else !sum *. (1. -. (float_of_int (till - !from + 6) *. step)) in
      from := till;
      if (if is_max then x > !best else x < !best) then begin
        best := x;
        best_row := r
      end
    done;
    let x = if !best > ceiling then ceiling else !best in
    let before = lower.(v) in
    if x > before then begin
      lower.(v) <- x;
      t.low_row.(v) <- !best_row;
      let change = if relative then (x -. before) /. x else x -. before in
      if change > !greatest then greatest := change
    end
  done;
  !greatest

type trial = Proved | Open | Refuted

let sweep_trial t ~first ~last ~forward =
  let e = t.equations in
  let trial = t.trial and near = e.near and node = e.node and above = t.above in
  let is_max = match e.direction with Max -> true | Min -> false in
  let grown = ref false and crossed = ref false in
  for n = 0 to last - first do
    let v = if forward then first + n else last - n in
    let best = ref (if is_max then 0. else infinity) and best_row = ref e.first_row.(v) in
    let from = ref e.first_entry.(e.first_row.(v)) in
    for r = e.first_row.(v) to e.first_row.(v + 1) - 1 do
      let till = e.first_entry.(r + 1) in
      let sum = ref (Array.unsafe_get above r) in
      for i = !from to till - 1 do
        sum := !sum +. (Array.unsafe_get near i *. Array.unsafe_get trial (Array.unsafe_get node i))
      done;
      let x = (!sum +. tiny) *. (1. +. (float_of_int (till - !from + 6) *. step)) in
      from := till;
      if (if is_max then x > !best else x < !best) then begin
        best := x;
        best_row := r
      end
    done;
    let x = !best in
    if x > trial.(v) || x > ceiling then grown := true;
    if x < t.lower.(v) then crossed := true;
    trial.(v) <- (if x > ceiling then infinity else x);
    t.trial_row.(v) <- !best_row
  done;
  if !crossed then Refuted else if !grown then Open else Proved

let set_trial t v x = t.trial.(v) <- (if x > ceiling then infinity else x)

let accept_trial t ~first ~last =
  for v = first to last do
    if t.trial.(v) < t.upper.(v) then begin
      t.upper.(v) <- t.trial.(v);
      t.high_row.(v) <- t.trial_row.(v)
    end
    else t.trial.(v) <- t.upper.(v)
  done

let drop_trial t ~first ~last = Array.blit t.upper first t.trial first (last - first + 1)

let single t v =
  ignore (raise_lower t ~first:v ~last:v ~forward:true ~relative:false);
  t.trial.(v) <- infinity;
  match sweep_trial t ~first:v ~last:v ~forward:true with
  | Proved | Open -> accept_trial t ~first:v ~last:v
  | Refuted -> Scc_base.Bug.fail __POS__ "a bound from above is below one from below"

let interval t v =
  (Q.of_float t.lower.(v), if Float.is_finite t.upper.(v) then Some (Q.of_float t.upper.(v)) else None)

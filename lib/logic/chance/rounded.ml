open Scc_exact
open Scc_data

type t = {
  equations : Equations.t;
  is_max : bool;
  below : float array;
  above : float array;
  lower : float array;
  upper : float array;
  low_row : int array;
  high_row : int array;
  guess : float array;
  row : int array;
  before : float array;
  measure : float array;
  low_trial : float array;
  high_trial : float array;
  trial_row : int array;
  sums : float array;
}

let ceiling = 1e18
let tiny = 1e-250
let step = 0x1p-52

let block = 8

(* The greatest number of rows of so many nodes that follow each other, or fewer. *)
let rows_of_a_block (e : Equations.t) =
  let most = ref 0 in
  for v = 0 to e.size - 1 do
    let till = Equations.first_row e (Int.min e.size (v + block)) in
    most := Int.max !most (till - Equations.first_row e v)
  done;
  !most

let start (e : Equations.t) ~upper =
  (* A constant is 0 exactly or positive; the float next to it may be 0 all the same. *)
  let below x = if x > 0. then Next_float.pred x else 0. in
  let above r x = if x > 0. || Rat.sign e.constant.(r) > 0 then Next_float.succ x else 0. in
  let rows () = Array.init e.size (Equations.first_row e) in
  {
    equations = e;
    is_max = (match e.direction with Max -> true | Min -> false);
    below = Array.map below e.near_constant;
    above = Array.mapi above e.near_constant;
    lower = Array.make e.size 0.;
    upper = Array.make e.size upper;
    low_row = rows ();
    high_row = rows ();
    guess = Array.make e.size 0.;
    row = rows ();
    before = Array.make e.size 0.;
    measure = [| 0. |];
    low_trial = Array.make e.size 0.;
    high_trial = Array.make e.size upper;
    trial_row = Array.make e.size 0;
    sums = Array.make (rows_of_a_block e) 0.;
  }

let steps t =
  let e = t.equations in
  {
    t with
    is_max = true;
    below = Array.make (Array.length t.below) 1.;
    upper = Array.make e.size infinity;
    guess = Array.make e.size 0.;
    row = Array.copy t.row;
    before = Array.make e.size 0.;
    measure = [| 0. |];
  }

(* The loops below make up all the time of large models. They allocate nothing: that is why they are written out,
   once for each side, and not made of functions that return floats. Indices come from the equations, where rows
   and entries are contiguous, and nodes of entries are less than the size. *)

(* Puts into [sums] the right sides of all rows of the nodes from low to high, for these values and constants. It
   goes through several nodes before any row is compared with another: values that lie far from each other are then
   waited for together, and not one after the other. *)
let sum_rows t (values : float array) (constants : float array) low high =
  let e = t.equations in
  let near = e.near and node = e.node and sums = t.sums in
  let first = Int_array.unsafe_get e.first_row low in
  let from = ref (Int_array.unsafe_get e.first_entry first) in
  for r = first to Int_array.unsafe_get e.first_row (high + 1) - 1 do
    let till = Int_array.unsafe_get e.first_entry (r + 1) in
    let sum = ref (Array.unsafe_get constants r) in
    for i = !from to till - 1 do
      sum := !sum +. (Array.unsafe_get near i *. Array.unsafe_get values (Int_array.unsafe_get node i))
    done;
    from := till;
    Array.unsafe_set sums (r - first) !sum
  done

(* Calls [f low high] for the blocks of the nodes from first to last. In a small component each node is a block, to
   be found with what those before it have become. *)
let by_blocks ~first ~last ~forward f =
  let width = if last - first < 8 * block then 1 else block in
  if forward then begin
    let low = ref first in
    while !low <= last do
      f !low (Int.min last (!low + width - 1));
      low := !low + width
    done
  end
  else begin
    let high = ref last in
    while !high >= first do
      f (Int.max first (!high - width + 1)) !high;
      high := !high - width
    done
  end

let improve t ~first ~last ~forward ~relative =
  let e = t.equations in
  let guess = t.guess and is_max = t.is_max and sums = t.sums in
  let greatest = [| 0. |] and total = [| 0. |] in
  by_blocks ~first ~last ~forward (fun low high ->
      sum_rows t guess t.below low high;
      let base = Int_array.unsafe_get e.first_row low in
      for v = low to high do
        let r0 = Int_array.unsafe_get e.first_row v in
        let best = ref (Array.unsafe_get sums (r0 - base)) and row = ref r0 in
        for r = r0 + 1 to Int_array.unsafe_get e.first_row (v + 1) - 1 do
          let sum = Array.unsafe_get sums (r - base) in
          if (if is_max then sum > !best else sum < !best) then begin
            best := sum;
            row := r
          end
        done;
        Array.unsafe_set t.row v !row;
        let x = if !best > ceiling then ceiling else !best in
        let change = Float.abs (x -. Array.unsafe_get guess v) in
        Array.unsafe_set guess v x;
        total.(0) <- total.(0) +. change;
        if change > (if relative then greatest.(0) *. x else greatest.(0)) then
          greatest.(0) <- (if relative then change /. x else change)
      done);
  t.measure.(0) <- total.(0);
  greatest.(0)

let evaluate t ~first ~last ~forward ~relative ~stride =
  let e = t.equations in
  let guess = t.guess and near = e.near and node = e.node and below = t.below in
  let greatest = ref 0. and total = ref 0. in
  for n = 0 to last - first do
    let v = if forward then first + n else last - n in
    let r = Array.unsafe_get t.row v in
    let sum = ref (Array.unsafe_get below r) in
    for i = Int_array.unsafe_get e.first_entry r to Int_array.unsafe_get e.first_entry (r + 1) - 1 do
      sum := !sum +. (Array.unsafe_get near i *. Array.unsafe_get guess (Int_array.unsafe_get node i))
    done;
    let old = Array.unsafe_get guess v in
    let x = old +. (stride *. (!sum -. old)) in
    let x = if x > ceiling then ceiling else if x < 0. then 0. else x in
    let change = Float.abs (x -. old) in
    Array.unsafe_set guess v x;
    total := !total +. change;
    if change > (if relative then !greatest *. x else !greatest) then
      greatest := if relative then change /. x else change
  done;
  t.measure.(0) <- !total;
  !greatest

let remember t ~first ~last = Array.blit t.guess first t.before first (last - first + 1)

let go_on t ~first ~last ~factor =
  for v = first to last do
    let x = t.guess.(v) +. (factor *. (t.guess.(v) -. t.before.(v))) in
    t.guess.(v) <- (if x < 0. then 0. else if x > t.upper.(v) then t.upper.(v) else x)
  done

type trial = Proved | Open | Refuted

(* The right side of a row, rounded, from what was computed for it, with so many entries. *)
let[@inline] rounded_down sum entries =
  if sum < tiny then 0. else sum *. (1. -. (float_of_int (entries + 6) *. step))

let[@inline] rounded_up sum entries = (sum +. tiny) *. (1. +. (float_of_int (entries + 6) *. step))

let[@inline] entries (e : Equations.t) r =
  Int_array.unsafe_get e.first_entry (r + 1) - Int_array.unsafe_get e.first_entry r

let sweep_low t ~first ~last ~forward =
  let e = t.equations in
  let trial = t.low_trial and is_max = t.is_max and sums = t.sums in
  let fallen = ref 0 in
  by_blocks ~first ~last ~forward (fun low high ->
      sum_rows t trial t.below low high;
      let base = Int_array.unsafe_get e.first_row low in
      for v = low to high do
        let r0 = Int_array.unsafe_get e.first_row v in
        let best = ref (rounded_down (Array.unsafe_get sums (r0 - base)) (entries e r0)) in
        let best_row = ref r0 in
        for r = r0 + 1 to Int_array.unsafe_get e.first_row (v + 1) - 1 do
          let x = rounded_down (Array.unsafe_get sums (r - base)) (entries e r) in
          if (if is_max then x > !best else x < !best) then begin
            best := x;
            best_row := r
          end
        done;
        let x = if !best > ceiling then ceiling else !best in
        let x = if x < t.lower.(v) then t.lower.(v) else x in
        if x < trial.(v) then incr fallen;
        trial.(v) <- x;
        t.trial_row.(v) <- !best_row
      done);
  t.measure.(0) <- float_of_int !fallen;
  if !fallen > 0 then Open else Proved

let sweep_high t ~first ~last ~forward =
  let e = t.equations in
  let trial = t.high_trial and is_max = t.is_max and sums = t.sums in
  let grown = ref 0 and crossed = ref false in
  by_blocks ~first ~last ~forward (fun low high ->
      sum_rows t trial t.above low high;
      let base = Int_array.unsafe_get e.first_row low in
      for v = low to high do
        let r0 = Int_array.unsafe_get e.first_row v in
        let best = ref (rounded_up (Array.unsafe_get sums (r0 - base)) (entries e r0)) in
        let best_row = ref r0 in
        for r = r0 + 1 to Int_array.unsafe_get e.first_row (v + 1) - 1 do
          let x = rounded_up (Array.unsafe_get sums (r - base)) (entries e r) in
          if (if is_max then x > !best else x < !best) then begin
            best := x;
            best_row := r
          end
        done;
        let x = if !best > ceiling then infinity else !best in
        let x = if x > t.upper.(v) then t.upper.(v) else x in
        if x > trial.(v) || x = infinity then incr grown;
        if x < t.lower.(v) then crossed := true;
        trial.(v) <- x;
        t.trial_row.(v) <- !best_row
      done);
  t.measure.(0) <- float_of_int !grown;
  if !crossed then Refuted else if !grown > 0 then Open else Proved

let set_low t v x =
  let x = if x > ceiling then ceiling else x in
  t.low_trial.(v) <- (if x > t.lower.(v) then x else t.lower.(v))

let set_high t v x =
  let x = if x > ceiling then infinity else x in
  t.high_trial.(v) <- (if x > t.upper.(v) then t.upper.(v) else x)

let accept_low t ~first ~last =
  for v = first to last do
    if t.low_trial.(v) > t.lower.(v) then begin
      t.lower.(v) <- t.low_trial.(v);
      t.low_row.(v) <- t.trial_row.(v)
    end
    else t.low_trial.(v) <- t.lower.(v)
  done

let accept_high t ~first ~last =
  for v = first to last do
    if t.high_trial.(v) < t.upper.(v) then begin
      t.upper.(v) <- t.high_trial.(v);
      t.high_row.(v) <- t.trial_row.(v)
    end
    else t.high_trial.(v) <- t.upper.(v)
  done

let drop_low t ~first ~last = Array.blit t.lower first t.low_trial first (last - first + 1)
let drop_high t ~first ~last = Array.blit t.upper first t.high_trial first (last - first + 1)

let begin_high t ~first ~last = Array.blit t.upper first t.guess first (last - first + 1)
let begin_low t ~first ~last = Array.blit t.lower first t.guess first (last - first + 1)

let settle t ~first ~last =
  for v = first to last do
    let low = t.lower.(v) and high = t.upper.(v) in
    t.guess.(v) <- (if high < infinity then low +. (0.5 *. (high -. low)) else low)
  done

let single t v =
  ignore (sweep_low t ~first:v ~last:v ~forward:true);
  accept_low t ~first:v ~last:v;
  t.high_trial.(v) <- infinity;
  (match sweep_high t ~first:v ~last:v ~forward:true with
   | Proved | Open -> accept_high t ~first:v ~last:v
   | Refuted -> Scc_base.Bug.fail __POS__ "a bound from above is below one from below");
  settle t ~first:v ~last:v

let interval t v =
  (Q.of_float t.lower.(v), if Float.is_finite t.upper.(v) then Some (Q.of_float t.upper.(v)) else None)

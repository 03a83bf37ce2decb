open Scc_exact
open Scc_rigid
module Cases = Turning_cases
module Turning = Scc_naive.Turning
module Rng = Scc_long.Rng

type cast = Motion.t -> Motion.t -> span:Rat.t -> grid:int -> Cast.outcome

let by_sweep a b ~span ~grid =
  match Sweep.relation a b Rat.zero with
  | Interpenetrating -> Cast.Inside
  | Apart | Touching -> (
      match Sweep.first_penetration a b ~from:Rat.zero ~until:span with
      | Never -> Never
      | At t ->
        let instant k = Rat.make k (Z.shift_left Z.one grid) in
        let low, _ = Algebraic.enclose t ~width:(instant Z.one) in
        let rec up k = if Algebraic.compare_rat t (instant (Z.succ k)) >= 0 then up (Z.succ k) else k in
        At (instant (up (Rat.floor (Rat.mul low (Rat.make (Z.shift_left Z.one grid) Z.one))))))

type verdict =
  | Agreed
  | Open of string
  | Wrong_time of string
  | Missed of string
  | Spurious of string

let resolution = Rat.make Z.one (Z.shift_left Z.one 20)

let judge (cast : cast) (c : Cases.case) =
  let a, b = Cases.motions c in
  let grid = Cast.grid a b ~resolution in
  let cell t = Rat.floor (Rat.mul t (Rat.make (Z.shift_left Z.one grid) Z.one)) in
  (* The answer t is that of some instant from lo to hi. *)
  let within t (lo, hi) =
    let k = Rat.mul t (Rat.make (Z.shift_left Z.one grid) Z.one) in
    Rat.is_integer k && Z.leq (cell lo) (cell t) && Z.leq (cell t) (cell hi)
  in
  let found = cast a b ~span:c.span ~grid in
  let naive = Turning.first c.a c.b ~span:c.span in
  let said = match found with Never -> "never" | Inside -> "inside" | At t -> "at " ^ Rat.to_string t in
  let told expected = Printf.sprintf "%s, but %s; grid %d; %s" said expected grid (Cases.show c) in
  let during (lo, hi) = Printf.sprintf "%s to %s" (Rat.to_string lo) (Rat.to_string hi) in
  let momentary t = (not c.grazes) && List.exists (within t) naive.doubts in
  let verdict =
    match (naive.first, found) with
    | Inside, Inside -> Agreed
    | Inside, (Never | At _) -> Missed (told "inside")
    | (Never | Within _), Inside -> Spurious (told "apart at first")
    | Never, Never -> if naive.given_up then Open (told "given up") else Agreed
    | Never, At t -> if naive.given_up || momentary t then Open (told "perhaps")
      else Spurious (told "never")
    | Within (lo, hi), Never -> Missed (told (during (lo, hi)))
    | Within (lo, hi), At t ->
      if within t (lo, hi) then Agreed
      else if momentary t then Open (told (during (lo, hi)))
      else Wrong_time (told (during (lo, hi)))
  in
  (naive.first, verdict)

type tally = {
  mutable checked : int;
  mutable hits : int;
  mutable agreed : int;
  mutable undecided : int;
  mutable missed : int;
  mutable spurious : int;
  mutable wrong_times : int;
  mutable complaints : string list;
  mutable opened : string list;
}

let tally () =
  { checked = 0;
    hits = 0;
    agreed = 0;
    undecided = 0;
    missed = 0;
    spurious = 0;
    wrong_times = 0;
    complaints = [];
    opened = [] }

let kind_key : Cases.kind -> int = function
  | Hit -> 0
  | Near_miss -> 1
  | Far -> 2
  | Chance -> 3
  | Grazing -> 4
  | Aligned -> 5
  | Peak -> 6

let run cast t ~seed kind shapes ~from ~count =
  for i = from to from + count - 1 do
    let g = Rng.make [ seed; kind_key kind; i ] in
    let shape_a = Rng.choose g shapes in
    let shape_b = Rng.choose g shapes in
    let c = Cases.make kind shape_a shape_b g in
    let naive, verdict =
      try judge cast c with exn -> (Turning.Never, Missed (Printexc.to_string exn ^ "; " ^ Cases.show c))
    in
    t.checked <- t.checked + 1;
    (match naive with Never -> () | Inside | Within _ -> t.hits <- t.hits + 1);
    let keep s all = if List.length all < 10 then all @ [ s ] else all in
    let complain s = t.complaints <- keep s t.complaints in
    match verdict with
    | Agreed -> t.agreed <- t.agreed + 1
    | Open s -> t.undecided <- t.undecided + 1; t.opened <- keep s t.opened
    | Wrong_time s -> t.wrong_times <- t.wrong_times + 1; complain s
    | Missed s -> t.missed <- t.missed + 1; complain s
    | Spurious s -> t.spurious <- t.spurious + 1; complain s
  done

let right t = t.missed = 0 && t.spurious = 0 && t.wrong_times = 0 && 20 * t.undecided <= t.checked

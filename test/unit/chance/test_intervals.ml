(* Values in intervals, of processes that are too large for all schedulers: against exact values and closed forms;
   and sets of states that are found in passes. *)

open Scc_data
open Scc_exact
open Scc_chance
open Processes
module Gen = QCheck2.Gen

(* {1 Intervals, by the exact values} *)

(* From 1 to 12 states that are one component as a rule, and two ends. *)
let gen_component =
  let open Gen in
  let* n = int_range 1 12 in
  let branch = pair (int_bound (n + 1)) (int_range 1 4) in
  let inner = pair (int_bound (n - 1)) (int_range 1 9) in
  let choice s =
    let* far = list_size (int_range 0 2) branch and* near = list_size (int_range 0 2) inner in
    let* reward = int_bound 2 in
    return (reward, (((s + 1) mod n, 3) :: near) @ far)
  in
  let* inside = flatten_l (List.init n (fun s -> list_size (int_range 1 3) (choice s))) in
  let stays s = [ (0, [ (s, 1) ]) ] in
  let plain = Array.of_list (inside @ [ stays n; stays (n + 1) ]) in
  let* both = bool in
  let goal = Array.init (n + 2) (fun s -> s = n || (both && s = n + 1)) in
  return { plain; goal; stay = Array.make (n + 2) true }

let precisely = { Effort.default with engine = Nearly; relative = true; width = rat 1 1_000_000_000 }

(* Whether an interval holds the value and is as narrow as was asked for. *)
let encloses (effort : Effort.t) (a : Answer.t) (x : Answer.t) =
  match (x, Answer.lower a, Answer.upper a) with
  | Infinite, _, _ -> a = Infinite
  | Exact x, Some low, Some high when effort.relative && Rat.sign x = 0 ->
    (* No share of 0 is positive: a tiny number has to do. *)
    Rat.sign low = 0 && Rat.compare high (Rat.make Z.one (Z.pow (Z.of_int 10) 100)) <= 0
  | Exact x, Some low, Some high ->
    let width = if effort.relative then Rat.mul effort.width low else effort.width in
    Answer.contains a x && Rat.compare (Rat.sub high low) width <= 0
  | _ -> false

let same_nearly solve efforts c =
  let q = question c in
  both (fun d ->
      let exact = solve q d exactly ~asked:Solution.All in
      List.for_all
        (fun effort ->
           let found = solve q d effort ~asked:Solution.All in
           all_states c (fun s -> encloses effort (Solution.value found s) (Solution.value exact s)))
        efforts)

(* A component with a long way to its ends, where values hardly differ for most of it: the ends of intervals need
   a margin for each step there. In both directions, and with the ways of the guesses from 0 and from 1. *)
let far () =
  let check n p =
    let m = Backwards.make (walk n p) in
    List.iter
      (fun goal ->
         let q = Qualitative.until m ~stay:(fun _ -> true) ~goal:(fun s -> s = goal) in
         List.iter
           (fun effort ->
              let found = Reach.solve q Max effort ~asked:All in
              for k = 1 to n - 1 do
                let lost = ruin_probability n p k in
                let x = if goal = 0 then lost else Rat.sub Rat.one lost in
                let a = Solution.value found k in
                Alcotest.(check bool) (Printf.sprintf "%d of %d: %s" k n (Answer.to_string a)) true
                  (encloses effort a (Exact x))
              done)
           [ { precisely with width = rat 1 1_000_000 }; nearly ])
      [ 0; n ]
  in
  check 70 (rat 3 5);
  check 500 (rat 3 5);
  check 300 (rat 49 100);
  check 200 (rat 1 2)

(* {1 How much it takes} *)

let sweeps solution =
  match Solution.found solution with
  | In_intervals { sweeps; _ } -> sweeps
  | By_graph | In_rationals | Given_up _ -> Alcotest.fail "no intervals"

(* Components of five states each, as long as most ways are: guessed by elimination, and proved at once. And a long
   walk, whose ends are proved by margins for each step. *)
let few () =
  let choice other s =
    let ring = 5 * (s / 5) in
    let back, far = if other then (3, 1) else (1, 2) in
    let step k = ring + ((s + k) mod 5) in
    (0, [ (step (if other then 2 else 1), 4); (step 4, 2); (ring - 5, back); (ring - 10, far) ])
  in
  let choices s =
    if s < 10 then [ (0, [ (s, 1) ]) ] else choice false s :: (if s mod 2 = 0 then [ choice true s ] else [])
  in
  let plain = Array.init 2_000 choices in
  let question m goal = Qualitative.until (Backwards.make m) ~stay:(fun _ -> true) ~goal in
  let effort = { precisely with width = rat 1 1_000_000 } in
  let at_most name most solution =
    let n = sweeps solution in
    Alcotest.(check bool) (Printf.sprintf "%s: %d sweeps" name n) true (n <= most)
  in
  let rings = question (build plain) (fun s -> s >= 5 && s < 10) in
  at_most "rings" 20 (Reach.solve rings Max effort ~asked:All);
  at_most "rings" 20 (Reach.solve rings Min effort ~asked:All);
  let far = question (walk 3_000 (rat 3 5)) (fun s -> s = 3_000) in
  at_most "a walk" 2_500 (Reach.solve far Max effort ~asked:All)

(* {1 Passes} *)

(* A long way whose states are numbered so that passes up and down find one or two of them: the same is found by
   searches backwards. Each seventh state has a choice to a trap, and each fifth one that stays. *)
let long_way n number =
  let place = Array.make (n + 2) 0 in
  for i = 0 to n + 1 do
    place.(number i) <- i
  done;
  let choices i =
    if i >= n then [ (0, [ (number i, 1) ]) ]
    else
      ((1, [ (number (i + 1), 1); (number (Int.max 0 (i - 1)), 1) ])
       :: (if i mod 7 = 3 && i > n / 2 then [ (1, [ (number (n + 1), 1) ]) ] else []))
      @ if i mod 5 = 1 && i < n / 4 then [ (0, [ (number (Int.max 0 (i - 1)), 1) ]) ] else []
  in
  Array.map choices place

let passes () =
  let n = 3_000 in
  let plainly i = i and scrambled i = if i >= n then i else i * 1_201 mod n in
  let look number =
    let found = Array.make n false in
    let place = Array.make n 0 in
    for i = 0 to n - 1 do
      place.(number i) <- i
    done;
    let step s =
      let i = place.(s) in
      let now = (not found.(s)) && (i = 0 || found.(number (i - 1))) in
      if now then found.(s) <- true;
      now
    in
    Passes.run ~size:n step
  in
  Alcotest.(check bool) "in order" true (look plainly);
  Alcotest.(check bool) "scrambled: given up" false (look scrambled);
  let sets number =
    let m = Backwards.make (build (long_way n number)) in
    let q = Qualitative.until m ~stay:(fun _ -> true) ~goal:(fun s -> s = number n) in
    let all = [ Qualitative.zero_max; Qualitative.zero_min; Qualitative.one_max; Qualitative.one_min ] in
    let ends = Components.ends m ~inside:(fun s -> s <> number n) ~allowed:(fun _ -> true) in
    let bits = List.map (fun set -> let set = set q in fun i -> Bits.mem set (number i)) all in
    (fun i -> ends.number.(number i) >= 0) :: bits
  in
  List.iteri
    (fun k (a, b) ->
       for i = 0 to n + 1 do
         Alcotest.(check bool) (Printf.sprintf "set %d of %d" k i) (a i) (b i)
       done)
    (List.combine (sets plainly) (sets scrambled))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "intervals"
    [
      ( "against exact values",
        [
          law "probabilities" gen_component print (same_nearly Reach.solve [ nearly; precisely ]);
          law "sums of rewards" gen_component print (same_nearly Reward.solve [ precisely ]); ] );
      ("effort", [ case "a long way" far; case "few sweeps" few ]);
      ("passes", [ case "slow ones" passes ]);
    ]

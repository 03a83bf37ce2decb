(* Values as functions of a parameter: against the exact values of the ordinary solver at many values, for random
   processes; against closed forms; and what is said of the shape of functions, against samples. *)

open Scc_exact
open Scc_chance
open Processes
module Gen = QCheck2.Gen

let whole = Rat.of_int
let constant q = Rational_function.constant q
let k = Rational_function.variable
let rest = Rational_function.(sub one k)

(* 1/2 at the first values that the solver looks at, and nowhere else: a guess from these values is wrong. *)
let deceptive =
  let times f x = Rational_function.(mul f (sub k (constant x))) in
  let first = [ rat 1 2; rat 1 3; rat 2 3; rat 1 4; rat 3 4; rat 1 5; rat 2 5; rat 3 5 ] in
  Rational_function.(add (constant Rat.half) (List.fold_left times one first))

(* Positive between 0 and 1. *)
let weights =
  Rational_function.
    [|
      k; rest; one; constant (whole 2); mul k k; add k one; mul k rest; deceptive; sub one deceptive;
      div one (add one k);
    |]

(* All are 1 at 1/2, where all choices are alike. The others are less on both sides of it, or more. *)
let alike =
  let twice f = Rational_function.mul (constant (whole 2)) f in
  let both_sides = Rational_function.(add (mul k k) (mul rest rest)) in
  Rational_function.[| one; twice (twice (mul k rest)); twice both_sides |]

type parametric = { case : case; weighed : (int * (int * Rational_function.t) list) list array }

(* The process of the case has the value of each weight at 2/7. *)
let at_first = rat 2 7

let of_weights weighed goal =
  let chosen (reward, branches) =
    let total = Rational_function.(List.fold_left (fun s (_, w) -> add s w) zero branches) in
    (reward, List.map (fun (t, w) -> (t, Rational_function.div w total)) branches)
  in
  let weighed = Array.map (List.map chosen) weighed in
  { case = { plain = Array.map (fun _ -> []) weighed; goal; stay = Array.map (fun _ -> true) goal }; weighed }

let value f x = Option.get (Rational_function.eval f x)

(* Each target once, as in an MDP. *)
let merged branches =
  let add all (t, f) =
    match all with
    | (u, g) :: rest when u = t -> (u, Rational_function.add g f) :: rest
    | _ -> (t, f) :: all
  in
  List.rev (List.fold_left add [] (List.stable_sort (fun (t, _) (u, _) -> Int.compare t u) branches))

let mdp p x =
  let b = Mdp.builder () in
  Array.iter
    (fun choices ->
       ignore (Mdp.add_state b);
       List.iter
         (fun (reward, branches) ->
            Mdp.add_choice b ~reward:(whole reward) (List.map (fun (t, f) -> (t, value f x)) branches))
         choices)
    p.weighed;
  match Mdp.finish b with Ok m -> m | Error e -> Alcotest.fail (Mdp.describe e)

let question p x =
  Qualitative.until (Backwards.make (mdp p x)) ~stay:(fun _ -> true) ~goal:(Array.get p.case.goal)

let attempted effort p problem =
  let q = question p at_first in
  let all = List.concat (Array.to_list p.weighed) in
  let functions = Array.of_list (List.concat_map (fun (_, l) -> List.map snd (merged l)) all) in
  let rewards = Array.of_list (List.map (fun (r, _) -> constant (whole r)) all) in
  let parametric =
    Parametric.make (Qualitative.backwards q) ~probability:(Array.get functions) ~reward:(Array.get rewards)
      ~low:Rat.zero ~high:Rat.one
  in
  Parametric.solve parametric (problem q) effort ~asked:0

let solved p problem =
  match attempted exactly p problem with
  | Ok pieces -> pieces
  | Error _ -> QCheck2.Test.fail_report "given up"

let at_value pieces x =
  let covers (p : Parametric.piece) =
    Algebraic.compare_rat p.low x <= 0 && Algebraic.compare_rat p.high x >= 0
  in
  List.map
    (fun (p : Parametric.piece) ->
       match p.value with Finite f -> Answer.Exact (value f x) | Infinite -> Infinite)
    (List.filter covers pieces)

let same (a : Answer.t) (b : Answer.t) =
  match (a, b) with Exact x, Exact y -> Rat.equal x y | Infinite, Infinite -> true | _ -> false

let samples = List.init 12 (fun i -> rat ((2 * i) + 1) 25)

let agrees p direction =
  let by problem solve =
    let pieces = solved p (fun q -> problem q direction) in
    List.for_all
      (fun x ->
         let plain = Solution.value (solve (question p x) direction exactly ~asked:(Solution.States [ 0 ])) 0 in
         let found = at_value pieces x in
         found <> [] && List.for_all (same plain) found)
      samples
  in
  by Reach.problem Reach.solve && by Reward.problem Reward.solve

(* Stopped at any moment: what was found before is right, and covers no more than was asked. *)
let kept = ref 0

let stands (p, direction, calls) =
  let left = ref calls in
  let interrupted () =
    decr left;
    !left < 0
  in
  let plain x =
    let q = question p x in
    Solution.value (Reach.solve q direction exactly ~asked:(Solution.States [ 0 ])) 0
  in
  match attempted { exactly with interrupted } p (fun q -> Reach.problem q direction) with
  | Ok _ -> true
  | Error { why = Solver Interrupted | Interrupted; found = { pieces; values } } ->
    if pieces <> [] || values <> [] then incr kept;
    List.for_all (fun (x, y) -> same (plain x) (Exact y)) values
    && List.for_all (fun x -> List.for_all (same (plain x)) (at_value pieces x)) samples
  | Error _ -> false

let process =
  let open Gen in
  let* n = int_range 2 6 in
  let branch = pair (int_bound (n - 1)) (map (Array.get weights) (int_bound (Array.length weights - 1))) in
  let choice = pair (int_bound 2) (list_size (int_range 1 3) branch) in
  let* states = array_size (pure n) (list_size (frequency [ (3, pure 1); (1, pure 2); (1, pure 3) ]) choice) in
  let* goal = array_size (pure n) (frequency [ (3, pure false); (1, pure true) ]) in
  pure (of_weights states goal)

(* One or two states with choices that are alike at 1/2, between a goal and a state that is never left. *)
let ties =
  let open Gen in
  let branch n = pair (int_bound (n - 1)) (map (Array.get alike) (int_bound (Array.length alike - 1))) in
  let* n = int_range 3 4 in
  let choice = pair (int_bound 1) (list_size (int_range 2 4) (branch n)) in
  let state s = if s = 1 || s = 2 then pure [ (0, [ (s, k) ]) ] else list_size (int_range 2 3) choice in
  let* states = flatten_a (Array.init n state) in
  pure (of_weights states (Array.init n (fun s -> s = 1)))

let print p =
  let branch (t, f) = Printf.sprintf "%d: %s" t (Rational_function.to_string ~variable:"k" f) in
  let choice (r, l) = Printf.sprintf "(%d) %s" r (String.concat "; " (List.map branch l)) in
  let state s choices =
    Printf.sprintf "%d%s: %s" s (if p.case.goal.(s) then " goal" else "")
      (String.concat " | " (List.map choice choices))
  in
  String.concat "\n" (Array.to_list (Array.mapi state p.weighed))

let test ~count name ~print gen law = Property.case (QCheck2.Test.make ~count ~name ~print gen law)

let random =
  test ~count:250 "values as functions" ~print process (fun p -> both (agrees p))

let tied =
  test ~count:250 "values as functions, where choices are alike at the first value" ~print ties
    (fun p -> both (agrees p))

let stopped =
  let gen = Gen.(triple process (oneofl [ Equations.Min; Max ]) (int_range 1 12)) in
  let print (p, _, calls) = Printf.sprintf "%s\n%d calls" (print p) calls in
  test ~count:1_000 "what was found stands" ~print gen stands

let some_kept () = Alcotest.(check bool) (Printf.sprintf "%d stopped with something" !kept) true (!kept > 10)

(* {1 Closed forms} *)

let piece = function
  | [ { Parametric.value = Finite f; _ } ] -> f
  | _ -> Alcotest.fail "not one function"

let is what expected pieces =
  Alcotest.(check string) what expected (Rational_function.to_string ~variable:"k" (piece pieces))

let rec power f n = if n = 0 then Rational_function.one else Rational_function.mul f (power f (n - 1))

(* Gambler's ruin on 0 .. n from i, with r = (1 - k)/k: it comes to n with (1 + r + ... + r^(i - 1)) / (1 + ... +
   r^(n - 1)). *)
let ruin () =
  let n = 7 and i = 3 in
  let state s =
    if s = 0 || s = n then [ (0, [ (s, Rational_function.one) ]) ] else [ (0, [ (s + 1, k); (s - 1, rest) ]) ]
  in
  (* State 0 is asked for: it is exchanged with i. *)
  let swap s = if s = 0 then i else if s = i then 0 else s in
  let swapped (r, l) = (r, List.map (fun (t, f) -> (swap t, f)) l) in
  let states = Array.init (n + 1) (fun s -> List.map swapped (state (swap s))) in
  let p = of_weights states (Array.init (n + 1) (fun s -> swap s = n)) in
  let sum m =
    List.fold_left Rational_function.add Rational_function.zero
      (List.init m (fun j -> power (Rational_function.div rest k) j))
  in
  let expected = Rational_function.to_string ~variable:"k" (Rational_function.div (sum i) (sum n)) in
  is "ruin" expected (solved p (fun q -> Reach.problem q Min))

(* The number of trials until the first success. *)
let geometric () =
  let p = of_weights [| [ (1, [ (1, k); (0, rest) ]) ]; [ (0, [ (1, k) ]) ] |] [| false; true |] in
  is "the mean" "1/k" (solved p (fun q -> Reward.problem q Min))

let deceived () =
  let p =
    of_weights [| [ (0, [ (1, deceptive); (2, Rational_function.(sub one deceptive)) ]) ]; [ (0, [ (1, k) ]) ];
                  [ (0, [ (2, k) ]) ] |]
      [| false; true; false |]
  in
  is "what 8 values do not tell" (Rational_function.to_string ~variable:"k" deceptive)
    (solved p (fun q -> Reach.problem q Min))

(* One choice is better below 1/3, and the other one above. *)
let choices () =
  let p =
    of_weights
      [|
        [ (0, [ (1, k); (2, rest) ]); (0, [ (1, constant (whole 1)); (2, constant (whole 2)) ]) ];
        [ (0, [ (1, k) ]) ]; [ (0, [ (2, k) ]) ];
      |]
      [| false; true; false |]
  in
  let text pieces =
    String.concat ", "
      (List.map
         (fun (p : Parametric.piece) ->
            match p.value with
            | Finite f ->
              Printf.sprintf "%s to %s" (Rational_function.to_string ~variable:"k" f) (Algebraic.to_string p.high)
            | Infinite -> "infinite")
         pieces)
  in
  let greatest = solved p (fun q -> Reach.problem q Max) and least = solved p (fun q -> Reach.problem q Min) in
  Alcotest.(check string) "greatest" "1/3 to 1/3, k to 1" (text greatest);
  Alcotest.(check string) "least" "k to 1/3, 1/3 to 1" (text least)

(* {1 Shapes} *)

let low = Rat.zero
let high = Rat.one

let function_ =
  let open Gen in
  let number = map (fun n -> whole (n - 6)) (int_bound 12) in
  let polynomial = map Polynomial.of_coefficients (list_size (int_range 1 6) number) in
  let* n = polynomial and* d = polynomial and* m = int_range 1 4 in
  (* No root of the denominator: a square and a positive number. *)
  let below = Polynomial.add (Polynomial.mul d d) (Polynomial.constant (rat 1 m)) in
  pure (Rational_function.make n below)

let one_piece f : Parametric.piece list =
  [ { low = Algebraic.of_rat low; high = Algebraic.of_rat high; value = Finite f } ]

let grid = List.init 99 (fun i -> rat (i + 1) 100)

let member set x =
  let within (i : Dependence.interval) =
    let l = Algebraic.compare_rat i.low x and h = Algebraic.compare_rat i.high x in
    (l < 0 || (l = 0 && i.low_included)) && (h > 0 || (h = 0 && i.high_included))
  in
  List.exists within (Dependence.intervals ~low ~high set)

let tested f =
  List.for_all
    (fun relation ->
       let bound = { Answer.relation; than = value f (rat 1 2) } in
       let set = Dependence.where ~low ~high bound (one_piece f) in
       List.for_all (fun x -> member set x = (Answer.holds (Exact (value f x)) bound = Some true)) grid)
    [ Answer.Less; At_most; At_least_so; More ]

(* Between two neighbours of the grid that lie in one interval the value rises, or falls. *)
let shaped f =
  match Dependence.shape ~low ~high (one_piece f) with
  | None -> false
  | Some { trends; extremes } ->
    let trend x y =
      List.find_opt (fun (l, h, _) -> Algebraic.compare_rat l x <= 0 && Algebraic.compare_rat h y >= 0) trends
    in
    let goes x y =
      let c = Rat.compare (value f y) (value f x) in
      match trend x y with
      | None -> true
      | Some (_, _, Rises) -> c > 0
      | Some (_, _, Falls) -> c < 0
      | Some (_, _, Constant) -> c = 0
    in
    let rec all = function x :: (y :: _ as rest) -> goes x y && all rest | _ -> true in
    let at_least (e : Dependence.extreme) x =
      match e.level with
      | Exactly y -> Rat.compare y (value f x) <= 0
      | Between (a, _) -> Rat.compare a (value f x) <= 0
      | Unbounded -> false
    and at_most (e : Dependence.extreme) x =
      match e.level with
      | Exactly y -> Rat.compare y (value f x) >= 0
      | Between (_, b) -> Rat.compare b (value f x) >= 0
      | Unbounded -> true
    in
    all grid
    && (match extremes with
        | None -> List.for_all (fun x -> Rat.equal (value f x) (value f Rat.half)) grid
        | Some (least, greatest) -> List.for_all (at_least least) grid && List.for_all (at_most greatest) grid)

let combined (f, g) =
  let half f = { Answer.relation = More; than = value f Rat.half } in
  let a = Dependence.where ~low ~high (half f) (one_piece f) in
  let b = Dependence.where ~low ~high (half g) (one_piece g) in
  let both = Dependence.combine ( && ) a b and neither = Dependence.complement (Dependence.combine ( || ) a b) in
  List.for_all
    (fun x -> member both x = (member a x && member b x) && member neither x = not (member a x || member b x))
    grid

let print_function f = Rational_function.to_string ~variable:"k" f

let shapes =
  [
    test ~count:150 "where a test holds" ~print:print_function function_ tested;
    test ~count:150 "rising, falling, extremes" ~print:print_function function_ shaped;
    test ~count:100 "sets together" ~print:(fun (f, g) -> print_function f ^ ", " ^ print_function g)
      (Gen.pair function_ function_) combined;
  ]

let interpolated =
  let points f = Array.init 24 (fun i -> let x = rat (i + 1) 25 in (x, value f x)) in
  test ~count:100 "interpolation" ~print:print_function function_ (fun f ->
      match Interpolation.through ~interrupted:(fun () -> false) (points f) with
      | Some g -> Rational_function.equal f g
      | None -> false)

let () =
  Alcotest.run "parametric"
    [
      ("functions", [ random; tied; interpolated ]);
      ("given up", [ stopped; Alcotest.test_case "something is found" `Quick some_kept ]);
      ( "closed forms",
        [
          Alcotest.test_case "Parametric: gambler's ruin" `Quick ruin;
          Alcotest.test_case "Parametric: trials until a success" `Quick geometric;
          Alcotest.test_case "Parametric: a guess that is wrong" `Quick deceived;
          Alcotest.test_case "Parametric: choices" `Quick choices;
        ] );
      ("shapes", shapes);
    ]

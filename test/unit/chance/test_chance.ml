(* Decision processes solved against the definition: all schedulers that remember nothing, one by one, each a chain
   whose linear system is solved with no thought for speed; and against closed forms. *)

open Scc_data
open Scc_exact
open Scc_chance
open Processes
module Gen = QCheck2.Gen

(* x = a x + b, with one solution: Gauss and Jordan. *)
let solve a b =
  let n = Array.length b in
  let entry i j =
    if j = n then b.(i) else Rat.sub (if i = j then Rat.one else Rat.zero) a.(i).(j)
  in
  let m = Array.init n (fun i -> Array.init (n + 1) (entry i)) in
  for k = 0 to n - 1 do
    let pivot = ref k in
    while Rat.sign m.(!pivot).(k) = 0 do incr pivot done;
    let row = m.(!pivot) in
    m.(!pivot) <- m.(k);
    m.(k) <- Array.map (fun x -> Rat.div x row.(k)) row;
    for i = 0 to n - 1 do
      if i <> k then
        let f = m.(i).(k) in
        m.(i) <- Array.mapi (fun j x -> Rat.sub x (Rat.mul f m.(k).(j))) m.(i)
    done
  done;
  Array.map (fun row -> row.(n)) m

(* From which states of a chain some state of the set can be reached, through states that may be passed. *)
let can_reach chain ~pass set =
  let n = Array.length chain in
  let found = Array.init n set in
  for _ = 1 to n do
    Array.iteri (fun s (_, branches) ->
        if pass s && List.exists (fun (t, _) -> found.(t)) branches then found.(s) <- true) chain
  done;
  found

let probabilities chain ~stay ~goal =
  let n = Array.length chain in
  let pass s = stay s && not (goal s) in
  let live = can_reach chain ~pass goal in
  let a = Array.make_matrix n n Rat.zero and b = Array.make n Rat.zero in
  Array.iteri
    (fun s (_, branches) ->
       if goal s then b.(s) <- Rat.one
       else if live.(s) then
         let sum = List.fold_left (fun x (_, w) -> x + w) 0 branches in
         List.iter (fun (t, w) -> if live.(t) then a.(s).(t) <- Rat.add a.(s).(t) (rat w sum)) branches)
    chain;
  solve a b

(* [None]: infinite. *)
let rewards chain ~stay ~goal =
  let n = Array.length chain in
  let p = probabilities chain ~stay ~goal in
  let finite s = Rat.equal p.(s) Rat.one in
  let a = Array.make_matrix n n Rat.zero and b = Array.make n Rat.zero in
  Array.iteri
    (fun s (reward, branches) ->
       if finite s && not (goal s) then begin
         let sum = List.fold_left (fun x (_, w) -> x + w) 0 branches in
         b.(s) <- Rat.of_int reward;
         List.iter (fun (t, w) -> a.(s).(t) <- Rat.add a.(s).(t) (rat w sum)) branches
       end)
    chain;
  let x = solve a b in
  Array.init n (fun s -> if finite s then Some x.(s) else None)

let rec schedulers = function
  | [] -> [ [] ]
  | choices :: rest ->
    let tails = schedulers rest in
    List.concat_map (fun c -> List.map (fun tail -> c :: tail) tails) choices

let chains (p : plain) = List.map Array.of_list (schedulers (Array.to_list p))

let compare_reward a b =
  match (a, b) with
  | None, None -> 0
  | None, Some _ -> 1
  | Some _, None -> -1
  | Some x, Some y -> Rat.compare x y

let best (direction : Equations.direction) compare values =
  let pick x y = match direction with Min -> if compare x y <= 0 then x else y | Max -> if compare x y >= 0 then x
    else y in match values with
  | first :: rest -> List.fold_left (fun acc v -> Array.map2 pick acc v) first rest
  | [] -> Alcotest.fail "no scheduler"

(* {1 Random processes} *)

let gen =
  let open Gen in
  let* n = int_range 2 6 in
  let branch = pair (int_bound (n - 1)) (int_range 1 4) in
  let choice = pair (int_bound 2) (list_size (int_range 1 3) branch) in
  let* plain = array_repeat n (list_size (int_range 1 3) choice) in
  let* goal = array_repeat n (map (fun k -> k = 0) (int_bound 3)) in
  let* stay = array_repeat n (map (fun k -> k > 0) (int_bound 6)) in
  return { plain; goal; stay }

(* What it is by each scheduler. *)
let of_all by c =
  List.map (fun chain -> by chain ~stay:(Array.get c.stay) ~goal:(Array.get c.goal)) (chains c.plain)

let chain_of c scheduler = Array.mapi (fun s choices -> List.nth choices scheduler.(s)) c.plain
let reach_exact c =
  let q = question c in
  both (fun d ->
      let expected =
        best d Rat.compare (of_all probabilities c) in
      let found = Reach.solve q d exactly ~asked:All in
      let attained =
        probabilities (chain_of c (Solution.scheduler found)) ~stay:(Array.get c.stay) ~goal:(Array.get c.goal)
      in
      all_states c (fun s ->
          match Solution.value found s with
          | Exact x -> Rat.equal x expected.(s) && Rat.equal attained.(s) x
          | Within _ | At_least _ | Infinite -> false))

let reach_nearly c =
  let q = question c in
  both (fun d ->
      let found = Reach.solve q d nearly ~asked:All in
      let expected =
        best d Rat.compare (of_all probabilities c) in
      all_states c (fun s ->
          let a = Solution.value found s in
          Answer.contains a expected.(s)
          && match (Answer.lower a, Answer.upper a) with
          | Some x, Some y -> Rat.compare (Rat.sub y x) nearly.width <= 0
          | _ -> false))

let rewards_exact c =
  let q = question c in
  both (fun d ->
      let expected =
        best d compare_reward (of_all rewards c) in
      let found = Reward.solve q d exactly ~asked:All in
      let attained =
        rewards (chain_of c (Solution.scheduler found)) ~stay:(Array.get c.stay) ~goal:(Array.get c.goal)
      in
      all_states c (fun s ->
          match (Solution.value found s, expected.(s), attained.(s)) with
          | Exact x, Some y, Some z -> Rat.equal x y && Rat.equal y z
          | Infinite, None, z -> d = Max || z = None
          | _ -> false))

let rewards_nearly c =
  let q = question c in
  both (fun d ->
      let expected =
        best d compare_reward (of_all rewards c) in
      let found = Reward.solve q d nearly ~asked:All in
      all_states c (fun s ->
          match (Solution.value found s, expected.(s)) with
          | Infinite, None -> true
          | a, Some x ->
            Answer.contains a x
            && (match (Answer.lower a, Answer.upper a) with
                | Some low, Some high -> Rat.compare (Rat.sub high low) nearly.width <= 0
                | _ -> false)
          | _, None -> false))

let qualitative c =
  let q = question c in
  let p d =
    best d Rat.compare (of_all probabilities c) in
  let least = p Equations.Min and greatest = p Equations.Max in
  let same set value numbers = all_states c (fun s -> Bits.mem set s = Rat.equal numbers.(s) value) in
  same (Qualitative.zero_max q) Rat.zero greatest
  && same (Qualitative.zero_min q) Rat.zero least
  && same (Qualitative.one_max q) Rat.one greatest
  && same (Qualitative.one_min q) Rat.one least

(* With a bound, what is decided is right, and something is decided unless the value is the bound itself. *)
let decided (c, k) =
  let q = question c in
  let bound = { Answer.relation = At_least_so; than = rat k 12 } in
  both (fun d ->
      let expected =
        best d Rat.compare (of_all probabilities c) in
      let found = Reach.solve q d { nearly with bound = Some bound } ~asked:(States [ 0 ]) in
      match Answer.holds (Solution.value found 0) bound with
      | Some yes -> yes = (Rat.compare expected.(0) bound.than >= 0)
      | None -> Rat.equal expected.(0) bound.than)

(* {1 Closed forms} *)

let ruin () =
  let check n p k =
    let m = Backwards.make (walk n p) in
    let always _ = true in
    let lost = Qualitative.until m ~stay:always ~goal:(fun s -> s = 0) in
    let over = Qualitative.until m ~stay:always ~goal:(fun s -> s = 0 || s = n) in
    List.iter
      (fun d ->
         let name what = Printf.sprintf "%s on %d at %s from %d" what n (Rat.to_string p) k in
         let same name expected solution =
           match Solution.value solution k with
           | Answer.Exact x -> Alcotest.(check string) name (Rat.to_string expected) (Rat.to_string x)
           | a -> Alcotest.fail (name ^ ": " ^ Answer.to_string a)
         in
         same (name "ruin") (ruin_probability n p k) (Reach.solve lost d exactly ~asked:(States [ k ]));
         same (name "duration") (expected_duration n p k) (Reward.solve over d exactly ~asked:(States [ k ]));
         let a = Solution.value (Reach.solve lost d nearly ~asked:(States [ k ])) k in
         Alcotest.(check bool) (name "enclosed") true (Answer.contains a (ruin_probability n p k)))
      [ Equations.Min; Max ]
  in
  check 5 (rat 2 5) 2;
  check 5 (rat 1 2) 1;
  check 60 (rat 1 2) 7;
  check 60 (rat 18 37) 20;
  check 200 (rat 99 100) 1

(* One component of thousands of states, exactly. *)
let long_walk () =
  let n = 5_000 and k = 1_700 in
  let m = Backwards.make (walk n Rat.half) in
  let until goal = Qualitative.until m ~stay:(fun _ -> true) ~goal in
  let same name expected solution =
    Alcotest.(check string) name (Rat.to_string expected) (Answer.to_string (Solution.value solution k))
  in
  let asked = Solution.States [ k ] in
  same "ruin" (ruin_probability n Rat.half k) (Reach.solve (until (Int.equal 0)) Max Effort.default ~asked);
  same "duration" (expected_duration n Rat.half k)
    (Reward.solve (until (fun s -> s = 0 || s = n)) Min Effort.default ~asked)

(* Intervals do not end too early where values creep: the plain test of convergence would, at 1/2 of the way. *)
let slow () =
  let n = 400 in
  let m = Backwards.make (walk n (rat 1 2)) in
  let q = Qualitative.until m ~stay:(fun _ -> true) ~goal:(fun s -> s = 0) in
  let a = Solution.value (Reach.solve q Max nearly ~asked:(States [ n / 2 ])) (n / 2) in
  Alcotest.(check bool) (Answer.to_string a) true (Answer.contains a (rat 1 2));
  match (Answer.lower a, Answer.upper a) with
  | Some x, Some y -> Alcotest.(check bool) "narrow" true (Rat.compare (Rat.sub y x) nearly.width <= 0)
  | _ -> Alcotest.fail "no interval"

(* {1 What is refused} *)

let refused () =
  let fault states =
    let b = Mdp.builder () in
    List.iter
      (fun choices ->
         ignore (Mdp.add_state b);
         List.iter (fun (reward, l) -> Mdp.add_choice b ~reward l) choices)
      states;
    match Mdp.finish b with Ok _ -> "accepted" | Error e -> Mdp.describe e
  in
  let check name expected states = Alcotest.(check string) name expected (fault states) in
  let loop = [ (Rat.zero, [ (0, Rat.one) ]) ] in
  check "a loop" "accepted" [ loop ];
  check "no choice" "state 1 has no choice" [ loop; [] ];
  check "a sum" "the probabilities of choice 0 of state 0 have the sum 1/2, which is not 1"
    [ [ (Rat.zero, [ (0, rat 1 2) ]) ] ];
  check "no state" "choice 0 of state 0 leads to state 3, which does not exist"
    [ [ (Rat.zero, [ (3, Rat.one) ]) ] ];
  check "a probability" "choice 1 of state 0 has the probability -1, which is not positive"
    [ [ (Rat.zero, [ (0, Rat.one) ]); (Rat.zero, [ (0, rat (-1) 1); (1, rat 2 1) ]) ]; loop ];
  check "a reward" "choice 0 of state 0 has the negative reward -1/2" [ [ (rat (-1) 2, [ (0, Rat.one) ]) ] ]

let interrupted () =
  let m = Backwards.make (walk 100_000 (rat 1 2)) in
  let q = Qualitative.until m ~stay:(fun _ -> true) ~goal:(fun s -> s = 0) in
  let effort = { nearly with interrupted = (fun () -> true) } in
  let a = Solution.value (Reach.solve q Max effort ~asked:(States [ 50_000 ])) 50_000 in
  Alcotest.(check bool) (Answer.to_string a) true (Answer.contains a (rat 1 2))

(* A clock that counts looks; exact values need so many, and intervals too. *)
let shared ~time ~needed ~intervals ~enough =
  let now = ref 0 and nearly = ref 0 and told = ref None in
  let until last () =
    incr now;
    !now > last
  in
  let part n () = until (!now + ((time - !now) / n)) in
  let effort =
    { Effort.default with interrupted = until time; half = part 2; quarter = part 4;
                          not_exact = (fun why -> told := Some why) }
  in
  let rec exactly n (effort : Effort.t) =
    if n = 0 then Ok "fraction"
    else if effort.interrupted () then Error Lifting.Interrupted
    else exactly (n - 1) effort
  in
  let nearly_ _ =
    incr nearly;
    now := !now + intervals;
    "interval"
  in
  let found = Exact_first.run effort ~exactly:(exactly needed) ~nearly:nearly_ ~enough:(fun _ -> enough) in
  (found, !nearly, Option.is_some !told)

let in_turn () =
  let check name expected found =
    Alcotest.(check (triple string int bool)) name expected found
  in
  check "at once" ("fraction", 0, false) (shared ~time:1_000 ~needed:50 ~intervals:10 ~enough:false);
  check "after the intervals" ("fraction", 1, false) (shared ~time:1_000 ~needed:240 ~intervals:10 ~enough:false);
  check "too long" ("interval", 1, true) (shared ~time:1_000 ~needed:900 ~intervals:10 ~enough:false);
  check "long intervals" ("interval", 1, true) (shared ~time:1_000 ~needed:240 ~intervals:600 ~enough:false);
  check "decided" ("interval", 1, true) (shared ~time:1_000 ~needed:240 ~intervals:10 ~enough:true);
  check "no time" ("interval", 1, true) (shared ~time:0 ~needed:5 ~intervals:10 ~enough:false)

(* A cycle in which each state is as far from its value as the one before: what becomes nearer goes around it, and
   the others, which rounding takes farther, never settle at once. *)
let around () =
  let plain =
    [|
      [ (1, [ (3, 2) ]) ]; [ (0, [ (1, 1); (1, 1); (4, 2) ]); (2, [ (0, 4) ]) ]; [ (0, [ (2, 1) ]) ];
      [ (2, [ (2, 4); (1, 1); (0, 3) ]); (0, [ (1, 4); (2, 1); (1, 1) ]) ];
      [ (1, [ (0, 4); (4, 3) ]); (2, [ (0, 1) ]); (0, [ (0, 2); (1, 4) ]) ];
    |]
  in
  let c = { plain; goal = Array.init 5 (Int.equal 2); stay = Array.make 5 true } in
  Alcotest.(check bool) "narrow" true (rewards_nearly c)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let with_bound = Gen.pair gen (Gen.int_bound 12) in
  Alcotest.run "chance"
    [
      ( "against all schedulers",
        [
          law "where it is 0, and where 1" gen print qualitative;
          law "probabilities" gen print reach_exact;
          law "probabilities in intervals" gen print reach_nearly;
          law "sums of rewards" gen print rewards_exact;
          law "sums of rewards in intervals" gen print rewards_nearly;
          law "what a bound decides" with_bound (fun (c, k) -> Printf.sprintf "%s\nbound %d/12" (print c) k)
            decided; ] );
      ("closed forms", [ case "ruin" ruin; case "a long walk" long_walk; case "slow convergence" slow ]);
      ("a cycle", [ case "rewards" around ]);
      ("limits", [ case "what is no process" refused; case "interrupted" interrupted;
                   case "fractions and intervals in turn" in_turn ]);
    ]

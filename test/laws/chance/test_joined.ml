(* Rule JoinedDraws: with the draws of an instant as one transition, and with the states between them, checks have
   the same answers, and runs that are shown are runs by the rules. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
open Scc_verify
open Scc_test_models
module Gen = QCheck2.Gen

(* {1 Checks} *)

let leaves (m : Told_otherwise.model) =
  let of_cluster (c, (cluster : Told_otherwise.cluster)) = List.mapi (fun l _ -> (c, l)) cluster.leaves in
  List.concat_map of_cluster (Told_otherwise.numbered m.clusters)

let name = Told_otherwise.leaf_name Told_otherwise.as_it_is

(* Predicates of states and events; the second kind is what may be seen between draws. *)
let literal (m : Told_otherwise.model) ~laws =
  let open Gen in
  let atoms = List.map (Told_otherwise.atom Told_otherwise.as_it_is) (Told_otherwise.atoms m.clusters ~laws) in
  let plain = List.filter (fun a -> not (String.length a > 5 && String.equal (String.sub a 0 5) "event")) atoms in
  let leaf = map name (oneofl (leaves m)) and axis = oneofl [ "x"; "y"; "z" ] in
  let place = map3 (fun a p (c, q) -> Printf.sprintf "%s(%s) %s %s(%s)" a p c a q) axis leaf
      (pair (oneofl [ "<"; "<="; ">" ]) leaf)
  and speed = map3 (fun a p k -> Printf.sprintf "v%s(%s) > %d" a p k) axis leaf (int_range (-1) 0)
  and drawn = map (fun p -> Printf.sprintf "event bounce(%s)" p) leaf in
  let one =
    frequency
      ([ (8, oneofl plain) ] @ if laws then [ (4, place); (3, speed); (1, drawn); (1, oneofl atoms) ] else
         [ (1, oneofl atoms) ])
  in
  map2 (fun a k -> if k = 0 then Printf.sprintf "not (%s)" a else a) one (int_bound 3)

let check m ~laws =
  let open Gen in
  let* p = literal m ~laws and* q = literal m ~laws and* r = literal m ~laws in
  let* bound = oneofl (if laws then [ "[<= 1]"; "[<= 2]"; "[1, 2]" ] else [ ""; "[<= 2]"; "[1, 2]" ]) in
  let* f = oneofl [ p; Printf.sprintf "(%s and %s)" p r; Printf.sprintf "(%s or %s)" p r ] in
  let* odds = oneofl [ "1/4"; "1/2"; "1" ] and* leaf = map name (oneofl (leaves m)) in
  let event = if laws then "bounce" else Printf.sprintf "split(a, %s)" leaf in
  let flat =
    [
      Printf.sprintf "EF%s %s" bound f; Printf.sprintf "AG%s %s" bound f; Printf.sprintf "AF%s %s" bound f;
      Printf.sprintf "P = ? [ eventually%s %s ]" bound f; Printf.sprintf "P = ? [ always%s %s ]" bound f;
      Printf.sprintf "P = ? [ %s U%s %s ]" q bound f; Printf.sprintf "Pmin = ? [ %s U%s %s ]" f bound q;
      Printf.sprintf "P >= %s [ eventually%s %s ] and EF%s %s" odds bound f bound q;
      Printf.sprintf "E = ? [ (if %s then 1 else 0) at %s ]" f (if laws then "1" else "3/2");
      Printf.sprintf "E = ? [ time U (%s or time >= 2) ]" f;
    ]
  and seeing =
    [
      Printf.sprintf "EX %s" f; Printf.sprintf "AX AX %s" f; Printf.sprintf "EF%s (%s and EX %s)" bound q f;
      Printf.sprintf "EF%s (P >= %s [ eventually%s %s ])" bound odds bound f;
      Printf.sprintf "P = ? [ %s U%s P >= %s [ eventually%s %s ] ]" q bound odds bound f;
      Printf.sprintf "EF%s (EF%s %s and EF%s %s and AG%s not %s)" bound bound p bound q bound r;
      Printf.sprintf "E = ? [ event %s U (%s or time >= 2) ]" event f;
    ]
  in
  frequency [ (3, oneofl flat); (1, oneofl seeing) ]

let case ~laws =
  let open Gen in
  let* m = Told_otherwise.model ~laws in
  let+ checks = list_size (1 -- 2) (check m ~laws) in
  let text = Told_otherwise.to_text Told_otherwise.as_it_is { m with questions = [] } in
  text ^ "\n" ^ String.concat "\n" (List.mapi (fun i c -> Printf.sprintf "check c%d : %s" i c) checks)

(* Walkers that are alike, in a room together. *)
let alike =
  let open Gen in
  let* n = 2 -- 3 and* far = oneofl [ 2; 3; 5 ] and* beat = oneofl [ ""; "steady"; "local" ] in
  let* law = oneofl [ "(1,0,0), (-1,0,0)"; "(1,0,0) weight 2, (0,0,0)"; "(vx,0,0), (1 - vx,0,0)" ] in
  let* wall = oneofl [ ""; " absorb" ] and* still = bool in
  let* k = int_range (-2) 4 and* bound = oneofl [ ""; "[<= 2]"; "[1, 2]" ] in
  let* how = oneofl [ "some"; "all" ] in
  let body i = Printf.sprintf "process w%d = Cube mass 1 at translate (%d, 0, 0) [nil]\n" i (far * i) in
  let each f = String.concat (if how = "some" then " or " else " and ") (List.init n f) in
  let at = each (fun i -> Printf.sprintf "x(w%d) > %d" i k) in
  let fast = each (fun i -> Printf.sprintf "vx(w%d) > 0" i) in
  let checks =
    [
      Printf.sprintf "P = ? [ eventually%s %s ]" (if bound = "" then "[<= 3]" else bound) at;
      Printf.sprintf "P = ? [ %s U[<= 2] %s ]" at fast; Printf.sprintf "EF[<= 2] (%s and %s)" at fast;
      Printf.sprintf "E = ? [ time U (%s or time >= 3) ]" at; "E = ? [ x(w0) + vx(w1) at 2 ]";
    ]
  in
  let+ asked = list_size (1 -- 2) (oneofl checks) in
  Printf.sprintf "split_step 1\ntimestep 1 %s\nshape Cube = box(1, 1, 1)\n" beat
  ^ Printf.sprintf "fixed wall = Cube%s at translate (%d, 0, 0)\n" wall ((far * n) + 1)
  ^ String.concat "" (List.init n body)
  ^ (if still then "process s = Cube mass 2 velocity (0, 1, 0) at translate (-5, 0, 0) [nil]\n" else "")
  ^ String.concat ""
    (List.init n (fun i -> Printf.sprintf "motion w%d = choose { %s }\n" i law))
  ^ String.concat "\n" (List.mapi (fun i c -> Printf.sprintf "check c%d : %s" i c) asked)

(* Walkers on a floor that wait, stop or bounce where they are blocked. Some meet a wall that takes them out, or
   make a bond on the way. Some are with a body at rest, or with one that moves and is no walker. *)
let floor_checks ~columns ~n =
  let open Gen in
  let* k = int_range 1 (2 * columns) and* how = oneofl [ "exists"; "forall" ] and* high = oneofl [ 1; 2; 3 ] in
  let* axis = oneofl [ "x"; "y" ] and* compared = oneofl [ ">"; ">="; "<"; "=" ] in
  let at = Printf.sprintf "%s q in w: %s(q) %s %d/2" how axis compared k in
  let corner = Printf.sprintf "exists q in w: (x(q) > %d/2 and y(q) < 3/4)" k in
  let one = Printf.sprintf "x(w[0]) %s %d/2" compared k and pair = Printf.sprintf "x(w[0]) %s x(w[1])" compared in
  let near = "distance2(w[0], w[1]) <= 1" and touch = Printf.sprintf "touching(w[%d], wall)" (n - 1) in
  let many = Printf.sprintf "count(q in w: x(q) > %d/2) >= 2" k and gone = "exists q in w: gone(q)" in
  let fast = "vx(w[0]) > 0" and tied = "bonds() > 0" in
  let* f = oneofl [ at; at; corner; corner; one; pair; near; touch; many; gone; tied; fast ] in
  let* g = oneofl [ at; corner; one; pair; many; tied; Printf.sprintf "time > %d/2" k ] in
  let flat =
    [
      Printf.sprintf "P = ? [ eventually[<= %d] %s ]" high f;
      Printf.sprintf "P = ? [ eventually[1/2, %d] %s ]" high f;
      Printf.sprintf "P = ? [ not (%s) U[<= %d] %s ]" g high f;
      Printf.sprintf "E = ? [ time U (%s or time >= %d) ]" f high;
      Printf.sprintf "P = ? [ eventually %s ]" f; Printf.sprintf "P = ? [ always[<= %d] (%s or %s) ]" high f g;
      Printf.sprintf "E = ? [ (if %s then 1 else 0) at %d/2 ]" f high;
    ]
  and seeing =
    [
      Printf.sprintf "E = ? [ x(w[0]) + y(w[%d]) at %d/2 ]" (n - 1) high;
      Printf.sprintf "EF[<= %d] (%s and %s)" high f g;
      Printf.sprintf "P = ? [ %s U[<= %d] P >= 1/4 [ eventually[<= 1] %s ] ]" g high f;
      Printf.sprintf "EX EX %s" f;
      Printf.sprintf "E = ? [ event bounce U (%s or time >= %d) ]" f high;
      Printf.sprintf "P >= 1/3 [ eventually[<= %d] %s ]" high f;
    ]
  in
  frequency [ (5, oneofl flat); (1, oneofl seeing) ]

let on_a_floor =
  let open Gen in
  let* columns, rows = oneofl [ (3, 1); (4, 1); (2, 2); (3, 2) ] in
  let* how = frequencyl [ (6, "wait"); (1, "stop"); (1, "bounce") ] in
  let* n = int_range 2 (if columns * rows > 4 then 3 else 2) in
  let* beat = frequencyl [ (4, "steady"); (1, ""); (1, "local") ] in
  let* kicks =
    oneofl
      [
        "(1,0,0), (-1,0,0), (0,1,0), (0,-1,0)"; "(1,0,0) weight 2, (-1,0,0), (0,0,0)"; "(1/2,0,0), (-1,0,0)";
        "(1,0,0) weight (if x > 1 then 3 else 1), (-1,0,0)"; "(2,0,0), (-1,0,0), (0,1,0)";
        "(1 + vx, 0, 0), (-1,0,0)"; "(1,0,0), (-1 - time, 0, 0)";
      ]
  in
  let* absorbs = frequencyl [ (3, ""); (1, " absorb") ] and* binds = frequencyl [ (3, false); (1, true) ] in
  let* still = frequencyl [ (4, ""); (1, "process s = Cube mass 2 at translate (0, 9, 0) [nil]\n");
                            (1, "process s = Cube mass 2 velocity (0,1,0) at translate (0, 9, 0) [nil]\n") ] in
  let* asked = list_size (1 -- 2) (floor_checks ~columns ~n) in
  let wall name (x, y) (a, b) fate =
    Printf.sprintf "fixed %s = box(%d, %d, 1)%s at translate (%d/2, %d/2, 0)\n" name a b fate x y
  in
  let body i =
    Printf.sprintf "process w[%d] = Cube mass 1 at translate (%d, %d, 0) [%s]\n" i (i mod columns) (i / columns)
      (if binds then "A" else "nil")
  in
  return
    (Printf.sprintf "split_step 1\ntimestep 1 %s\nblocked %s\nshape Cube = box(1, 1, 1)\n" beat how
     ^ "behaviour A on Cube = <a, {right}> . omega(a, {right}) . A + <~a, {left}> . omega(a, {left}) . A\n"
     ^ wall "wall" (-2, rows - 1) (1, rows + 2) absorbs ^ wall "east" (2 * columns, rows - 1) (1, rows + 2) ""
     ^ wall "south" (columns - 1, -2) (columns, 1) "" ^ wall "north" (columns - 1, 2 * rows) (columns, 1) ""
     ^ String.concat "" (List.init n body) ^ still
     ^ Printf.sprintf "motion w = choose { %s }\n" kicks
     ^ String.concat "\n" (List.mapi (fun i c -> Printf.sprintf "check c%d : %s" i c) asked))

(* {1 The comparison} *)

type tally = {
  mutable joined : int;  (** models with other states *)
  mutable numbers : int;
  mutable truths : int;
  mutable runs : int;
  mutable seen : int;  (** checks that may see between *)
}

let tally = { joined = 0; numbers = 0; truths = 0; runs = 0; seen = 0 }

(* What is decided, and between which numbers a number is. *)
type known = Is of bool | Between of (Rat.t option * Rat.t option) list | Open

let known (v : Verdict.t) =
  let ends (_, (m : Scc_ctl.Eval.measured)) = (Scc_chance.Answer.lower m.least, Scc_chance.Answer.upper m.most) in
  match v with
  | Holds { bounds = []; _ } -> Is true
  | Violated _ -> Is false
  | Measured { reasons = []; values; _ } -> Between (List.map ends values)
  | Holds _ | Measured _ | Depends _ | Undecided _ -> Open

let meet (low, high) (low', high') =
  let below a b = match (a, b) with Some a, Some b -> Rat.compare a b <= 0 | None, _ | _, None -> true in
  below low high' && below low' high

let compare_verdicts text a b =
  match (known a, known b) with
  | Open, _ | _, Open -> ()
  | Is a, Is b ->
    tally.truths <- tally.truths + 1;
    if not (Bool.equal a b) then QCheck2.Test.fail_reportf "joined: %b, one by one: %b\n%s" a b text
  | Between a, Between b ->
    tally.numbers <- tally.numbers + 1;
    if not (List.for_all2 meet a b) then QCheck2.Test.fail_reportf "other numbers\n%s" text
  | Is _, Between _ | Between _, Is _ -> QCheck2.Test.fail_report "a number and a truth"

let replays semantics initial (v : Verdict.t) =
  match v with
  | Holds { witness = Some w; _ } | Violated { witness = Some w } | Measured { witness = Some w; _ } -> (
      tally.runs <- tally.runs + 1;
      match Scc_test_networks.Reach.follow semantics initial (Scc_explain.Witness.choices w) with
      | Error _ -> QCheck2.Test.fail_report "a run does not replay"
      | Ok transitions ->
        let last = match List.rev transitions with [] -> initial | t :: _ -> t.Transition.target in
        if not (State.equal last w.last) then QCheck2.Test.fail_report "a run leads elsewhere")
  | Holds _ | Violated _ | Measured _ | Depends _ | Undecided _ -> ()

let agrees text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> true
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 2500 } in
    let run reductions = Check.run { Setup.default with bounds; reductions } semantics ~initial e.checks in
    let others = List.filter (fun k -> not (Reduction.equal k Draws)) Reduction.all in
    let each ?(fewer = true) (joined : Check.report) (plain : Check.report) =
      if joined.stats.states <> plain.stats.states then tally.joined <- tally.joined + 1;
      if fewer && joined.stats.complete && plain.stats.complete && joined.stats.states > plain.stats.states then
        QCheck2.Test.fail_report "more states";
      List.iter2
        (fun (a : Verdict.outcome) (b : Verdict.outcome) ->
           if not (Between_draws.unseen a.check) then tally.seen <- tally.seen + 1;
           if a.lost <> [] || b.lost <> [] then QCheck2.Test.fail_reportf "a run is lost\n%s" text;
           compare_verdicts text a.verdict b.verdict;
           replays semantics initial a.verdict)
        joined.outcomes plain.outcomes
    in
    let plain = run [ Reduction.Jump ] and all = run Reduction.all in
    each (run [ Reduction.Jump; Draws ]) plain;
    each all (run others);
    each all plain ~fewer:false;
    true

let random name count case = QCheck2.Test.make ~name ~count ~print:Fun.id case agrees
let scale = match Sys.getenv_opt "JOINED_DRAWS" with Some n -> int_of_string n | None -> 1

let tests =
  [
    random "JoinedDraws: lots" (20 * scale) (case ~laws:false);
    random "JoinedDraws: velocities" (30 * scale) (case ~laws:true);
    random "JoinedDraws: walkers that are alike" (40 * scale) alike;
    random "JoinedDraws: walkers that wait" (30 * scale) on_a_floor;
  ]

let counts () =
  Printf.printf "%d models with other states, %d numbers and %d truths compared, %d runs, %d checks that see\n"
    tally.joined tally.numbers tally.truths tally.runs tally.seen;
  let some what expected n = if n < expected then Alcotest.failf "only %d %s" n what in
  some "models with other states" 20 tally.joined;
  some "numbers" 40 tally.numbers;
  some "truths" 15 tally.truths;
  some "runs" 20 tally.runs;
  some "checks that see" 10 tally.seen

(* {1 By hand: what each condition is for} *)

let cube = "shape Cube = box(1, 1, 1)\ntimestep 1 steady\n"

let walker ?(velocity = 0) ?(x = 0) name y law =
  Printf.sprintf "process %s = Cube mass 1 velocity (%d, 0, 0) at translate (%d, %d, 0) [nil]\n" name velocity x y
  ^ Printf.sprintf "motion %s = choose { %s }\n" name law

let coin = "(1,0,0), (-1,0,0)"
let two = walker "p" 0 coin ^ walker "q" 9 coin

let told : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Violated _ -> "violated"
  | Measured { values = (_, { least = Exact x; most = Exact y }) :: _; _ } when Rat.equal x y -> Rat.to_string x
  | Holds _ | Measured _ | Depends _ | Undecided _ -> "undecided"

let is expected scene check () =
  let e = Load.exactly (Load.text (cube ^ scene ^ "check c : " ^ check)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let initial = Result.get_ok (Network.initial semantics e.declared) in
  let run reductions =
    List.hd (Check.run { Setup.default with reductions } semantics ~initial e.checks).outcomes
  in
  let without = run [ Reduction.Jump ] and all = run [ Reduction.Jump; Draws ] in
  Alcotest.(check string) "one by one" expected (told without.verdict);
  Alcotest.(check string) "joined" expected (told all.verdict);
  Alcotest.(check (list string)) "no run is lost" [] all.lost;
  replays semantics initial all.verdict

(* Between the draws it is known where p goes, and not where q goes. *)
let nested =
  "EF[0, 0] (P >= 1 [ eventually x(p) > 0 within 1/2 ] and EF[0, 1/2] x(q) > 0 and EF[0, 1/2] x(q) < 0)"

(* A law that keeps most of its velocity: from 0 it goes with 1/4, and goes on with 3/4. *)
let keeps = "(vx,0,0) weight 3, (1 - vx,0,0)"

(* A body of two leaves, of which one keeps its velocity: the mean is 1 or 0, and then it may be 3/2. *)
let half =
  "process d = a : Cube mass 1 at translate (0, 0, 0) [nil] <b, {a.right, c.left}>\n\
   c : Cube mass 1 at translate (1, 0, 0) [nil]\n\
   motion a = choose { (2,0,0), (0,0,0) }\n"

(* It stays where it is for ever, and comes back to another velocity than it began with. *)
let stays = "(0,0,0), (1,0,0)"

(* It comes to 0 from the left, and then goes round between 0 and 1, and comes to 0 from the right. *)
let goes_round = "(if x < 1/2 then 1 else -1, 0, 0)"

let through () =
  let o n chance =
    { Joint_draws.tuple = [| n |]; chance = Result.get_ok (Rat.of_literal chance); transitions = 1 }
  in
  let leave t =
    match t.(0) with
    | 1 -> Ok (Some [ o 3 "1" ])
    | 2 -> Ok (Some [ o 3 "1/2"; o 4 "1/2" ])
    | _ -> Ok None
  in
  match Joint_draws.through leave [ o 1 "1/3"; o 2 "2/3"; o 5 "0" ] with
  | Ok (Some found) ->
    let told (o : Joint_draws.outcome) = (o.tuple.(0), Rat.to_string o.chance, o.transitions) in
    Alcotest.(check (list (triple int string int))) "merged" [ (5, "0", 1); (3, "2/3", 2); (4, "1/3", 2) ]
      (List.map told found)
  | Ok None | Error () -> Alcotest.fail "too many, or a fault"

let by_hand =
  [
    ("operators within others see", is "holds" two nested);
    ("X sees", is "holds" two "EX energy = 0");
    ("numbers that read velocities see them", is "3/4" two "P = ? [ eventually[1, 1] vx(p) > 0 ]");
    ("laws that read velocities keep them",
     is "3/16" (walker "p" 0 keeps ^ walker "q" 9 keeps) "P = ? [ eventually x(p) >= 2 within 2 ]");
    ("so do leaves without a law",
     is "1/4" (half ^ walker "q" 9 coin) "P = ? [ eventually x(a) > 9/4 within 2 ]");
    ("runs that recur",
     is "violated" (walker "p" 0 ~velocity:5 stays ^ walker "q" 9 stays) "AF x(p) > 1");
    ("runs that come back with another velocity",
     is "violated" (walker ~x:(-1) "p" 0 goes_round ^ walker ~x:(-1) "q" 9 goes_round) "AF y(p) > 5");
    ("runs that come back from another place",
     is "violated" ("blocked wait\n" ^ walker ~x:(-1) "p" 0 goes_round ^ walker ~x:(-1) "q" 9 goes_round)
       "AF y(p) > 5");
    ("outcomes are merged", through);
  ]

(* {1 Growth} *)

(* The draws of so many bodies at time 0, and the words that their exploration allocates. *)
let instant reductions n =
  let one i = walker (Printf.sprintf "w%d" i) (9 * i) "for i in 1..4: (i,0,0)" in
  let walkers = String.concat "" (List.init n one) in
  let e = Load.exactly (Load.text (cube ^ walkers ^ "check c : possibly x(w0) > 0 within 0")) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let initial = Result.get_ok (Network.initial semantics e.declared) in
  let bounds = { Bounds.default with states = Default 1_000_000; time = Given Rat.zero } in
  let before = Gc.minor_words () in
  let stats = (Check.run { Setup.default with bounds; reductions } semantics ~initial e.checks).stats in
  (stats, Gc.minor_words () -. before)

let rec power n = if n = 0 then 1 else 4 * power (n - 1)

(* The states after all draws, and the first one: those between are as many as a third of them. *)
let grows () =
  let words = ref [] in
  for n = 2 to 7 do
    let joined, allocated = instant [ Reduction.Jump; Draws ] n and plain, _ = instant [ Reduction.Jump ] n in
    let draws = power n in
    Printf.printf "%d bodies: %d states, one by one %d; %.0f words an outcome\n" n joined.states plain.states
      (allocated /. float_of_int draws);
    Alcotest.(check int) "one by one" ((draws * 4) - 1) (3 * (plain.states - draws));
    Alcotest.(check int) "joined" ((2 * draws) + 1) joined.states;
    words := (allocated /. float_of_int draws) :: !words
  done;
  match !words with
  | w7 :: w6 :: _ -> if w7 > 1.5 *. w6 then Alcotest.fail "an outcome costs more the more there are"
  | _ -> Alcotest.fail "nothing was measured"

let () =
  Alcotest.run "joined draws"
    [
      ("random", Scc_test_support.Property.cases tests @ [ Alcotest.test_case "counts" `Quick counts ]);
      ("by hand", List.map (fun (name, test) -> Alcotest.test_case name `Quick test) by_hand);
      ("growth", [ Alcotest.test_case "of the draws of one instant" `Quick grows ]);
    ]

(* Rule Isometry: turns and mirror images of a scene take transitions to transitions and keep predicates, and
   numbers are the same with the reduction and without. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Scc_verify
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

let load text =
  match Scc_test_models.Load.text text with
  | Error errors ->
    let message (d : Scc_base.Diag.t) = d.message in
    QCheck2.Test.fail_reportf "refused\n%s\n%s" text (String.concat "\n" (List.map message errors))
  | Ok e -> (e, Network.initial (standard e.model) e.declared)

(* {1 Scenes} *)

let kicks =
  [
    (5, "(1,0,0), (-1,0,0), (0,1,0), (0,-1,0)"); (1, "(1,0,0) weight 2, (-1,0,0), (0,1,0), (0,-1,0)");
    (1, "(1,0,0) weight 2, (-1,0,0) weight 2, (0,1,0), (0,-1,0)"); (1, "(1,0,0), (0,1,0)");
    (1, "(1,0,0), (-1,0,0)");
    (1, "(1,1,0), (-1,1,0), (1,-1,0), (-1,-1,0)"); (1, "(1/2,0,0), (-1/2,0,0), (0,1/2,0), (0,-1/2,0)");
    (1, "(if x > 1 then 1 else -1, 0, 0), (0,1,0)"); (1, "(1,0,0), (0,1,0), (-1,-1,0)");
  ]

(* Walls of one body, or of four, of which one may be longer, or take out what hits it. *)
let walls ~columns ~rows =
  let open Gen in
  let wall name (x, y) (a, b) fate =
    Printf.sprintf "fixed %s = box(%d, %d, 1)%s at translate (%d/2, %d/2, 0)\n" name a b fate x y
  in
  let* absorbs = frequencyl [ (4, ""); (1, " absorb") ] and* longer = frequencyl [ (3, 2); (1, 4) ] in
  let four =
    wall "west" (-1, rows) (1, rows + longer) absorbs ^ wall "east" ((2 * columns) + 1, rows) (1, rows + 2) ""
    ^ wall "south" (columns, -1) (columns, 1) "" ^ wall "north" (columns, (2 * rows) + 1) (columns, 1) ""
  in
  let room =
    Printf.sprintf "fixed wall = solids.Room(%d, %d, 1, 1) at translate (%d/2, %d/2, 0)\n" columns rows columns
      rows
  in
  frequencyl [ (2, four); (3, room) ]

let cells ~columns ~rows = List.concat_map (fun x -> List.init rows (fun y -> (x, y))) (List.init columns Fun.id)

let predicate ~columns ~rows ~n ~binds =
  let open Gen in
  let* axis = oneofl [ "x"; "y" ] and* k = int_range 0 (2 * columns) and* how = oneofl [ "exists"; "forall" ] in
  let* compared = oneofl [ ">"; ">="; "<"; "=" ] and* i = int_bound (n - 1) in
  let corner = Printf.sprintf "%s q in w: (x(q) > %d - 1 and y(q) > %d - 1)" how columns rows in
  let middle = Printf.sprintf "exists q in w: (2*x(q) = %d and 2*y(q) %s %d)" columns compared rows in
  let square axis n = Printf.sprintf "(%s(q) - %d/2)*(%s(q) - %d/2)" axis n axis n in
  let far = Printf.sprintf "%s q in w: %s + %s > 1" how (square "x" columns) (square "y" rows) in
  let sides = Printf.sprintf "x(w[%d]) < 1 or x(w[%d]) > %d - 1" i i columns in
  let strip = Printf.sprintf "%s q in w: %s(q) %s %d/2" how axis compared k in
  let diagonal = Printf.sprintf "x(w[%d]) %s y(w[%d])" i compared i in
  let many = Printf.sprintf "count(q in w: %s(q) > %d/2) = 1" axis k in
  let near = "distance2(w[0], w[1]) <= 1" and gone = "exists q in w: gone(q)" in
  let touch = Printf.sprintf "touching(w[%d], w[%d])" i (if i = 0 then 1 else 0) in
  let fast = Printf.sprintf "v%s(w[%d]) > 0" axis i in
  let later = Printf.sprintf "time > %d/2" k in
  frequencyl
    ([ (4, corner); (2, middle); (3, far); (2, sides); (1, strip); (1, diagonal); (1, many); (2, near); (1, gone);
       (1, touch); (1, fast); (1, later) ]
     @ if binds then [ (3, "bonds() > 0"); (1, "same(w[0], w[1])") ] else [])

let check ~columns ~rows ~n ~binds =
  let open Gen in
  let* p = predicate ~columns ~rows ~n ~binds and* q = predicate ~columns ~rows ~n ~binds in
  let* high = int_range 1 3 in
  frequencyl
    [
      (3, Printf.sprintf "P = ? [ eventually[<= %d] %s ]" high p);
      (1, Printf.sprintf "P = ? [ not (%s) U[<= %d] %s ]" q high p);
      (2, Printf.sprintf "E = ? [ time U (%s or time >= %d) ]" p high);
      (1, Printf.sprintf "E = ? [ time U (%s) ]" p);
      (1, Printf.sprintf "E = ? [ (if %s then 1 else 0) at %d/2 ]" p high);
      (1, Printf.sprintf "E = ? [ (2*x(w[0]) - %d)*(%d - 2*x(w[0])) at %d ]" columns columns high);
      (1, Printf.sprintf "E = ? [ x(w[0]) + y(w[%d]) at %d ]" (n - 1) high);
      (1, Printf.sprintf "P = ? [ always[<= %d] (%s or %s) ]" high p q);
    ]

let scene =
  let open Gen in
  let* columns, rows = frequencyl [ (4, (3, 3)); (2, (2, 2)); (1, (3, 2)); (1, (4, 2)); (1, (3, 1)) ] in
  let* how = frequencyl [ (5, "wait"); (2, "stop"); (1, "bounce") ] in
  let* beat = frequencyl [ (4, "steady"); (1, ""); (1, "local") ] in
  let* n = frequencyl [ (1, 1); (4, 2); (1, 3) ] and* law = frequencyl kicks in
  let* binds =
    frequencyl [ (6, None); (1, Some "right"); (2, Some "only top"); (1, Some "only left, only right") ]
  in
  let* walls = walls ~columns ~rows and* places = shuffle_l (cells ~columns ~rows) in
  let* obstacles = frequencyl [ (3, 0); (2, 1); (1, 2) ] in
  let* shape = frequencyl [ (3, "box(1, 1, 1)"); (1, "Wedge") ] and* off = frequencyl [ (3, 0); (1, 1) ] in
  let n = Int.min (Int.max 2 n) (List.length places) in
  let obstacles = Int.max 0 (Int.min obstacles (List.length places - n)) in
  let at ?(off = 0) k =
    let x, y = List.nth places k in
    Printf.sprintf "(%d/2, %d/2, 0)" ((2 * x) + 1) ((2 * (y - off)) + 1)
  in
  let+ asked = list_size (1 -- 2) (check ~columns ~rows ~n ~binds:(Option.is_some binds)) in
  let body i =
    let behaviour = if binds = None then "nil" else "A" in
    let off = if binds = None then off else 0 in
    let shape = if off = 1 then "Off" else "Cube mass 1" in
    Printf.sprintf "process w[%d] = %s at translate %s [%s]\n" i shape (at ~off i) behaviour
  in
  let obstacle i = Printf.sprintf "fixed b%d = %s at translate %s\n" i shape (at (n + i)) in
  Printf.sprintf "import <solids>\nsplit_step 1\ntimestep 1 %s\nblocked %s\nshape Cube = box(1, 1, 1)\n" beat how
  ^ "compound Off { part a : Cube mass 1 at translate (0, 1, 0) }\n"
  ^ "shape Wedge {\n  vertices a (-1/2,-1/2,-1/2) b (1/2,-1/2,-1/2) c (-1/2,1/2,-1/2)\n"
  ^ "  d (-1/2,-1/2,1/2) e (1/2,-1/2,1/2) f (-1/2,1/2,1/2)\n"
  ^ "  faces low [a,c,b] high [d,e,f] s1 [a,b,e,d] s2 [b,c,f,e] s3 [c,a,d,f]\n}\n"
  ^ (match binds with
      | None -> ""
      | Some side -> Printf.sprintf "behaviour A on Cube = <a, {%s}> . nil + <~a, {%s}> . nil\n" side side)
  ^ walls ^ String.concat "" (List.init obstacles obstacle) ^ String.concat "" (List.init n body)
  ^ Printf.sprintf "motion w = choose { %s }\n" law
  ^ String.concat "\n" (List.mapi (fun i c -> Printf.sprintf "check c%d : %s" i c) asked)

(* {1 Transitions of a state and of its image} *)

type tally = {
  mutable scenes : int;
  mutable symmetric : int;  (** scenes with an isometry *)
  mutable states : int;  (** states compared with their images *)
  mutable fewer : int;  (** scenes of which less was explored *)
  mutable numbers : int;
  mutable runs : int;
}

let tally = { scenes = 0; symmetric = 0; states = 0; fewer = 0; numbers = 0; runs = 0 }

(* What a state may come to, without labels: durations, chances and targets, in order. *)
let ways context at tuple =
  let catalogue = Network_lts.catalogue context in
  match Network_lts.successors context tuple with
  | Error _ -> QCheck2.Test.fail_report "a fault"
  | Ok steps ->
    let way (s : Scc_graph_search.Lts.step) =
      let target = Catalogue.decode catalogue (Scc_graph_search.Tuples.apply s.changes tuple) in
      let chance = Option.fold ~none:"" ~some:Rat.to_string (Catalogue.chance catalogue s.label) in
      (Rat.to_string (Network_lts.duration context s.label), chance, Catalogue.encode catalogue (at target))
    in
    List.sort compare (List.map way steps)

let image g model s = State.mapi (fun _ p -> Isometry.image g model p) s

let predicates checks = List.concat_map (fun (c : Property.check) -> Formula.predicates c.formula) checks

let numbers checks =
  let of_check (c : Property.check) =
    match c.asked with
    | Expected (_, Value_at (n, _), _) -> Some n
    | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> None
  in
  List.filter_map of_check checks

let found (e : Scc_elaborate.Elaborate.t) initial =
  Isometry.find e.model ~initial ~predicates:(predicates e.checks) ~numbers:(numbers e.checks)

let same_in_both semantics ~predicates ~numbers s t =
  let instant s = Trajectory.make semantics s Scc_ctl.Timeline.Instant in
  let truth p = Scc_ctl.Truth.equal (Trajectory.holds semantics s p) (Trajectory.holds semantics t p) in
  let value n =
    match (Trajectory.number_at (instant s) n Rat.zero, Trajectory.number_at (instant t) n Rat.zero) with
    | Ok x, Ok y -> Rat.equal x y
    | Error _, Error _ -> true
    | Ok _, Error _ | Error _, Ok _ -> false
  in
  List.for_all truth predicates && List.for_all value numbers

(* From the initial state, breadth first. *)
let compare_states text (e : Scc_elaborate.Elaborate.t) initial isometries =
  let semantics = standard e.model in
  let context = Network_lts.make ~joined:true semantics initial in
  let catalogue = Network_lts.catalogue context in
  let predicates = predicates e.checks and numbers = numbers e.checks in
  let seen = Hashtbl.create 64 and waiting = Queue.create () in
  let enter tuple =
    if Hashtbl.length seen < 25 && not (Hashtbl.mem seen tuple) then begin
      Hashtbl.add seen tuple ();
      Queue.add tuple waiting
    end
  in
  let compare_with tuple g =
    let s = Catalogue.decode catalogue tuple in
    let there = image g e.model s in
    tally.states <- tally.states + 1;
    if not (same_in_both semantics ~predicates ~numbers s there) then
      QCheck2.Test.fail_reportf "a predicate\n%s" text;
    if ways context (image g e.model) tuple <> ways context Fun.id (Catalogue.encode catalogue there) then
      QCheck2.Test.fail_reportf "other transitions\n%s" text
  in
  enter (Network_lts.initial context);
  while not (Queue.is_empty waiting) do
    let tuple = Queue.take waiting in
    List.iter (compare_with tuple) isometries;
    List.iter (fun (_, _, target) -> enter target) (ways context Fun.id tuple)
  done

(* {1 Numbers} *)

let ends (_, (m : Scc_ctl.Eval.measured)) = (Scc_chance.Answer.lower m.least, Scc_chance.Answer.upper m.most)

let meet a b =
  let (low, high), (low', high') = (ends a, ends b) in
  let below a b = match (a, b) with Some a, Some b -> Rat.compare a b <= 0 | None, _ | _, None -> true in
  below low high' && below low' high

let compare_verdicts text (a : Verdict.outcome) (b : Verdict.outcome) =
  match (a.verdict, b.verdict) with
  | Measured { reasons = []; values; _ }, Measured { reasons = []; values = others; _ } ->
    tally.numbers <- tally.numbers + 1;
    if not (List.for_all2 meet values others) then QCheck2.Test.fail_reportf "other numbers\n%s" text
  | _ -> ()

let run reductions (e : Scc_elaborate.Elaborate.t) initial =
  let bounds = { Bounds.default with states = Default 600; time = Given (Rat.of_int 6) } in
  Check.run { Setup.default with bounds; reductions } (standard e.model) ~initial e.checks

let compare_numbers text e initial kinds =
  let others = List.filter (fun k -> not (Reduction.equal k Isometry)) kinds in
  let with_it = run kinds e initial and without = run others e initial in
  if Check.faults with_it <> [] then QCheck2.Test.fail_reportf "a run is lost\n%s" text;
  if with_it.stats.complete && without.stats.complete then begin
    if with_it.stats.states < without.stats.states then tally.fewer <- tally.fewer + 1;
    if with_it.stats.states > without.stats.states then QCheck2.Test.fail_reportf "more states\n%s" text
  end;
  List.iter2 (compare_verdicts text) with_it.outcomes without.outcomes;
  let replays (o : Verdict.outcome) =
    if Option.is_some (Compared.witness o.verdict) then begin
      tally.runs <- tally.runs + 1;
      if not (Compared.replays e initial o) then QCheck2.Test.fail_reportf "a run does not replay\n%s" text
    end
  in
  List.iter replays with_it.outcomes

let agrees text =
  match load text with
  | _, Error _ -> true
  | e, Ok initial ->
    tally.scenes <- tally.scenes + 1;
    let isometries = found e initial in
    if isometries <> [] then begin
      tally.symmetric <- tally.symmetric + 1;
      compare_states text e initial isometries;
      compare_numbers text e initial Reduction.all;
      compare_numbers text e initial [ Jump; Draws; Isometry ]
    end;
    true

let scale = match Sys.getenv_opt "ISOMETRIES" with Some n -> int_of_string n | None -> 1
let random = QCheck2.Test.make ~name:"Isometry: scenes" ~count:(200 * scale) ~print:Fun.id scene agrees

let counts () =
  Printf.printf "%d scenes, %d with isometries; %d states and images, %d explored in part, %d numbers, %d runs\n"
    tally.scenes tally.symmetric tally.states tally.fewer tally.numbers tally.runs;
  let some what expected n = if n < expected then Alcotest.failf "only %d %s" n what in
  some "scenes with isometries" 15 tally.symmetric;
  some "scenes explored in part" 5 tally.fewer;
  some "numbers" 20 tally.numbers;
  some "runs" 3 tally.runs

(* {1 By hand: what each condition is for} *)

let plane = "(1,0,0), (-1,0,0), (0,1,0), (0,-1,0)"
let middle = "P = ? [ eventually[<= 2] 2*x(p) = 3 and 2*y(p) = 3 ]"

let room ?(how = "wait") ?(body = "Cube mass 1") ?behaviour ?(law = plane) ?(inside = "") check =
  let behaviour, more =
    match behaviour with None -> ("nil", "") | Some term -> ("A", "behaviour A on Cube = " ^ term ^ "\n")
  in
  Printf.sprintf "import <solids>\nsplit_step 1\ntimestep 1 steady\nblocked %s\n" how
  ^ "shape Cube = box(1, 1, 1)\nshape Plank = box(1, 1/2, 1/2)\n" ^ more
  ^ "compound Off { part a : Cube mass 1 at translate (0, 1, 0) }\n"
  ^ "fixed wall = solids.Room(3, 3, 1, 1) at translate (3/2, 3/2, 0)\n" ^ inside
  ^ Printf.sprintf "process p = %s at translate (1/2, %s, 0) [%s]\nmotion p = choose { %s }\n" body
    (if String.equal body "Off" then "-1/2" else "1/2") behaviour law
  ^ "process q = Cube mass 1 at translate (5/2, 3/2, 0) [nil]\nmotion q = choose { " ^ law ^ " }\n"
  ^ "check c : " ^ check

let has expected text () =
  match load text with
  | _, Error _ -> Alcotest.fail "refused"
  | e, Ok initial ->
    Alcotest.(check int) "isometries" expected (List.length (found e initial))

(* A number counts by itself, whatever else a check reads. *)
let of_numbers () =
  match load (room "E = ? [ 2*x(p) - 3 at 2 ]") with
  | _, Error _ -> Alcotest.fail "refused"
  | e, Ok initial ->
    let found = Isometry.find e.model ~initial ~predicates:[] ~numbers:(numbers e.checks) in
    Alcotest.(check int) "isometries" 1 (List.length found)

(* Walkers between walls, which bounce for ever within an instant. Two of their bounces are images of each other,
   so that a round of states does not lead back to where it began. *)
let rounds () =
  let text =
    "import <solids>\ntimestep 1 local\nblocked bounce\nshape Cube = box(1, 1, 1)\n\
     fixed west = box(1, 4, 1) at translate (-1/2, 1, 0)\nfixed east = box(1, 4, 1) at translate (5/2, 1, 0)\n\
     process w[0] = Cube mass 1 at translate (1/2, 1, 0) [nil]\n\
     process w[1] = Cube mass 1 at translate (3/2, 1, 0) [nil]\nmotion w = choose { (1,0,0), (-1,0,0) }\n\
     check c : P = ? [ eventually[<= 1] distance2(w[0], w[1]) <= 1/2 ]"
  in
  match load text with
  | _, Error _ -> Alcotest.fail "refused"
  | e, Ok initial ->
    let report = run Reduction.all e initial in
    Alcotest.(check (list string)) "faults" [] (Check.faults report);
    Alcotest.(check bool) "a run that goes on for ever within an instant" true (Option.is_some report.zeno)

let by_hand =
  [
    ("rounds that do not lead back", rounds);
    ("numbers alone", of_numbers);
    ("a square room", has 7 (room middle));
    ("a goal at one side", has 1 (room "P = ? [ eventually[<= 2] x(p) < 1 ]"));
    ("a goal in a corner", has 1 (room "P = ? [ eventually[<= 2] x(p) < 1 and y(p) < 1 ]"));
    ("a goal off the diagonals", has 0 (room "P = ? [ eventually[<= 2] 4*x(p) < 1 + y(p) ]"));
    ("a place written otherwise",
     has 1 (room "P = ? [ eventually[<= 2] (x(p) < 1 or not (2*x(p) <= 4)) and y(p) < 1 ]"));
    ("a mean that is not symmetric", has 1 (room "E = ? [ x(p) at 2 ]"));
    ("a mean of which the opposite is", has 1 (room "E = ? [ 2*x(p) - 3 at 2 ]"));
    ("a mean that is", has 7 (room "E = ? [ (2*x(p) - 3)*(2*x(p) - 3) + (2*y(p) - 3)*(3 - 2*y(p))*(-1) at 2 ]"));
    ("a velocity", has 1 (room "P = ? [ eventually[<= 2] vx(p) > 0 ]"));
    ("chances that differ", has 1 (room ~law:"(1,0,0) weight 2, (-1,0,0), (0,1,0), (0,-1,0)" middle));
    ("a law that reads places", has 0 (room ~law:"(if x > 1 then 1 else 1, 0, 0), (-1,0,0)" middle));
    ("a body that is longer", has 3 (room ~body:"Plank mass 1" middle));
    ("a body off its reference point", has 7 (room ~body:"Off" middle));
    ("a goal that is symmetric about reference points alone",
     has 1 (room ~body:"Off" "P = ? [ eventually[<= 2] 2*x(p) = 3 and 2*y(p) = 1 ]"));
    ("an obstacle in a corner", has 1 (room ~inside:"fixed b = Cube at translate (1/2, 5/2, 0)\n" middle));
    ("an obstacle beside the middle", has 1 (room ~inside:"fixed b = Cube at translate (3/2, 1/2, 0)\n" middle));
    ("a channel on one side", has 0 (room ~behaviour:"<a, {right}> . nil" ~how:"bounce" middle));
    ("a channel above, whose edges change places",
     has 0 (room ~behaviour:"<a, {top}> . nil" ~how:"bounce" middle));
    ("a channel on a face alone", has 3 (room ~behaviour:"<a, {only top}> . nil" ~how:"bounce" middle));
    ("walls that meet otherwise in a mirror, where bodies bounce", has 3 (room ~how:"bounce" middle));
    ("a wall that is named, and one set",
     has 0 (room "P = ? [ eventually[<= 2] touching(p, wall) and x(p) < y(p) ]"));
  ]

let () =
  Alcotest.run "isometries"
    [
      ("random", Scc_test_support.Property.cases [ random ] @ [ Alcotest.test_case "counts" `Quick counts ]);
      ("by hand", List.map (fun (name, test) -> Alcotest.test_case name `Quick test) by_hand);
    ]

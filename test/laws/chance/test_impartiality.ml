(* Law Impartiality: nothing that is asked depends on where bodies stand, how all is turned, in which order they
   are declared, or what they are called, though lots and velocities are drawn in an order of places. Models are
   told in other ways as texts, so that nothing of the program takes part in it. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_verify
open Scc_test_models
module Gen = QCheck2.Gen

(* {1 What is answered} *)

let exact : Scc_chance.Answer.t -> bool = function Exact _ | Infinite -> true | Within _ | At_least _ -> false

let told : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Violated _ -> "violated"
  | Measured { values; reasons = []; _ }
    when List.for_all (fun (_, (v : Scc_ctl.Eval.measured)) -> exact v.least && exact v.most) values ->
    let value (_, ({ least; _ } : Scc_ctl.Eval.measured)) = Scc_chance.Answer.to_string least in
    String.concat " " (List.map value values)
  | Holds _ | Measured _ | Depends _ | Undecided _ -> "undecided"

let answers_of (e : Scc_elaborate.Elaborate.t) =
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> []
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 1500 } in
    let outcomes = (Check.run { Setup.default with bounds } semantics ~initial e.checks).outcomes in
    List.map (fun (o : Verdict.outcome) -> told o.verdict) outcomes

let answers text = answers_of (Load.exactly (Load.text text))

(* {1 The law} *)

(* How many questions were asked and decided, and of how many the least number is not the greatest. *)
type count = { mutable asked : int; mutable undecided : int; mutable free : int }

let count = { asked = 0; undecided = 0; free = 0 }

let note a =
  count.asked <- count.asked + 1;
  if String.equal a "undecided" then count.undecided <- count.undecided + 1;
  match String.split_on_char ' ' a with
  | [ least; most ] when not (String.equal least most) -> count.free <- count.free + 1
  | _ -> ()

let print (m, ways) =
  String.concat "\n\n" (List.map (fun way -> Told_otherwise.to_text way m) (Told_otherwise.as_it_is :: ways))

(* What ends at a bound may do so elsewhere when it is told otherwise. *)
let agree a b =
  let decided a = not (String.equal a "undecided") in
  List.equal (fun a b -> String.equal a b || not (decided a && decided b)) a b

let same (m, ways) =
  let asked way = answers (Told_otherwise.to_text way m) in
  let first = asked Told_otherwise.as_it_is in
  List.iter note first;
  List.for_all (fun way -> agree first (asked way)) ways

let generate ~laws = Gen.pair (Told_otherwise.model ~laws) (Gen.list_repeat 3 Told_otherwise.way)

let lots = QCheck2.Test.make ~name:"Impartiality: lots" ~count:30 ~print (generate ~laws:false) same
let velocities = QCheck2.Test.make ~name:"Impartiality: velocities" ~count:20 ~print (generate ~laws:true) same

(* {1 Labels} *)

let face = Str.regexp "\\.\\([a-z]+\\)"
let vector = Str.regexp "(\\([-0-9/]+\\), \\([-0-9/]+\\), \\([-0-9/]+\\))"

(* The label of what is turned: with the names of its faces, and the directions of what is drawn. *)
let turned (way : Told_otherwise.way) label =
  let turned_face s =
    let name = Str.matched_group 1 s in
    let d = List.find (fun d -> String.equal (Told_otherwise.face d) name) Told_otherwise.directions in
    "." ^ Told_otherwise.face (way.turn d)
  in
  let turned_vector s =
    let group k = Str.matched_group k s in
    let components = List.map (fun k -> Result.get_ok (Rat.of_literal (group k))) [ 1; 2; 3 ] in
    let image k =
      let x = List.nth components (abs k - 1) in
      Rat.to_string (if k < 0 then Rat.neg x else x)
    in
    let x, y, z = way.turn (1, 2, 3) in
    Printf.sprintf "(%s, %s, %s)" (image x) (image y) (image z)
  in
  let label = Str.global_substitute face turned_face label in
  Scc_equivalence.Label.canonical (Str.global_substitute vector turned_vector label)

let space text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> None
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 3000; time = Default (Rat.of_int 2) } in
    let space = Explored.explore { Setup.default with bounds } semantics ~initial in
    let too_many (t : Verdict.truncation) = match t.limit with States _ -> true | _ -> false in
    if List.exists too_many space.stopped_by then None else Some space

(* A process is told by the least name in it. *)
let label_of (space : Explored.t) s (label : Transition.label) =
  let model = Explored.model space in
  let name l = model.leaves.(l).name in
  let told first =
    let leaves = (Option.get (State.home (space.state s) first)).leaves in
    let least best (l : State.leaf) = if String.compare (name l.leaf) (name best) < 0 then l.leaf else best in
    Array.fold_left least first leaves
  in
  let label : Transition.label =
    match label with
    | Draw d -> Draw { d with first = told d.first }
    | Bounce { firsts; _ } -> Bounce { firsts = List.map told firsts; hits = [] }
    | Absorb a -> Absorb { a with first = told a.first }
    | label -> label
  in
  Transition.label_to_string model label

(* What is later than the bound of time is so in every way of telling it. *)
let graph_of (space : Explored.t) =
  let open Scc_equivalence in
  let b = Graph.builder () in
  let add source label target = Graph.add b ~source ~label:(Graph.intern b label) ~target in
  for s = 0 to space.size - 1 do
    Array.iter (fun (e : Explored.edge) -> add s (label_of space s e.label) e.target) (space.edges s);
    if space.rests s then add s (Label.of_passing Forever) s;
    if not (space.expanded s) then add s "later" s
  done;
  Graph.finish b ~size:space.size ~initial:0 ~unknown:(fun _ -> false)

let compared = ref 0
let too_large = ref 0

(* What moves may meet what else there is: then all is turned as a whole. *)
let moves (m : Told_otherwise.model) =
  let pushed (s : Told_otherwise.summand) =
    String.length s.how > 4 && String.equal (String.sub s.how 0 4) "push"
  in
  let leaf (l : Told_otherwise.leaf) = l.law <> [] || List.exists pushed l.first in
  List.exists (fun (c : Told_otherwise.cluster) -> List.exists leaf c.leaves) m.clusters

let as_a_whole (way : Told_otherwise.way) =
  { way with place = (fun c -> way.turn (Told_otherwise.as_it_is.place c)) }

(* Who looks at transitions alone cannot tell which way it is told. *)
let labels_same (m, ways) =
  let m = { m with Told_otherwise.questions = [] } in
  let ways = if moves m then List.map as_a_whole ways else ways in
  let prepared ~told =
    Option.map (fun space -> Scc_equivalence.(Compare.prepare Timed (Draws.joined ~told (graph_of space))))
  in
  let graph way ~told =
    prepared ~told (space (Told_otherwise.to_text { way with name = Told_otherwise.as_it_is.name } m))
  in
  let as_it_is = lazy (space (Told_otherwise.to_text Told_otherwise.as_it_is m)) in
  let effort = Scc_equivalence.Effort.make ~stop:(fun () -> false) in
  let same (way : Told_otherwise.way) =
    match (prepared ~told:(turned way) (Lazy.force as_it_is), graph way ~told:Scc_equivalence.Label.canonical) with
    | Some one, Some two -> (
        incr compared;
        match (Scc_equivalence.Compare.run effort Timed one two).verdict with
        | Equivalent -> true
        | Different _ | Undecided _ -> false)
    | None, _ | _, None ->
      incr too_large;
      true
  in
  List.for_all same ways

let labels =
  let case laws = Gen.pair (Told_otherwise.model ~laws) (Gen.list_repeat 2 Told_otherwise.way) in
  let generate = Gen.bind Gen.bool case in
  QCheck2.Test.make ~name:"Impartiality: what labels tell" ~count:20 ~print generate labels_same

(* So that it is about something. *)
let scope () =
  Printf.printf "%d questions, %d undecided, %d of free choices\n" count.asked count.undecided count.free;
  Printf.printf "%d pairs compared, %d too large\n" !compared !too_large;
  Alcotest.(check bool) "most are compared" true (!compared > !too_large);
  Alcotest.(check bool) "most are decided" true (10 * count.undecided < 3 * count.asked);
  Alcotest.(check bool) "some depend on choices" true (20 * count.free > count.asked)

(* Where the law says that it fails. *)
let within_others () =
  let file = "../../../specs/models/laws/lots.sc" in
  let answers far = answers_of (Load.exactly (Load.file ~overrides:[ ("far", Rat.of_int far) ] file)) in
  let check = Alcotest.(check (list string)) in
  check "on the right" [ "1"; "1/4"; "holds" ] (answers 10);
  check "on the left" [ "1"; "1/4"; "violated" ] (answers (-10))

let () =
  Alcotest.run "impartiality"
    [
      ( "laws",
        Scc_test_support.Property.cases [ lots; velocities; labels ]
        @ [ Alcotest.test_case "Impartiality: fails for operators within others" `Quick within_others ] );
      ("scope", [ Alcotest.test_case "scope" `Quick scope ]);
    ]

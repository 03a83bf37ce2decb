(* Law Impartiality: nothing that is asked depends on where bodies stand, how all is turned, in which order they
   are declared, or what they are called, though lots and velocities are drawn in an order of places. Models are
   told in other ways as texts, so that nothing of the program takes part in it. *)

open Scc_exact
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
  | Holds _ | Measured _ | Undecided _ -> "undecided"

let answers_of (e : Scc_elaborate.Elaborate.t) =
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> []
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 1500 } in
    let outcomes = (Check.run { Check.default with bounds } semantics ~initial e.checks).outcomes in
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

let lots = QCheck2.Test.make ~name:"Impartiality: lots" ~count:60 ~print (generate ~laws:false) same
let velocities = QCheck2.Test.make ~name:"Impartiality: velocities" ~count:40 ~print (generate ~laws:true) same

(* So that it is about something. *)
let scope () =
  Printf.printf "%d questions, %d undecided, %d of free choices\n" count.asked count.undecided count.free;
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
        Scc_test_support.Property.cases [ lots; velocities ]
        @ [ Alcotest.test_case "Impartiality: fails for operators within others" `Quick within_others ] );
      ("scope", [ Alcotest.test_case "scope" `Quick scope ]);
    ]

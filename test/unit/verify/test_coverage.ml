(* What coverage counts: by hand on small models, and against the rules that transitions name on all. *)

open Scc_calculus
open Scc_semantics
open Scc_verify
open Scc_test_models

let standard = Scc_engine.Standard.of_model

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let space ?(options = Setup.default) (e : Scc_elaborate.Elaborate.t) =
  match Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> Coverage.explore options (standard e.model) ~initial

let covered text =
  let s, c = space (Load.exactly (Load.text (cube ^ text))) in
  (Explored.model s, c)

(* Of each summand: the definition, its kind and channel, and how often it fired. *)
let summands (m : Model.t) c =
  let sign : Behaviour.polarity -> string = function Name -> "" | Co_name -> "~" in
  let show (s : Coverage.summand) =
    let owner =
      match s.definition with
      | Some k -> m.definitions.(k).name
      | None -> "at " ^ m.leaves.(s.leaf).name
    in
    let what =
      match s.term with
      | Open (p, c, _) -> sign p ^ c.name
      | Weak (c, _, _) -> "omega " ^ c.name
      | Strong (list, _, _) -> "rho " ^ String.concat " " (List.map (fun (c : Behaviour.channel) -> c.name) list)
      | Nil | Delay _ | Wait _ | Sum _ | Call _ -> "?"
    in
    Printf.sprintf "%s: %s %d" owner what s.fired
  in
  List.map show (Coverage.summands c)

let reached (m : Model.t) c =
  List.map
    (fun (b : Coverage.behaviour) ->
       Printf.sprintf "%s by %s %b" m.definitions.(b.definition).name b.species b.reached)
    (Coverage.behaviours c)

let channels c =
  List.map
    (fun (x : Coverage.channel) -> Printf.sprintf "%s %d %d %d" x.name x.made x.weak x.strong)
    (Coverage.channels c)

let expect what expected got = Alcotest.(check (list string)) what expected got

(* p and q run into each other, bind by dock, come to rest, and part again or not; r is far away. *)
let equal_summands () =
  let m, c =
    covered
      {|
behaviour K = <dock, {right}>. Held + <clip, {right}>. Held
behaviour L = <dock, {right}>. Held
behaviour Held = omega(dock, {right}). nil
process p = Cube mass 1 velocity (1,0,0) [K]
behaviour Q = <~dock, {left}>. (omega(dock, {left}). nil + rho({<dock, {left}>}). nil)
process q = Cube mass 1 velocity (-1,0,0) at translate (6,0,0) [Q + nil]
process r = Cube mass 1 at translate (0,9,0) [L]
|}
  in
  expect "of two definitions that are alike, the one that was used"
    [
      "K: dock 1"; "K: clip 0"; "Q: ~dock 1"; "Q: omega dock 1"; "Q: rho dock 0"; "L: dock 0";
      "Held: omega dock 1";
    ]
    (summands m c);
  expect "channels" [ "clip 0 0 0"; "dock 1 1 0" ] (channels c);
  expect "behaviours" [ "K by Cube true"; "Q by Cube true"; "L by Cube true"; "Held by Cube true" ] (reached m c)

(* Alike within one definition after different prefixes: one summand. Which of two definitions something anonymous
   stands in cannot be told: both count. *)
let alike () =
  let m, c =
    covered
      {|
behaviour K = <dock, {right}>. omega(dock, {right}). nil + <clip, {right}>. omega(dock, {right}). nil
behaviour L = <clip, {right}>. omega(dock, {right}). nil
process p = Cube mass 1 velocity (1,0,0) [K]
process q = Cube mass 1 velocity (-1,0,0) at translate (6,0,0) [<~dock, {left}>. omega(dock, {left}). nil]
process r = Cube mass 1 at translate (0,9,0) [L]
|}
  in
  expect "summands"
    [
      "K: dock 1"; "K: omega dock 1"; "K: clip 0"; "L: clip 0"; "L: omega dock 1"; "at q: ~dock 1";
      "at q: omega dock 1";
    ]
    (summands m c)

(* The name and the co-name lead to the same: the collision tells which was used only if the other could not be. *)
let polarities () =
  let m, c =
    covered
      {|
behaviour K = <dock, {right}>. nil + <~dock, {right}>. nil
process p = Cube mass 1 velocity (1,0,0) [K]
process q = Cube mass 1 at translate (4,0,0) [<~dock, {left}>. nil]
|}
  in
  expect "only the partner of what is open" [ "K: dock 1"; "K: ~dock 0"; "at q: ~dock 1" ] (summands m c)

let species () =
  let m, c =
    covered
      {|
shape Rod = Cube scaled (2, 1, 1)
behaviour Hand = <dock, {right}>. Shaken
behaviour Arm  = <~dock, {left}>. Shaken
behaviour Shaken = nil
behaviour Slow = eps(2). Late
behaviour Late = <dock, {top}>. Shaken
process p = Cube mass 1 velocity (1,0,0) [Hand]
process q = Cube mass 1 at translate (4,0,0) [Arm]
process r = Rod mass 1 at translate (0,9,0) [Slow]
process s = Cube mass 1 at translate (-9,9,0) [Late + Hand]
|}
  in
  expect "by time, under a sum, and not at all"
    [
      "Hand by Cube true"; "Arm by Cube true"; "Slow by Rod true"; "Late by Cube true"; "Late by Rod true";
      "Shaken by Cube true"; "Shaken by Rod false";
    ]
    (reached m c)

(* {1 Every model} *)

let folder = "../../../specs/models"

let models () =
  let names = Sys.readdir folder in
  Array.sort String.compare names;
  List.filter (fun name -> Filename.check_suffix name ".sc") (Array.to_list names)

(* How many transitions name each rule. *)
let named (s : Explored.t) =
  let counts = Hashtbl.create 16 in
  let add r =
    let id = Rule.id r in
    Hashtbl.replace counts id (1 + Option.value ~default:0 (Hashtbl.find_opt counts id))
  in
  for i = 0 to s.size - 1 do
    if s.expanded i then
      match Network.successors s.semantics (s.state i) with
      | Ok list -> List.iter (fun (t : Transition.t) -> List.iter add t.rules) list
      | Error (Persistent_contact _) -> ()
      | Error (Bad_law _ | Bad_chance _) -> Alcotest.fail "an expanded state has transitions, or is a dead end"
  done;
  counts

let rules_agree name () =
  let options = { Setup.default with bounds = { Bounds.default with states = Given 400 } } in
  let s, c = space ~options (Load.exactly (Load.file (Filename.concat folder name))) in
  let counts = named s in
  let show (r, n) = Printf.sprintf "%s %d" (Rule.id r) n in
  let expected (r, _) = (r, Option.value ~default:0 (Hashtbl.find_opt counts (Rule.id r))) in
  let got = Coverage.rules c in
  expect name (List.map (fun r -> show (expected r)) got) (List.map show got)

(* Each bond that is made has two summands behind it, and each that is released as well. *)
let nothing_unattributed name () =
  let options = { Setup.default with bounds = { Bounds.default with states = Given 400 } } in
  let _, c = space ~options (Load.exactly (Load.file (Filename.concat folder name))) in
  let fired kind =
    List.fold_left (fun n (x : Coverage.summand) -> if kind x.term then n + x.fired else n) 0 (Coverage.summands c)
  in
  let total f = List.fold_left (fun n (x : Coverage.channel) -> n + f x) 0 (Coverage.channels c) in
  let at_least what kind n = Alcotest.(check bool) (name ^ ": " ^ what) true (fired kind >= 2 * n) in
  at_least "made" (function Behaviour.Open _ -> true | _ -> false) (total (fun x -> x.made));
  at_least "weakly" (function Behaviour.Weak _ -> true | _ -> false) (total (fun x -> x.weak));
  let strong = fired (function Behaviour.Strong _ -> true | _ -> false) in
  Alcotest.(check bool) (name ^ ": strongly") true (strong > 0 = (total (fun x -> x.strong) > 0))

let suite =
  let case = Alcotest.test_case in
  let for_models f = List.map (fun name -> case name `Quick (f name)) (models ()) in
  ("coverage",
   [
     ( "by hand",
       [
         case "summands that are alike in two definitions" `Quick equal_summands;
         case "summands that cannot be told apart" `Quick alike;
         case "name and co-name" `Quick polarities;
         case "behaviours by species" `Quick species;
       ] );
     ("the rules that transitions name", for_models rules_agree);
     ("nothing goes without a summand", for_models nothing_unattributed);
   ])

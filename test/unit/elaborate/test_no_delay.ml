(* Delays of 0 before names (rule Eps0, reading I-14). *)

open Scc_calculus
open Scc_semantics
open Models

let behaviour_of (t : Scc_elaborate.Elaborate.t) name =
  let leaves (p : State.process) = Array.to_list p.leaves in
  let leaves = List.concat_map leaves (Array.to_list t.declared.processes) in
  let is_it (l : State.leaf) = String.equal t.model.leaves.(l.leaf).name name in
  (List.find is_it leaves).behaviour

(* The origins of bodies whose behaviours unfold to names, with a delay of 0 on the way and without. *)
let no_delay () =
  let t =
    accept
      (cube
       ^ "param none = 0\n\
          behaviour Z on Cube = <a, {top}>. nil  behaviour Other on Cube = Z\n\
          behaviour K on Cube = eps(none). Z  behaviour Twice on Cube = eps(0). eps(0). Other\n\
          behaviour Far on Cube = Near  behaviour Near on Cube = eps(0). K\n\
          behaviour In_sum on Cube = eps(0). (Z + nil)  behaviour Summand on Cube = eps(0). Z + nil\n\
          behaviour After on Cube = <a, {top}>. K\n\
          process k = Cube mass 1 [K]  process other = Cube mass 1 at translate (9,0,0) [Other]\n\
          process twice = Cube mass 1 at translate (18,0,0) [Twice]\n\
          process far = Cube mass 1 at translate (27,0,0) [Far]\n\
          process in_sum = Cube mass 1 at translate (36,0,0) [In_sum]\n\
          process summand = Cube mass 1 at translate (45,0,0) [Summand]\n\
          process term = Cube mass 1 at translate (54,0,0) [eps(0). Z]\n\
          process after = Cube mass 1 at translate (63,0,0) [After]")
  in
  let name k = t.model.definitions.(k).name in
  let origin name' = (name', Option.map name (behaviour_of t name').origin) in
  Alcotest.(check (list (pair string (option string)))) "origins"
    [ ("k", Some "Z"); ("other", Some "Other"); ("twice", Some "Other"); ("far", Some "Z");
      ("in_sum", Some "In_sum");
      ("summand", Some "Summand"); ("term", Some "Z"); ("after", Some "After") ]
    (List.map origin [ "k"; "other"; "twice"; "far"; "in_sum"; "summand"; "term"; "after" ]);
  let continues =
    match Behaviours.offers t.model.definitions (behaviour_of t "after") with
    | [ Offer_open (_, _, next) ] -> (Behaviour.fresh next).origin
    | _ -> None
  in
  Alcotest.(check (option string)) "what follows a prefix" (Some "Z") (Option.map name continues)

let suite =
  ("no delay", [ ("behaviours", [ Alcotest.test_case "I-14: an eps(0) before a name" `Quick no_delay ]) ])

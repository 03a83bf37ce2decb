open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

let turn_left (s : State.t) =
  Array.fold_left (fun d p -> Option.merge Rat.min d (Turn.left p)) None s.processes

let rec follow semantics ~start ~lasts s piece =
  if Rat.sign lasts > 0 then
    match turn_left s with
    | Some left when Rat.sign left = 0 -> (
        match Steer.settle semantics s with
        | Ok settled -> follow semantics ~start ~lasts settled.state piece
        | Error _ -> Bug.fail __POS__ "a run goes on where it cannot")
    | left ->
      let d = Option.fold ~none:lasts ~some:(Rat.min lasts) left in
      piece ~start ~lasts:d s;
      if Rat.compare d lasts < 0 then
        follow semantics ~start:(Rat.add start d) ~lasts:(Rat.sub lasts d) (Time.pass semantics d s) piece

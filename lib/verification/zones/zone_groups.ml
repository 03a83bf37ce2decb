open Scc_calculus
open Scc_property
open Scc_symbolic

type t = {
  keeps_time : bool;
  part : State.t option;
  members : (int * Property.check) list;
  premises : (int * Property.check) list;
}

(* Those that ask about time are explored apart: with time a coordinate, little ever recurs, but there is an end
   where all of them have a bound. A bound of time for all makes it a coordinate for all. *)
let by_time ~bounded part numbered =
  let of_check is (_, (c : Property.check)) = is c.formula in
  let timed, others = List.partition (of_check Answers.needs_time) numbered in
  let ends, endless = List.partition (of_check (fun f -> Option.is_some (Plan.horizon f))) timed in
  let some keeps_time = function [] -> [] | members -> [ { keeps_time; part; members; premises = [] } ] in
  some bounded others @ some true ends @ some true endless

(* Each premise with the first group that has a check of its name. *)
let with_premises premises groups =
  let put (left, groups) g =
    let names (_, (p : Property.check)) =
      List.exists (fun (_, (c : Property.check)) -> String.equal c.name p.name) g.members
    in
    let premises, left = List.partition names left in
    (left, { g with premises } :: groups)
  in
  List.rev (snd (List.fold_left put (List.mapi (fun i p -> (i, p)) premises, []) groups))

(* Each slice is explored apart. *)
let make ~bounded ~part ~premises checks =
  let put part member =
    let joined (same, members) =
      if Option.equal State.equal same part then Some (same, member :: members) else None
    in
    Scc_data.Lists.put joined (part, [ member ])
  in
  let add (i, groups) c = (i + 1, put (part c) (i, c) groups) in
  match checks with
  | [] -> [ { keeps_time = bounded; part = None; members = []; premises = [] } ]
  | _ :: _ ->
    List.fold_left add (0, []) checks
    |> snd
    |> List.concat_map (fun (part, members) -> by_time ~bounded part (List.rev members))
    |> with_premises premises

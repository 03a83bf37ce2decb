open Scc_calculus
open Scc_property
open Scc_symbolic

type t = {
  keeps_time : bool;
  part : State.t option;
  members : (int * Property.check) list;
  premises : (int * Property.check) list;
}

(* With time a coordinate, little ever recurs, but there is an end where all that checks look at has a bound. So
   checks with such a bound are explored apart, and of the others those that ask about time. A bound of time for
   all makes it a coordinate for all. *)
let by_time ~bounded part numbered =
  let partition is = List.partition (fun (_, (c : Property.check)) -> is c.formula) in
  let ends, endless = partition (fun f -> Option.is_some (Plan.reach f)) numbered in
  let timed, others = partition Answers.needs_time endless in
  let some keeps_time = function [] -> [] | members -> [ { keeps_time; part; members; premises = [] } ] in
  some bounded others @ some true ends @ some true timed

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

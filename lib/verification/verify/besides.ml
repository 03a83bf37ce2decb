open Scc_state_space
module Graph = State_graph

type t = {
  slow : Verdict.convergence option;
  likely : Growth.cause list;
  long : Scc_base.Diag.t option;
  ended : Verdict.truncation option;
}

(* The first state with a number that is too long. *)
let growth (r : Unsettled.t) =
  let told i =
    let state = Catalogue.decode (Network_lts.catalogue r.context) (Graph.tuple r.graph i) in
    Bounds.long_number r.model state ~depth:(Graph.depth r.graph i)
  in
  Option.map told (Unsettled.first r Bits)

let convergence (r : Unsettled.t) =
  match Quickening.find r.context r.graph with
  | Some q -> Some (Verdict.Proved q)
  | None -> Option.map (fun s -> Verdict.Named s) (Slowing.find r.graph)

let none = { slow = None; likely = []; long = None; ended = None }

(* It looks for the deepest of what may be millions of states, and at some hundreds, which may be large. It takes
   less than runs that are shown, and comes before them. *)
let find (r : Unsettled.t) met =
  let lost = Lost.make r.bounds r.surroundings.attempt in
  let causes look = Option.value ~default:[] (Lost.attempt lost (fun () -> look r.context r.graph)) in
  match Unsettled.stopped_by met with
  | [] -> none
  | _ :: _ ->
    let likely = List.concat_map causes Growth.looks in
    let slow = Option.join (Lost.attempt lost (fun () -> convergence r)) in
    { slow; likely; long = growth r; ended = (Lost.taken lost).left_out }

open Scc_data
open Scc_geometry
open Scc_calculus
open Scc_semantics

(* For each leaf its group, which bears the number of one of its processes. *)
type t = { groups : (int, int) Hashtbl.t; members : (int, int list) Hashtbl.t }

let of_processes model processes =
  let state = State.make ~processes:(Array.to_list processes) ~step:None ~time:None in
  let parts = Parts.of_state model state in
  let joined = Union_find.create (Array.length state.processes) in
  let join (i, j) = ignore (Union_find.union joined parts.(i).process parts.(j).process) in
  List.iter join (Boxes.pairs (Array.map Parts.box parts));
  let groups = Hashtbl.create 16 and members = Hashtbl.create 16 in
  Array.iteri
    (fun i (p : State.process) ->
       let g = Union_find.find joined i in
       Array.iter
         (fun (l : State.leaf) ->
            Hashtbl.replace groups l.leaf g;
            let known = Option.value (Hashtbl.find_opt members g) ~default:[] in
            Hashtbl.replace members g (l.leaf :: known))
         p.leaves)
    state.processes;
  { groups; members }

let of_leaf t leaf =
  match Hashtbl.find_opt t.groups leaf with
  | Some g -> g
  | None -> Scc_base.Bug.fail __POS__ "a leaf that no process has"

let leaves t g = Option.value (Hashtbl.find_opt t.members g) ~default:[]

open Scc_data
open Scc_calculus
open Scc_broad_phase
open Scc_semantics
open Scc_engine

(* For each leaf its group, which bears the number of one of its processes. *)
type t = { groups : (int, int) Hashtbl.t; members : (int, int list) Hashtbl.t }

let of_processes semantics processes =
  let parts = Collisions.parts semantics processes in
  let joined = Union_find.create (Array.length processes) in
  let join (i, j) = ignore (Union_find.union joined parts.(i).Part.process parts.(j).process) in
  List.iter join (Boxes.pairs (Array.map (Neighbours.box ~margin:Scc_exact.Rat.zero) parts));
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
    processes;
  { groups; members }

let of_leaf t leaf =
  match Hashtbl.find_opt t.groups leaf with
  | Some g -> g
  | None -> Scc_base.Bug.fail __POS__ "a leaf that no process has"

let leaves t g = Option.value (Hashtbl.find_opt t.members g) ~default:[]

open Scc_exact
open Scc_calculus
open Scc_semantics

let standard = Scc_engine.Standard.of_model

let bits (s : State.t) =
  let of_rat q = max (Z.numbits (Q.num q)) (Z.numbits (Q.den q)) in
  let of_vec (v : Vec.t) = max (of_rat v.x) (max (of_rat v.y) (of_rat v.z)) in
  let of_leaf most (l : State.leaf) = max most (max (of_vec l.position) (Quaternion.bits l.turned)) in
  let of_process most (p : State.process) =
    Array.fold_left of_leaf (max most (max (of_vec p.velocity) (of_vec p.spin))) p.leaves
  in
  Array.fold_left of_process 0 s.processes

let longest = 800

let successors m s =
  match Network.successors (standard m) s with
  | Ok ts -> ts
  | Error (Persistent_contact _) -> []
  | Error (Bad_law _ | Bad_chance _) -> failwith "a law of motion could not be evaluated"

(* The first states breadth first, each with its transitions. *)
let explored m start ~limit =
  let rec go seen found = function
    | [] -> List.rev found
    | s :: rest ->
      let ts = if bits s > longest then [] else successors m s in
      let fresh =
        List.filter_map
          (fun (t : Transition.t) ->
             if List.exists (State.equal t.target) seen then None else Some t.target)
          ts
      in
      let seen = fresh @ seen in
      if List.length found >= limit then List.rev found else go seen ((s, ts) :: found) (rest @ fresh)
  in
  go [ start ] [] [ start ]

(* A run that chooses now this, now that. *)
let run m start ~steps =
  let rec go s n found =
    if n >= steps || bits s > longest then List.rev found
    else
      match successors m s with
      | [] -> List.rev ((s, []) :: found)
      | ts -> go (List.nth ts (n * 7 mod List.length ts)).target (n + 1) ((s, ts) :: found)
  in
  go start 0 []

let states ?(limit = 8) ?(steps = 16) m start = explored m start ~limit @ run m start ~steps

let reached network =
  let m, start = Random_rigid.start network in
  (m, states m start)

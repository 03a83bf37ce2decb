open Scc_calculus
open Scc_verify
open Scc_runs

module Behaviours = Scc_data.Numbering.Make (struct
    type t = Behaviour.aged

    let equal = Behaviour.equal_aged
    let hash = Behaviour.hash_aged
  end)

type variable =
  | Number
  | Process of int
  | Behaviour of int
  | Bonds of string

type t = {
  space : Explored.t;
  behaviours : Behaviours.t array;  (** by leaf: numbers in order of appearance *)
  variables : (string * variable) list;
}

let iter_leaves f (s : State.t) =
  Array.iter
    (fun (p : State.process) -> Array.iter (fun l -> f p l) p.leaves)
    s.processes

let count_bonds name (s : State.t) =
  Array.fold_left
    (fun n (p : State.process) ->
       Array.fold_left
         (fun n (b : State.bond) -> if String.equal b.name name then n + 1 else n)
         n p.bonds)
    0 s.processes

let make (space : Explored.t) =
  let leaves = (Explored.model space).leaves in
  let n = Array.length leaves in
  let behaviours = Array.init n (fun _ -> Behaviours.create ()) in
  let first = Array.make n (-1) and regrouped = Array.make n false in
  let bonds = Hashtbl.create 4 and bond_names = ref [] in
  let visit_leaf (p : State.process) (l : State.leaf) =
    ignore (Behaviours.number behaviours.(l.leaf) l.behaviour);
    let process = p.leaves.(0).leaf in
    if first.(l.leaf) < 0 then first.(l.leaf) <- process
    else if first.(l.leaf) <> process then regrouped.(l.leaf) <- true
  in
  let visit_bond (b : State.bond) =
    if not (Hashtbl.mem bonds b.name) then begin
      Hashtbl.replace bonds b.name ();
      bond_names := b.name :: !bond_names
    end
  in
  for i = 0 to space.size - 1 do
    let s = space.state i in
    iter_leaves visit_leaf s;
    Array.iter (fun (p : State.process) -> Array.iter visit_bond p.bonds) s.processes
  done;
  let names = Safe_names.make ~reserved:[ "state" ] in
  let of_leaf k (l : Model.leaf) =
    (if regrouped.(k) then [ (Safe_names.name names ("process_" ^ l.name), Process k) ] else [])
    @
    if Behaviours.size behaviours.(k) > 1 then
      [ (Safe_names.name names ("behaviour_" ^ l.name), Behaviour k) ]
    else []
  in
  let of_leaves = List.concat (List.mapi of_leaf (Array.to_list leaves)) in
  let of_bond name = (Safe_names.name names ("bonds_" ^ name), Bonds name) in
  let of_bonds = List.map of_bond (List.sort String.compare !bond_names) in
  { space; behaviours; variables = (("state", Number) :: of_leaves) @ of_bonds }

let names v = List.map fst v.variables

let values v i =
  let s = v.space.state i in
  let n = Array.length v.behaviours in
  let process = Array.make n 0 and behaviour = Array.make n 0 in
  iter_leaves
    (fun p l ->
       process.(l.leaf) <- p.leaves.(0).leaf;
       behaviour.(l.leaf) <- Behaviours.number v.behaviours.(l.leaf) l.behaviour)
    s;
  let value = function
    | Number -> i
    | Process k -> process.(k)
    | Behaviour k -> behaviour.(k)
    | Bonds name -> count_bonds name s
  in
  List.map (fun (_, variable) -> value variable) v.variables

let behaviour_texts v leaf =
  let m = Explored.model v.space in
  let text (b : Behaviour.aged) =
    let text = State_json.behaviour m ~leaf b in
    match b.origin with
    | Some k when not (String.equal m.definitions.(k).name text) ->
      Printf.sprintf "%s, from %s" text m.definitions.(k).name
    | _ -> text
  in
  List.map text (Behaviours.keys v.behaviours.(leaf))

let meanings v =
  let meaning (name, variable) =
    match variable with
    | Number | Bonds _ -> (name, [])
    | Process _ ->
      (name, Array.to_list (Array.map (fun (l : Model.leaf) -> l.name) (Explored.model v.space).leaves))
    | Behaviour k -> (name, behaviour_texts v k)
  in
  List.map meaning v.variables

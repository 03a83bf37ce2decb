open Scc_calculus
open Scc_runs

module Bonds = Set.Make (struct
    type t = State.bond

    let compare = State.compare_bond
  end)

type t = {
  model : Model.t;
  state : int -> State.t;
  positions : bool;
  common : Bonds.t;  (** in every state *)
  varies : bool array;  (** by leaf: its behaviour differs between states *)
}

let greatest = 40

(* Cuts between code points. *)
let cut s =
  let rec back i = if i > 0 && Char.code s.[i] land 0xC0 = 0x80 then back (i - 1) else i in
  if String.length s <= greatest then s else String.sub s 0 (back greatest) ^ "…"

let behaviour (m : Model.t) (l : State.leaf) =
  let text = State_json.behaviour m ~leaf:l.leaf l.behaviour in
  match l.behaviour.origin with
  | Some k ->
    let name = m.definitions.(k).name in
    if String.equal name text then name else name ^ "*"
  | None -> cut text

let bonds s = Bonds.of_list (State.bonds s)

let make ~positions model ~size state =
  let n = Array.length model.Model.leaves in
  let first = Array.make n "" and varies = Array.make n false in
  List.iter
    (fun (l : State.leaf) -> first.(l.leaf) <- behaviour model l)
    (State.leaves (state 0));
  let common = ref (bonds (state 0)) in
  let compare_leaf (l : State.leaf) =
    if not (varies.(l.leaf) || String.equal first.(l.leaf) (behaviour model l)) then
      varies.(l.leaf) <- true
  in
  for i = 1 to size - 1 do
    let s = state i in
    common := Bonds.inter !common (bonds s);
    Array.iter (fun (p : State.process) -> Array.iter compare_leaf p.leaves) s.processes
  done;
  { model; state; positions; common = !common; varies }

let place (m : Model.t) ((p : State.process), (l : State.leaf)) =
  Printf.sprintf "%s at %s, %s" m.leaves.(l.leaf).name (Short_text.position m l) (Short_text.motion m p)

let fixed (m : Model.t) ((_ : State.process), (l : State.leaf)) = m.leaves.(l.leaf).fixed

let lines d i =
  let m = d.model in
  let s = d.state i in
  let leaves = State.by_leaf s in
  let bonds = Bonds.elements (Bonds.diff (bonds s) d.common) in
  let varying (_, (l : State.leaf)) =
    if d.varies.(l.leaf) then Some (Printf.sprintf "%s: %s" m.leaves.(l.leaf).name (behaviour m l))
    else None
  in
  List.map (Short_text.bond m) bonds
  @ List.filter_map varying leaves
  @ List.map (fun leaf -> m.leaves.(leaf).name ^ ": gone") (State.gone m s)
  @ if d.positions then List.map (place m) (List.filter (fun l -> not (fixed m l)) leaves) else []

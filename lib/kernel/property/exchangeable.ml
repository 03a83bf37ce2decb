open Property
module Leaves = Set.Make (Int)

type term = Num of num | Prop of prop | Temporal of temporal

type t = { term : term; leaves : Leaves.t; parts : parts }

and parts =
  | None_
  | In_place of t list
  | In_any_order of { operands : t array; naming : (int, int list) Hashtbl.t  (** for each leaf, which of them *) }

let ordered f = function
  | Num n -> Num (Rename.ordered_num (Rename.num f n))
  | Prop p -> Prop (Rename.ordered_prop (Rename.prop f p))
  | Temporal g -> Temporal (Rename.ordered (Rename.temporal f g))

let compare a b =
  match (a, b) with
  | Num a, Num b -> Order.num a b
  | Prop p, Prop q -> Order.prop p q
  | Temporal f, Temporal g -> Order.temporal f g
  | (Num _ | Prop _ | Temporal _), _ -> Scc_base.Bug.fail __POS__ "parts of different kinds"

(* {1 Parts} *)

let atom term a = { term; leaves = Leaves.of_list (Atom.leaves a); parts = None_ }
let all_leaves parts = List.fold_left (fun found t -> Leaves.union t.leaves found) Leaves.empty parts
let in_place term parts = { term; leaves = all_leaves parts; parts = In_place parts }

let in_any_order term parts =
  let operands = Array.of_list parts in
  let naming = Hashtbl.create (Array.length operands) in
  let note k (leaf : int) =
    Hashtbl.replace naming leaf (k :: Option.value (Hashtbl.find_opt naming leaf) ~default:[])
  in
  Array.iteri (fun k t -> Leaves.iter (note k) t.leaves) operands;
  { term; leaves = all_leaves parts; parts = In_any_order { operands; naming } }

let rec num n =
  let term = Num n in
  match n with
  | Quantity q -> atom term (Atom.quantity q)
  | Count ps -> in_any_order term (List.map prop ps)
  | Add _ -> in_any_order term (List.map num (Rename.summands n))
  | Mul _ -> in_any_order term (List.map num (Rename.factors n))
  | _ -> all_in_place term (Parts.of_num n)

and prop p =
  let term = Prop p in
  match p with
  | Compare ((Eq | Ne), a, b) -> in_any_order term [ num a; num b ]
  | Fact f -> atom term (Atom.fact f)
  | And ps | Or ps -> in_any_order term (List.map prop ps)
  | _ -> all_in_place term (Parts.of_prop p)

and all_in_place term { numbers; predicates } = in_place term (List.map prop predicates @ List.map num numbers)

let rec temporal f =
  let term = Temporal f in
  match f with
  | State p -> in_place term [ prop p ]
  | Temporal_and fs | Temporal_or fs -> in_any_order term (List.map temporal fs)
  | _ -> in_place term (List.map temporal (Parts.of_temporal f))

(* In order, what is joined in one way is one list. *)
let make f = temporal (Rename.ordered f)

(* {1 Two leaves} *)

let swap i j (k : int) = if k = i then j else if k = j then i else k

let rec are t i j =
  if not (Leaves.mem i t.leaves || Leaves.mem j t.leaves) then true
  else
    match t.parts with
    | None_ -> compare (ordered Fun.id t.term) (ordered (swap i j) t.term) = 0
    | In_place parts -> List.for_all (fun t -> are t i j) parts
    | In_any_order { operands; naming } -> (
        let of_leaf leaf = Option.value (Hashtbl.find_opt naming leaf) ~default:[] in
        let concerned = List.sort_uniq Int.compare (of_leaf i @ of_leaf j) in
        (* Operands that stay as they are do so on both sides. *)
        match List.filter (fun t -> not (are t i j)) (List.map (fun k -> operands.(k)) concerned) with
        | [] -> true
        | [ _ ] -> false
        | changed ->
          let sorted f = List.sort compare (List.map (fun t -> ordered f t.term) changed) in
          List.compare compare (sorted Fun.id) (sorted (swap i j)) = 0)

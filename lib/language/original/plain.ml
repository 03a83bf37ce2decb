open Scc_exact
open Scc_syntax
module Names = Map.Make (String)

type value = Number of Rat.t | Vector of Vec.t
type t = value Names.t

let none = Names.empty

(* A number that grows beyond this is not worked out here; the language has a limit of its own. *)
let max_bits = 100_000

let rec value names (e : Ast.expr) =
  let refuse = Error e.at in
  match e.it with
  | Number q -> Ok (Number q)
  | Path { it = [ { name; indices = [] } ]; _ } -> (
      match Names.find_opt name.it names with Some v -> Ok v | None -> refuse)
  | Vector (x, y, z) ->
    let* x = number names x in
    let* y = number names y in
    let* z = number names z in
    Ok (Vector (Vec.make x y z))
  | Neg x -> (
      let* x = value names x in
      match x with Number q -> Ok (Number (Rat.neg q)) | Vector v -> Ok (Vector (Vec.neg v)))
  | Binary (o, x, y) ->
    let* x = value names x in
    let* y = value names y in
    binary refuse o x y
  | _ -> refuse

and binary refuse o x y =
  match (o, x, y) with
  | Add, Number a, Number b -> bounded refuse (Rat.add a b)
  | Sub, Number a, Number b -> bounded refuse (Rat.sub a b)
  | Mul, Number a, Number b -> bounded refuse (Rat.mul a b)
  | Div, Number a, Number b -> if Rat.sign b = 0 then refuse else bounded refuse (Rat.div a b)
  | Add, Vector v, Vector w -> Ok (Vector (Vec.add v w))
  | Sub, Vector v, Vector w -> Ok (Vector (Vec.sub v w))
  | Mul, Number a, Vector v | Mul, Vector v, Number a -> Ok (Vector (Vec.scale a v))
  | Div, Vector v, Number a -> if Rat.sign a = 0 then refuse else Ok (Vector (Vec.scale (Rat.div Rat.one a) v))
  | _ -> refuse

and bounded refuse q = if Rat.bits q > max_bits then refuse else Ok (Number q)

and number names e =
  let* v = value names e in
  match v with Number q -> Ok q | Vector _ -> Error e.at

let vector names e =
  let* v = value names e in
  match v with Vector v -> Ok v | Number _ -> Error e.at

let add names (i : Ast.item) =
  match (i.it, Tree.declared i) with
  | Let (n, e), None -> (
      match value names e with Ok v -> Names.add n.it v names | Error _ -> Names.remove n.it names)
  | (Param (n, _) | Param_in (n, _, _)), _ -> Names.remove n.it names
  | _ -> names

(* Not those whose names stand for something else somewhere: what is written there means that. *)
let of_model items =
  let inner = Hashtbl.create 16 in
  let hide (n : Ast.name) = Hashtbl.replace inner n.it () in
  let head (h : Ast.head) ds =
    List.iter hide h.formals;
    List.iter (fun (p : Ast.expr) -> match p.it with Path { it = [ s ]; _ } -> hide s.name | _ -> ()) h.places;
    List.iter (fun (n, _) -> hide n) ds
  in
  let rec within ~top (i : Ast.item) =
    match i.it with
    | Shape (h, _, ds) | Compound (h, _, _, ds) | Decomposed (h, _, _, ds) | Behaviour (h, _, _, ds) ->
      head h ds
    | For (ranges, body) ->
      List.iter (fun (r : Ast.range) -> hide r.index) ranges;
      List.iter (within ~top:false) body
    | Let (n, _) when not top -> hide n
    | _ -> ()
  in
  List.iter (within ~top:true) items;
  let is_inner (i : Ast.item) = match i.it with Let (n, _) -> Hashtbl.mem inner n.it | _ -> false in
  List.fold_left add none (List.filter (fun i -> not (is_inner i)) items)

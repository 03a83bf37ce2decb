open Scc_base
open Scc_syntax
open Scc_describe

type target =
  | Here of int
  | Several of int list
  | Channel of string
  | There of { library : bool; file : string; name : string }

type occurrence = { at : Span.t; target : target; declares : bool }

let same a b =
  match (a, b) with
  | Here a, Here b -> Int.equal a b
  | Several a, Several b -> List.equal Int.equal a b
  | Channel a, Channel b -> String.equal a b
  | There a, There b ->
    Bool.equal a.library b.library && String.equal a.file b.file && String.equal a.name b.name
  | (Here _ | Several _ | Channel _ | There _), _ -> false

let offset (d : Declared.t) = d.name.at.start
let there (i : Ast.import) name = There { library = i.library; file = i.from.it; name }

(* The first declaration of a family, or of what is declared several times. *)
let first_of (all : Declared.all) (d : Declared.t) =
  let among table of_kind =
    let found = List.filter (fun (e : Declared.t) -> of_kind e.kind) (Declared.find table d.name.it) in
    List.fold_left (fun least e -> Int.min least (offset e)) (offset d) found
  in
  match d.kind with
  | Process | Fixed -> among all.bodies (function Process | Fixed -> true | _ -> false)
  | Behaviour -> among all.behaviours (function Behaviour -> true | _ -> false)
  | Shape | Compound -> among all.templates (function Shape | Compound -> true | _ -> false)
  | _ -> offset d

(* The alias of an import is a name of this text. *)
let of_declared all (name : Ast.name) (d : Declared.t) =
  match d.source with
  | None -> Here (first_of all d)
  | Some (i, "") ->
    let is_alias = d.name.at.start <> i.from.at.start in
    if is_alias && name.at.start <> i.from.at.start then Here (offset d) else there i ""
  | Some (i, original) -> if String.equal name.it original then there i original else Here (offset d)

let of_list all name ds =
  match List.sort_uniq Stdlib.compare (List.map (of_declared all name) ds) with
  | [] -> None
  | [ target ] -> Some target
  | _ :: _ -> Some (Several (List.sort_uniq Int.compare (List.map (first_of all) ds)))

let of_use (uses : Uses.t) (u : Scope.use) =
  match Lazy.force u.meaning with
  | Declared ds -> of_list uses.all u.name ds
  | Alike ds -> Some (Several (List.sort_uniq Int.compare (List.map (first_of uses.all) ds)))
  | Channel -> Some (Channel u.name.it)
  | Of_module { source = Some (i, _); _ } -> Some (there i u.name.it)
  | Of_module _ | Word _ | Feature | Unknown -> None

let declares (uses : Uses.t) (u : Scope.use) =
  match Lazy.force u.meaning with
  | Declared ds -> List.exists (fun (d : Declared.t) -> Int.equal (offset d) u.name.at.start) ds
  | Channel ->
    let opens (c : Scope.channel_use) =
      Int.equal c.at.start u.name.at.start && match c.how with As_name | As_co_name -> true | _ -> false
    in
    List.exists opens (Hashtbl.find_all uses.channels u.name.it)
  | Alike _ | Of_module _ | Word _ | Feature | Unknown -> false

let of_name uses (u : Scope.use) =
  Option.map (fun target -> { at = u.name.at; target; declares = declares uses u }) (of_use uses u)

let all (r : Reading.t) =
  let uses = Lazy.force r.uses in
  let opening = Hashtbl.create 64 in
  Hashtbl.iter
    (fun _ (c : Scope.channel_use) ->
       match c.how with As_name | As_co_name -> Hashtbl.replace opening c.at.start () | _ -> ())
    uses.channels;
  let one (u : Scope.use) =
    match of_use uses u with
    | None -> None
    | Some (Channel _ as target) -> Some { at = u.name.at; target; declares = Hashtbl.mem opening u.name.at.start }
    | Some target -> Some { at = u.name.at; target; declares = declares uses u }
  in
  let found = Hashtbl.fold (fun _ u found -> match one u with Some o -> o :: found | None -> found) uses.uses [] in
  List.sort (fun a b -> Int.compare a.at.start b.at.start) found

let at (r : Reading.t) where =
  let uses = Lazy.force r.uses and tokens = Lazy.force r.tokens in
  let one i = Option.bind (Uses.at uses tokens.tokens.(i).start) (of_name uses) in
  List.find_map one (Reading.tokens_at tokens where)

let exported_all (r : Reading.t) name =
  let all = (Lazy.force r.uses).all in
  let tables = [ all.templates; all.behaviours; all.values ] in
  let found = List.concat_map (fun table -> Declared.find table name) tables in
  (all, List.filter (fun (d : Declared.t) -> Option.is_none d.source) found)

let exported_target r name =
  match exported_all r name with
  | _, [] -> None
  | all, d :: _ -> Some (Here (first_of all d))

open Scc_syntax
open Scc_describe

type solid = { qualifier : string option; name : string; corners : int option }

type t = {
  bodies : (string * solid option) list;
  behaviours : string list;
  wearers : (string, solid list) Hashtbl.t;
  shapes : string list;
  imported : string list;
  imported_kinds : (string * string) list;
  values : string list;
  modules : (string * (string * string) list) list;
  channels : string list;
  features : (string, string list) Hashtbl.t;
  families : (string * string) list;
  on : (string, solid) Hashtbl.t;
  members : (string * string) list;
  groups : string list;
  processes : string list;
  network : string list option;
}

let empty =
  {
    bodies = []; behaviours = []; shapes = []; imported = []; imported_kinds = []; values = []; modules = [];
    channels = []; features = Hashtbl.create 1; families = []; wearers = Hashtbl.create 1;
    on = Hashtbl.create 1; members = []; groups = []; processes = []; network = None;
  }

let called s = match s.qualifier with Some q -> q ^ "." ^ s.name | None -> s.name

let features t s =
  match Hashtbl.find_opt t.features (called s) with
  | Some found -> found
  | None -> if Option.is_none s.qualifier then Features.predefined s.name ~corners:s.corners else []

let all_features t =
  let of_own name = Option.value (Hashtbl.find_opt t.features name) ~default:[] in
  let plain f = not (String.contains f '.') in
  List.sort_uniq String.compare (List.filter plain (List.concat_map of_own t.shapes))

(* {1 Of a text} *)

let rec of_solid (s : Ast.solid) =
  match s.it with
  | Scaled (s, _) -> of_solid s
  | Template t ->
    let corners = match t.arguments with e :: _ -> Features.number e | [] -> None in
    Some { qualifier = Option.map (fun (q : Ast.name) -> q.it) t.qualifier; name = t.target.it; corners }
  | Mesh _ | Faces _ | Hull _ -> None

let kind_of (d : Declared.t) =
  match d.kind with
  | Shape | Compound -> Some "shape"
  | Behaviour -> Some "behaviour"
  | Parameter | Value -> Some "value"
  | _ -> None

(* In the order of their places. *)
let items (all : Declared.all) =
  let found = Hashtbl.fold (fun at d found -> (at, d) :: found) all.items [] in
  List.map snd (List.sort (fun (a, _) (b, _) -> Int.compare a b) found)

let exported modules (d : Declared.t) =
  match d.source with
  | Some (i, "") -> (
      match modules i with
      | None -> []
      | Some (m : Reading.t) ->
        let one d = Option.map (fun kind -> (kind, d.Declared.name.it)) (kind_of d) in
        List.filter_map one (items (Lazy.force m.uses).all))
  | Some _ | None -> []

let kind_of_import modules (d : Declared.t) =
  let named original (e : Declared.t) = if String.equal e.name.it original then kind_of e else None in
  match (d.kind, d.source) with
  | Imported, Some (i, original) ->
    let*? (m : Reading.t) = modules i in
    let*? kind = List.find_map (named original) (items (Lazy.force m.uses).all) in
    Some (d.name.it, kind)
  | _ -> None

(* What a behaviour is on. *)
let declared_on (model : Ast.model) =
  let table = Hashtbl.create 64 in
  let rec each (items : Ast.model) =
    List.iter
      (fun (i : Ast.item) ->
         match i.it with
         | Behaviour (h, Some r, _, _) ->
           let qualifier = Option.map (fun (q : Ast.name) -> q.it) r.qualifier in
           Hashtbl.replace table h.declared.it { qualifier; name = r.target.it; corners = None }
         | For (_, inner) -> each inner
         | _ -> ())
      items
  in
  each model;
  table

let families items =
  let of_item : Ast.item_kind -> (string * string) option = function
    | Shape (h, _, _) | Compound (h, _, _, _) | Decomposed (h, _, _, _) | Behaviour (h, _, _, _)
      when h.formals <> [] || h.places <> [] ->
      Some (h.declared.it, Printer.head h)
    | _ -> None
  in
  List.filter_map of_item items

let rec each_item (items : Ast.model) =
  List.concat_map (fun (i : Ast.item) -> match i.it with For (_, inner) -> each_item inner | it -> [ it ]) items

let segment (s : Ast.segment) =
  Printer.expr { s.name with it = Ast.Path { it = [ s ]; at = s.name.at } }

let members items =
  let of_segment (s : Ast.segment) = if s.indices = [] then [] else [ (s.name.it, segment s) ] in
  let of_leaf (l : Ast.leaf) = Option.fold ~none:[] ~some:of_segment l.label in
  let of_item : Ast.item_kind -> (string * string) list = function
    | Process (s, first, rest) | Fixed (s, first, rest) ->
      of_segment s @ of_leaf first @ List.concat_map (fun (_, l) -> of_leaf l) rest
    | _ -> []
  in
  List.concat_map of_item items

let groups items =
  let of_item : Ast.item_kind -> string option = function
    | Process (s, _, _ :: _) | Fixed (s, _, _ :: _) -> Some s.name.it
    | _ -> None
  in
  List.filter_map of_item items

(* The processes that take part, by their names or those of their families. *)
let network items =
  let first (p : Ast.path) = match p.it with s :: _ -> Some s.name.it | [] -> None in
  let listed = function Ast.Network paths -> Some (List.filter_map first paths) | _ -> None in
  let lists = List.filter_map listed items in
  match lists with [] -> None | _ :: _ -> Some (List.concat lists)

let of_text modules (r : Reading.t) =
  let uses = Lazy.force r.uses in
  let all = items uses.all in
  let of_kind keep = List.filter (fun (d : Declared.t) -> keep d.kind) all in
  let name (d : Declared.t) = d.name.it in
  let templates = of_kind (function Shape | Compound -> true | _ -> false) in
  let imported = List.map name (of_kind (function Imported -> true | _ -> false)) in
  let brings d = (name d, exported modules d) in
  let brought = List.map brings (of_kind (function Module -> true | _ -> false)) in
  let features = Hashtbl.create 64 in
  let note qualifier name =
    let found = Features.of_name modules r ~qualifier name ~corners:None in
    Hashtbl.replace features (called { qualifier; name; corners = None }) found
  in
  List.iter (note None) (List.map name templates @ imported);
  List.iter (fun (q, list) -> List.iter (fun (kind, n) -> if kind = "shape" then note (Some q) n) list) brought;
  let worn = Hashtbl.create 64 and on = declared_on (Lazy.force r.model) in
  let written = each_item (Lazy.force r.model) in
  Wearers.iter uses.wearers (fun name solids -> Hashtbl.replace worn name (List.filter_map of_solid solids));
  Hashtbl.iter (fun name s -> Hashtbl.replace worn name [ s ]) on;
  let channel name _ found = name :: found in
  {
    bodies =
      List.map
        (fun (d : Declared.t) -> (name d, Option.bind d.solid of_solid))
        (of_kind (function Process | Fixed | Leaf -> true | _ -> false));
    behaviours = List.map name (of_kind (function Behaviour -> true | _ -> false));
    wearers = worn;
    shapes = List.map name templates;
    imported;
    imported_kinds = List.filter_map (kind_of_import modules) all;
    values = List.map name (of_kind (function Parameter | Value -> true | _ -> false));
    modules = brought;
    channels = List.sort_uniq String.compare (Hashtbl.fold channel uses.channels []);
    features;
    families = families written;
    on;
    members = members written;
    groups = groups written;
    processes = List.map name (of_kind (function Process | Fixed -> true | _ -> false));
    network = network written;
  }

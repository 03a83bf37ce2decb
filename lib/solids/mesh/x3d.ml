open Text
open Xml_tags

(* An element that is open: what has been found in it, in reverse order, each with the field that it is for. *)
type element = {
  tag : tag;
  container : bool;  (* of nodes, and no node itself *)
  name : string option;
  mutable inside : (word * Scene.node) list;
}

type reader = {
  path : string;
  text : string;
  names : Scene.names;
  mutable routes : Scene.route list;
  mutable opened : element list;  (* the innermost first; the last one is the file *)
  mutable depth : int;
}

let attribute tag key = List.find_opt (fun a -> String.equal a.key.text key) tag.attributes

let value r tag key =
  Option.map (fun a -> Scene.ok (Xml_tags.value ~path:r.path r.text a)) (attribute tag key)

let needed r tag key =
  match value r tag key with
  | Some value -> value
  | None -> Scene.bad ~path:r.path tag.name "`%s` of %s is missing" key tag.name.text

(* {1 Elements that are no nodes} *)

let containers = [ "X3D"; "Scene"; "head" ]

(* The prototypes are not expanded: their instances are refused. *)
let passed_over = [ "ProtoDeclare"; "ExternProtoDeclare"; "component"; "meta"; "EXPORT" ]

let route r tag =
  ignore (needed r tag "fromNode");
  r.routes <- { Scene.at = tag.name; node = needed r tag "toNode"; field = needed r tag "toField" } :: r.routes

let unit_of r tag =
  let text = needed r tag "conversionFactor" in
  let start = match attribute tag "conversionFactor" with Some a -> fst a.value | None -> tag.name.start in
  Scene_unit.check ~path:r.path tag.name ~category:(needed r tag "category") ~factor:{ text; start }

(* {1 Nodes} *)

(* These belong to the element, and are no fields. *)
let of_element = [ "DEF"; "USE"; "containerField"; "class"; "id"; "style" ]

let fields r tag =
  let own = List.filter (fun a -> not (List.mem a.key.text of_element)) tag.attributes in
  let words a =
    match Scene_table.find tag.name.text with
    | Read _ -> Scene.ok (Xml_tags.words ~path:r.path r.text a)
    | Still | Left_out | Unread _ -> []
  in
  List.map (fun a -> (a.key, Scene.Words (words a))) own

let put r element (role : string) node =
  let field = { element.tag.name with text = role } in
  match r.opened with
  | around :: _ -> around.inside <- (field, node) :: around.inside
  | [] -> Scc_base.Bug.fail __POS__ "an element outside of the file"

let finish r element =
  if element.container then
    match r.opened with
    | around :: _ -> around.inside <- element.inside @ around.inside
    | [] -> Scc_base.Bug.fail __POS__ "an element outside of the file"
  else
    let tag = element.tag in
    let role =
      match value r tag "containerField" with Some role -> role | None -> Scene_table.usual tag.name.text
    in
    match attribute tag "USE" with
    | Some a -> (
        let name = { text = Scene.ok (Xml_tags.value ~path:r.path r.text a); start = fst a.value } in
        let node = Scene.used ~path:r.path r.names name in
        match (fields r tag, List.rev element.inside) with
        | [], [] -> put r element role node
        | (w, _) :: _, _ | [], (w, _) :: _ ->
          Scene.bad ~path:r.path w "a node that is used again, by `USE`, has no fields of its own")
    | None ->
      let nodes = List.rev_map (fun (field, node) -> (field, Scene.Nodes [ node ])) element.inside in
      let node = { Scene.kind = tag.name; name = element.name; fields = fields r tag @ nodes } in
      Scene.closing r.names node;
      put r element role node

let close r (tag : tag) =
  match r.opened with
  | element :: (_ :: _ as around) when String.equal tag.name.text ("/" ^ element.tag.name.text) ->
    r.opened <- around;
    r.depth <- r.depth - 1;
    finish r element
  | _ -> Scene.bad ~path:r.path tag.name "the tag %s ends no element that is open" (quote tag.name.text)

let start r (tag : tag) =
  let container = List.mem tag.name.text containers in
  let name = if container || Option.is_some (attribute tag "USE") then None else value r tag "DEF" in
  if r.depth >= Scene.max_depth then
    Scene.bad ~path:r.path tag.name "nodes are inside of each other more than %d deep" Scene.max_depth;
  Scene.opening r.names name;
  let element = { tag; container; name; inside = [] } in
  if tag.closed then finish r element
  else (
    r.opened <- element :: r.opened;
    r.depth <- r.depth + 1)

(* The tags after the end of an element that is passed over. *)
let after r (tag : tag) rest =
  let is name (t : tag) = String.equal t.name.text name in
  let rec go depth = function
    | [] -> Scene.bad ~path:r.path tag.name "the element %s does not end" tag.name.text
    | t :: rest when is ("/" ^ tag.name.text) t -> if depth = 0 then rest else go (depth - 1) rest
    | (t : tag) :: rest -> go (if is tag.name.text t && not t.closed then depth + 1 else depth) rest
  in
  if tag.closed then rest else go 0 rest

let scene ~path text =
  let file = { name = { text = ""; start = 0 }; attributes = []; closed = false } in
  let root = { tag = file; container = true; name = None; inside = [] } in
  let r = { path; text; names = Scene.names (); routes = []; opened = [ root ]; depth = 0 } in
  let rec go = function
    | [] -> ()
    | (tag : tag) :: rest -> (
        match tag.name.text with
        | "ROUTE" -> route r tag; go (after r tag rest)
        | "unit" -> unit_of r tag; go (after r tag rest)
        | name when List.mem name passed_over -> go (after r tag rest)
        | name when String.length name > 0 && name.[0] = '/' -> close r tag; go rest
        | _ -> start r tag; go rest)
  in
  go (Scene.ok (Xml_tags.tags ~path text));
  match r.opened with
  | [ root ] ->
    { Scene.nodes = List.rev_map snd root.inside; routes = List.rev r.routes; names = Scene.known r.names }
  | element :: _ -> Scene.bad ~path element.tag.name "the element %s does not end" (quote element.tag.name.text)
  | [] -> Scc_base.Bug.fail __POS__ "the file is closed"

let read ~path text = Scene_solid.read ~path ~size:(String.length text) (fun () -> scene ~path text)

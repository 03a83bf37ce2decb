open Text
open Xml_tags

(* An element that is open: what has been found in it, in reverse order, each with the field that it is for. *)
type element = {
  tag : tag;
  container : bool;  (* of nodes, and no node itself *)
  name : string option;
  mutable inside : (word * Scene.node) list;
  mutable connected : (word * Scene.value) list;  (* fields with the values of a prototype's fields *)
}

type reader = {
  library : Scene_library.t;
  path : string;
  text : X3d_text.t;
  names : Scene.names;
  units : Scene_unit.t;
  mutable routes : Scene.route list;
  mutable changes : Scene.change list;  (* by the routes of prototypes *)
  mutable prototypes : (string * body Scene.prototype) list;
  scope : Scene.scope;
  fields : (Scene.interface * Scene.fields) option;  (* of the prototype whose body this is *)
  mutable opened : element list;  (* the innermost first; the last one is the file *)
  mutable depth : int;
  mutable containers : string list;  (* those that were there *)
}

(* The tags of a body, and the prototypes that it can use: those declared before it. *)
and body = { tags : tag list; length : int; known : (string * body Scene.prototype) list }

let attribute = X3d_text.attribute
let value r = X3d_text.value_of r.text
let needed r = X3d_text.needed r.text
let needed_word r = X3d_text.needed_word r.text

(* {1 Elements that are no nodes} *)

let containers = [ "X3D"; "Scene"; "head" ]

let passed_over = [ "component"; "meta"; "EXPORT" ]

let is_text (tag : tag) = String.equal tag.name.text Xml_tags.characters
let is name (tag : tag) = String.equal tag.name.text name

(* Shapes, and what connects them, stand in the scene, or in the body or a value of a prototype. *)
let check_in_scene r (tag : tag) =
  match r.opened with
  | { tag = { name = { text = ("" | "X3D" | "head") as around; _ }; _ }; container = true; _ } :: _ ->
    Scene.bad ~path:r.path tag.name "this %s stands outside of the `Scene`%s" tag.name.text
      (if around = "head" then ", in the `head`" else "")
  | _ -> ()

let route r tag =
  let from = needed r tag "fromNode" and node = needed r tag "toNode" and field = needed r tag "toField" in
  r.routes <- { Scene.place = tag.name; from; node; field } :: r.routes

let unit_of r tag =
  let text = needed r tag "conversionFactor" in
  let start = match attribute tag "conversionFactor" with Some a -> fst a.value | None -> tag.name.start in
  Scene_unit.state r.units ~path:r.path tag.name ~category:(needed r tag "category") ~factor:{ text; start }

(* {1 Nodes} *)

(* These belong to the element, and are no fields. *)
let of_element = [ "DEF"; "USE"; "containerField"; "class"; "id"; "style" ]

let fields r tag =
  let own = List.filter (fun a -> not (List.mem a.key.text of_element)) tag.attributes in
  let words a =
    match Scene_table.find tag.name.text with
    | Read _ -> X3d_text.words r.text a
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
        let name = { text = X3d_text.value r.text a; start = fst a.value } in
        let node = Scene.used ~path:r.path r.names name in
        if not (is "ProtoInstance" tag || String.equal node.kind.text tag.name.text) then
          Scene.bad ~path:r.path tag.name "%s is the name of a node %s, and this is a %s" (quote name.text)
            node.kind.text tag.name.text;
        (* The DTD wants the name of the prototype there too. *)
        let no_field ((w : word), _) = is "ProtoInstance" tag && String.equal w.text "name" in
        match (List.filter (fun f -> not (no_field f)) (fields r tag), List.rev element.inside) with
        | [], [] -> put r element role node
        | (w, _) :: _, _ | [], (w, _) :: _ ->
          Scene.bad ~path:r.path w "a node that is used again, by `USE`, has no fields of its own")
    | None ->
      let nodes = List.rev_map (fun (field, node) -> (field, Scene.Nodes [ node ])) element.inside in
      let own = fields r tag @ List.rev element.connected in
      let node = { Scene.kind = tag.name; name = element.name; fields = own @ nodes } in
      Scene.closing r.names node;
      put r element role node

let close r (tag : tag) =
  match r.opened with
  | element :: (_ :: _ as around) when String.equal tag.name.text ("/" ^ element.tag.name.text) ->
    r.opened <- around;
    r.depth <- r.depth - 1;
    finish r element
  | _ -> Scene.bad ~path:r.path tag.name "the tag %s ends no element that is open" (quote tag.name.text)

let check_depth r (tag : tag) =
  if r.depth >= Scene.max_depth then
    Scene.bad ~path:r.path tag.name "nodes are inside of each other more than %d deep" Scene.max_depth

(* Each at its place, and once. *)
let check_container r (tag : tag) =
  let name = tag.name.text in
  let around = List.map (fun e -> e.tag.name.text) r.opened in
  let fits =
    match (name, around) with
    | "X3D", [ "" ] | ("Scene" | "head"), ([ "" ] | [ "X3D"; "" ]) -> true
    | _ -> false
  in
  if not fits then Scene.bad ~path:r.path tag.name "the element %s does not stand here" name;
  if List.mem name r.containers then Scene.bad ~path:r.path tag.name "the element %s is there twice" name;
  r.containers <- name :: r.containers

(* What these elements say of the file. *)
let check_own r (tag : tag) =
  let of_file = [ "profile"; "version"; "xmlns"; "id"; "class"; "style" ] in
  let prefixes = [ "xmlns:"; "xsd:"; "xsi:"; "xml:" ] in
  let known a = List.mem a of_file || List.exists (fun prefix -> String.starts_with ~prefix a) prefixes in
  match List.find_opt (fun a -> not (known a.key.text)) tag.attributes with
  | None -> ()
  | Some a ->
    Scene.unread ~path:r.path a.key ~hint:"remove it if it changes nothing"
      "%s has no attribute %s that is known here" tag.name.text (quote a.key.text)

let stray_text r (tag : tag) =
  Scene.bad ~path:r.path { tag.name with text = " " }
    "text stands between elements here, where X3D has none: values are attributes"

(* Scripts and shaders have a text; nothing else has. *)
let characters r tag =
  match r.opened with
  | { tag = around; container = false; _ } :: _ when Scene_table.find around.name.text = Still -> ()
  | _ -> stray_text r tag

let start r (tag : tag) =
  let container = List.mem tag.name.text containers in
  if container then (check_container r tag; check_own r tag) else check_in_scene r tag;
  let name = if container || Option.is_some (attribute tag "USE") then None else value r tag "DEF" in
  check_depth r tag;
  Scene.opening r.names name;
  let element = { tag; container; name; inside = []; connected = [] } in
  if tag.closed then finish r element
  else (
    r.opened <- element :: r.opened;
    r.depth <- r.depth + 1)

(* The tags inside of an element, and those after its end. *)
let split r (tag : tag) rest =
  let rec go depth found = function
    | [] -> Scene.bad ~path:r.path tag.name "the element %s does not end" tag.name.text
    | t :: rest when is ("/" ^ tag.name.text) t ->
      if depth = 0 then (List.rev found, rest) else go (depth - 1) (t :: found) rest
    | (t : tag) :: rest -> go (if is tag.name.text t && not t.closed then depth + 1 else depth) (t :: found) rest
  in
  if tag.closed then ([], rest) else go 0 [] rest

(* The elements side by side in an element, with the tags inside of each. Others than those of these names are
   refused, but for nodes that change nothing. *)
let elements r (around : tag) names tags =
  let rec go found = function
    | [] -> List.rev found
    | tag :: _ when is_text tag -> stray_text r tag
    | (tag : tag) :: rest ->
      let inside, rest = split r tag rest in
      if List.mem tag.name.text names then go ((tag, inside) :: found) rest
      else if Scene_table.find tag.name.text = Still then go found rest
      else Scene.bad ~path:r.path tag.name "this %s does not belong into a %s" tag.name.text around.name.text
  in
  go [] tags

(* What follows an element in which nothing stands. *)
let after r tag rest =
  let inside, rest = split r tag rest in
  ignore (elements r tag [] inside);
  rest

(* {1 Prototypes} *)

(* A field with the value of a field of the prototype, for each `connect` of an `IS`. *)
let connections r ~kind (is : tag) tags =
  if Option.is_none r.fields then Scene_type.no_prototype ~path:r.path is.name;
  let one ((tag : tag), inside) =
    ignore (elements r tag [] inside);
    let own = needed_word r tag "protoField" and field = needed_word r tag "nodeField" in
    let value = Scene_type.connected ~path:r.path is.name r.fields r.prototypes ~kind field own in
    Option.map (fun value -> (field, value)) value
  in
  List.filter_map one (elements r is [ "connect" ] tags)

(* [name]: of the element that has the nodes, "" for the file. *)
let empty_root name =
  let file = { name = { text = name; start = 0 }; attributes = []; closed = false } in
  { tag = file; container = true; name = None; inside = []; connected = [] }

let all_changes r = List.rev_append r.changes (Scene.changes r.names (List.rev r.routes))

(* The nodes of some tags. *)
let rec contents r ~of_element tags =
  let around = r.opened and root = empty_root of_element in
  r.opened <- [ root ];
  r.depth <- r.depth + 1;
  let rec go = function
    | [] -> ()
    | (tag : tag) :: rest -> (
        match tag.name.text with
        | "ROUTE" -> check_in_scene r tag; route r tag; go (after r tag rest)
        | "IMPORT" as name ->
          Scene.unread ~path:r.path tag.name ~hint:(Scene_table.cure name) "`IMPORT` is not read"
        | "unit" -> unit_of r tag; go (after r tag rest)
        | "ProtoDeclare" -> check_in_scene r tag; go (declare r tag rest)
        | "ExternProtoDeclare" ->
          check_in_scene r tag;
          let name = needed_word r tag "name" in
          Scene.declare ~path:r.path r.scope name;
          let inside, rest = split r tag rest in
          let interface = List.map (X3d_text.outer_field r.text) (elements r tag [ "field" ] inside) in
          Scene.check_interface ~path:r.path interface;
          let urls = match attribute tag "url" with Some a -> X3d_text.words r.text a | None -> [] in
          let elsewhere = Scene_library.elsewhere ~path:r.path ~name:name.text ~interface tag.name urls in
          r.prototypes <- (name.text, Elsewhere elsewhere) :: r.prototypes;
          go rest
        | "ProtoInstance" -> check_in_scene r tag; go (instance r tag rest)
        | _ when is_text tag -> characters r tag; go rest
        | "IS" ->
          let inside, rest = split r tag rest in
          let element = List.hd r.opened in
          element.connected <- List.rev_append (connections r ~kind:element.tag.name tag inside) element.connected;
          go rest
        | name when List.mem name passed_over -> go (after r tag rest)
        | name when String.length name > 0 && name.[0] = '/' -> close r tag; go rest
        | _ -> start r tag; go rest)
  in
  go tags;
  match r.opened with
  | [ _ ] ->
    r.opened <- around;
    r.depth <- r.depth - 1;
    List.rev_map snd root.inside
  | { tag; _ } :: _ -> Scene.bad ~path:r.path tag.name "the element %s does not end" (quote tag.name.text)
  | [] -> Scc_base.Bug.fail __POS__ "the file is closed"

(* A value: an attribute, or the nodes inside. *)
and value_of r tag inside =
  match attribute tag "value" with
  | Some a -> Some (Scene.Words (X3d_text.words r.text a))
  | None when inside = [] -> None
  | None ->
    check_depth r tag;
    Scene.spend ~path:r.path (Scene_library.room r.library) tag.name (List.length inside);
    Some (Nodes (contents r ~of_element:tag.name.text inside))

and declare r tag rest =
  let inside, rest = split r tag rest in
  let all = elements r tag [ "ProtoInterface"; "ProtoBody" ] inside in
  let parts name =
    match List.filter (fun (t, _) -> is name t) all with
    | [] -> (tag, [])
    | [ part ] -> part
    | _ :: ((other : tag), _) :: _ -> Scene.bad ~path:r.path other.name "the prototype has this twice"
  in
  let interface, fields = parts "ProtoInterface" in
  let name = needed_word r tag "name" in
  Scene.declare ~path:r.path r.scope name;
  let field ((tag : tag), inside) =
    let own, event = X3d_text.inner_field r.text (tag, inside) in
    let value = if event then None else value_of r tag inside in
    Option.iter (Scene_type.check_value ~path:r.path ~quoted:false own.field ~type_:own.type_) value;
    (own, if event then None else Some (Option.value value ~default:(Scene.Words [])))
  in
  let all = List.map field (elements r interface [ "field" ] fields) in
  let interface = List.map fst all in
  Scene.check_interface ~path:r.path interface;
  let fields = List.map (fun ((d : Scene.declared), default) -> (d.field.text, default)) all in
  let tags = snd (parts "ProtoBody") in
  let body = { tags; length = List.length tags; known = r.prototypes } in
  r.prototypes <- (name.text, Own { interface; fields; body }) :: r.prototypes;
  rest

and no_prototype r (tag : tag) name =
  let known = Scene_library.listed (List.rev_map fst r.prototypes) in
  let hint =
    if known = "" then "declare it, or " ^ Scene_table.cure tag.name.text
    else "write one of the names that are there: " ^ known
  in
  match name with
  | Some name ->
    Scene.unread ~path:r.path tag.name ~hint "no prototype of the name %s is declared before it" (quote name)
  | None -> Scene.unread ~path:r.path tag.name ~hint "the name of the prototype is missing"

and instance r tag rest =
  let inside, rest = split r tag rest in
  let given_name = value r tag "name" in
  (match (attribute tag "USE", Option.map (fun n -> List.assoc_opt n r.prototypes) given_name) with
   | Some _, _ ->
     finish r { tag; container = false; name = None; inside = []; connected = [] }
   | None, (None | Some None) ->
     no_prototype r tag given_name
   | None, Some (Some Inside) -> Scene.inside ~path:r.path tag.name (Option.value given_name ~default:"")
   | None, Some (Some (Elsewhere elsewhere)) -> expand r tag inside (from_file r ~depth:r.depth elsewhere)
   | None, Some (Some (Own { interface; fields; body })) ->
     let name = Option.value given_name ~default:"" in
     expand r tag inside (own_prototype r name interface fields body));
  rest

and from_file r ~depth elsewhere =
  Scene_library.find r.library ~depth ~length:(Scene_unit.length r.units) elsewhere

and own_prototype r prototype interface fields body =
  let body ~path (kind : word) ~depth fields =
    Scene.spend ~path (Scene_library.room r.library) kind body.length;
    if depth >= Scene.max_depth then
      Scene.bad ~path kind "nodes are inside of each other more than %d deep" Scene.max_depth;
    let inner =
      {
        r with
        names = Scene.names (); routes = []; changes = []; prototypes = Scene.within prototype body.known;
        scope = Scene.scope ();
        fields = Some (interface, fields);
        opened = []; depth;
      }
    in
    match contents inner ~of_element:"ProtoBody" body.tags with
    | node :: _ -> (node, all_changes inner)
    | [] -> Scene.bad ~path kind "the prototype has no node in its body"
  in
  { Scene_library.interface; fields; body }

and expand r tag inside (prototype : Scene_library.prototype) =
  let name = value r tag "DEF" in
  let field ((tag : tag), inside) =
    (needed_word r tag "name", Option.value (value_of r tag inside) ~default:(Scene.Words []))
  in
  Scene.opening r.names name;
  let own, values = List.partition (fun (t, _) -> is "IS" t) (elements r tag [ "IS"; "fieldValue" ] inside) in
  let kind = { tag.name with text = Option.value (value r tag "name") ~default:"" } in
  let connected = List.concat_map (fun (is, inside) -> connections r ~kind is inside) own in
  let values = List.map field values @ connected in
  let fields = Scene.given ~path:r.path kind prototype.interface prototype.fields values in
  Scene_type.check_values ~path:r.path ~quoted:false prototype.interface values;
  let node, changes = prototype.body ~path:r.path tag.name ~depth:r.depth fields in
  let node = { node with name = (if Option.is_some name then name else node.name) } in
  r.changes <- List.rev_append changes r.changes;
  Scene.instance r.names { node with name };
  let usual = Scene_table.usual node.kind.text in
  put r { tag; container = false; name; inside = []; connected = [] }
    (Option.value (value r tag "containerField") ~default:usual)
    node

let file library ~path ~first text =
  let text = { X3d_text.path; text; first } in
  let r =
    {
      library; path; text; names = Scene.names (); units = Scene_unit.none ();
      routes = []; changes = []; prototypes = []; scope = Scene.scope (); fields = None;
      opened = []; depth = 0; containers = [];
    }
  in
  (r, X3d_text.tags text)

let scene library ~path text =
  let r, tags = file library ~path ~first:0 text in
  let nodes = contents r ~of_element:"" tags in
  { Scene.nodes; changes = all_changes r; length = Scene_unit.length r.units }

let prototypes library ~path ~start ~depth text =
  let r, tags = file library ~path ~first:start text in
  r.depth <- depth;
  ignore (contents r ~of_element:"" tags);
  Scene_library.file ~units:r.units ~own:(own_prototype r) ~elsewhere:(from_file r) r.prototypes

open Scc_base
open Text

(* Tokens: braces and brackets by themselves, strings with the quote before them; comments left out. Their places
   are counted from [first] on. *)
let tokens ~first text =
  let n = String.length text in
  let is_blank c = c = ' ' || c = '\t' || c = '\n' || c = '\r' || c = ',' || c = '\x0c' in
  let is_bracket c = c = '{' || c = '}' || c = '[' || c = ']' in
  let rec to_line_end i = if i < n && text.[i] <> '\n' && text.[i] <> '\r' then to_line_end (i + 1) else i in
  let rec after_quote i =
    if i >= n then n
    else
      match text.[i] with
      | '"' -> i + 1
      | '\\' -> after_quote (i + 2)
      | _ -> after_quote (i + 1)
  in
  let rec word_end i =
    let parts c = is_blank c || is_bracket c || c = '#' || c = '"' in
    if i < n && not (parts text.[i]) then word_end (i + 1) else i
  in
  let rec scan acc i =
    if i >= n then List.rev acc
    else
      match text.[i] with
      | '#' -> scan acc (to_line_end i)
      | '"' ->
        let stop = after_quote (i + 1) in
        scan ({ text = String.sub text i (min n stop - i); start = first + i } :: acc) stop
      | c when is_blank c -> scan acc (i + 1)
      | c when is_bracket c -> scan ({ text = String.make 1 c; start = first + i } :: acc) (i + 1)
      | _ ->
        let stop = word_end i in
        scan ({ text = String.sub text i (stop - i); start = first + i } :: acc) stop
  in
  scan [] 0

(* Nodes are built from the tokens that are left. *)
type reader = {
  library : Scene_library.t;
  path : string;
  first : int;  (* the place of the file's first byte *)
  mutable left : word list;
  names : Scene.names;
  units : Scene_unit.t;
  mutable routes : Scene.route list;
  mutable changes : Scene.change list;  (* by the routes of prototypes *)
  mutable prototypes : (string * body Scene.prototype) list;
  scope : Scene.scope;
  fields : (Scene.interface * Scene.fields) option;  (* of the prototype whose body this is *)
}

(* The words of a body, and the prototypes that it can use: those declared before it. *)
and body = { words : word list; length : int; known : (string * body Scene.prototype) list }

let reader ~library ~path ~first ~units ~prototypes ~fields left =
  {
    library; path; first; left; names = Scene.names (); units; routes = []; changes = []; prototypes;
    scope = Scene.scope (); fields;
  }

(* {1 Words} *)

let is_bracket w = match w.text with "{" | "}" | "[" | "]" -> true | _ -> false

(* A number, a string or a truth value, and no name. *)
let is_plain w =
  match w.text.[0] with
  | '0' .. '9' | '+' | '-' | '.' | '"' -> true
  | _ ->
    List.mem w.text [ "TRUE"; "FALSE" ] || List.mem (String.lowercase_ascii w.text) [ "nan"; "inf"; "infinity" ]

let is_name w = not (is_plain w || is_bracket w)

let rec plain r found =
  match r.left with
  | w :: rest when is_plain w ->
    r.left <- rest;
    plain r (w :: found)
  | _ -> List.rev found

(* A bracket, and the words in it. *)
let brackets r =
  let rec go at depth found =
    match r.left with
    | [] -> Scene.bad ~path:r.path at "a `%s` without its end" at.text
    | w :: rest ->
      r.left <- rest;
      let depth = match w.text with "{" | "[" -> depth + 1 | "}" | "]" -> depth - 1 | _ -> depth in
      if depth > 0 then go at depth (w :: found) else List.rev found
  in
  match r.left with
  | ({ text = "[" | "{"; _ } as at) :: rest ->
    r.left <- rest;
    go at 1 []
  | w :: _ -> Scene.bad ~path:r.path w "expected a bracket, found %s" (quote w.text)
  | [] -> Scene.ok (error_at ~path:r.path r.first "the file ends where a bracket is expected")

(* {1 Statements that are no nodes} *)

let route r (at : word) (source : word) (target : word) =
  let parts (w : word) =
    match String.split_on_char '.' w.text with
    | [ node; field ] -> (node, field)
    | _ -> Scene.bad ~path:r.path w "expected a node and its field, found %s" (quote w.text)
  in
  let from, _ = parts source in
  let node, field = parts target in
  r.routes <- { Scene.place = at; from; node; field } :: r.routes

let access_of = function
  | "eventIn" | "inputOnly" -> Some Scene.In
  | "eventOut" | "outputOnly" -> Some Out
  | "field" | "initializeOnly" -> Some Field
  | "exposedField" | "inputOutput" -> Some Exposed
  | _ -> None

let no_field r (w : word) = Scene.bad ~path:r.path w "expected a field or an event, found %s" (quote w.text)
let open_interface r at = Scene.bad ~path:r.path at "a `[` without its `]`"

let begins_value (w : word) rest =
  is_plain w
  || List.mem w.text [ "["; "NULL"; "DEF"; "USE" ]
  || match rest with { text = "{"; _ } :: _ -> true | _ -> false

(* The declarations of a prototype in another file up to the `]`, the last one first. *)
let rec outer_interface r at found =
  match r.left with
  | { text = "]"; _ } :: rest ->
    r.left <- rest;
    found
  | w :: rest -> (
      match (access_of w.text, rest) with
      | Some access, kind :: field :: rest when is_name kind && is_name field ->
        r.left <- rest;
        Scene_type.check ~path:r.path kind;
        outer_interface r at ({ Scene.field; type_ = kind.text; access } :: found)
      | None, _ when found <> [] && begins_value w rest ->
        Scene.bad ~path:r.path w "a field of an EXTERNPROTO has no value: the other file gives it one"
      | _ -> no_field r w)
  | [] -> open_interface r at

(* [false] if there is none. *)
let other_statement r =
  let after rest f =
    r.left <- rest;
    f ();
    true
  in
  match r.left with
  | ({ text = "ROUTE"; _ } as at) :: source :: { text = "TO"; _ } :: target :: rest ->
    after rest (fun () -> route r at source target)
  | { text = "EXTERNPROTO"; _ } :: name :: ({ text = "["; _ } as at) :: rest ->
    after rest (fun () ->
        Scene.declare ~path:r.path r.scope name;
        let interface = List.rev (outer_interface r at []) in
        Scene.check_interface ~path:r.path interface;
        let urls = match r.left with { text = "["; _ } :: _ -> brackets r | _ -> plain r [] in
        let elsewhere = Scene_library.elsewhere ~path:r.path ~name:name.text ~interface name urls in
        r.prototypes <- (name.text, Elsewhere elsewhere) :: r.prototypes)
  | { text = "PROFILE" | "COMPONENT"; _ } :: _ :: rest | { text = "META"; _ } :: rest ->
    after rest (fun () -> ignore (plain r []))
  | ({ text = "UNIT"; _ } as at) :: { text = category; _ } :: _ :: factor :: rest ->
    after rest (fun () -> Scene_unit.state r.units ~path:r.path at ~category ~factor)
  | { text = "EXPORT"; _ } :: _ :: { text = "AS"; _ } :: _ :: rest | { text = "EXPORT"; _ } :: _ :: rest ->
    after rest ignore
  | _ -> false

(* {1 Nodes} *)

let starts_node r =
  match r.left with
  | { text = "DEF" | "USE"; _ } :: w :: _ -> is_name w
  | kind :: { text = "{"; _ } :: _ -> is_name kind
  | _ -> false

let check_depth r depth at =
  if depth > Scene.max_depth then
    Scene.bad ~path:r.path at "nodes are inside of each other more than %d deep" Scene.max_depth

let rec node r depth =
  (match r.left with at :: _ -> check_depth r depth at | [] -> ());
  match r.left with
  | { text = "USE"; _ } :: name :: rest ->
    r.left <- rest;
    Scene.used ~path:r.path r.names name
  | { text = "DEF"; _ } :: name :: kind :: ({ text = "{"; _ } as at) :: rest when is_name kind ->
    r.left <- rest;
    any r depth at kind (Some name.text)
  | kind :: ({ text = "{"; _ } as at) :: rest when is_name kind ->
    r.left <- rest;
    any r depth at kind None
  | w :: _ -> Scene.bad ~path:r.path w "expected a node, found %s" (quote w.text)
  | [] -> Scene.ok (error_at ~path:r.path r.first "the file ends where a node is expected")

and any r depth at kind name =
  match List.assoc_opt kind.text r.prototypes with
  | None -> simple r depth at kind name
  | Some Inside -> Scene.inside ~path:r.path kind kind.text
  | Some (Elsewhere elsewhere) -> instance r depth at kind name (from_file r ~depth elsewhere)
  | Some (Own own) -> instance r depth at kind name (own_prototype r kind.text own.interface own.fields own.body)

and from_file r ~depth elsewhere =
  Scene_library.find r.library ~depth ~length:(Scene_unit.length r.units) elsewhere

and own_prototype r name interface fields body =
  let body ~path kind ~depth fields =
    Scene.spend ~path (Scene_library.room r.library) kind body.length;
    let prototypes = Scene.within name body.known in
    let inner =
      reader ~library:r.library ~path:r.path ~first:r.first ~units:r.units ~prototypes
        ~fields:(Some (interface, fields)) body.words
    in
    match contents inner depth with
    | node :: _ -> (node, all_changes inner)
    | [] -> Scene.bad ~path kind "the prototype %s has no node in its body" (quote kind.text)
  in
  { Scene_library.interface; fields; body }

and instance r depth at kind name (prototype : Scene_library.prototype) =
  Scene.opening r.names name;
  let values = own_fields r depth at kind in
  let fields = Scene.given ~path:r.path kind prototype.interface prototype.fields values in
  Scene_type.check_values ~path:r.path ~quoted:true prototype.interface values;
  let node, changes = prototype.body ~path:r.path kind ~depth:(depth + 1) fields in
  let node = { node with name = (if Option.is_some name then name else node.name) } in
  r.changes <- List.rev_append changes r.changes;
  Scene.instance r.names { node with name };
  node

and simple r depth at kind name =
  Scene.opening r.names name;
  let node = { Scene.kind; name; fields = own_fields r depth at kind } in
  Scene.closing r.names node;
  node

(* Scripts and shaders declare fields, as words of their own; other nodes have each field once. *)
and check_once r (kind : word) fields =
  match Scene_table.find kind.text with
  | Read _ | Left_out -> Scene.check_twice ~path:r.path (List.rev_map fst fields)
  | Still | Unread _ -> ()

(* All fields up to the `}`. One that is connected to an event has no value. *)
and own_fields r depth at kind =
  let rec go fields =
    if statement r depth then go fields
    else
      match r.left with
      | { text = "}"; _ } :: rest ->
        r.left <- rest;
        check_once r kind fields;
        List.rev fields
      | w :: ({ text = "IS"; _ } as is) :: outer :: rest when is_name w ->
        r.left <- rest;
        let value = Scene_type.connected ~path:r.path is r.fields r.prototypes ~kind w outer in
        go (match value with Some value -> (w, value) :: fields | None -> fields)
      | w :: rest when is_name w ->
        r.left <- rest;
        go ((w, value r depth) :: fields)
      | w :: _ -> Scene.bad ~path:r.path w "expected a field of %s or `}`, found %s" kind.text (quote w.text)
      | [] -> Scene.bad ~path:r.path at "a `{` without its `}`"
  in
  go []

(* The nodes of the file, or of the body of a prototype. *)
and contents r depth =
  let rec go found =
    if statement r depth then go found
    else
      match r.left with
      | [] -> List.rev found
      | { text = "IMPORT"; _ } as w :: _ ->
        Scene.unread ~path:r.path w ~hint:(Scene_table.cure w.text) "`IMPORT` is not read"
      | { text = "}" | "]"; _ } as w :: _ -> Scene.bad ~path:r.path w "a `%s` without its start" w.text
      | _ -> go (node r depth :: found)
  in
  go []

and all_changes r = List.rev_append r.changes (Scene.changes r.names (List.rev r.routes))

and statement r depth =
  match r.left with
  | { text = "PROTO"; _ } :: name :: ({ text = "["; _ } as at) :: rest ->
    r.left <- rest;
    check_depth r depth at;
    Scene.declare ~path:r.path r.scope name;
    let declared = List.rev (interface r (depth + 1) at []) in
    let interface = List.map fst declared in
    Scene.check_interface ~path:r.path interface;
    let fields = List.map (fun ((d : Scene.declared), default) -> (d.field.text, default)) declared in
    let words = brackets r in
    let body = { words; length = List.length words; known = r.prototypes } in
    r.prototypes <- (name.text, Own { interface; fields; body }) :: r.prototypes;
    true
  | _ -> other_statement r

(* The declarations of a prototype up to the `]`, the last one first. *)
and interface r depth at found =
  match r.left with
  | { text = "]"; _ } :: rest ->
    r.left <- rest;
    found
  | w :: rest -> (
      match (access_of w.text, rest) with
      | Some access, kind :: field :: rest ->
        r.left <- rest;
        Scene_type.check ~path:r.path kind;
        let default =
          match access with
          | In | Out -> None
          | Field | Exposed | Unsaid -> Some (default r depth field ~type_:kind.text)
        in
        interface r depth at (({ Scene.field; type_ = kind.text; access }, default) :: found)
      | _ -> no_field r w)
  | [] -> open_interface r at

and default r depth field ~type_ =
  (match r.left with
   | w :: rest when w.text <> "]" && begins_value w rest -> ()
   | _ -> Scene.bad ~path:r.path field "the field %s of the prototype has no value" (quote field.text));
  let value = value r depth in
  Scene_type.check_value ~path:r.path ~quoted:true field ~type_ value;
  value

and value r depth =
  match r.left with
  | ({ text = "["; _ } as at) :: rest ->
    r.left <- rest;
    list r depth at
  | { text = "NULL"; _ } :: rest ->
    r.left <- rest;
    Scene.Nodes []
  | _ when starts_node r -> Nodes [ node r (depth + 1) ]
  | _ -> Words (plain r [])

and list r depth at =
  let rec nodes found =
    if statement r depth then nodes found
    else
      match r.left with
      | { text = "]"; _ } :: rest ->
        r.left <- rest;
        List.rev found
      | [] -> Scene.bad ~path:r.path at "a `[` without its `]`"
      | _ -> nodes (node r (depth + 1) :: found)
  in
  if starts_node r then Scene.Nodes (nodes [])
  else
    let words = plain r [] in
    match r.left with
    | { text = "]"; _ } :: rest ->
      r.left <- rest;
      Words words
    | w :: _ -> Scene.bad ~path:r.path w "expected a number or `]`, found %s" (quote w.text)
    | [] -> Scene.bad ~path:r.path at "a `[` without its `]`"

(* Both formats say in their first line what they are. A comment may follow. *)
let is_header head =
  let line = List.hd (String.split_on_char '\n' (String.map (function '\r' -> '\n' | c -> c) head)) in
  let words = String.split_on_char ' ' (String.map (function '\t' -> ' ' | c -> c) line) in
  let version v = String.length v = 4 && List.mem (String.sub v 0 3) [ "V3."; "V4." ] in
  match List.filter (fun w -> w <> "") words with
  | "#VRML" :: "V2.0" :: "utf8" :: _ -> true
  | "#X3D" :: v :: "utf8" :: _ -> version v && v.[3] >= '0' && v.[3] <= '9'
  | _ -> false

let check_header ~path text =
  let head = String.trim (String.sub text 0 (min 80 (String.length text))) in
  let starts prefix = String.starts_with ~prefix head in
  let refuse ~hint what =
    raise (Scene.Refused (Diag.error Code.mesh_format (Span.of_file path) ~hint "%s" what))
  in
  if is_header head then ()
  else if starts "#VRML V1" || starts "#Inventor" then
    refuse "VRML 1 files are not supported" ~hint:"convert the file to VRML 2 (VRML97), X3D, PLY or OFF"
  else if starts "\x1F\x8B" then refuse "the file is compressed" ~hint:"decompress it, by gunzip for instance"
  else
    refuse "the first line says neither `#VRML V2.0 utf8` nor `#X3D V3.0 utf8`"
      ~hint:"write one of them before everything else, if the file is of that format"

let file library ~path ~first text =
  check_header ~path text;
  reader ~library ~path ~first ~units:(Scene_unit.none ()) ~prototypes:[] ~fields:None (tokens ~first text)

let scene library ~path text =
  let r = file library ~path ~first:0 text in
  let nodes = contents r 0 in
  { Scene.nodes; changes = all_changes r; length = Scene_unit.length r.units }

let prototypes library ~path ~start ~depth text =
  let r = file library ~path ~first:start text in
  ignore (contents r depth);
  Scene_library.file ~units:r.units ~own:(own_prototype r) ~elsewhere:(from_file r) r.prototypes

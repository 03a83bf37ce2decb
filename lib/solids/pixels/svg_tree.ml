open Svg_number

type node = {
  name : string;
  attributes : (string * string) list;
  at : int * int;
  parent : node option;
  mutable children : node list;
  mutable text : string list;
}

type t = {
  root : node;
  ids : (string, node) Hashtbl.t;
  sheet : Css.t;
  valid : string -> string -> bool;
  program : (int * int) option;
}

exception Fault of (int * int) * exn

let at node f =
  match f () with
  | result -> result
  | exception ((Bad _ | Unread _ | Beyond _) as fault) -> raise (Fault (node.at, fault))

let space = "http://www.w3.org/2000/svg"
let xlink = "http://www.w3.org/1999/xlink"
let max_depth = 200
let max_elements = 200_000
let max_classes = 100
let attribute node (name : string) = List.assoc_opt name node.attributes

let href node =
  match attribute node "href" with Some target -> Some target | None -> attribute node "xlink:href"

(* {1 Reading} *)

let plain attributes =
  List.filter_map
    (fun ((ns, name), v) ->
       if ns = "" then Some (name, v) else if ns = xlink then Some ("xlink:" ^ name, v) else None)
    attributes

(* Before a signal that is a start tag is read, [at] becomes the place after its name. *)
type input = {
  xml : Xmlm.input;
  mutable at : int * int;
  mutable program : (int * int) option;  (* the place of the first one *)
}

let note_program input = if input.program = None then input.program <- Some input.at

let is_handler ((ns, name), _) = ns = "" && String.length name > 2 && String.sub name 0 2 = "on"

(* By XML, no attribute is there twice; Xmlm does not see to it. *)
let check_once attributes =
  let by_name (((a : Xmlm.name), _) : Xmlm.attribute) (b, _) = compare a b in
  let rec once : Xmlm.attribute list -> unit = function
    | (a, _) :: ((b, _) :: _ as rest) ->
      if a = b then raise (Bad (Printf.sprintf "the attribute %s twice" (snd a)));
      once rest
    | [ _ ] | [] -> ()
  in
  once (List.sort by_name attributes)

let signal input =
  input.at <- Xmlm.pos input.xml;
  match Xmlm.input input.xml with
  | `El_start (_, attributes) as start ->
    check_once attributes;
    start
  | (`El_end | `Data _ | `Dtd _) as other -> other

(* The rest of an element whose start was read is passed over. *)
let pass_over input =
  let rec go depth =
    if depth > 0 then
      match signal input with
      | `El_start _ -> go (depth + 1)
      | `El_end -> go (depth - 1)
      | `Data _ | `Dtd _ -> go depth
  in
  go 1

let rec root_tag input =
  match signal input with
  | `Dtd _ -> root_tag input
  | `El_start ((ns, "svg"), attributes) when ns = space || ns = "" -> attributes
  | _ -> raise (Unread "XML whose root is no svg element")

let element input ?parent name attributes =
  if List.exists is_handler attributes then note_program input;
  { name; attributes = plain attributes; at = input.at; parent; children = []; text = [] }

(* The elements around the place, the nearest first, and how deep it is; children are in reverse until their
   parent ends. *)
let content input root =
  let count = ref 1 in
  let rec go stack depth =
    if depth > max_depth then raise (Bad "elements nested too deep");
    match (signal input, stack) with
    | _, [] -> ()
    | `El_end, node :: outer ->
      node.children <- List.rev node.children;
      if outer <> [] then go outer (depth - 1)
    | `El_start ((ns, name), _), _ when (ns <> space && ns <> "") || Svg_table.within_shape name ->
      if name = "script" then note_program input;
      pass_over input;
      go stack depth
    | `El_start ((_, name), attributes), parent :: _ ->
      incr count;
      if !count > max_elements then raise (Beyond (Printf.sprintf "%d elements" max_elements));
      let node = element input ~parent name attributes in
      parent.children <- node :: parent.children;
      go (node :: stack) (depth + 1)
    | `Data text, node :: _ ->
      if List.mem node.name [ "style"; "text"; "tspan" ] then node.text <- text :: node.text;
      go stack depth
    | `Dtd _, _ -> go stack depth
  in
  go [ root ] 1

(* {1 Styles} *)

let is_css node =
  let is name accepted =
    match attribute node name with None -> true | Some v -> List.mem (String.lowercase_ascii (String.trim v))
                                                              accepted
  in
  if not (is "type" [ ""; "text/css" ]) then raise (Unread "style sheets in another language than CSS");
  if not (is "media" [ ""; "all"; "screen" ]) then raise (Unread "style sheets for other media than the screen")

(* All elements, in the order of the document. *)
let iter f root =
  let rec go = function
    | [] -> ()
    | node :: rest ->
      f node;
      go (List.rev_append (List.rev node.children) rest)
  in
  go [ root ]

let read ~valid text =
  let entities =
    match Svg_entities.of_text text with
    | Some found -> found
    | None ->
      let what = "document types with declarations of their own, but for entities with plain values" in
      raise (Fault ((1, 1), Unread what))
  in
  let xml = Xmlm.make_input ~entity:(Svg_entities.meaning entities) (`String (0, text)) in
  let input = { xml; at = (1, 1); program = None } in
  let root =
    try
      let attributes = root_tag input in
      let root = element input "svg" attributes in
      content input root;
      if not (Xmlm.eoi input.xml) then raise (Bad "something after the end of the svg element");
      root
    with (Bad _ | Unread _ | Beyond _) as fault -> raise (Fault (input.at, fault))
  in
  let ids = Hashtbl.create 64 and sheets = ref [] in
  iter
    (fun node ->
       Option.iter (fun id -> if not (Hashtbl.mem ids id) then Hashtbl.replace ids id node) (attribute node "id");
       if node.name = "style" then begin
         let text = String.concat "" (List.rev node.text) in
         let rules = at node (fun () -> is_css node; Css.rules ~valid text) in
         sheets := rules :: !sheets
       end)
    root;
  { root; ids; sheet = at root (fun () -> Css.sheet (List.rev !sheets)); valid; program = input.program }

let subject node =
  let classes =
    match attribute node "class" with
    | None -> []
    | Some text ->
      let text = String.map (fun c -> if is_blank c then ' ' else c) text in
      List.filter (( <> ) "") (String.split_on_char ' ' text)
  in
  if List.compare_length_with classes max_classes > 0 then
    raise (Bad (Printf.sprintf "an element of more than %d classes" max_classes));
  { Css.name = node.name; id = attribute node "id"; classes }

let declared t node =
  let rec chain node = subject node :: (match node.parent with None -> [] | Some parent -> chain parent) in
  let sheet = if Css.is_empty t.sheet then [] else Css.declared t.sheet (chain node) in
  Svg_declarations.of_element ~valid:t.valid node.name node.attributes ~sheet

type run = { set : string; least : int; most : int option }

type t =
  | Anything
  | Null
  | Bool
  | Integer of { least : int option; most : int option }
  | Text of { least : int }
  | Form of run list
  | Repeated of run list
  | Constant of Json.t list
  | Items of { each : t; least : int; most : int option; distinct : bool }
  | Tuple of t list
  | Members of member list
  | Entries of t
  | Any_of of t list
  | Reference of { file : string; name : string; target : t Lazy.t }
  | Document of { file : string; target : t }
  | About of string * t
  | Also of (string * Json.t) list * t

and member = { name : string; required : bool; value : t }

(* {1 Forms} *)

let one_run r =
  let set = if String.length r.set = 1 && r.set <> "." then r.set else "[" ^ r.set ^ "]" in
  match (r.least, r.most) with
  | 1, Some 1 -> set
  | 0, Some 1 -> set ^ "?"
  | 0, None -> set ^ "*"
  | 1, None -> set ^ "+"
  | n, Some m when n = m -> Printf.sprintf "%s{%d}" set n
  | n, Some m -> Printf.sprintf "%s{%d,%d}" set n m
  | n, None -> Printf.sprintf "%s{%d,}" set n

let body runs = String.concat "" (List.map one_run runs)
let pattern runs = "^" ^ body runs ^ "$"
let repeated_pattern runs = "^(" ^ body runs ^ ")+$"

(* A set is characters and ranges, as in a regular expression; '-' is a range between two characters only. *)
let mem set c =
  let n = String.length set in
  let rec from i =
    if i >= n then false
    else if i + 2 < n && set.[i + 1] = '-' then (set.[i] <= c && c <= set.[i + 2]) || from (i + 3)
    else set.[i] = c || from (i + 1)
  in
  from 0

let matches ?(again = false) runs s =
  let n = String.length s in
  let rec taken r i k =
    let is_more = Option.fold ~none:true ~some:(fun m -> k < m) r.most in
    if is_more && i + k < n && mem r.set s.[i + k] then taken r i (k + 1) else k
  in
  let rec from start i = function
    | [] -> i = n || (again && i > start && from i i runs)
    | r :: rest ->
      let k = taken r i 0 in
      k >= r.least && from start (i + k) rest
  in
  from 0 0 runs

(* {1 As JSON} *)

let at_least name = function None -> [] | Some n -> [ (name, `Int n) ]
let positive n = if n > 0 then Some n else None
let kind name = ("type", `String name)

let of_types =
  [
    "minimum"; "maximum"; "minLength"; "pattern"; "items"; "prefixItems"; "minItems"; "maxItems"; "uniqueItems";
    "properties"; "required"; "additionalProperties";
  ]

let is_of_type (keyword, _) = List.mem keyword of_types

(* What is of simple types alone is one list of types. So is a value of one type, or null: the keywords about
   values of a type allow all others. *)
let any_of alternatives : (string * Json.t) list =
  let simple = function `Assoc [ ("type", `String t) ] -> Some (`String t) | _ -> None in
  let types = List.filter_map simple alternatives in
  match alternatives with
  | [ `Assoc (("type", (`String _ as t)) :: rest); `Assoc [ ("type", `String "null") ] ]
    when List.for_all is_of_type rest ->
    ("type", `List [ t; `String "null" ]) :: rest
  | _ when List.compare_lengths types alternatives = 0 -> [ ("type", `List types) ]
  | _ -> [ ("anyOf", `List alternatives) ]

let rec keywords inside = function
  | Anything -> []
  | Null -> [ kind "null" ]
  | Bool -> [ kind "boolean" ]
  | Integer { least; most } -> (kind "integer" :: at_least "minimum" least) @ at_least "maximum" most
  | Text { least } -> kind "string" :: at_least "minLength" (positive least)
  | Form runs -> [ kind "string"; ("pattern", `String (pattern runs)) ]
  | Repeated runs -> [ kind "string"; ("pattern", `String (repeated_pattern runs)) ]
  | Constant [ value ] -> [ ("const", value) ]
  | Constant values -> [ ("enum", `List values) ]
  | Items { each; least; most; distinct } ->
    [ kind "array"; ("items", whole inside each) ]
    @ at_least "minItems" (positive least)
    @ at_least "maxItems" most
    @ if distinct then [ ("uniqueItems", `Bool true) ] else []
  | Tuple items ->
    let count = List.length items in
    [ kind "array"; ("prefixItems", `List (List.map (whole inside) items)) ]
    @ [ ("minItems", `Int count); ("maxItems", `Int count) ]
  | Members members ->
    let property m = (m.name, whole inside m.value) in
    let required = List.filter_map (fun m -> if m.required then Some (`String m.name) else None) members in
    [
      kind "object";
      ("properties", `Assoc (List.map property members));
      ("required", `List required);
      ("additionalProperties", `Bool false);
    ]
  | Entries each -> [ kind "object"; ("additionalProperties", whole inside each) ]
  | Any_of alternatives -> any_of (List.map (whole inside) alternatives)
  | Reference { file; name; _ } ->
    let at = if String.equal file inside then "" else file ^ ".schema.json" in
    [ ("$ref", `String (Printf.sprintf "%s#/$defs/%s" at name)) ]
  | Document { file; _ } -> [ ("$ref", `String (file ^ ".schema.json")) ]
  | About (text, t) -> ("description", `String text) :: keywords inside t
  | Also (more, t) -> keywords inside t @ more

and whole inside t : Json.t = `Assoc (keywords inside t)

(* {1 Files} *)

type file = { name : string; title : string; root : t option; parts : t list }

module Names = Map.Make (String)

(* The definitions that a schema refers to, those of other files included. *)
let rec collect found = function
  | Anything | Null | Bool | Integer _ | Text _ | Form _ | Repeated _ | Constant _ | Document _ -> found
  | Items { each; _ } | Entries each | About (_, each) | Also (_, each) -> collect found each
  | Members members -> List.fold_left (fun found m -> collect found m.value) found members
  | Any_of all | Tuple all -> List.fold_left collect found all
  | Reference { file; name; target } ->
    let key = file ^ "#" ^ name in
    if Names.mem key found then found
    else
      let target = Lazy.force target in
      collect (Names.add key (file, name, target) found) target

let document ~all (f : file) : Json.t =
  let of_file found f = List.fold_left collect found (Option.to_list f.root @ f.parts) in
  let found = List.fold_left of_file Names.empty all in
  let own = List.filter (fun (_, (file, _, _)) -> String.equal file f.name) (Names.bindings found) in
  let definitions = List.map (fun (_, (_, name, t)) -> (name, whole f.name t)) own in
  `Assoc
    ([
      ("$schema", `String "https://json-schema.org/draft/2020-12/schema");
      ("$id", `String (f.name ^ ".schema.json"));
      ("title", `String f.title);
    ]
      @ Option.fold ~none:[] ~some:(keywords f.name) f.root
      @ if definitions = [] then [] else [ ("$defs", `Assoc definitions) ])

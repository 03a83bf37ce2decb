open Scc_base
open Scc_exact

type path = Whole | Member of path * string | Item of path * int
type fault = { at : path; told : string }

(* Inside of [read] only. *)
exception Refused of fault

type ('w, 'r) t = {
  write : 'w -> Json.t;
  read : path -> Json.t -> 'r;
  null : bool;  (** [null] is one of its values *)
  schema : Json_schema.t;
}

let write t x = t.write x
let schema t = t.schema
let read t json = match t.read Whole json with x -> Ok x | exception Refused f -> Error f
let refuse at fmt = Printf.ksprintf (fun told -> raise_notrace (Refused { at; told })) fmt

let rec place = function
  | Whole -> ""
  | Member (Whole, name) -> name
  | Member (p, name) -> place p ^ "." ^ name
  | Item (p, i) -> Printf.sprintf "%s[%d]" (place p) i

let fault_to_string { at; told } =
  match at with Whole -> "this " ^ told | _ -> Printf.sprintf "`%s` %s" (place at) told

(* {1 Values} *)

let value ?(null = false) schema what write read =
  let read at json = match read json with Some x -> x | None -> refuse at "is not %s" what in
  { write; read; null; schema }

let text = value (Text { least = 0 }) "a text" Json.text Json.string

let nonempty json = Option.bind (Json.string json) (fun s -> if s = "" then None else Some s)
let some_text = value (Text { least = 1 }) "a text that is not empty" Json.text nonempty

let formed schema pattern matches =
  let read json = Option.bind (Json.string json) (fun s -> if matches s then Some s else None) in
  value schema ("a text of the form " ^ pattern) Json.text read

let form runs = formed (Form runs) (Json_schema.pattern runs) (Json_schema.matches runs)

let repeated runs =
  formed (Repeated runs) (Json_schema.repeated_pattern runs) (Json_schema.matches ~again:true runs)

let bool = value Bool "a truth value" (fun b -> `Bool b) (function `Bool b -> Some b | _ -> None)

let integer ?least ?most () =
  let above = Option.fold ~none:(fun _ -> true) ~some:(fun m n -> n >= m) least in
  let below = Option.fold ~none:(fun _ -> true) ~some:(fun m n -> n <= m) most in
  let read json = Option.bind (Json.int json) (fun n -> if above n && below n then Some n else None) in
  let what = match least with Some m -> Printf.sprintf "an integer from %d on" m | None -> "an integer" in
  value (Integer { least; most }) what (fun n -> `Int n) read

let natural = integer ~least:0 ()

let digits least = { Json_schema.set = "0-9"; least; most = None }
let one set = { Json_schema.set; least = 1; most = Some 1 }
let sign = { Json_schema.set = "-"; least = 0; most = Some 1 }
let fraction = [ digits 1; one "/"; one "1-9"; digits 0 ]
let rational = value (Form (sign :: fraction)) "a rational number" Json.rat Json.rational

let duration =
  let read json = Option.bind (Json.rational json) (fun q -> if Rat.sign q >= 0 then Some q else None) in
  value (Form fraction) "a duration, a text \"p/q\" that is at least 0" Json.rat read

let number =
  let forms = [ fraction; [ digits 1 ]; [ digits 1; one "."; digits 1 ] ] in
  value (Any_of (List.map (fun f -> Json_schema.Form (sign :: f)) forms)) "a number" Json.text Json.rational

let word name all =
  let names = List.map (fun x -> (name x, x)) all in
  let schema = Json_schema.Constant (List.map (fun (n, _) -> `String n) names) in
  let read json = Option.bind (Json.string json) (fun s -> List.assoc_opt s names) in
  let what = "one of " ^ String.concat ", " (List.map fst names) in
  value schema what (fun x -> `String (name x)) read

let one_of ?what numbers =
  let read json = Option.bind (Json.int json) (fun n -> if List.mem n numbers then Some n else None) in
  let default = "one of " ^ String.concat ", " (List.map string_of_int numbers) in
  let what = Option.value what ~default in
  value (Constant (List.map (fun n -> `Int n) numbers)) what (fun n -> `Int n) read

(* {1 Several values} *)

let rec equal (a : Json.t) (b : Json.t) =
  match (a, b) with
  | `Null, `Null -> true
  | `Bool a, `Bool b -> Bool.equal a b
  | `Int a, `Int b -> Int.equal a b
  | `String a, `String b -> String.equal a b
  | `List a, `List b -> List.compare_lengths a b = 0 && List.for_all2 equal a b
  | `Assoc a, `Assoc b ->
    let same (name, x) = Option.fold ~none:false ~some:(equal x) (List.assoc_opt name b) in
    List.compare_lengths a b = 0 && List.for_all same a
  | _ -> false

module Texts = Set.Make (String)

(* Of equal values the texts are equal, but for the order of members, which no format with distinct items has. *)
let are_distinct items =
  let add seen item = Option.bind seen (fun seen ->
      let line = Json.line item in
      if Texts.mem line seen then None else Some (Texts.add line seen))
  in
  Option.is_some (List.fold_left add (Some Texts.empty) items)

let list ?(least = 0) ?most ?(distinct = false) t =
  let read at = function
    | `List items ->
      let count = List.length items in
      if count < least then refuse at "has less than %d items" least;
      Option.iter (fun m -> if count > m then refuse at "has more than %d items" m) most;
      if distinct && not (are_distinct items) then refuse at "has an item twice";
      List.mapi (fun i x -> t.read (Item (at, i)) x) items
    | _ -> refuse at "is not an array"
  in
  {
    write = (fun items -> `List (List.map t.write items));
    read; null = false;
    schema = Items { each = t.schema; least; most; distinct };
  }

let triple a b c =
  let read at = function
    | `List [ x; y; z ] -> (a.read (Item (at, 0)) x, b.read (Item (at, 1)) y, c.read (Item (at, 2)) z)
    | _ -> refuse at "is not an array of three"
  in
  {
    write = (fun (x, y, z) -> `List [ a.write x; b.write y; c.write z ]);
    read; null = false;
    schema = Tuple [ a.schema; b.schema; c.schema ];
  }

let from f t = { t with write = (fun x -> t.write (f x)) }
let array ?least ?most t = from Array.to_list (list ?least ?most t)

let into f t =
  let read at json = match f (t.read at json) with Ok x -> x | Error told -> refuse at "%s" told in
  { t with read }

let entries t =
  let read at = function
    | `Assoc members -> List.map (fun (name, x) -> (name, t.read (Member (at, name)) x)) members
    | _ -> refuse at "is not an object"
  in
  {
    write = (fun all -> `Assoc (List.map (fun (name, x) -> (name, t.write x)) all));
    read; null = false;
    schema = Entries t.schema;
  }

let nullable t =
  {
    write = (function None -> `Null | Some x -> t.write x);
    read = (fun at -> function `Null -> None | json -> Some (t.read at json));
    null = true;
    schema = Any_of [ t.schema; Null ];
  }

let null = { (value Null "null" (fun () -> `Null) (function `Null -> Some () | _ -> None)) with null = true }

let json ?(schema = Json_schema.Anything) () =
  { write = Fun.id; read = (fun _ json -> json); null = true; schema }

(* {1 Objects} *)

type ('o, 'r) members = {
  put : 'o -> (string * Json.t) list -> (string * Json.t) list;  (** before those that follow *)
  get : path -> (string * Json.t) list -> 'r;
  listed : Json_schema.member list;
}

let written_members m o = m.put o []

let described about t =
  match about with None -> t.schema | Some text -> Json_schema.About (text, t.schema)

let required name ?about t part =
  let get at members =
    match List.assoc_opt name members with
    | Some json -> t.read (Member (at, name)) json
    | None -> refuse (Member (at, name)) "is missing"
  in
  {
    put = (fun o rest -> (name, t.write (part o)) :: rest);
    get;
    listed = [ { name; required = true; value = described about t } ];
  }

let optional name ?about t part =
  let get at members =
    match List.assoc_opt name members with
    | None -> None
    | Some `Null when not t.null -> None
    | Some json -> Some (t.read (Member (at, name)) json)
  in
  {
    put = (fun o rest -> match part o with None -> rest | Some x -> (name, t.write x) :: rest);
    get;
    listed = [ { name; required = false; value = described about t } ];
  }

let ( let+ ) m f = { m with get = (fun at members -> f (m.get at members)) }

let ( and+ ) a b =
  let get at members =
    let x = a.get at members in
    (x, b.get at members)
  in
  { put = (fun o rest -> a.put o (b.put o rest)); get; listed = a.listed @ b.listed }

let all list =
  {
    put = (fun o rest -> List.fold_right (fun m rest -> m.put o rest) list rest);
    get = (fun at members -> List.iter (fun m -> m.get at members) list);
    listed = List.concat_map (fun m -> m.listed) list;
  }

let within f m = { m with put = (fun x rest -> m.put (f x) rest) }

(* A member that stands in one place of some documents, and in another of others, is listed once. *)
let listed_once members =
  let add found (m : Json_schema.member) =
    if List.exists (fun (n : Json_schema.member) -> String.equal n.name m.name) found then found else m :: found
  in
  List.rev (List.fold_left add [] members)

let obj m =
  let read at = function `Assoc members -> m.get at members | _ -> refuse at "is not an object" in
  { write = (fun o -> `Assoc (m.put o [])); read; null = false; schema = Members (listed_once m.listed) }

let fields list = obj (all list)
let ignored m = ( let+ ) m ignore
let field name ?about t part = ignored (required name ?about t part)
let maybe name ?about t part = ignored (optional name ?about t part)

let constant it =
  let read at json = if not (equal json it) then refuse at "is not %s" (Json.line it) in
  { write = (fun () -> it); read; null = false; schema = Constant [ it ] }

let fixed name ?about it = required name ?about (constant it) ignore

(* {1 Alternatives} *)

type ('w, 'r) case = {
  written : 'w -> Json.t option;
  taken : path -> Json.t -> 'r;
  alternative : Json_schema.t;
}

let case t part make =
  {
    written = (fun x -> Option.map t.write (part x));
    taken = (fun at json -> make (t.read at json));
    alternative = t.schema;
  }

let written cases x =
  match List.find_map (fun c -> c.written x) cases with
  | Some json -> json
  | None -> Bug.fail __POS__ "a value of no case"

let rec first_taken cases at json =
  match cases with
  | [] -> refuse at "is none of what it may be"
  | [ c ] -> c.taken at json
  | c :: rest -> ( match c.taken at json with x -> x | exception Refused _ -> first_taken rest at json)

let union cases =
  {
    write = written cases;
    read = first_taken cases;
    null = false;
    schema = Any_of (List.map (fun c -> c.alternative) cases);
  }

let variant ?about tag part members make =
  let c = case (obj members) part make in
  (tag, match about with None -> c | Some text -> { c with alternative = About (text, c.alternative) })

let rec tagged_schema ?about name tag : Json_schema.t -> Json_schema.t = function
  | Members listed ->
    let value = Json_schema.Constant [ `String tag ] in
    let value = match about with None -> value | Some text -> Json_schema.About (text, value) in
    Members ({ name; required = true; value } :: listed)
  | About (text, t) -> About (text, tagged_schema ?about name tag t)
  | _ -> Bug.fail __POS__ "a variant that is no object"

let tagged name ?about variants =
  let with_tag (tag, c) =
    let put json = match json with
      | `Assoc members -> `Assoc ((name, `String tag) :: members)
      | _ -> Bug.fail __POS__ "a variant that is no object"
    in
    let alternative = tagged_schema ?about name tag c.alternative in
    { c with written = (fun x -> Option.map put (c.written x)); alternative }
  in
  let cases = List.map with_tag variants in
  let read at json =
    match Option.bind (Json.member name json) Json.string with
    | None -> refuse (Member (at, name)) "is missing"
    | Some tag -> (
        match List.filter (fun (t, _) -> String.equal t tag) variants with
        | [] -> refuse (Member (at, name)) "is none of %s" (String.concat ", " (List.map fst variants))
        | fitting -> first_taken (List.map snd fitting) at json)
  in
  {
    write = written cases;
    read; null = false;
    schema = Any_of (List.map (fun c -> c.alternative) cases);
  }

(* {1 Changes} *)

let checked t = into (fun _ -> Ok ()) t
let about text t = { t with schema = Json_schema.About (text, t.schema) }

let constrained keywords complaint t =
  let read at json =
    let x = t.read at json in
    Option.iter (fun told -> refuse at "%s" told) (complaint json);
    x
  in
  { t with read; schema = Also (keywords, t.schema) }

let named ~file name t = { t with schema = Reference { file; name; target = lazy t.schema } }

let document ~file t = { (checked t) with schema = Document { file; target = t.schema } }

let recursive ~file name make =
  let rec whole = lazy (make self)
  and self =
    {
      write = (fun x -> (Lazy.force whole).write x);
      read = (fun at json -> (Lazy.force whole).read at json);
      null = false;
      schema = Reference { file; name; target = lazy (Lazy.force whole).schema };
    }
  in
  self

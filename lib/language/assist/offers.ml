open Scc_syntax
open Scc_describe

type offer = { name : string; kind : string; form : string option; about : string option }

let unique names =
  let seen : (string, unit) Hashtbl.t = Hashtbl.create 64 in
  let is_new name =
    let known = Hashtbl.mem seen name in
    if not known then Hashtbl.add seen name ();
    not known
  in
  List.filter is_new names

(* {1 Words} *)

let beginning =
  [
    "behaviour"; "binding"; "blocked"; "bond"; "bonds"; "check"; "collisions"; "compound"; "dynamics"; "fixed";
    "for"; "import"; "let"; "model"; "motion"; "network"; "param"; "process"; "resolution"; "round"; "shape";
    "split_step"; "timestep";
  ]

let attributes = [ "at"; "mass"; "velocity"; "spin"; "translate"; "rotate"; "scale"; "scaled"; "absorb" ]

let temporal =
  [
    "always"; "eventually"; "possibly"; "AG"; "AF"; "EF"; "EG"; "A"; "E"; "P"; "Pmin"; "Pmax"; "forall"; "exists";
    "not";
  ]

let names kind = List.map (fun name -> { name; kind; form = None; about = None })

let meaning categories name =
  List.find_map (fun c -> Vocabulary.find c name) categories
  |> Option.map (fun (e : Vocabulary.entry) -> e.meaning)

let all_categories = [ Vocabulary.Word; Setting; Solid; Function; Atom; Law; Event; Measure; Component ]

let word ?(categories = all_categories) form name =
  let first forms = match forms with f :: _ -> Some f | [] -> None in
  { name; kind = "word"; form = Option.bind (Forms.find form name) first; about = meaning categories name }

let words = List.map (word Forms.Written)
let of_category category = List.filter (fun (e : Vocabulary.entry) -> e.category = category) Vocabulary.all

let entries category form =
  let offer (e : Vocabulary.entry) = { (word ~categories:[ category ] form e.word) with kind = e.kind } in
  List.map offer (of_category category)

let keywords () = words (List.filter (fun w -> String.length w > 1) (List.map fst Lexer.words))

(* {1 What the text declares} *)

type place = { known : Known.t; p : Pieces.t; item : Pieces.item option }

(* Those of the window are there even if the text could not be read since. *)
let declared t kinds =
  let of_kind (i : Pieces.item) = List.mem i.word kinds && i.name <> "" in
  List.filter_map (fun (i : Pieces.item) -> if of_kind i then Some i.name else None) t.p.items

let is_channel (w : string array) i =
  let at k = if i - k >= 0 then w.(i - k) else "" in
  let next = if i + 1 < Array.length w then w.(i + 1) else "" in
  let opened =
    at 1 = "<" || (at 1 = "~" && at 2 = "<") || (at 1 = "(" && at 2 = "omega")
    || (at 1 = "~" && at 2 = "(" && at 3 = "omega")
  in
  Pieces.is_name w.(i) && ((opened && next = ",") || (at 1 = "~" && at 2 = "<"))

let channels t =
  let found = List.filteri (fun i _ -> is_channel t.p.words i) (Array.to_list t.p.words) in
  unique (found @ t.known.channels)

(* The bodies of a process that are named: `a : Cube`, `a[i] : Cube`. *)
let leaves t (i : Pieces.item) =
  let w k = if k < i.stop then t.p.words.(k) else "" in
  let rec after k = if k >= i.stop then "" else if w k = "]" then w (k + 1) else after (k + 1) in
  let named k =
    Pieces.is_name (w k) && match w (k + 1) with ":" -> true | "[" -> after k = ":" | _ -> false
  in
  if not (List.mem i.word [ "process"; "fixed" ]) then []
  else
    let after_name = List.init (Int.max 0 (i.stop - i.first - 2)) (fun k -> i.first + 2 + k) in
    List.filter_map (fun k -> if named k then Some (w k) else None) after_name

let bodies t =
  let near = declared t [ "process"; "fixed" ] @ List.concat_map (leaves t) t.p.items in
  names "body" (unique (near @ List.map fst t.known.bodies))

let values t = names "value" (unique (declared t [ "param"; "let" ] @ t.known.values))
let predefined () = entries Vocabulary.Solid Forms.Called
let modules t = names "module" (List.map fst t.known.modules)

(* Of those that are chosen from imports, those of this kind, and those of which the kind is not known. *)
let imported t kind =
  let fits name = match List.assoc_opt name t.known.imported_kinds with None -> true | Some k -> k = kind in
  List.filter fits t.known.imported

let shapes t = names "shape" (unique (declared t [ "shape"; "compound" ] @ t.known.shapes @ imported t "shape"))
let solids t = shapes t @ modules t @ predefined ()
let named_behaviours t = unique (declared t [ "behaviour" ] @ t.known.behaviours)

(* With the head of a family, which alone is no reference. *)
let with_head t o = { o with form = List.assoc_opt o.name t.known.families }

let behaviours t =
  List.map (with_head t) (names "behaviour" (named_behaviours t @ imported t "behaviour"))
  @ modules t
  @ words [ "nil"; "omega"; "rho"; "eps" ]

(* {1 The shape at hand} *)

let integer text = match int_of_string_opt text with Some n when n >= 0 -> Some n | _ -> None

(* The solid that begins at a word: `box(…)`, `Cube`, `m.Cube`. *)
let solid_at t (i : Pieces.item) k : Known.solid list =
  let w j = if j < i.stop then t.p.words.(j) else "" in
  let qualifier, name, next = if w (k + 1) = "." then (Some (w k), w (k + 2), k + 3) else (None, w k, k + 1) in
  let corners = if w next = "(" then integer (w (next + 1)) else None in
  if Pieces.is_name name then [ { qualifier; name; corners } ] else []

let solids_of_body t (i : Pieces.item) =
  let depth = ref 0 and found = ref [] in
  for k = i.first to i.stop - 1 do
    match t.p.words.(k) with
    | "[" | "{" | "(" -> incr depth
    | "]" | "}" | ")" -> decr depth
    | ("=" | ":") when !depth = 0 || i.word = "compound" -> found := solid_at t i (k + 1) @ !found
    | _ -> ()
  done;
  List.rev !found

let features_of t = List.concat_map (Known.features t.known)

(* Of a behaviour, those of what it is on, or of the bodies that have it. *)
let features_at_hand t (i : Pieces.item) =
  let w = t.p.words in
  let rec on k = if k >= i.stop || w.(k) = "=" then None else if w.(k) = "on" then Some k else on (k + 1) in
  let found =
    if i.word <> "behaviour" then features_of t (solids_of_body t i)
    else
      match (on i.first, Hashtbl.find_opt t.known.wearers i.name) with
      | Some k, _ -> features_of t (solid_at t i (k + 1))
      | None, Some wearers -> features_of t wearers
      | None, None -> []
  in
  match unique found with [] -> Known.all_features t.known | found -> found

let solid_of_leaf t (i : Pieces.item) name =
  let w k = if k < i.stop then t.p.words.(k) else "" in
  let labelled k = w k = name && (w (k + 1) = ":" || w (k + 1) = "[") in
  let rec colon k = if k >= i.stop then None else if w k = ":" then Some k else colon (k + 1) in
  let rec find k = if k >= i.stop then None else if labelled k then colon k else find (k + 1) in
  match find (i.first + 2) with Some k -> solid_at t i (k + 1) | None -> []

let features_of_body t (i : Pieces.item) name =
  match (solid_of_leaf t i name, List.assoc_opt name t.known.bodies) with
  | (_ :: _ as own), _ -> features_of t own
  | [], Some (Some s) -> Known.features t.known s
  | [], (Some None | None) -> []

(* The features of a part, or of a body. *)
let inside t name (i : Pieces.item) =
  let prefix = name ^ "." in
  let n = String.length prefix in
  let begins f = String.length f > n && String.sub f 0 n = prefix in
  match List.filter begins (features_at_hand t i) with
  | _ :: _ as parts -> List.map (fun f -> String.sub f n (String.length f - n)) parts
  | [] -> features_of_body t i name

(* {1 After a dot} *)

(* Whose something stands after the dot: `q` of `q.`, and of `q[i].` *)
let owner t =
  if Pieces.before t.p 2 <> "]" then Pieces.before t.p 2
  else
    let rec back k =
      match Pieces.before t.p k with
      | "" -> ""
      | "[" -> Pieces.before t.p (k + 1)
      | _ -> back (k + 1)
    in
    back 3

let exported ?(only = fun _ -> true) t name =
  match List.assoc_opt name t.known.modules with
  | None -> []
  | Some found -> List.concat_map (fun (kind, n) -> if only kind then names kind [ n ] else []) found

let after_dot t (i : Pieces.item) =
  let name = owner t in
  match exported t name with
  | _ :: _ as found -> found
  | [] -> (
      match inside t name i with
      | _ :: _ as found -> names "feature" found
      | [] -> entries Vocabulary.Component Forms.Called)

open Scc_json

let int r n = Random.State.int r n
let one_of r list = List.nth list (int r (List.length list))

(* {1 Documents} *)

let character r set =
  let rec all i =
    if i >= String.length set then []
    else if i + 2 < String.length set && set.[i + 1] = '-' then (set.[i], set.[i + 2]) :: all (i + 3)
    else (set.[i], set.[i]) :: all (i + 1)
  in
  let low, high = one_of r (all 0) in
  Char.chr (Char.code low + int r (Char.code high - Char.code low + 1))

let of_run r (run : Json_schema.run) =
  let most = Option.value run.most ~default:(run.least + 2) in
  let count = run.least + int r (most - run.least + 1) in
  String.init count (fun _ -> character r run.set)

(* Schemas recur: deep inside, arrays are as short as they may be, and the last alternative is taken. *)
let rec made r deep (t : Json_schema.t) : Json.t =
  let inside = made r (deep + 1) in
  match t with
  | Anything -> one_of r [ `Null; `Int 3; `String "any"; `List []; `Assoc [] ]
  | Null -> `Null
  | Bool -> `Bool (Random.State.bool r)
  | Integer { least; most } ->
    let least = Option.value least ~default:(-5) in
    let most = Option.value most ~default:(least + 20) in
    `Int (least + int r (most - least + 1))
  | Text { least } ->
    let empty = if least = 0 then [ "" ] else [] in
    `String (one_of r (empty @ [ "p"; "a text"; "Σ\"\\"; "p.right" ]))
  | Form runs -> `String (String.concat "" (List.map (of_run r) runs))
  | Repeated runs ->
    let once () = String.concat "" (List.map (of_run r) runs) in
    `String (String.concat "" (List.init (1 + int r 3) (fun _ -> once ())))
  | Constant values -> one_of r values
  | Items { each; least; most; distinct } ->
    let more = if deep > 10 then 0 else int r 3 in
    let count = Option.fold ~none:(least + more) ~some:(Int.min (least + more)) most in
    let items = List.init count (fun _ -> inside each) in
    `List (if distinct then List.sort_uniq compare items else items)
  | Tuple items -> `List (List.map inside items)
  | Members members ->
    let given (m : Json_schema.member) =
      if m.required || (deep < 12 && Random.State.bool r) then Some (m.name, inside m.value) else None
    in
    `Assoc (List.filter_map given members)
  | Entries each ->
    `Assoc (List.filter (fun _ -> Random.State.bool r) [ ("a", inside each); ("b c", inside each) ])
  | Any_of alternatives ->
    inside (if deep > 10 then List.nth alternatives (List.length alternatives - 1) else one_of r alternatives)
  | Reference { target; _ } -> inside (Lazy.force target)
  | Document { target; _ } -> inside target
  | About (_, t) | Also (_, t) -> inside t

let document r t = made r 0 t

(* {1 Changes} *)

let without r list =
  let k = int r (List.length list) in
  List.filteri (fun i _ -> i <> k) list

let twice r list =
  let k = int r (List.length list) in
  List.concat (List.mapi (fun i x -> if i = k then [ x; x ] else [ x ]) list)

(* Other characters than those of ASCII are not cut in two. *)
let text_changed r s =
  let s = if String.for_all (fun c -> Char.code c < 128) s then s else "text" in
  let n = String.length s in
  let k = int r (n + 1) in
  let from = Int.min n (k + int r 2) in
  String.sub s 0 k ^ one_of r [ ""; "x"; "0"; "/" ] ^ String.sub s from (n - from)

let replaced r : string * Json.t =
  one_of r
    [
      ("null", `Null); ("kind", `Bool true); ("kind", `List []); ("kind", `Assoc []); ("number", `Int (-1));
      ("number", `Int 0); ("number", `Int 7); ("text", `String ""); ("text", `String "zz");
    ]

let here r (json : Json.t) =
  match (json, int r 3) with
  | `Assoc (_ :: _ as members), 0 -> ("member left out", `Assoc (without r members))
  | `Assoc members, 1 -> ("member added", `Assoc (members @ [ ("added", `Int 1) ]))
  | `List (_ :: _ as items), 0 -> ("item left out", `List (without r items))
  | `List (_ :: _ as items), 1 -> ("item twice", `List (twice r items))
  | `String s, (0 | 1) -> ("text", `String (text_changed r s))
  | `Int n, 0 -> ("number", `Int (n + 1))
  | `Int n, 1 -> ("number", `Int (-n - 1))
  | _ -> replaced r

let rec size : Json.t -> int = function
  | `List items -> List.fold_left (fun sum x -> sum + size x) 1 items
  | `Assoc members -> List.fold_left (fun sum (_, x) -> sum + size x) 1 members
  | _ -> 1

(* The value with the number [k] among all, in the order of the text, is changed. *)
let rec at r k (json : Json.t) =
  if k = 0 then here r json
  else
    let rec inside k = function
      | [] -> invalid_arg "Samples.at"
      | x :: rest when k < size x ->
        let kind, x = at r k x in
        (kind, x :: rest)
      | x :: rest ->
        let kind, rest = inside (k - size x) rest in
        (kind, x :: rest)
    in
    match json with
    | `List items ->
      let kind, items = inside (k - 1) items in
      (kind, `List items)
    | `Assoc members ->
      let kind, values = inside (k - 1) (List.map snd members) in
      (kind, `Assoc (List.map2 (fun (name, _) x -> (name, x)) members values))
    | _ -> invalid_arg "Samples.at"

let changed r json = at r (int r (size json)) json

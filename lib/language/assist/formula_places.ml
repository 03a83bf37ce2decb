open Scc_describe
open Offers

(* Names of bodies or integers that `forall`, `exists` and `count` declare before the place. *)
let variables t (i : Pieces.item) =
  let w k = if k < t.p.count then t.p.words.(k) else "" in
  let is_integer k = match w k with "" -> false | x -> (x.[0] >= '0' && x.[0] <= '9') || w (k + 1) = ".." in
  let at k =
    let name = if w k = "count" && w (k + 1) = "(" then k + 2 else k + 1 in
    if List.mem (w k) [ "forall"; "exists"; "count"; "for" ] && w (name + 1) = "in" then
      Some ((if is_integer (name + 2) then "value" else "body"), w name)
    else None
  in
  let from = if i.word = "for" then i.first else i.first + 1 in
  List.filter_map (fun k -> at (from + k)) (List.init (Int.max 0 (t.p.count - from)) Fun.id)

let of_variables kind all = List.filter_map (fun (k, name) -> if String.equal k kind then Some name else None) all

let integers t i = of_variables "value" (variables t i)

(* One body is meant: a member of a family is offered with its indices, and a process of several bodies is not. *)
let single_bodies t =
  let near = List.filter (fun (i : Pieces.item) -> List.mem i.word [ "process"; "fixed" ]) t.p.items in
  let group name = List.exists (fun (i : Pieces.item) -> i.name = name && leaves t i <> []) near in
  let member name =
    let indexed (i : Pieces.item) = i.name = name && i.first + 2 < i.stop && t.p.words.(i.first + 2) = "[" in
    match List.assoc_opt name t.known.members with
    | Some written -> Some written
    | None -> if List.exists indexed near then Some (name ^ "[i]") else None
  in
  let takes_part name =
    match (t.known.network, List.assoc_opt name t.known.bodies) with
    | None, _ | _, None -> true
    | Some listed, Some _ -> List.mem name listed || not (List.mem name t.known.processes)
  in
  let kept o = not (List.mem o.name t.known.groups || group o.name) && takes_part o.name in
  List.map (fun o -> { o with form = member o.name }) (List.filter kept (bodies t))

(* The call around the place, with the number of commas between: only if an argument begins here. *)
let call t (i : Pieces.item) =
  match Pieces.bracket t.p with
  | Some k when k > i.first && t.p.words.(k) = "(" && Pieces.is_name t.p.words.(k - 1) ->
    let depth = ref 0 and commas = ref 0 in
    for j = k + 1 to t.p.count - 1 do
      match t.p.words.(j) with
      | "(" | "[" | "{" -> incr depth
      | ")" | "]" | "}" -> decr depth
      | "," when !depth = 0 -> incr commas
      | _ -> ()
    done;
    Some (k - 1, !commas, List.mem (Pieces.before t.p 1) [ "("; "," ])
  | _ -> None

(* What the forms of a word call its argument: `body`, `channel`, or a number by any other name. *)
let argument t k n =
  let is_event = k > 0 && t.p.words.(k - 1) = "event" in
  match Forms.find (if is_event then Event else Called) t.p.words.(k) with
  | None -> None
  | Some forms ->
    let of_form form =
      let slice (from, stop) = String.sub form from (stop - from) in
      Option.map slice (List.nth_opt (Signatures.arguments form) n)
    in
    Some (unique (List.filter_map of_form forms))

let numbers t variables =
  values t @ names "value" (of_variables "value" variables)
  @ entries Vocabulary.Atom Forms.Called
  @ entries Vocabulary.Function Forms.Called
  @ modules t

let arguments t (i : Pieces.item) =
  let all = variables t i in
  match call t i with
  | None -> None
  | Some (k, n, begins) -> (
      match argument t k n with
      | None -> None
      | Some kinds when List.for_all (fun kind -> List.mem kind [ "body"; "channel" ]) kinds ->
        let of_kind = function
          | "body" -> single_bodies t @ names "body" (of_variables "body" all)
          | _ -> names "channel" (channels t)
        in
        Some (if begins then List.concat_map of_kind kinds else [])
      | Some _ -> Some (numbers t all @ words [ "count"; "if"; "then"; "else" ]))

(* The index of a family, `c[`. *)
let index t (i : Pieces.item) =
  match Pieces.bracket t.p with
  | Some k when k > i.first && t.p.words.(k) = "[" && List.mem_assoc t.p.words.(k - 1) t.known.members ->
    Some (values t @ names "value" (integers t i) @ entries Vocabulary.Function Forms.Called)
  | _ -> None

(* Of what a quantifier is: `forall b in `. *)
let range t =
  let before k = Pieces.before t.p k in
  let quantified = List.mem (before 3) [ "forall"; "exists" ] || (before 3 = "(" && before 4 = "count") in
  if before 1 = "in" && quantified then Some (shapes t @ bodies t @ modules t @ predefined () @ values t) else None

(* After `behaviour(p) =`. *)
let compared t =
  let before k = Pieces.before t.p k in
  let rec opening k depth =
    match before k with
    | "" -> false
    | ")" -> opening (k + 1) (depth + 1)
    | "(" -> if depth = 1 then before (k + 1) = "behaviour" else opening (k + 1) (depth - 1)
    | _ -> opening (k + 1) depth
  in
  if List.mem (before 1) [ "="; "!=" ] && before 2 = ")" && opening 2 0 then
    Some (List.map (with_head t) (names "behaviour" (named_behaviours t @ imported t "behaviour")) @ modules t)
  else None

(* What stands after a dot in a formula: what a module brings, a part of a body that is hit, a component. *)
let after_dot_of_formula t (i : Pieces.item) =
  let name = owner t in
  let is_body = List.mem_assoc name t.known.bodies || List.mem_assoc name t.known.members in
  if Pieces.before t.p 1 <> "." then None
  else if List.mem_assoc name t.known.modules then Some (exported t name)
  else if is_body then
    match call t i with
    | Some (k, _, _) when t.p.words.(k) = "hit" && k > 0 && t.p.words.(k - 1) = "event" ->
      let parts f = match String.index_opt f '.' with Some j -> Some (String.sub f 0 j) | None -> None in
      Some (names "feature" (unique (List.filter_map parts (features_of_body t i name))))
    | Some _ | None -> Some []
  else Some (entries Vocabulary.Component Forms.Called)

let offers t (i : Pieces.item) =
  let first = [ after_dot_of_formula t i; index t i; range t; compared t; arguments t i ] in
  List.find_map Fun.id first

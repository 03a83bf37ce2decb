open Scc_base
open Ast
open Layout

let start (span : Span.t) = if Span.is_none span then -1 else span.start
let last_byte (span : Span.t) = if Span.is_none span then -1 else span.stop - 1
let at loc = start loc.at

(* [separated sep ds]: with [sep] between two. *)
let separated sep = function [] -> [] | d :: ds -> d :: List.concat_map (fun d -> [ sep; d ]) ds

(* {1 Formulas}

   One that is too long is broken at its outermost connective. *)

let connective = function And -> Some "and " | Or -> Some "or " | Implies -> Some "=> " | _ -> None

let same_connective a b =
  match (a, b) with And, And | Or, Or -> true | _ -> false

let operand o side e =
  let text = Text.expr e in
  if Text.needs_parentheses o side e then "(" ^ text ^ ")" else text

let formula e =
  match e.it with
  | Binary (o, _, _) when Option.is_some (connective o) ->
    let word = Option.value ~default:"" (connective o) in
    (* The left spine of one connective, first operand first. *)
    let rec spine acc e =
      match e.it with
      | Binary (o', l, r) when same_connective o o' ->
        spine (text ~at:(at r) (word ^ operand o Text.Right r) :: acc) l
      | _ -> text ~at:(at e) (operand o Text.Left e) :: acc
    in
    let pieces =
      match e.it with
      | Binary (Implies, l, r) ->
        [ text ~at:(at l) (operand o Text.Left l); text ~at:(at r) (word ^ operand o Text.Right r) ]
      | _ -> spine [] e
    in
    cat (separated space pieces)
  | Leads_to (f, bound, g) ->
    cat [ text ~at:(at f) (Text.condition f); space; text ~at:(at g) (Text.consequence bound g) ]
  | _ -> text ~at:(at e) (Text.expr e)

(* {1 Behaviours} *)

let summands b =
  let rec spine acc b = match b.it with Sum (l, r) -> spine (r :: acc) l | _ -> b :: acc in
  spine [] b

let summand i b =
  let pieces = List.mapi
      (fun k (at, s) -> text ~at (if k = 0 && i > 0 then "+ " ^ s else s)) (Text.prefixes b)
  in
  nest 4 (cat (separated (fill " ") pieces))

let behaviour_doc b = cat (separated space (List.mapi summand (summands b)))

(* {1 Processes} *)

let leaf_doc l =
  let label = match l.label with None -> "" | Some s -> Text.segment s ^ " : " in
  let head = text ~at:(start l.leaf_span) (label ^ Text.solid l.solid) in
  let attributes = List.map (fun a -> text ~at:(at a) (Text.attribute a)) l.attributes in
  let box =
    match l.behaviour with None -> [] | Some b -> [ text ~at:(at b) ("[" ^ Text.behaviour b ^ "]") ]
  in
  nest 2 (cat (separated (fill " ") ((head :: attributes) @ box)))

let process_doc span word name l rest =
  let head = text ~at:(start span) (word ^ " " ^ Text.segment name ^ " =") in
  match rest with
  | [] -> cat [ head; fill " "; leaf_doc l ]
  | _ ->
    let link (b, l) = [ space; text ~at:(start b.bond_span) (Text.bond b); space; leaf_doc l ] in
    group (cat [ head; nest 2 (cat (space :: leaf_doc l :: List.concat_map link rest)) ])

(* {1 Declarations} *)

(* A small power of two as such. *)
let fineness e =
  match e.it with
  | Number q ->
    (match Numerals.power_of_two q with
     | Some s -> text ~at:(at e) s
     | None -> formula e)
  | _ -> formula e

let definition head body = group (cat [ head; nest 2 (cat [ space; body ]) ])

let block close head lines =
  let close = closing ~at:close "}" in
  match lines with
  | [] -> group (cat [ head; space; close ])
  | _ -> cat [ head; nest 2 (cat (line :: separated paragraph lines)); line; close ]

let column_of word = function
  | [] -> text ~at:(-1) word
  | ((first, _) :: _) as entries ->
    let pieces = List.map (fun (at, s) -> text ~at s) entries in
    cat [ text ~at:first word; nest 9 (cat (fill (String.make (9 - String.length word) ' ')
                                            :: separated (fill "  ") pieces)) ]

let template close head vs fs =
  let vertex (((n : name), _) as v) = (at n, Text.vertex v) in
  let face ((n : name), ws) = (at n, Text.face n ws) in
  let lines = [ column_of "vertices" (List.map vertex vs); column_of "faces" (List.map face fs) ] in
  cat [ head; nest 2 (cat (line :: separated line lines)); line; closing ~at:close "}" ]

(* The offset of the brace that closes a declaration, or one after it. *)
let brace span = function
  | [] -> last_byte span
  | ((n : name), _) :: _ -> at n - 1

let part_doc p =
  let head = Printf.sprintf "part %s : %s" p.part.it (Text.solid p.part_solid) in
  let head = text ~at:(start p.part_span) head in
  let attributes = List.map (fun a -> text ~at:(at a) (Text.attribute a)) p.part_attributes in
  nest 2 (cat (separated (fill " ") (head :: attributes)))

(* Vertices and faces are laid out as in the declaration of a shape; what stretches them, and the attributes,
   follow. *)
let decomposition head s attributes =
  let rec unscaled s after =
    match s.it with
    | Scaled (inner, v) -> unscaled inner (text ~at:(at v) ("scaled " ^ Text.vector v) :: after)
    | Faces (vs, fs) -> (template (last_byte s.at) (cat [ head; text ~at:(at s) " {" ]) vs fs, after)
    | Mesh _ | Template _ | Hull _ -> (cat [ head; nest 2 (cat [ fill " ";
                                                                 text ~at:(at s) (Text.decomposed s) ]) ], after)
  in
  let attributes = List.map (fun a -> text ~at:(at a) (Text.attribute a)) attributes in
  let first, after = unscaled s attributes in
  cat [ first; nest 2 (cat (List.concat_map (fun d -> [ fill " "; d ]) after)) ]

let glue_doc g =
  text ~at:(start g.glue_span)
    (Printf.sprintf "glue %s ~ %s" (Text.feature g.glue_first) (Text.feature g.glue_second))

let range (r : range) = Printf.sprintf "%s in %s" r.index.it (Text.bounds r.bounds)
let ranges list = String.concat ", " (List.map range list)

let optional word = function None -> "" | Some e -> Printf.sprintf " %s %s" word (Text.expr e)

let kick (k : kick) =
  let written = Text.expr k.velocity ^ optional "spin" k.spin ^ optional "weight" k.weight in
  match k.over with
  | [] -> (at k.velocity, written)
  | first :: _ -> (at first.index, Printf.sprintf "for %s: %s" (ranges k.over) written)

let motion span subject law =
  let head = match subject with None -> "motion" | Some p -> "motion " ^ Text.path p ^ " =" in
  match law.it with
  | Inertial -> text ~at:(start span) (head ^ " inertial")
  | Expression (v, spin) ->
    let written = match subject with None -> Text.law_of_all v | Some _ -> Text.expr v in
    definition (text ~at:(start span) head) (text ~at:(at law) (written ^ optional "spin" spin))
  | Choose kicks ->
    let n = List.length kicks in
    let entry i (at, s) = text ~at (if i < n - 1 then s ^ "," else s) in
    let entries = List.mapi entry (List.map kick kicks) in
    group
      (cat
         [ text ~at:(start span) (head ^ " choose {"); nest 2 (cat (space :: separated space entries));
           space; closing ~at:(last_byte span) "}" ])

let network span = function
  | [] -> text ~at:(start span) "network nil"
  | first :: rest ->
    let pieces =
      text ~at:(start span) ("network " ^ Text.path first)
      :: List.map (fun p -> text ~at:(at p) ("|| " ^ Text.path p)) rest
    in
    nest 2 (cat (separated (fill " ") pieces))


(* What is declared, with the names of its own after it. *)
let with_definitions doc definitions =
  let one (n, e) = (at n, Printf.sprintf "%s = %s" n.it (Text.expr e)) in
  let last = List.length definitions - 1 in
  let piece i (at, s) =
    text ~at ((if i = 0 then "where " else "      ") ^ s ^ if i < last then "," else "")
  in
  match definitions with
  | [] -> doc
  | _ :: _ ->
    cat [ doc; nest 2 (cat (line :: separated line (List.mapi piece (List.map one definitions)))) ]

let import span (i : import) =
  let from = if i.library then "<" ^ i.from.it ^ ">" else Text.quoted i.from.it in
  let chosen ((n : name), m) =
    match m with None -> n.it | Some (m : name) -> n.it ^ " as " ^ m.it
  in
  let names =
    match i.names with
    | Qualified None -> ""
    | Qualified (Some n) -> " as " ^ n.it
    | Chosen ns -> " (" ^ String.concat ", " (List.map chosen ns) ^ ")"
  in
  text ~at:(start span) ("import " ^ from ^ names)

let rec item i =
  let span = i.at in
  let head fmt = Printf.ksprintf (fun s -> text ~at:(start span) s) fmt in
  match i.it with
  | Model n -> head "model %s" n.it
  | Param (n, e) -> definition (head "param %s =" n.it) (formula e)
  | Param_in (n, low, high) ->
    head "param %s in %s%s, %s%s" n.it
      (if low.included then "[" else "(")
      (Text.expr low.value) (Text.expr high.value)
      (if high.included then "]" else ")")
  | Timestep (e, kind) ->
    let word = match kind with Shared -> [] | Local -> [ " local" ] | Steady -> [ " steady" ] in
    definition (head "timestep") (cat (formula e :: List.map (text ~at:(last_byte span)) word))
  | Split_step e -> definition (head "split_step") (formula e)
  | Dynamics n -> head "dynamics %s" n.it
  | Collisions n -> head "collisions %s" n.it
  | Binding n -> head "binding %s" n.it
  | Bonds n -> head "bonds %s" n.it
  | Blocked n -> head "blocked %s" n.it
  | Resolution e -> definition (head "resolution") (fineness e)
  | Round (n, e) -> definition (head "round %s" n.it) (fineness e)
  | Import i -> import span i
  | Shape (h, ({ it = Faces (vs, fs); _ }), ds) ->
    with_definitions (template (brace span ds) (head "shape %s {" (Text.head h)) vs fs) ds
  | Shape (h, s, ds) ->
    with_definitions (definition (head "shape %s =" (Text.head h)) (text ~at:(at s) (Text.solid s))) ds
  | Compound (h, parts, glues, ds) ->
    with_definitions
      (block (brace span ds) (head "compound %s {" (Text.head h))
         (List.concat [ List.map part_doc parts; List.map glue_doc glues ]))
      ds
  | Decomposed (h, s, attributes, ds) ->
    with_definitions (decomposition (head "compound %s = decompose" (Text.head h)) s attributes) ds
  | Behaviour (h, on, b, ds) ->
    let on = match on with None -> "" | Some t -> " on " ^ Text.reference t in
    with_definitions (definition (head "behaviour %s%s =" (Text.head h) on) (behaviour_doc b)) ds
  | Process (n, l, rest) -> process_doc span "process" n l rest
  | Fixed (n, l, rest) -> process_doc span "fixed" n l rest
  | Bond b -> head "bond %s" (Text.bond b)
  | For (over, body) -> loop span (head "for %s {" (ranges over)) body
  | Network ps -> network span ps
  | Motion (p, l) -> motion span p l
  | Let (n, e) -> definition (head "let %s =" n.it) (formula e)
  | Check (n, e) -> definition (head "check %s :" n.it) (formula e)

and loop span head body =
  match List.map item body with
  | [ one ] ->
    group (cat [ head; nest 2 (cat [ space; one ]); space; closing ~at:(last_byte span) "}" ])
  | lines -> block (last_byte span) head lines

let model ?(trivia = []) items = render trivia (cat (separated paragraph (List.map item items)))
let expr = Text.expr
let head = Text.head
let behaviour = Text.behaviour

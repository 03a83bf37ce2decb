open Scc_base
open Scc_syntax
open Ast

let whole c = (Content.element c).Document.whole
let loc c it = { it; at = whole c }
let expr c key = Content.required c key Content.expression

(* {1 Features} *)

let named c = Content.required c "name" Content.feature

let feature c =
  match Content.one c "feature" named with
  | Some f -> f
  | None ->
    let at = (Content.element c).at in
    Content.missing c "a `<feature>` is missing here";
    { it = Named { it = []; at }; at }

let member c =
  let only = Option.value ~default:false (Content.optional c "only" Content.flag) in
  Content.required c "name" (Content.member ~only)

(* {1 Behaviours} *)

let channel c =
  let channel = Content.required c "channel" Content.name in
  let co = Option.value ~default:false (Content.optional c "co" Content.flag) in
  { channel; co; features = Content.many c [ "feature" ] member; span = whole c }

let push c = Content.optional c "push" Content.expression

let odds c =
  if Content.has c "odds" || Content.has c "value" then
    let odds = Content.required c "odds" Content.word in
    Some { odds; value = expr c "value" }
  else None

let open_prefix c = let ch = channel c in fun next -> loc c (Open (ch, next))

let weak c =
  let ch = channel c in
  let push = push c in
  let odds = odds c in
  fun next -> loc c (Weak (ch, { push; odds }, next))

let strong c =
  let push = push c in
  let bonds = Content.many c [ "channel" ] channel in
  fun next -> loc c (Strong (bonds, push, next))

let delay c =
  let t = expr c "time" in
  fun next -> loc c (Delay (t, next))

let prefixes =
  [ ("open", open_prefix); ("weakSplit", weak); ("strongSplit", strong); ("delay", delay) ]

let too_deep c =
  Content.error (Content.reports c) Code.too_deep (Content.element c).at
    "this behaviour is nested too deeply (the limit is %d)" Tokens.max_depth;
  raise Document.Stop

(* The behaviour, and how deep its tree is: prefixes of one another nest, and summands. *)
let rec sequence c =
  let rec go acc count =
    let prefix = Option.bind (Content.next c) (fun tag -> List.assoc_opt tag prefixes) in
    match (prefix, Content.next c) with
    | Some read, Some tag when count <= Tokens.max_depth ->
      (match Content.one c tag read with
       | Some wrap -> go (wrap :: acc) (count + 1)
       | None -> Bug.fail __POS__ "the next element is not there")
    | Some _, _ -> too_deep c
    | None, _ -> (acc, count)
  in
  let wraps, count = go [] 0 in
  let last, deep = ending c in
  if count + deep > Tokens.max_depth then too_deep c;
  (List.fold_left (fun next wrap -> wrap next) last wraps, count + deep)

and ending c =
  let at = (Content.element c).at in
  match Content.next c with
  | Some "nil" -> (Option.value ~default:{ it = Nil; at } (Content.one c "nil" (fun c -> loc c Nil)), 0)
  | Some "call" ->
    let call c = loc c (Name (Content.required c "name" Content.behaviour)) in
    (Option.value ~default:{ it = Nil; at } (Content.one c "call" call), 0)
  | Some "choice" -> Option.value ~default:({ it = Nil; at }, 0) (Content.one c "choice" choice)
  | Some _ | None ->
    Content.missing c "a behaviour ends with `<nil>`, `<call>` or `<choice>`, which is missing here";
    ({ it = Nil; at }, 0)

and choice c =
  match Content.many c [ "branch" ] sequence with
  | first :: (_ :: _ as rest) ->
    let sum (left, deep) (right, deep') = (loc c (Sum (left, right)), max (deep + 1) (deep' + 1)) in
    List.fold_left sum first rest
  | [] | [ _ ] ->
    Content.missing c "a choice has two `<branch>`es at least";
    (loc c Nil, 0)

let behaviour c = fst (sequence c)

(* {1 Shapes} *)

let vertex c =
  let name = Content.required c "name" Content.name in
  if Content.has c "point" then (name, expr c "point")
  else
    let x = expr c "x" in
    let y = expr c "y" in
    let z = expr c "z" in
    (name, loc c (Vector (x, y, z)))

let vertices c =
  let found = Content.many c [ "vertex" ] vertex in
  found

let face c =
  let name = Content.required c "name" Content.name in
  (name, Content.required c "vertices" Content.names)

let face_set c =
  let vs = vertices c in
  loc c (Faces (vs, Content.many c [ "face" ] face))

let mesh c =
  let file = Content.required c "file" Content.line in
  let length key = Content.optional c key Content.expression in
  let done_ key = Option.value (Content.optional c key Content.flag) ~default:false in
  let grid = length "grid" and weld = done_ "weld" and orient = done_ "orient" and merge = done_ "merge" in
  let snap = length "snap" in
  loc c (Mesh (file, { grid; weld; orient; merge; snap; union = done_ "union" }))

let solids =
  [
    ("template", fun c -> loc c (Template (Content.required c "name" Content.template)));
    ("indexedFaceSet", face_set); ("hull", fun c -> loc c (Hull (vertices c))); ("mesh", mesh);
  ]

let scaled c = (whole c, expr c "by")

let solid c =
  let at = (Content.element c).at in
  let read = Option.bind (Content.next c) (fun tag -> List.assoc_opt tag solids) in
  let found =
    match (read, Content.next c) with
    | Some read, Some tag -> Content.one c tag read
    | _ ->
      Content.missing c "a solid is missing here: `<template>`, `<indexedFaceSet>`, `<hull>` or `<mesh>`";
      None
  in
  let first = Option.value found ~default:{ it = Hull []; at } in
  let factors = Content.many c [ "scaled" ] scaled in
  if List.compare_length_with factors Tokens.max_depth > 0 then too_deep c;
  List.fold_left (fun s (at, by) -> { it = Scaled (s, by); at }) first factors

(* {1 Attributes} *)

let quadruple c (a, b, x, d) =
  let a = expr c a in
  let b = expr c b in
  let x = expr c x in
  (a, b, x, expr c d)

let matrix c =
  match Content.many c [ "row" ] (fun c -> quadruple c ("a", "b", "c", "d")) with
  | [ _; _; _; _ ] as rows -> loc c (Matrix rows)
  | _ ->
    Content.missing c "a matrix has four `<row>`s";
    loc c (Matrix [])

let transform c =
  match (Content.element c).tag with
  | "translate" -> loc c (Translate (expr c "by"))
  | "scale" -> loc c (Scale (expr c "by"))
  | "rotate" ->
    let w, x, y, z = quadruple c ("w", "x", "y", "z") in
    loc c (Rotate (w, x, y, z))
  | _ -> matrix c

let attribute c =
  match (Content.element c).tag with
  | "mass" -> loc c (Mass (expr c "value"))
  | "velocity" -> loc c (Velocity (expr c "value"))
  | "spin" -> loc c (Spin (expr c "value"))
  | "absorb" -> loc c Absorb
  | _ -> (
      match Content.many c [ "translate"; "rotate"; "scale"; "matrix" ] transform with
      | [] ->
        Content.missing c "a transformation is missing here: `<translate>`, `<rotate>`, `<scale>` or `<matrix>`";
        loc c (At [])
      | ts -> loc c (At ts))

let attributes c = Content.many c [ "mass"; "velocity"; "spin"; "absorb"; "at" ] attribute

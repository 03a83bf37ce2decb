open Scc_base
open Scc_syntax

type t = { kind : kind; at : Span.t }

and kind =
  | Named of Ast.path
  | Hull of Ast.path list
  | Interior of t
  | Polygon of Ast.expr list
  | Segment of Ast.expr * Ast.expr
  | Point of Ast.expr
  | Half of Ast.expr * Ast.expr
  | Cap of Ast.expr * Ast.expr
  | Whole
  | Empty
  | Union of t * t
  | Common of t * t
  | Less of t * t

exception Fault of Diag.t

let refuse ?hint at fmt =
  Printf.ksprintf (fun text -> raise (Fault (Diag.error ?hint Code.bad_region at "%s" text))) fmt

let hint =
  "a region is a feature, `hull(a, b)`, `polygon(p, q, r)`, `segment(p, q)`, `point(p)`, `half(n, d)`, \
   `cap(v, c)`, \
   `interior(f)`, `surface()`, or X + Y, X * Y, X - Y of regions"

let path_of (e : Ast.expr) =
  match e.it with
  | Path p -> p
  | _ -> refuse e.at "the corners of a `hull` are names of vertices" ~hint:"of places, it is a `polygon` or \
                                                                            `segment`"

(* As deep as the text is: at most Tokens.max_depth. *)
let rec of_expr (e : Ast.expr) =
  let kind =
    match e.it with
    | Path p -> Named p
    | Binary (Add, x, y) -> Union (of_expr x, of_expr y)
    | Binary (Mul, x, y) -> Common (of_expr x, of_expr y)
    | Binary (Sub, x, y) -> Less (of_expr x, of_expr y)
    | Apply (f, arguments) -> applied e.at f arguments
    | _ -> refuse e.at "this is no region of contact" ~hint
  in
  { kind; at = e.at }

and applied at (f : Ast.name) arguments =
  match (f.it, arguments) with
  | "hull", (_ :: _ as corners) -> Hull (List.map path_of corners)
  | "interior", [ x ] -> Interior (of_expr x)
  | "polygon", (_ :: _ :: _ :: _ as corners) -> Polygon corners
  | "segment", [ p; q ] -> Segment (p, q)
  | "point", [ p ] -> Point p
  | "half", [ n; d ] -> Half (n, d)
  | "cap", [ v; c ] -> Cap (v, c)
  | "surface", [] -> Whole
  | "empty", [] -> Empty
  | ("hull" | "interior" | "polygon" | "segment" | "point" | "half" | "cap" | "surface" | "empty"), _ ->
    refuse at "`%s` does not take these arguments" f.it ~hint
  | _ -> refuse f.at "`%s` makes no region of contact" f.it ~hint

let read e = match of_expr e with x -> Ok x | exception Fault d -> Error d

(* {1 Features} *)

let feature x : Ast.feature option =
  match x.kind with
  | Named p -> Some (Tree.at x.at (Ast.Named p))
  | Hull corners -> Some (Tree.at x.at (Ast.Tuple (None, corners)))
  | _ -> None

let members x =
  let member only x = Option.map (fun feature -> [ { Ast.feature; only } ]) (feature x) in
  let rec go x =
    match x.kind with
    | Empty -> Some []
    | Interior y -> member true y
    | Union (y, z) -> (
        match (go y, go z) with
        | Some a, Some b -> Some (List.append a b)
        | _ -> None)
    | _ -> member false x
  in
  go x

let is_operator (s : Ast.segment) =
  match s.name.it with "AF" | "AG" | "AX" | "EF" | "EG" | "EX" -> true | _ -> false

let of_path (p : Ast.path) : Ast.expr =
  match p.it with
  | first :: _ when is_operator first ->
    refuse first.name.at "`%s` cannot be the name of a region: it is an operator there" first.name.it
  | _ -> Tree.at p.at (Ast.Path p)

let apply span f arguments : Ast.expr = Tree.at span (Ast.Apply (Tree.at span f, arguments))

let written (f : Ast.feature) =
  match f.it with
  | Named p -> of_path p
  | Tuple (prefix, corners) ->
    let whole (p : Ast.path) =
      match prefix with
      | None -> of_path p
      | Some (q : Ast.path) -> of_path (Tree.at p.at (List.append q.it p.it))
    in
    apply f.at "hull" (List.map whole corners)

let of_feature f = match written f with x -> Ok x | exception Fault d -> Error d

let of_member (m : Ast.member) =
  let x = written m.feature in
  if m.only then apply m.feature.at "interior" [ x ] else x

let of_members span members =
  match List.map of_member members with
  | [] -> Ok (apply span "empty" [])
  | first :: rest ->
    let join (x : Ast.expr) (y : Ast.expr) = Tree.at (Span.merge x.at y.at) (Ast.Binary (Add, x, y)) in
    Ok (List.fold_left join first rest)
  | exception Fault d -> Error d

let faults items =
  let found = ref [] in
  let check e = match read e with Ok _ -> () | Error d -> found := d :: !found in
  let feature f =
    Option.iter check (Tree.region f);
    f
  in
  let channel (c : Ast.channel) =
    List.iter (fun (m : Ast.member) -> ignore (feature m.feature)) c.features;
    c
  in
  let item i =
    (match Tree.declared i with Some (Region (_, _, e)) -> check e | Some (Curved _) | None -> ());
    ignore (Walk.item { Walk.same with feature; channel } i)
  in
  List.iter item items;
  List.rev !found

open Scc_syntax

(* The printer of the language writes the tree, in which the text of each region is a name between marks; these are
   control characters, which stand in no text. What the language has around them is taken away afterwards. *)

let opening = '\003'
let closing = '\004'
let between = '\005'
let mark c s = String.make 1 c ^ s

let name (f : Ast.feature) text : Ast.feature = Tree.at f.at (Ast.Named (Tree.path f.at [ text ]))

let channel (c : Ast.channel) =
  match c.features with
  | [ ({ feature; only = false } as m) ] -> (
      match Tree.region feature with
      | Some x ->
        let text = mark opening (Printer.expr x ^ mark closing "") in
        { c with features = [ { m with feature = name feature text } ] }
      | None -> c)
  | _ -> c

(* X of X * Y, with brackets where it is a union or a difference. *)
let factor (x : Ast.expr) =
  match x.it with Binary ((Add | Sub | Mul), _, _) -> "(" ^ Printer.expr x ^ ")" | _ -> Printer.expr x

let pair one two =
  match (Tree.region one, Tree.region two) with
  | Some x, Some y ->
    (name one (mark opening (factor x ^ mark between "")), name two (factor y ^ mark closing ""))
  | _ -> (one, two)

let bond (b : Ast.bond) =
  let first, second = pair b.first b.second in
  { b with first; second }

(* <H, m, p, v>, for a body whose attributes say just these. *)
let tuple (s : Ast.solid) (attributes : Ast.attribute list) =
  let mass (a : Ast.attribute) = match a.it with Mass e -> Some e | _ -> None in
  let velocity (a : Ast.attribute) = match a.it with Velocity e -> Some e | _ -> None in
  let place (a : Ast.attribute) = match a.it with At [ { it = Translate p; _ } ] -> Some p | _ -> None in
  let taken (a : Ast.attribute) = match a.it with Mass _ | Velocity _ | At _ -> true | Spin _ | Absorb ->
    false in
  let only found = match List.filter_map found attributes with [ e ] -> Some e | _ -> None in
  match (only mass, only place, only velocity) with
  | Some m, Some p, Some v when List.length (List.filter taken attributes) = 3 ->
    let text =
      Printf.sprintf "<%s, %s, %s, %s>" (Text.solid s) (Printer.expr m) (Printer.expr p) (Printer.expr v)
    in
    let reference : Ast.reference =
      { qualifier = None; target = Tree.at s.at text; indices = []; arguments = [] }
    in
    (Tree.at s.at (Ast.Template reference), List.filter (fun a -> not (taken a)) attributes)
  | _ -> (s, attributes)

let leaf (l : Ast.leaf) =
  let solid, attributes = tuple l.solid l.attributes in
  { l with solid; attributes }

let part (p : Ast.part) =
  let part_solid, part_attributes = tuple p.part_solid p.part_attributes in
  { p with part_solid; part_attributes }

let glue (g : Ast.glue) =
  let glue_first, glue_second = pair g.glue_first g.glue_second in
  { g with glue_first; glue_second }

let rec item (i : Ast.item) : Ast.item =
  let chain rest = List.map (fun (b, l) -> (bond b, leaf l)) rest in
  let it : Ast.item_kind =
    match i.it with
    | Process (s, first, rest) -> Process (s, leaf first, chain rest)
    | Fixed (s, first, rest) -> Fixed (s, leaf first, chain rest)
    | Bond b -> Bond (bond b)
    | Compound (h, parts, glues, ds) -> Compound (h, List.map part parts, List.map glue glues, ds)
    | For (ranges, body) -> For (ranges, List.map item body)
    | other -> other
  in
  { i with it }

(* The marks, and what the language has around them, in the order in which a text has them. *)
let changes =
  [
    ("{\003", ""); ("\004}", ""); ("\005, ", " * "); ("\003", ""); ("\005 ~ ", " * "); ("\004", "");
    ("let \002", ""); ("dynamics \002", "curved ");
  ]

let unmarked text =
  let n = String.length text in
  let b = Buffer.create n in
  let starts i piece = i + String.length piece <= n && String.equal (String.sub text i (String.length piece))
                         piece in
  let rec go i =
    if i < n then
      match text.[i] with
      | '{' | 'l' | 'd' | '\003' .. '\005' -> (
          match List.find_opt (fun (piece, _) -> starts i piece) changes with
          | Some (piece, instead) ->
            Buffer.add_string b instead;
            go (i + String.length piece)
          | None -> keep i)
      | _ -> keep i
  and keep i =
    Buffer.add_char b text.[i];
    go (i + 1)
  in
  go 0;
  Buffer.contents b

(* [curved inscribed 1/20] has no [=]: it is written as the declaration of a name. *)
let setting (i : Ast.item) : Ast.item =
  match Tree.declared i with
  | Some (Curved (word, e)) ->
    { i with it = Dynamics (Tree.at word.at (Printf.sprintf "\002%s %s" word.it (Printer.expr e))) }
  | Some (Region _) | None -> i

let model ~trivia items =
  let channels = { Walk.same with channel } in
  let shown = List.map (fun i -> item (Walk.item channels (setting i))) items in
  unmarked (Printer.model ~trivia shown)
